"""Seeds one fault after the other into a copy of the examples of extensions and expects scripts/check_extensions to name
it."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCRIPT = ROOT / "scripts" / "check_extensions"
PROGRAM = "tests/app/registering_program.cpp"
CLEAN = {PROGRAM: (ROOT / PROGRAM).read_text(),
         **{f"tests/added/{path.name}": path.read_text() for path in (ROOT / "tests/added").iterdir()},
         "elements/registry.h": "#pragma once\n"}


def check(changes):
    """Exit status and output of the check on the clean tree with `changes` (path -> text) applied."""
    with tempfile.TemporaryDirectory() as folder:
        for path, text in {**CLEAN, **changes}.items():
            file = pathlib.Path(folder, path)
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text)
        done = subprocess.run([sys.executable, SCRIPT, "--root", folder], capture_output=True, text=True)
        return done.returncode, done.stdout + done.stderr


def program(old, new):
    assert old in CLEAN[PROGRAM]
    return {PROGRAM: CLEAN[PROGRAM].replace(old, new)}


class CheckExtensions(unittest.TestCase):
    def expect(self, text, changes):
        status, output = check(changes)
        self.assertEqual(status, 1, output)
        self.assertIn(text, output)

    def test_examples_pass(self):
        status, output = check({})
        self.assertEqual(status, 0, output)
        self.assertEqual(output, "7 extensions of 7 kinds: one file and one line each\n")

    def test_library_that_knows_an_element(self):
        self.expect("elements/registry.h:2: names Wedge15", {"elements/registry.h": "#pragma once\nstruct Wedge15;\n"})

    def test_library_that_asks_for_a_name(self):
        self.expect('handlers/a.cpp:1: names "log-mooney-rivlin"', {"handlers/a.cpp": 'if (law == "log-mooney-rivlin") f();\n'})

    def test_a_second_line(self):
        line = "  registerElement<test::Wedge15>();\n"
        self.expect("neither a registration", program(line, line + "  setUpWedges();\n"))

    def test_a_second_registration(self):
        line = "  registerElement<test::Wedge15>();\n"
        self.expect("Wedge15 is registered a second time", program(line, line + line))

    def test_a_kind_without_example(self):
        self.expect("registers no Element", program("  registerElement<test::Wedge15>();\n", ""))

    def test_a_second_file(self):
        self.expect("tests/added/wedge_points.h:1: holds 0", {"tests/added/wedge_points.h": "#pragma once\n"})

    def test_a_file_that_needs_another(self):
        text = "#include <tests/support/meshes.h>\n" + CLEAN["tests/added/wedge15.h"]
        self.expect("tests/added/wedge15.h:1: takes more", {"tests/added/wedge15.h": text})

    def test_two_of_one_file(self):
        text = CLEAN["tests/added/wedge15.h"] + "struct TwoHalves {};\n"
        self.expect("TwoHalves is declared in 2 files", {"tests/added/wedge15.h": text})


if __name__ == "__main__":
    unittest.main()
