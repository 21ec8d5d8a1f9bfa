"""The page of scripts/web_page in a real browser, opened from disk without a network, against the command line.

  web_page_test.py PROGRAM

Builds the page first. Exit status 77 where there is no Emscripten or no Chromium: the test then counts as skipped.
"""
import json
import math
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from browser import Browser, find_chromium  # noqa: E402

SKIPPED = 77
SOURCE = pathlib.Path(__file__).resolve().parents[2]
PAGE = SOURCE / "build" / "web" / "ringwatch.html"
STEEL = ["--young", "210e9", "--poisson", "0.3", "--density", "7850"]  # what the page offers
# The two are compiled for other instructions, so that sums differ in their last bits; of the bracket, whose search ends where
# little is to be gained, 4e-7 was measured.
TOLERANCE = 1e-6
REPORT = "document.querySelector('iframe')?.contentWindow.ringwatchReport"

DYNA = """*KEYWORD
*NODE
{nodes}*ELEMENT_SOLID
       1       1       1       2       4       3       5       6       8       7
       2       1       5       6       8       7       9      10      12      11
*PART
bar
         1         1         1
*SECTION_SOLID
         1         2
*MAT_ELASTIC
         1      7850     2e+11       0.3
*END
"""


def true(value, what):
    if not value:
        raise AssertionError(what)


def same(found, expected, where=""):
    """The same JSON, numbers but for TOLERANCE; returns how many numbers were compared."""
    if isinstance(expected, dict):
        true(list(found) == list(expected), f"{where}: {list(found)}, not {list(expected)}")
        return sum(same(found[key], value, f"{where}.{key}") for key, value in expected.items())
    if isinstance(expected, list):
        true(len(found) == len(expected), f"{where}: {len(found)} entries, not {len(expected)}")
        return sum(same(a, b, f"{where}[{i}]") for i, (a, b) in enumerate(zip(found, expected)))
    if isinstance(expected, float):
        true(abs(found - expected) <= TOLERANCE * abs(expected), f"{where}: {found}, not {expected}")
        return 1
    true(found == expected, f"{where}: {found}, not {expected}")
    return isinstance(expected, int)


def said(page):
    return page.evaluate("document.querySelector('[role=status]').textContent")


def give(page, file):
    """Hands a file to the page's field, as a user does by a click, and waits for what the page says of it."""
    page.evaluate("document.getElementById('file').dispatchEvent(new Event('click'))")
    page.call("DOM.enable")
    root = page.call("DOM.getDocument")["root"]["nodeId"]
    field = page.call("DOM.querySelector", nodeId=root, selector="#file")["nodeId"]
    page.call("DOM.setFileInputFiles", nodeId=field, files=[str(file)])
    page.wait_for("!/computing|^$/.test(document.querySelector('[role=status]').textContent)", 120)


def inspected(program, file, *options):
    result = subprocess.run([program, "inspect", file.name, *options, "--distribution", "--json", "-"], cwd=file.parent,
                            check=False, capture_output=True, text=True)
    return json.loads(result.stdout) if result.returncode == 0 else result.stderr.removeprefix("ringwatch: ").strip()


def check_numbers(page, program, file, *options):
    give(page, file)
    expected = inspected(program, file, *options)
    true(isinstance(expected, dict), expected)
    page.wait_for("!!(document.querySelector('.bad') || document.querySelector('iframe')?.contentDocument.querySelector('h2'))")
    true(page.evaluate("typeof ringwatchInspection") == "object", f"{file.name}: the page says {said(page)}")
    true(same(page.evaluate("ringwatchInspection"), expected, file.name) > 100, "few numbers were compared")
    verdict = page.evaluate("document.querySelector('iframe').contentDocument.querySelector('h2').textContent")
    true(said(page) == f"{file.name}: {verdict}", said(page))


def check_report(page):
    """The ten worst elements, in space; the distribution; the rules, of which some are in the numbers of `inspect` too."""
    page.wait_for(f"{REPORT}?.ready === true", 60)
    cards, pictures = page.evaluate("""(() => {
      const report = document.querySelector('iframe').contentDocument;
      report.querySelector('.show-me').click();
      return [report.querySelectorAll('.card .show-me').length, report.querySelectorAll('#distribution svg').length];
    })()""")
    true(cards >= 10 and pictures > 0, f"{cards} cards of elements, {pictures} pictures")
    known = page.evaluate("ringwatchInspection.critical_step.metrics")
    rules = {rule["metric"]: rule["step"] for rule in page.evaluate(f"{REPORT}.report.analysis.rules")}
    both = rules.keys() & known.keys()
    true(both and len(rules) > len(both), f"rules: {list(rules)}")
    same([rules[name] for name in both], [known[name] for name in both], "rules")
    shown = page.evaluate(f"[{REPORT}.mesh.state().selected, Number(document.querySelector('iframe').contentDocument"
                          ".querySelector('.show-me').dataset.element)]")
    true(shown[0] == shown[1], f"element {shown[0]} is shown, not {shown[1]}")


