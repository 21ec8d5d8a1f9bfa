"""The page of a run in a real browser: opened from disk without a network, its controls do what they say.

  report_page_test.py NAME PROGRAM [AXE]

NAME is one of the checks below. Exit status 77 where there is no browser, or for `accessible` no axe-core (AXE is its
axe.min.js): the test then counts as skipped. `scripts/setup --browser` installs the browsers.
"""
import json
import os
import pathlib
import pty
import re
import select
import signal
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from browser import Browser, find_chromium  # noqa: E402
from firefox import Firefox, find_firefox  # noqa: E402

SKIPPED = 77
READY = "globalThis.ringwatchReport?.ready === true"

SCENE = """[mesh]
generate = "bar"
size = [0.1, 0.02, 0.02]
cells = [10, 2, 2]
jitter = 0.15
[material]
model = "stvk"
young = 30e3
poisson = 0.3
density = 1000
[integrator]
step = 9e-4
end = 0.05
[monitor]
on_violation = "warn"
[[fix]]
where = "x < 1e-6"
[[move]]
where = "x > 0.1 - 1e-6"
velocity = [0.5, 0, 0]
[output]
every = 5e-3
fields = ["critical_step", "verdict", "handler"]
picture = false
"""


def equal(found, expected, what):
    if found != expected:
        raise AssertionError(f"{what}: {found}, not {expected}")


def true(value, what):
    if not value:
        raise AssertionError(what)


def make_run(program, folder):
    (folder / "bar.toml").write_text(SCENE)
    result = subprocess.run([program, "run", "bar.toml", "--out", "run", "--report", "--quiet"], cwd=folder, check=False)
    true(result.returncode in (0, 1), f"the run ended with {result.returncode}")
    return folder / "run"


def check_opens(browser, chromium, run):
    """From disk, with the network off: no message on the console, no request; both colour schemes, wide and narrow."""
    del browser
    for width, dark in ((1200, False), (1200, True), (380, False), (380, True)):
        with Browser(chromium, width, 900, dark) as page:
            page.open(run / "report.html")
            page.wait_for(READY)
            equal(page.said(), [], f"messages at width {width}")
            equal(page.requests(), [], f"requests at width {width}")
            true(page.evaluate("document.documentElement.scrollWidth <= innerWidth"), f"wider than {width} pixels")


def check_still(browser, chromium, run):
    """Without scripts: verdict, two pictures and tables."""
    del browser
    with Browser(chromium, scripts=False) as page:
        page.open(run / "report.html")
        root = page.call("DOM.getDocument")["root"]["nodeId"]

        def shown(selector):
            """Width and height of what a selector finds, as drawn."""
            node = page.call("DOM.querySelector", nodeId=root, selector=selector)["nodeId"]
            model = page.call("DOM.getBoxModel", nodeId=node)["model"]
            return model["width"], model["height"]

        for selector in ("#verdict .lead", "#history-static svg", "#mesh-static svg image", "#distribution svg",
                         "#what-if table", "#history table", ".card svg"):
            width, height = shown(selector)
            true(width > 40 and height > 10, f"{selector} is {width} by {height}")


