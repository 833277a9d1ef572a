"""Everything a person may get wrong: exit code, place, reason, suggestion, and nothing damaged."""

import unittest

from program import STUDY, Case


class Mistakes(Case):
    def complaint(self, text, *parts, code=2, arguments=()):
        self.write("bad.toml", text)
        before = self.files(".")
        error = self.program("run", "bad.toml", *arguments, code=code).stderr
        for part in parts:
            self.assertIn(part, error)
        self.assertEqual(self.files("."), before, "something was written")

    def test_misspelt_key(self):
        self.complaint(STUDY.replace("width =", "widht ="), "bad.toml:8:1", "unknown key 'grains.widht'",
                       "did you mean 'grains.width'")

    def test_misspelt_section(self):
        self.complaint(STUDY.replace("[integrator]", "[integrater]"), "bad.toml:10:2", "did you mean 'integrator'")

    def test_wrong_type(self):
        self.complaint(STUDY.replace("count = 64", 'count = "many"'), "bad.toml:7:9", "grains.count",
                       "an integer is expected")

    def test_wrong_unit(self):
        self.complaint(STUDY.replace("speed = 2e-3", 'speed = "2 cm/s"'), "bad.toml:21:9", "scaled units", "d/tau_c")

    def test_unit_of_the_option(self):
        self.write("good.toml", STUDY.replace("speed = 2e-3", 'speed = "2e-3 d/tau_c"'))
        hashes = [self.program("run", f, "--dry-run").stdout for f in ("good.toml", "tiny.toml")]
        self.assertEqual(*hashes)

    def test_out_of_range(self):
        self.complaint(STUDY.replace("contact.friction = 0.5", "contact.friction = -0.5"), "bad.toml:31:20",
                       "out of range", "at least 0")

    def test_what_cannot_start_is_said_before_anything_runs(self):
        bad = STUDY.replace("[domain]", "[domain]\ndimension = 3") if "[domain]" in STUDY else (
            STUDY.replace("[integrator]", "[domain]\ndimension = 3\n\n[integrator]"))
        for arguments in ((), ("--dry-run",)):
            self.complaint(bad, "domain.walls", "bead walls are for two dimensions", arguments=arguments)
            self.complaint(STUDY.replace("contact.friction = 0.5", 'contact.damping = "printed"'),
                           "damping rule cannot reach",
                           arguments=arguments)

    def test_clusters_that_cannot_be(self):
        def of(shape, walls="box", more=""):
            return f"""[study]
name = "bad"

[grains]
count = 50
{shape}

[domain]
walls = "{walls}"
width = 10
gravity = 0.002

[contact]
law = "ratio"

[[stage]]
name = "fall"
kind = "settle"
{more}"""
        arm = "0, 0, 0, 1, 0, 0, 3, 1"
        for arguments in ((), ("--dry-run",)):
            def complaint(text, *parts):
                self.complaint(text, *parts, arguments=arguments)
            complaint(of('shape = "star"'), "bad.toml:6:1", "a star does not lie in a plane")
            complaint(of('shape = "custom"\narms = [1, 2]'), "bad.toml:7:1", "grains.arms has 2 numbers; an arm has 8")
            complaint(of(f'shape = "custom"\narms = [{arm}, 9, 9, 0, 1, 0, 0, 3, 1]'), "bad.toml:7:1", "not one body")
            complaint(of('shape = "custom"\narms = [0, 0, 0, 1, 0, 0, 0.5, 1]'), "bad.toml:7:1", "shorter (0.5) than thick")
            complaint(of('shape = "cross"', "flat"), "bad.toml:6:1", "clusters are for containers")
            complaint(of('shape = "cross"').replace("gravity = 0.002", ""), "bad.toml:18:1", "without gravity")
            complaint(of('shape = "cross"', more='[[stage]]\nkind = "press"\nname = "lid"\n'), "stage.lid.force")
            complaint(of('shape = "cross"').replace('"ratio"', '"hertz"\ndamping_ratio = 0.2'), "bad.toml:15:1",
                      "no constant damping ratio")

    def test_unknown_name(self):
        self.complaint(STUDY.replace('"gear5"', '"gear"'), "bad.toml:11:10", '"verlet", "gear5"', "gear5")

    def test_repeated_key(self):
        self.complaint(STUDY.replace("count = 64", "count = 64\ncount = 65"), "bad.toml:8:", "count")

    def test_broken_syntax(self):
        self.complaint(STUDY.replace("[grains]", "[grains"), "bad.toml:6:")

    def test_impossible_packing(self):
        self.complaint(STUDY.replace("to = 0.88", "to = 0.5"), "bad.toml:20:1", "compress.to", "packing fraction")

    def test_frames_outside_the_stage(self):
        self.complaint(STUDY.replace("[0.8]", "[0.95]"), "bad.toml:23:1", "frames_at", "0.95")

    def test_unknown_measure(self):
        self.complaint(STUDY + '[measure]\nlist = ["coordinaton"]\n', "coordination")

    def test_no_stage(self):
        self.complaint('[study]\nname = "a"\n', "stage")

    def test_command_line(self):
        self.assertIn("jamscape run", self.program("rum", code=2).stderr)
        self.assertIn("--help", self.program(code=2).stderr)
        self.program("run", code=2)
        error = self.program("run", "tiny.toml", "--jobs", "0", code=2).stderr
        self.assertIn("jamscape run --help", error)
        self.assertIn("i/n", self.program("run", "tiny.toml", "--shard", "3/2", code=2).stderr)
        self.assertIn("key=value", self.program("run", "tiny.toml", "--set", "friction", code=2).stderr)
        self.assertIn("no effect", self.program("run", "tiny.toml", "--set", "contact.friction=1", code=2).stderr)
        self.assertIn("did you mean", self.program("run", "tiny.toml", "--set", "grains.cuont=1", code=2).stderr)

    def test_missing_study(self):
        self.assertIn("none.toml", self.program("run", "none.toml", code=2).stderr)
        self.assertIn("did you mean 'quickstart'", self.program("run", "quikstart", code=2).stderr)

    def test_no_results(self):
        for command in ("status", "report", "score", "verify"):
            self.assertIn("study.toml", self.program(command, ".", code=2).stderr)

    def test_folder_of_something_else(self):
        (self.folder / "out").mkdir()
        self.write("out/thesis.txt", "do not touch")
        before = self.files("out")
        self.assertIn("--out", self.program("run", "tiny.toml", "--out", "out", code=2).stderr)
        self.assertEqual(self.files("out"), before)

    def test_folder_of_another_study(self):
        self.program("run", "tiny.toml", "--out", "out", "--set", "study.realisations=1", "--quiet")
        before = self.files("out")
        for change, part in (('name = "tiny"', 'name = "other"'), ("seed = 3", "seed = 4"),
                             ("contact.friction = 0.5", "contact.friction = 0.4")):
            self.write("other.toml", STUDY.replace(change, part))
            error = self.program("run", "other.toml", "--out", "out", code=2).stderr
            self.assertIn("out", error)
            self.assertIn("--out", error)
            self.assertEqual(self.files("out"), before)
        self.assertIn("contact.friction", error)

    def test_unreadable_inputs(self):
        self.write("cut.csv", "i,j,force\n0,1,2.5\n1,2\n")
        self.assertIn("cut.csv:3", self.program("persistence", "cut.csv", code=3).stderr)
        self.write("minus.csv", "i,j,force\n0,1,-2.5\n")
        self.assertIn("minus.csv:2", self.program("persistence", "minus.csv", code=3).stderr)
        self.program("persistence", "none.csv", code=3)
        self.write("run.h5", "this is no HDF5 file")
        self.program("measure", "run.h5", code=3)


if __name__ == "__main__":
    unittest.main()