def check_units(page, program, folder):
    """The page knows the systems that scenes know; its numbers and labels are those of the command line, without a conversion."""
    schema = json.loads(subprocess.run([program, "schema", "scene"], check=True, capture_output=True, text=True).stdout)
    names = page.evaluate("[...document.getElementById('units').options].map(option => option.value)")
    true(names == schema["properties"]["units"]["properties"]["system"]["enum"], f"systems of units: {names}")
    page.evaluate("""['step', 'fix'].forEach(id => document.getElementById(id).value = '');
      const units = document.getElementById('units'); units.value = 'mm-kg-ms'; units.dispatchEvent(new Event('change'))""")
    check_numbers(page, program, folder / "part.vtu", "--young", "210", "--poisson", "0.3", "--density", "7.85e-6", "--units", "mm-kg-ms")
    text = page.evaluate("document.querySelector('iframe').contentDocument.body.innerText")
    true(re.search(r"\d ms\b", text) and not re.search(r"\d (s|m|Pa)\b|\((s|m|Pa)\)", text), "labels of the SI in the page")


def check_chosen_again(page, program, file):
    """A file that has changed is refused until it is chosen again, which is no change of its name."""
    give(page, file)
    file.write_text(file.read_text() + "\n\n")
    page.evaluate("document.querySelector('form').requestSubmit()")
    page.wait_for("document.querySelector('.bad')?.textContent.includes('choose it again')")
    check_numbers(page, program, file, *STEEL)


def check_refusals(page, program, folder):
    broken = folder / "broken.msh"
    broken.write_text((folder / "part.msh").read_text()[:5000])
    give(page, broken)
    true(said(page) == inspected(program, broken, *STEEL), said(page))
    page.evaluate("""(() => {
      const dataTransfer = new DataTransfer();
      dataTransfer.items.add(new File(['no mesh'], 'dropped.msh'));
      dispatchEvent(new DragEvent('drop', {dataTransfer}));
    })()""")
    page.wait_for("document.querySelector('.bad')?.textContent.startsWith('dropped.msh:1:')")
    page.evaluate("document.getElementById('young').value = 'stiff'")
    give(page, folder / "part.msh")
    true('"stiff" is no number' in said(page), said(page))


def main():
    program, chromium = pathlib.Path(sys.argv[1]).resolve(), find_chromium()
    if chromium is None or shutil.which("emcc") is None:
        print("skipped: there is no Chromium or no Emscripten; scripts/setup --browser --web installs them")
        return SKIPPED
    subprocess.run([SOURCE / "scripts" / "web_page"], check=True)
    with tempfile.TemporaryDirectory() as name, Browser(chromium) as page:
        folder = pathlib.Path(name)
        subprocess.run([program, *"mesh generate bar --cells 8 3 3 --jitter 0.3 -o part.msh".split()], cwd=folder, check=True)
        subprocess.run([program, *"mesh convert part.msh part.vtu".split()], cwd=folder, check=True)
        nodes = "".join(f"{1 + i:8d}{i % 2:16d}{i // 2 % 2:16d}{i // 4:16d}\n" for i in range(12))
        (folder / "part.k").write_text(DYNA.format(nodes=nodes))
        # No two elements alike, of which rounding would choose one.
        (folder / "bar.inp").write_text(re.sub(
            r"^(\d+)((?:, [-\d.e]+){3})$", lambda node: f"{node[1]}" + "".join(
                f", {float(x) + 1e-3 * math.sin(7 * int(node[1]) + i)}" for i, x in enumerate(node[2].split(",")[1:])),
            (SOURCE / "tests" / "foreign" / "pulled_bar.inp").read_text(), flags=re.M))
        page.open(PAGE)
        check_numbers(page, program, folder / "part.msh", *STEEL)
        check_report(page)
        check_numbers(page, program, folder / "part.vtu", *STEEL)
        check_numbers(page, program, folder / "part.k")
        check_numbers(page, program, folder / "bar.inp")
        check_chosen_again(page, program, folder / "part.msh")
        page.evaluate("document.getElementById('step').value = '1e-5'; document.getElementById('fix').value = 'x < 1e-6'")
        check_numbers(page, program, folder / "part.msh", *STEEL, "--step", "1e-5", "--fix", "x < 1e-6")
        check_units(page, program, folder)
        check_refusals(page, program, folder)
        true(page.said() == [] and page.requests() == [], f"messages {page.said()}, requests {page.requests()}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