def check_mesh(browser, chromium, run):
    """Threshold, frames, cards and cut show what the run's own numbers say."""
    del chromium
    summary = json.loads((run / "summary.json").read_text())
    total = sum(summary["mesh"]["elements"].values())
    browser.open(run / "report.html")
    browser.wait_for(READY)
    state = "ringwatchReport.mesh.state()"
    equal(browser.evaluate(f"{state}.shown"), 0, "elements shown at first")
    report = json.loads(browser.evaluate("document.getElementById('report').textContent"))

    # The threshold by keyboard: at its end all elements but the largest may be shown, and every one between grows.
    browser.evaluate("document.querySelector('#mesh-live input[type=range]').focus()")
    shown = []
    for key in ("Home", *["ArrowRight"] * 12):
        browser.key(key)
        shown.append(browser.evaluate(f"{state}.shown"))
    equal(shown, sorted(shown), "elements below a growing threshold")
    browser.key("End")
    equal(browser.evaluate(f"{state}.shown"), total, "elements below the largest threshold")
    equal(browser.evaluate(f"{state}.drawnTriangles"), 4 * total, "triangles of them")

    # Between the fifth and the sixth of the ten worst steps five elements are below.
    steps = [card["step"] for card in report["worst"]]
    middle = next(i for i in range(9) if steps[i + 1] > 1.001 * steps[i])
    browser.evaluate(f"ringwatchReport.mesh.setThreshold({(steps[middle] * steps[middle + 1]) ** 0.5})")
    equal(browser.evaluate(f"{state}.shown"), middle + 1, "elements below a step between two of the worst")
    browser.evaluate("[...document.querySelectorAll('#mesh-live button')].find(b => b.textContent == 'Whole surface').click()")
    equal(browser.evaluate(f"{state}.shown"), 0, "elements after Whole surface")

    # Every card's button brings its element into the picture, in the colour of its step.
    for place in range(len(steps)):
        browser.evaluate(f"document.querySelectorAll('.show-me')[{place}].click()")
        element = browser.evaluate(f"Number(document.querySelectorAll('.show-me')[{place}].dataset.element)")
        browser.wait_for(f"{state}.selected === {element} && document.activeElement.tagName === 'CANVAS'")
        pixel = browser.evaluate(f"ringwatchReport.mesh.pixelOf({element})")
        equal((pixel["colour"][3], pixel["alone"][3]), (255, 255), f"what is drawn at element {element}")
        # Faces are shaded between 0.68 and 1; one more for the rounding of colours.
        true(all(0.68 * c - 1 <= found <= c + 1 for found, c in zip(pixel["alone"], pixel["expected"])),
             f"element {element} is {pixel['alone']}, not {pixel['expected']}")
        true(f"number {report['worst'][place]['id']} in the mesh" in browser.evaluate(
            "document.querySelector('#mesh-live [role=status]').textContent"), f"the numbers of element {element}")

    # Frames by keyboard, to the last one.
    frames = sum(len(group["frames"]) for group in report["mesh"]["groups"])
    browser.evaluate("[...document.querySelectorAll('#mesh-live label')].find(l => l.textContent.startsWith('Frame'))"
                     ".parentElement.querySelector('input').focus()")
    browser.key("Home")
    browser.wait_for(f"{state}.frame === 1")
    browser.key("End")
    browser.wait_for(f"{state}.frame === {frames}")

    # Half of a bar is cut off along x.
    browser.evaluate("ringwatchReport.mesh.setThreshold(0)")
    whole = browser.evaluate(f"{state}.surfaceTriangles")
    true(whole > 0, "a surface")
    browser.evaluate("(() => { const s = [...document.querySelectorAll('#mesh-live select')].at(-1); s.value = '0';"
                     " s.dispatchEvent(new Event('change')); })()")
    cut = browser.evaluate(f"{state}.drawnTriangles")
    true(0.3 * 4 * total < cut < 0.7 * 4 * total, f"{cut} triangles of {4 * total} are left of the cut bar")
    equal(browser.said(), [], "messages")


def check_history(browser, chromium, run):
    """Zoom and cursor over all pictures at once, and the saved CSV is the run's."""
    del chromium
    browser.open(run / "report.html")
    browser.wait_for(READY)
    begin, end = browser.evaluate("ringwatchReport.history.range()")
    press = "[...document.querySelectorAll('#history-live button')].find(b => b.textContent == '{}').click()"
    browser.evaluate(press.format("Closer"))
    low, high = browser.evaluate("ringwatchReport.history.range()")
    true(abs((high - low) - 0.5 * (end - begin)) < 1e-9 * (end - begin), "Closer shows half of the time")
    browser.evaluate(press.format("Later"))
    true(browser.evaluate("ringwatchReport.history.range()")[1] > high, "Later moves on")
    browser.evaluate(press.format("All"))
    equal(browser.evaluate("ringwatchReport.history.range()"), [begin, end], "All")
    browser.evaluate("document.querySelector('#history-live input[type=range]').focus()")
    browser.key("End")
    lines = (run / "history.csv").read_text().splitlines()
    last = lines[-1].split(",")
    readout = browser.evaluate("ringwatchReport.history.readout()")
    true(readout.startswith(f"step {last[0]} ·") and f"controlled by element {last[5]}" in readout, readout)
    # What a click on the button would save.
    browser.evaluate("""(() => { globalThis.saved = null; const make = URL.createObjectURL;
      URL.createObjectURL = blob => { blob.text().then(t => { globalThis.saved = t; }); return make(blob); };
      HTMLAnchorElement.prototype.click = () => {}; document.getElementById('save-history').click(); })()""")
    browser.wait_for("globalThis.saved !== null")
    saved = browser.evaluate("globalThis.saved").splitlines()
    equal(len(saved), len(lines), "rows saved")
    head, saved_head = lines[0].split(","), saved[0].split(",")
    for own, row in zip(lines[1:], saved[1:]):
        found, wanted = dict(zip(saved_head, row.split(","))), dict(zip(head, own.split(",")))
        for name, cell in wanted.items():
            true(found[name] == cell or float(found[name]) == float(cell), f"{name}: {found[name]}, not {cell}")
    browser.evaluate("globalThis.saved = null; document.getElementById('save-json').click()")
    browser.wait_for("globalThis.saved !== null")
    everything = json.loads(browser.evaluate("globalThis.saved"))
    equal(everything["summary"], json.loads((run / "summary.json").read_text()), "the summary saved")
    equal(len(everything["history"]["safe_s"]), len(lines) - 1, "rows in the JSON")
    equal(browser.said(), [], "messages")


