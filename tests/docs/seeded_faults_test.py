"""Seeds one fault after the other into the documents and expects documents_test.py and snippets.py to name it.

usage: seeded_faults_test.py PROGRAM
"""
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
SOURCE = HERE.parents[1]
PROGRAM = sys.argv.pop()


def tree(folder, document, old, new):
    """The repository in a folder, by links, with one text of one file replaced."""
    copied = {"README.md", "CONTRIBUTING.md", "docs", document.split("/")[0]}
    for entry in SOURCE.iterdir():
        if entry.name not in copied:
            (folder / entry.name).symlink_to(entry)
        elif entry.is_dir():
            shutil.copytree(entry, folder / entry.name)
        else:
            shutil.copy(entry, folder)
    path = folder / document
    text = path.read_text(encoding="utf-8")
    assert old in text, f"{document} has no {old}"
    path.write_text(text.replace(old, new, 1), encoding="utf-8")


class SeededFaults(unittest.TestCase):
    def expect(self, check, message, document, old, new, *pages):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            tree(folder, document, old, new)
            if check == "snippets":
                command = [sys.executable, HERE / "snippets.py", folder, folder / "out.cpp"]
            elif check in ("theorems", "spelling"):
                command = [sys.executable, HERE / f"{check}_test.py", folder]
            else:
                command = [sys.executable, HERE / "documents_test.py", check, folder, PROGRAM, *pages]
            done = subprocess.run(command, capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
            self.assertIn(message, done.stdout + done.stderr)

    def test_links(self):
        self.expect("links", "the link docs/images/none.png leads nowhere", "README.md", "docs/images/stretch_bar.png",
                    "docs/images/none.png")
        self.expect("links", "the link integrators.md#theorem-27 leads nowhere", "docs/theory/notation.md",
                    "](integrators.md)", "](integrators.md#theorem-27)")
        self.expect("links", "there is no docs/none.md", "docs/python.md", "`docs/gpu.md`", "`docs/none.md`")

        self.expect("links", "there is no folder nowhere/", "CONTRIBUTING.md", "`docs/`", "`docs/`, `nowhere/`")
        self.expect("links", "there is no handlers/registry.h", "CONTRIBUTING.md", "`handlers/registry.cpp`",
                    "`handlers/registry.h`")
        self.expect("links", "rooms of folders", "CONTRIBUTING.md", "`handlers/fe_pbd/`, ", "")

    def test_invocations(self):
        self.expect("lists", "there is no such topic", "README.md", "`ringwatch help scene`", "`ringwatch help sceen`")
        self.expect("lists", "there is no such command", "README.md", "ringwatch inspect bar.msh", "ringwatch look bar.msh")
        self.expect("lists", "there is no option --globally", "README.md", "--global", "--globally")
        self.expect("lists", "there is no study element", "README.md", "ringwatch verify elements", "ringwatch verify element")

    def test_scene_keys(self):
        self.expect("lists", "a scene has no key handler.methods", "docs/handlers.md", 'method = "imex"', 'methods = "imex"')
        self.expect("lists", "a scene has no key handler.methods", "README.md", "`[handler] method =", "`[handler] methods =")
        self.expect("lists", "a scene has no key monitor.evry", "docs/gpu.md", "`monitor.every`", "`monitor.evry`")
        self.expect("lists", "handler.selection cannot be single", "docs/handlers.md", '"element-frequency"', '"single"')

        self.expect("lists", "handler.margin is not valid: 1.5", "docs/handlers.md", "margin = 0.1", "margin = 1.5")
        self.expect("lists", "'fast' is not", "docs/handlers.md", "step = 1.2e-4", 'step = "fast"')
        self.expect("lists", "is no TOML", "docs/run.md", "young = 30e3", "young = 30 e3")
        self.expect("lists", "integrator is not valid: Additional properties are not allowed ('methods'", "docs/run.md", "method = ", "methods = ")

    def test_outputs(self):
        self.expect("commands", "the output does not go on with this line:   optimistic", "docs/inspect.md", "0.0006436527321 s",
                    "0.0006446527321 s", "docs/inspect.md")
        self.expect("commands", "dolfinx_adapter.py does not go on with this line", "docs/foreign_solvers.md", "self.form =", "self.forms =",
                    "docs/foreign_solvers.md")

    def test_words(self):
        self.expect("words", '"busy": give the load', "docs/monitor.md", "## Modes", "The machine was busy.\n\n## Modes")

    def test_spelling(self):
        if not shutil.which("hunspell"):
            self.skipTest("hunspell is missing")
        right, wrong = "at every observation |", "at every obervation |"
        lines = (SOURCE / "docs/monitor.md").read_text(encoding="utf-8").splitlines()
        number = next(at for at, line in enumerate(lines, 1) if right in line)
        self.expect("spelling", f"docs/monitor.md:{number}: obervation", "docs/monitor.md", right, wrong)

    def test_theorems(self):
        self.expect("theorems", "there is no Theorem 99", "monitor/exact_step.h", "Theorem 8,", "Theorem 99,")
        self.expect("theorems", "Theorem 8 is in docs/theory/rings_and_rayleigh.md, not in docs/theory/exchange.md",
                    "monitor/exact_step.h", "docs/theory/rings_and_rayleigh.md", "docs/theory/exchange.md")
        self.expect("theorems", "monitor/bounds.h:9: states a bound and names no theorem", "monitor/bounds.h",
                    "(Theorem 27, docs/theory/integrators.md)", "(docs/theory/integrators.md)")
        self.expect("theorems", "theorems are not numbered 1 to ", "docs/theory/exchange.md", "## Theorem 12:", "## Claim:")
        self.expect("theorems", "exchange.md has the theorems [12, 13], not 12, 14", "docs/theory/README.md", "| 12, 13 |", "| 12, 14 |")
        self.expect("theorems", "lines of the theorems [12] are missing", "docs/theory/README.md", "| [12](", "| 12 (")

    def test_names(self):
        self.expect("lists", "handlers: the document has", "README.md", ", `modal-filter`", "")
        self.expect("lists", "the handlers are", "docs/handlers.md", ', "modal-filter"', "")
        self.expect("lists", "has no row of metrics", "README.md", "| metrics |", "| estimates |")
        self.expect("lists", "laws: the document has", "README.md", "`corotational`, ", "")
        self.expect("lists", "mesh formats: the document has", "README.md", ", `.inp`", "")
        self.expect("lists", "elements: the document has", "docs/elements.md", "| `hex20` | 20", "| `hex27` | 20")
        self.expect("lists", "the rules of wedge6 are", "docs/elements.md", "`gauss-3x2`, `fierz2013`", "`fierz2013`")
        self.expect("lists", "monitor.mode: the document has", "docs/monitor.md", "| `threshold` |", "| `certify` |")
        self.expect("lists", "the handler modal-filter has no section", "docs/handlers.md", "## modal-filter", "## filters")

    def test_versions(self):
        self.expect("lists", "the version is not 0.2.0", "CITATION.cff", "version: 0.2.0", "version: 0.1.0")
        self.expect("lists", "does not say that this is version 0.2", "README.md", "Version 0.2:", "Version 0.1:")

    def test_results(self):
        self.expect("lists", "its first table has no row compiler", "bench/results/2026-11-24-amd-epyc-2-cores/README.md", "| compiler |", "| language |")
        self.expect("lists", "does not list 2026-11-24-nvidia-h100", "bench/results/README.md", "](2026-11-24-nvidia-h100/README.md)", "](README.md)")

    def test_snippets(self):
        self.expect("snippets", "has no context", "docs/monitor.md", "## Modes", "```cpp\nint i;\n```\n## Modes")
        self.expect("snippets", "there is no snippet 0 any more", "README.md", "```cpp", "```text")
        self.expect("snippets", "is not examples/embed_minimal.cpp", "README.md", "h = 2e-3;", "h = 3e-3;")


if __name__ == "__main__":
    unittest.main()
