"""The shapes of rigid clusters, beside the numbers that S3 prints."""

import json
import unittest

from program import Case


class Shapes(Case):
    def lines(self, *arguments):
        return [json.loads(x) for x in self.program("shapes", *arguments, "--json").stdout.splitlines()]

    def test_the_papers_sphericities(self):
        shapes = self.lines()
        self.assertEqual([(s["shape"], s["aspect"]) for s in shapes[::8]], [("cross", 1.1), ("star", 1.1)])
        self.assertEqual(len(shapes), 16)
        for s in shapes:
            with self.subTest(shape=s["shape"], aspect=s["aspect"]):
                # 1.1 is an erratum of S3; its star of 8.5 is .462 in the table and .461 in the text.
                allowed = {1.1: 4e-3, 8.5: 1.5e-3}.get(s["aspect"], 6e-4)
                self.assertAlmostEqual(s["sphericity_deviation"], s["sphericity"] - s["sphericity_paper"], 12)
                self.assertLess(abs(s["sphericity_deviation"]), allowed)
                self.assertAlmostEqual(s["d3"], 3 * s["d1"], 12)
        self.assertGreater(shapes[0]["sphericity_deviation"], 3e-3)

    def test_the_table(self):
        text = self.program("shapes").stdout
        row = next(line.split() for line in text.splitlines() if line.split()[:2] == ["star", "11"])
        self.assertEqual(row[2:8], ["23.71853", "95.1873", "0.4194", "0.419", "+0.0004", "6.78723"])
        self.assertIn("L/d = 1.1: the printed .995 is not the sphericity", text)

    def test_other_aspect_ratios(self):
        cross, star = self.lines("5")
        self.assertEqual((cross["shape"], star["shape"]), ("cross", "star"))
        self.assertNotIn("sphericity_paper", cross)
        self.assertAlmostEqual(cross["area"], 2 * (4 + 3.141592653589793 / 4) - 1, 12)
        self.assertAlmostEqual(star["j1"], 3 ** .5 / 5, 12)
        text = self.program("shapes", "5", "7").stdout
        self.assertNotIn("L/d = 1.1", text)
        self.assertEqual(sum(line.startswith(("cross", "star")) for line in text.splitlines()), 4)

    def test_a_sphere_at_one(self):
        for shape in self.lines("1"):
            self.assertAlmostEqual(shape["sphericity"], 1, 12)

    def test_mistakes(self):
        for bad in ("0.5", "nan", "inf"):
            message = self.program("shapes", bad, code=2).stderr
            self.assertIn("L/d of at least 1", message)
        self.assertIn("error:", self.program("shapes", "long", code=2).stderr)


if __name__ == "__main__":
    unittest.main()