MATERIAL = "--young 30e3 --poisson 0.3 --density 1000".split()


def make_inspection(program, folder):
    """A mesh with badly shaped elements, and its page."""
    subprocess.run([program, *"mesh generate bar --size 0.1 0.02 0.02 --cells 10 2 2 --jitter 0.3 -o bar.msh".split()],
                   cwd=folder, check=True, stdout=subprocess.DEVNULL)
    subprocess.run([program, *"inspect bar.msh --step 3e-3 --report mesh.html --json mesh.json --distribution".split(),
                    *MATERIAL], cwd=folder, check=True, stdout=subprocess.DEVNULL)
    return folder / "mesh.html"


def make_comparison(program, folder):
    (folder / "swing.toml").write_text(SCENE.split("[monitor]")[0] + "[[fix]]\nwhere = \"x < 1e-6\"\n[[initial]]\nwhere = "
                                       "\"x > -1\"\nvelocity = [0, 0.2, 0]\n")
    subprocess.run([program, *"compare swing.toml --integrators verlet,rk4 --step 4e-4,2e-4 --report compare.html "
                    "--set integrator.end=4e-3".split()], cwd=folder, check=True, stdout=subprocess.DEVNULL)
    return folder / "compare.html"


def check_other_pages(browser, chromium, run):
    """Pages of an inspection and of a comparison: they open in silence, fit, and their controls work."""
    del browser
    program, folder = os.environ["RINGWATCH"], run.parent
    inspection, comparison = make_inspection(program, folder), make_comparison(program, folder)
    for width, dark in ((1200, False), (380, True)):
        for file in (inspection, comparison):
            with Browser(chromium, width, 900, dark) as page:
                page.open(file)
                page.wait_for(READY)
                equal(page.said(), [], f"messages of {file.name} at width {width}")
                equal(page.requests(), [], f"requests of {file.name} at width {width}")
                true(page.evaluate("document.documentElement.scrollWidth <= innerWidth"), f"{file.name} is too wide")
    numbers = json.loads((folder / "mesh.json").read_text())
    with Browser(chromium) as page:
        page.open(inspection)
        page.wait_for(READY)
        # Below the step asked about are the elements whose reduced ring forbids it, as inspect counts them.
        page.evaluate("[...document.querySelectorAll('#mesh-live button')].find(b => b.textContent.startsWith('Below')).click()")
        equal(page.evaluate("ringwatchReport.mesh.state().shown"), numbers["ill_shaped"]["count"], "elements below")
        # Without the others, which may lie before it, an element has the colour of its step.
        page.evaluate("[...document.querySelectorAll('#mesh-live button')].find(b => b.textContent == 'Whole surface').click()")
        for place, worst in enumerate(numbers["worst_elements"][:3]):
            page.evaluate(f"document.querySelectorAll('.show-me')[{place}].click()")
            page.wait_for(f"ringwatchReport.mesh.state().selected === {worst['index']}")
            pixel = page.evaluate(f"ringwatchReport.mesh.pixelOf({worst['index']})")
            true(all(0.68 * c - 1 <= found <= c + 1 for found, c in zip(pixel["alone"], pixel["expected"])),
                 f"element {worst['index']} is {pixel['alone']}, not {pixel['expected']}")
        equal(page.said(), [], "messages")


