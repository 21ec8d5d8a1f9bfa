"""Seeds one fault after the other into a small tree and expects scripts/check_layers to name it."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "scripts" / "check_layers"
TABLE = "ground:\nleft: ground\nright: ground\ntop: left\n"
CLEAN = {
    "cmake/layers.txt": TABLE,
    "ground/a.h": "#pragma once\n#include <vector>\n",
    "left/b.h": "#pragma once\n#include <ringwatch/ground/a.h>\n// #include <ringwatch/top/d.h>\n",
    "right/c.h": "/* using namespace std; */\n#pragma once\n",
    "top/d.h": "#pragma once\n#include <ringwatch/ground/a.h>\n#include <ringwatch/left/b.h>\n",
    "top/d.cpp": '#include "d.h"\nusing namespace std;\n',
    "top/CMakeLists.txt": "ringwatch_folder(top LINKS ringwatch::left)\n",
    "tests/top/test.cpp": "#include <ringwatch/right/c.h>\n#include <ringwatch/top/d.h>\n",
}


def check(changes):
    """Exit status and output of the check on the clean tree with `changes` (path -> text) applied."""
    with tempfile.TemporaryDirectory() as folder:
        for path, text in {**CLEAN, **changes}.items():
            file = pathlib.Path(folder, path)
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text)
        done = subprocess.run([sys.executable, SCRIPT, "--root", folder], capture_output=True, text=True)
        return done.returncode, done.stdout + done.stderr


class CheckLayers(unittest.TestCase):
    def expect(self, status, text, changes):
        found_status, output = check(changes)
        self.assertEqual(found_status, status, output)
        self.assertIn(text, output)

    def test_clean_tree_passes(self):
        self.assertEqual(check({}), (0, ""))

    def test_include_from_above(self):
        self.expect(1, "ground/a.h:2: ground may not include left",
                    {"ground/a.h": "#pragma once\n#include <ringwatch/left/b.h>\n"})

    def test_include_from_the_side(self):
        self.expect(1, "right/e.cpp:1: right may not include left", {"right/e.cpp": "# include <ringwatch/left/b.h>\n"})

    def test_quoted_include(self):
        self.expect(1, "left/e.cpp:1: left may not include top", {"left/e.cpp": '#include "../top/d.h"\n'})

    def test_template_of_a_source(self):
        self.expect(1, "left/e.cpp.in:1: left may not include top", {"left/e.cpp.in": "#include <ringwatch/top/d.h>\n"})

    def test_include_that_skips_a_layer_aside(self):
        self.expect(1, "top/e.h:2: top may not include right; cmake/layers.txt allows it ground, left",
                    {"top/e.h": "#pragma once\n#include <ringwatch/right/c.h>\n"})

    def test_include_of_a_subfolder_that_is_not_allowed(self):
        subfolders = {"cmake/layers.txt": TABLE + "top/lower:\ntop/upper: top/lower\n",
                 "top/lower/a.h": "#pragma once\n#include <ringwatch/top/d.h>\n",
                 "top/upper/b.h": "#pragma once\n#include <ringwatch/top/lower/a.h>\n"}
        self.assertEqual(check(subfolders), (0, ""))
        self.expect(1, "top/lower/c.h:2: top/lower may not include top/upper; cmake/layers.txt allows it no other subfolder",
                    {**subfolders, "top/lower/c.h": "#pragma once\n#include <ringwatch/top/upper/b.h>\n"})
        self.expect(1, "top/other/c.h:2: top/other may not include top/upper",
                    {**subfolders, "top/other/c.h": "#pragma once\n#include <ringwatch/top/upper/b.h>\n"})
        self.expect(2, "layers.txt:5: 'top/lower' names 'left', which is not on a line above",
                    {"cmake/layers.txt": TABLE + "top/lower: left\n"})

    def test_link_from_above(self):
        self.expect(1, "left/CMakeLists.txt:1: left may not link top",
                    {"left/CMakeLists.txt": "ringwatch_folder(left LINKS ringwatch::top)\n"})

    def test_header_without_pragma_once(self):
        self.expect(1, "left/e.h:1: a header starts with #pragma once", {"left/e.h": "struct E {};\n"})

    def test_using_namespace_in_header(self):
        self.expect(1, "left/e.h:2: no 'using namespace'", {"left/e.h": "#pragma once\nusing namespace std;\n"})

    def test_path_of_one_machine(self):
        self.expect(1, "README.md:2: a path of one machine", {"README.md": "Build it\nin /" + "home/somebody/code\n"})

    def test_cycle_in_the_table(self):
        self.expect(2, "layers.txt:1: 'ground' names 'top', which is not on a line above",
                    {"cmake/layers.txt": TABLE.replace("ground:", "ground: top", 1)})


if __name__ == "__main__":
    unittest.main()
