"""The check of the floors against small made-up trees: it must stay silent on a good one and name every breach."""
import tempfile
import unittest
from pathlib import Path

import check_layers

GOOD = {
    "CMakeLists.txt": "add_subdirectory(src/jamscape/low)\nadd_subdirectory(src/jamscape/high)\n",
    "src/jamscape/low/CMakeLists.txt": "jam_module(low)\n",
    "src/jamscape/low/README.md": "low\n",
    "src/jamscape/low/a.hpp": "// a\n#pragma once\n#include <vector>\n",
    "src/jamscape/high/CMakeLists.txt": "jam_module(high\n  USES low # and no other\n  LINKS fmt::fmt)\n",
    "src/jamscape/high/README.md": "high\n",
    "src/jamscape/high/b.hpp": '#pragma once\n#include "jamscape/low/a.hpp"\n',
    "src/jamscape/high/b.cpp": '#include "jamscape/high/b.hpp"\n',
}


class CheckLayers(unittest.TestCase):
    def findings(self, changes):
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder)
            for name, text in {**GOOD, **changes}.items():
                if text is not None:
                    (root / name).parent.mkdir(parents=True, exist_ok=True)
                    (root / name).write_text(text)
            return check_layers.check(root)

    def expect(self, changes, *parts):
        found = self.findings(changes)
        self.assertEqual(len(found), 1, found)
        for part in parts:
            self.assertIn(part, found[0])

    def test_a_good_tree_has_no_findings(self):
        self.assertEqual(self.findings({}), [])

    def test_include_from_a_module_not_used(self):
        self.expect({"src/jamscape/low/c.cpp": '\n#include "jamscape/high/b.hpp"\n'},
                    "src/jamscape/low/c.cpp:2:", "low USES no high")

    def test_use_of_a_module_above(self):
        self.expect({"src/jamscape/low/CMakeLists.txt": "jam_module(low\n USES high)\n"},
                    "src/jamscape/low/CMakeLists.txt:2:", "not below it", "CMakeLists.txt:2")

    def test_use_of_something_that_is_no_module(self):
        self.expect({"src/jamscape/low/CMakeLists.txt": "jam_module(low USES other)\n"}, ":1:", "no module")

    def test_include_that_does_not_exist(self):
        self.expect({"src/jamscape/high/b.cpp": '#include "jamscape/high/nowhere.hpp"\n'},
                    "src/jamscape/high/b.cpp:1:", "there is no")

    def test_include_that_does_not_start_at_the_root(self):
        self.expect({"src/jamscape/high/b.cpp": '#include "b.hpp"\n'}, "b.cpp:1:", "from the root")

    def test_header_without_pragma_once(self):
        self.expect({"src/jamscape/low/a.hpp": "int a();\n"}, "src/jamscape/low/a.hpp:1:", "#pragma once")

    def test_module_without_readme(self):
        self.expect({"src/jamscape/low/README.md": None}, "src/jamscape/low/README.md:1:", "missing")

    def test_module_that_the_floors_do_not_name(self):
        self.expect({"src/jamscape/new/CMakeLists.txt": "jam_module(new)\n"}, "CMakeLists.txt:1:", "module new")

    def test_programs_may_include_from_every_module(self):
        self.assertEqual(self.findings({"app/main.cpp": '#include "jamscape/high/b.hpp"\n'}), [])


if __name__ == "__main__":
    unittest.main()