def check_live(browser, chromium, run):
    """While a run goes on its page loads itself again, keeps what it showed, can be told to stay, and stays at the end."""
    del browser
    folder = run.parent
    scene = SCENE.replace("end = 0.05", "end = 1e6").replace("every = 5e-3", "every = 0.5").replace(
        "velocity = [0.5, 0, 0]", "velocity = [1e-9, 0, 0]")
    (folder / "long.toml").write_text(scene)
    live = folder / "live"
    with subprocess.Popen([os.environ["RINGWATCH"], "run", "long.toml", "--out", "live", "--live", "--quiet"],
                          cwd=folder) as process:
        try:
            end = time.monotonic() + 60
            while not (live / "report.html").exists() or not (live / "run.pvd").exists():
                true(time.monotonic() < end and process.poll() is None, "the run writes its page while it goes on")
                time.sleep(0.1)
            with Browser(chromium) as page:
                page.open(live / "report.html")
                page.wait_for(READY)
                true(page.evaluate("document.querySelector('#verdict-title').textContent").startswith("Running: "),
                     "the page says that the run goes on")
                step = "JSON.parse(document.getElementById('report').textContent).summary.steps"
                first = page.evaluate(step)
                # What is shown stays so: the part of the time, the place on the page.
                page.wait_for("ringwatchReport.mesh !== undefined", 60)
                whole = page.evaluate("ringwatchReport.history.range()[1]")
                page.evaluate("[...document.querySelectorAll('#history-live button')].find(b => b.textContent == 'Closer').click()")
                page.evaluate("scrollTo(0, 700)")
                # The picture follows when it is drawn next.
                page.wait_for("(range => range[1] - range[0] < 0.9 * %r)(globalThis.ringwatchReport?.history?.range() "
                              "?? [0, Infinity])" % whole, 60)
                seen = page.evaluate("ringwatchReport.history.range()")
                page.wait_for(f"globalThis.ringwatchReport?.ready === true && {step} > {first}", 60)
                again = page.evaluate("ringwatchReport.history.range()")
                true(all(abs(a - b) < 1e-6 * abs(b) + 1e-12 for a, b in zip(again, seen)), f"{again}, not {seen}")
                true(abs(page.evaluate("scrollY") - 700) < 60, "the page is where it was")
                # A reader may keep it.
                page.evaluate("document.getElementById('stay').click(); globalThis.kept = true")
                time.sleep(2.2 * page.evaluate("ringwatchReport.live.seconds"))
                true(page.evaluate("globalThis.kept === true"), "the page stays")
                equal(page.said(), [], "messages")
            process.send_signal(signal.SIGINT)
            equal(process.wait(60), 4, "the interrupted run's exit status")
        finally:
            process.kill()
    text = (live / "report.html").read_text()
    true('"reloadAfter":0' in text and "interrupted" in text, "the last page stays and says how the run ended")


def drawn_rows(picture):
    """The terminal picture's rows without their frame."""
    return [row.split("|")[1].replace("\x1b[K", "") for row in picture.splitlines() if re.match(r"^.{10} \|", row)]


def check_terminal(browser, chromium, run):
    """On a terminal --live shows progress, time left, the bracket and the monitor's cost, and clears it at the end."""
    del browser, chromium
    folder = run.parent
    # Longer than any machine needs to say how long it will take; the run is interrupted then.
    end = 400
    scene = SCENE.replace("end = 0.05", f"end = {end}").replace("every = 5e-3", "every = 100").replace(
        "velocity = [0.5, 0, 0]", "velocity = [1e-7, 0, 0]").replace("step = 9e-4", "step = 8e-4")
    (folder / "watched.toml").write_text(scene)
    main, terminal = pty.openpty()
    said, last, interrupted = b"", None, False
    with subprocess.Popen([os.environ["RINGWATCH"], "run", "watched.toml", "--out", "watched", "--live"], cwd=folder,
                          stderr=terminal, stdout=subprocess.DEVNULL) as process:
        os.close(terminal)
        while select.select([main], [], [], 120)[0]:
            try:
                part = os.read(main, 1 << 16)
            except OSError:
                break
            if not part:
                break
            said += part
            whole = [p for p in said.decode(errors="replace").split("\x1b[J")[:-1] if "wall time: monitor" in p]
            if not interrupted and len(whole) >= 2 and " left" in whole[-1] and any("#" in r for r in drawn_rows(whole[-1])):
                last, interrupted = whole[-1], True
                process.send_signal(signal.SIGINT)
        true(interrupted, "the run says how long it will take before it ends")
        equal(process.wait(60), 4, "the interrupted run's exit status")
    os.close(main)
    shares = [int(n) for n in re.search(r"wall time: monitor (\d+) %, force (\d+) %, output (\d+) %", last).groups()]
    true(98 <= sum(shares) <= 102, f"the shares of the wall time are {shares}")
    done, now, to, left = re.search(r"\] (\d+) %, t = (\S+) of (\S+) s, ([\d.]+) (?:s|min|h) left", last).groups()
    equal(float(to), float(end), "the end of the run")
    true(abs(int(done) - 100 * float(now) / end) <= 1 and float(left) >= 0, f"{done} % at t = {now} s, {left} left")
    true("h = 0.0008 s" in last and re.search(r"safe \S+ s, optimistic \S+ s, element 0:\d+", last), last)
    true(all(len(row.rstrip()) <= 1 + (int(done) + 1) / 100 * 68 for row in drawn_rows(last)), "nothing is drawn beyond now")
    true(said.decode().rstrip().endswith("\x1b[J"), "the terminal is left clean")


