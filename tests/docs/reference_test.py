#!/usr/bin/env python3
"""Holds what `ringwatch reference` writes to the repository and to the programs that read it.

usage: reference_test.py SOURCE_DIR PROGRAM
"""
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

PROGRAM = sys.argv.pop()
SOURCE = pathlib.Path(sys.argv.pop())


def run(*command, **options):
    return subprocess.run(command, capture_output=True, text=True, check=False, **options)


class Reference(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.share = pathlib.Path(cls.folder.name) / "share"
        done = run(PROGRAM, "reference", cls.share)
        assert done.returncode == 0, done.stderr
        cls.pages = cls.share / "doc/ringwatch/reference"
        cls.bash = cls.share / "bash-completion/completions/ringwatch"
        cls.zsh = cls.share / "zsh/site-functions/_ringwatch"

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_the_repository_has_the_pages_of_this_program(self):
        if "implicit-euler" not in run(PROGRAM, "help", "integrators").stdout:
            self.skipTest("built without SUNDIALS")
        written = {p.name: p.read_text(encoding="utf-8") for p in self.pages.glob("*.md")}
        here = {p.name: p.read_text(encoding="utf-8") for p in (SOURCE / "docs/reference").iterdir()}
        self.assertEqual(sorted(written), sorted(here), "run scripts/reference")
        for name, text in written.items():
            self.assertEqual(text, here[name], f"docs/reference/{name} is not what this program writes: run scripts/reference")

    def test_schemas_are_schemas_and_accept_the_examples(self):
        sys.path.append("/usr/lib/python3/dist-packages")  # where Debian has it, whichever python3 comes first
        import jsonschema
        import tomllib
        schemas = {p.name: json.loads(p.read_text(encoding="utf-8")) for p in self.pages.glob("*.schema.json")}
        self.assertGreaterEqual(len(schemas), 5)
        for name, schema in schemas.items():
            jsonschema.Draft7Validator.check_schema(schema)
            self.assertEqual(json.loads(run(PROGRAM, "schema", name.split(".")[0]).stdout), schema)
        scene = jsonschema.Draft7Validator(schemas["scene.schema.json"])
        examples = sorted((SOURCE / "examples").glob("*.toml"))
        self.assertGreaterEqual(len(examples), 5)
        for path in examples:
            self.assertEqual([e.message for e in scene.iter_errors(tomllib.loads(path.read_text(encoding="utf-8")))], [], path)

    def test_the_manual_page_is_well_formed(self):
        if not shutil.which("groff"):
            self.skipTest("no groff")
        page = self.share / "man/man1/ringwatch.1"
        done = run("groff", "-man", "-ww", "-z", "-K", "utf8", page)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        text = run("groff", "-man", "-Tascii", "-K", "utf8", "-P-c", page).stdout
        text = re.sub(r".\x08", "", text)  # bold
        for word in ("ringwatch inspect MESH", "--certificate FILE", "EXIT STATUS", "mesh generate"):
            self.assertIn(word, text)

    def complete(self, *words):
        script = ('source "$1"; shift; COMP_WORDS=("$@"); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _ringwatch; '
                  'printf "%s\\n" "${COMPREPLY[@]}"')
        done = run("bash", "-c", script, "bash", self.bash, "ringwatch", *words, cwd=SOURCE)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return done.stdout.split()

    def test_bash_completes(self):
        self.assertEqual(run("bash", "-n", self.bash).returncode, 0)
        self.assertEqual(self.complete("insp"), ["inspect"])
        self.assertEqual(self.complete("mesh", "ch"), ["check"])
        self.assertEqual(self.complete("inspect", "--integr"), ["--integrator"])
        self.assertEqual(self.complete("inspect", "--integrator", "verl"), ["verlet"])
        self.assertEqual(self.complete("inspect", "bar.msh", "--lumping", "row"), ["row-sum"])
        self.assertEqual(self.complete("schema", "sum"), ["summary"])
        self.assertEqual(self.complete("help", "integ"), ["integrators"])
        self.assertEqual(self.complete("verify", "robust"), ["robustness"])
        self.assertEqual(self.complete("mesh", "generate", "gra"), ["graded"])
        self.assertEqual(self.complete("run", "examples/stretch_b"), ["examples/stretch_bar.toml"])
        self.assertEqual(self.complete("inspect", "--young", "x"), [])

    def test_zsh_reads_its_completion(self):
        if not shutil.which("zsh"):
            self.skipTest("no zsh")
        done = run("zsh", "-f", "-c", f"autoload -U compinit; compinit -D; source {self.zsh}; whence -w _ringwatch_mesh_generate")
        self.assertIn("function", done.stdout, done.stderr)


if __name__ == "__main__":
    unittest.main()