def check_firefox(browser, chromium, run):
    """The page in another browser: no error, its mesh and its history work."""
    del browser, chromium
    def said(page):
        """Messages, but for what the browser itself says of a machine without WebGL."""
        return [text for text in page.said() if not text.startswith("Failed to create WebGL context")]

    with Firefox(find_firefox()) as page:
        page.open(run / "report.html")
        page.wait_for(READY)
        equal(said(page), [], "messages")
        begin, end = page.evaluate("ringwatchReport.history.range()")
        page.evaluate("[...document.querySelectorAll('#history-live button')].find(b => b.textContent == 'Closer').click()")
        low, high = page.evaluate("ringwatchReport.history.range()")
        true(abs((high - low) - 0.5 * (end - begin)) < 1e-9 * (end - begin), "Closer shows half of the time")
        true(page.evaluate("document.documentElement.scrollWidth <= innerWidth"), "the page is too wide")
        if page.evaluate("ringwatchReport.mesh !== undefined"):
            report = json.loads(page.evaluate("document.getElementById('report').textContent"))
            page.evaluate("document.querySelectorAll('.show-me')[0].click()")
            page.wait_for(f"ringwatchReport.mesh.state().selected === {report['worst'][0]['index']}")
            pixel = page.evaluate(f"ringwatchReport.mesh.pixelOf({report['worst'][0]['index']})")
            true(all(0.68 * c - 1 <= found <= c + 1 for found, c in zip(pixel["alone"], pixel["expected"])),
                 f"the element is {pixel['alone']}, not {pixel['expected']}")
        else:  # a machine on which this browser has no WebGL
            true("no WebGL 2" in page.evaluate("document.getElementById('mesh-static').textContent"), "the page says so")
        equal(said(page), [], "messages")


def check_accessible(browser, chromium, run, axe):
    """axe-core finds nothing, light and dark, wide and narrow, on a page of each kind."""
    del browser
    program = os.environ["RINGWATCH"]
    files = [run / "report.html", make_inspection(program, run.parent), make_comparison(program, run.parent)]
    for file, width, dark in [(f, w, d) for f in files for w, d in ((1200, False), (380, True))]:
        with Browser(chromium, width, dark=dark) as page:
            page.open(file)
            page.wait_for(READY)
            page.evaluate("document.querySelectorAll('details').forEach(d => { d.open = true; })")
            page.evaluate(pathlib.Path(axe).read_text() + "; 0")
            faults = page.evaluate("axe.run(document, {resultTypes: ['violations']}).then(r => r.violations.map(v => "
                                   "v.id + ': ' + v.help + ' at ' + v.nodes.map(n => n.target.join(' ')).join(', ')))")
            equal(faults, [], f"faults of {file.name}, {'dark' if dark else 'light'}, {width} pixels wide")


CHECKS = {"opens": check_opens, "still": check_still, "mesh": check_mesh, "history": check_history,
          "other_pages": check_other_pages, "live": check_live, "terminal": check_terminal, "firefox": check_firefox,
          "accessible": check_accessible}


def main():
    name, program = sys.argv[1], pathlib.Path(sys.argv[2]).resolve()
    chromium = find_chromium()
    os.environ["RINGWATCH"] = str(program)
    if name == "firefox":
        if find_firefox() is None:
            print("skipped: there is no firefox; scripts/setup --browser installs it")
            return SKIPPED
    elif name != "terminal" and chromium is None:
        print("skipped: there is no chromium; scripts/setup --browser installs it")
        return SKIPPED
    more = []
    if name == "accessible":
        if len(sys.argv) < 4 or not pathlib.Path(sys.argv[3]).is_file():
            print("skipped: there is no axe-core; npm ci in app/report/web installs it")
            return SKIPPED
        more = [sys.argv[3]]
    with tempfile.TemporaryDirectory() as folder:
        run = make_run(program, pathlib.Path(folder))
        if name in ("mesh", "history"):
            with Browser(chromium) as browser:
                CHECKS[name](browser, chromium, run, *more)
        else:
            CHECKS[name](None, chromium, run, *more)
    return 0


if __name__ == "__main__":
    sys.exit(main())
