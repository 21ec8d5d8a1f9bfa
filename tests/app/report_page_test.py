"""The page of a run in a real browser: opened from disk without a network, its controls do what they say.

  report_page_test.py NAME PROGRAM [AXE]

NAME is one of the checks below. Exit status 77 where there is no browser, or for `accessible` no axe-core (AXE is its
axe.min.js): the test then counts as skipped. `scripts/setup --browser` installs them.
"""
import json
import os
import pathlib
import pty
import re
import select
import shutil
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
fields = ["critical_step", "verdict", "handler", "von_mises", "max_stretch"]
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
            # The distribution is seen whole, in letters that can be read.
            drawn, frame, letters = page.evaluate("""(() => {
              const svg = document.querySelector('#distribution svg'), text = svg.querySelector('.tick');
              const width = svg.getBoundingClientRect().width;
              return [width, svg.parentElement.clientWidth, parseFloat(getComputedStyle(text).fontSize) * width / svg.viewBox.baseVal.width];
            })()""")
            true(drawn <= frame + 1, f"the distribution is {drawn} wide in {frame} pixels")
            true(letters >= 9, f"letters of {letters} pixels at width {width}")


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
        browser.evaluate(f"document.querySelectorAll('.smallest .show-me')[{place}].click()")
        element = browser.evaluate(f"Number(document.querySelectorAll('.smallest .show-me')[{place}].dataset.element)")
        browser.wait_for(f"{state}.selected === {element} && document.activeElement.tagName === 'CANVAS'")
        pixel = browser.evaluate(f"ringwatchReport.mesh.pixelOf({element})")
        equal((pixel["colour"][3], pixel["alone"][3]), (255, 255), f"what is drawn at element {element}")
        # Faces are shaded between 0.68 and 1; one more for the rounding of colours.
        true(all(0.68 * c - 1 <= found <= c + 1 for found, c in zip(pixel["alone"], pixel["expected"])),
             f"element {element} is {pixel['alone']}, not {pixel['expected']}")
        true(f"number {report['worst'][place]['id']} in the mesh" in browser.evaluate(
            "document.querySelector('#mesh-live [role=status]').textContent"), f"the numbers of element {element}")

    # The same elements by every other field of the frames: red is the largest stress.
    wanted = ["verdict", "handler", "von Mises stress (Pa)", "largest stretch"]
    for name in wanted:
        browser.evaluate("(() => { const s = [...document.querySelectorAll('#mesh-live label')].find(l => "
                         "l.textContent.startsWith('Colour')).parentElement.querySelector('select'); s.value = %s; "
                         "s.dispatchEvent(new Event('change')); })()" % json.dumps(name))
        browser.wait_for(f"{state}.field === {json.dumps(name)}")
        element = browser.evaluate(f"{state}.selected")
        browser.wait_for(f"ringwatchReport.mesh.pixelOf({element}).expected !== undefined")
        pixel = browser.evaluate(f"ringwatchReport.mesh.pixelOf({element})")
        true(all(0.68 * c - 1 <= found <= c + 1 for found, c in zip(pixel["alone"], pixel["expected"])),
             f"by {name} element {element} is {pixel['alone']}, not {pixel['expected']}")
    values = browser.evaluate("ringwatchReport.mesh.elements().then(e => [...e.fields.find(f => f[0] == 'largest stretch')[1]])")
    cells = browser.evaluate("ringwatchReport.mesh.elements().then(e => [...e.group.cells])")
    most, least = cells[values.index(max(values))], cells[values.index(min(values))]
    equal(browser.evaluate(f"ringwatchReport.mesh.pixelOf({most}).expected"), [165, 0, 38], "the most stretched element's colour")
    equal(browser.evaluate(f"ringwatchReport.mesh.pixelOf({least}).expected"), [49, 54, 149], "the least stretched one's")

    # Frames by keyboard, to the last one.
    frames = sum(len(group["frames"]) for group in report["mesh"]["groups"])
    browser.evaluate("[...document.querySelectorAll('#mesh-live label')].find(l => l.textContent.startsWith('Frame'))"
                     ".parentElement.querySelector('input').focus()")
    browser.key("Home")
    browser.wait_for(f"{state}.frame === 1")
    browser.key("End")
    browser.wait_for(f"{state}.frame === {frames}")

    # Frames follow one another until they are stopped.
    press = "[...document.querySelectorAll('#mesh-live button')].find(b => /^(Play|Pause)$/.test(b.textContent)).click()"
    at = browser.evaluate(f"{state}.frame")
    browser.evaluate(press)
    browser.wait_for(f"{state}.frame !== {at}")
    later = browser.evaluate(f"{state}.frame")
    browser.wait_for(f"{state}.frame !== {later}")
    browser.evaluate(press)
    time.sleep(0.3)  # s, for the frame that was under way
    stopped = browser.evaluate(f"{state}.frame")
    time.sleep(0.5)
    equal(browser.evaluate(f"{state}.frame"), stopped, "the frame after Pause")

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
    # Of a generated bar of one block, whose elements are numbered from 0: by the number that a file has.
    number = last[5].split(":")[1]
    true(readout.startswith(f"step {last[0]} ·") and f"controlled by element {number} " in readout, readout)
    # The band of who controls when: in each run of rows the colour of its element, another one for the next element.
    rows = [line.split(",") for line in lines[1:]]
    changes = [i for i in range(1, len(rows) - 1) if rows[i][5] != rows[i - 1][5]]
    true(changes, "the controlling element changes along the run")
    colour_of, wide = {}, 0
    for row in [0, *changes]:
        end = next((i for i in changes if i > row), len(rows) - 1)
        if end - row < 3 or not rows[row][5]:  # too thin to hit a pixel of it
            continue
        wide += 1
        at = browser.evaluate(f"ringwatchReport.history.bandAt({(row + end) // 2})")
        equal(at["colour"], at["expected"], f"the band at row {row}")
        equal(colour_of.setdefault(rows[row][5], at["colour"]), at["colour"], f"the colour of element {rows[row][5]}")
    true(wide > 1, "several elements hold the bracket for some rows")
    equal(len({tuple(c) for c in colour_of.values()}), len(colour_of), "colours of the elements")
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
            page.evaluate(f"document.querySelectorAll('.smallest .show-me')[{place}].click()")
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
                # Asked for again where the page loads itself at that very moment; the picture follows when it is drawn next.
                page.wait_for("""(() => {
                    const range = globalThis.ringwatchReport?.history?.range();
                    if (!range) return false;
                    scrollTo(0, 700);
                    if (range[1] - range[0] < 0.9 * %r) return true;
                    [...document.querySelectorAll('#history-live button')].find(b => b.textContent == 'Closer')?.click();
                    return false;
                })()""" % whole, 60)
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
    done, now, to, left = re.search(r"\] (\d+) %, t = (\S+) of (\S+) s, ([\d.]+) (?:seconds|min|h) left", last).groups()
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
            page.evaluate("document.querySelectorAll('.smallest .show-me')[0].click()")
            page.wait_for(f"ringwatchReport.mesh.state().selected === {report['worst'][0]['index']}")
            pixel = page.evaluate(f"ringwatchReport.mesh.pixelOf({report['worst'][0]['index']})")
            true(all(0.68 * c - 1 <= found <= c + 1 for found, c in zip(pixel["alone"], pixel["expected"])),
                 f"the element is {pixel['alone']}, not {pixel['expected']}")
        else:  # a machine on which this browser has no WebGL
            true("no WebGL 2" in page.evaluate("document.getElementById('mesh-static').textContent"), "the page says so")
        equal(said(page), [], "messages")


def make_live_page(folder):
    """The page of a run that goes on, taken away from the run."""
    scene = SCENE.replace("end = 0.05", "end = 1e6").replace("every = 5e-3", "every = 0.5").replace(
        "velocity = [0.5, 0, 0]", "velocity = [1e-9, 0, 0]")
    (folder / "long.toml").write_text(scene)
    page = folder / "going_on" / "report.html"
    with subprocess.Popen([os.environ["RINGWATCH"], "run", "long.toml", "--out", "going_on", "--live", "--quiet"],
                          cwd=folder) as process:
        try:
            end = time.monotonic() + 60
            while not page.exists() or '"reloadAfter":0' in page.read_text():
                true(time.monotonic() < end and process.poll() is None, "the run writes its page while it goes on")
                time.sleep(0.1)
            copy = folder / "going_on.html"
            copy.write_text(page.read_text())
        finally:
            process.kill()
    return copy


def make_other_pages(program, folder):
    """A page of each kind but that of a run that has ended."""
    quiet = {"cwd": folder, "stdout": subprocess.DEVNULL}
    subprocess.run([program, "audit", "run/run.pvd", "--scene", "bar.toml", "--report", "audit.html"], check=False, **quiet)
    subprocess.run([program, "verify", "elements", "--quick", "--report", "verify.html"], check=True, **quiet)
    return [make_inspection(program, folder), make_comparison(program, folder), folder / "audit.html",
            folder / "verify.html", make_live_page(folder)]


def check_accessible(browser, chromium, run, axe):
    """axe-core finds nothing, light and dark, wide and narrow, on a page of each kind."""
    del browser
    files = [run / "report.html", *make_other_pages(os.environ["RINGWATCH"], run.parent)]
    for file, width, dark in [(f, w, d) for f in files for w, d in ((1200, False), (380, True))]:
        with Browser(chromium, width, dark=dark) as page:
            page.open(file)
            page.wait_for(READY)
            page.evaluate("document.getElementById('stay')?.click()")
            page.evaluate("document.querySelectorAll('details').forEach(d => { d.open = true; })")
            page.evaluate(pathlib.Path(axe).read_text() + "; 0")
            faults = page.evaluate("axe.run(document, {resultTypes: ['violations']}).then(r => r.violations.map(v => "
                                   "v.id + ': ' + v.help + ' at ' + v.nodes.map(n => n.target.join(' ')).join(', ')))")
            equal(faults, [], f"faults of {file.name}, {'dark' if dark else 'light'}, {width} pixels wide")
            equal(page.said(), [], f"messages of {file.name}")


def check_keyboard(browser, chromium, run):
    """Tab reaches every control in turn, shows where it is and leaves the picture again; its keys turn the picture."""
    del chromium
    browser.open(run / "report.html")
    browser.wait_for(READY)
    stops = browser.evaluate("""(() => {
      const all = [...document.querySelectorAll('a[href], button, select, input, summary, [tabindex="0"]')]
        .filter(e => !e.disabled && e.checkVisibility({visibilityProperty: true}));
      all.forEach((e, i) => { e.dataset.stop = i; });
      return all.map(e => e.tagName + ' ' + (e.getAttribute('aria-label') || e.textContent || e.id).slice(0, 40));
    })()""")
    true(len(stops) > 30, f"only {len(stops)} controls")
    seen, canvas = [], None
    for _ in range(len(stops) + 20):
        browser.key("Tab")
        stop = browser.evaluate("document.activeElement.dataset.stop ?? null")
        if stop is None:
            continue
        seen.append(int(stop))
        width = browser.evaluate("(s => s.outlineStyle === 'none' ? 0 : parseFloat(s.outlineWidth))(getComputedStyle(document.activeElement))")
        true(width >= 1, f"{stops[int(stop)]} does not show that it has the focus")
        if canvas is None and browser.evaluate("document.activeElement.tagName === 'CANVAS'"):
            canvas = int(stop)
            camera = "ringwatchReport.mesh.view().camera"
            for key, text in (("ArrowRight", ""), ("ArrowUp", ""), ("+", "+"), ("-", "-")):
                before, scroll = browser.evaluate(camera), browser.evaluate("scrollY")
                browser.key(key, text)
                after = browser.evaluate(camera)
                true(max(abs(a - b) for a, b in zip(after, before)) > 1e-4 * max(map(abs, before)), f"{key} turns nothing")
                equal(browser.evaluate("scrollY"), scroll, f"the page after {key}")
        if len(seen) > 1 and seen[-1] == seen[0]:
            break
    missing = [stops[i] for i in range(len(stops)) if i not in seen]
    equal(missing, [], "controls that Tab does not reach")
    order = seen[:len(stops)]
    equal(order, sorted(order), "the order of the controls")
    true(canvas is not None, "Tab reaches the picture")
    # A card's button by Enter: its element is shown and the picture has the focus.
    browser.evaluate("document.querySelectorAll('.smallest .show-me')[1].focus()")
    browser.key("Enter", "\r")
    browser.wait_for("document.activeElement.tagName === 'CANVAS'")
    element = browser.evaluate("Number(document.querySelectorAll('.smallest .show-me')[1].dataset.element)")
    equal(browser.evaluate("ringwatchReport.mesh.state().selected"), element, "the element of the second card")
    equal(browser.said(), [], "messages")


def check_prints(browser, chromium, run):
    """On paper: verdict, pictures, tables and cards in dark on white, without controls, no wider than a page."""
    del browser
    for dark in (False, True):
        with Browser(chromium, 794, 1123, dark) as page:  # A4 at 96 dots an inch
            page.open(run / "report.html")
            page.wait_for(READY)
            page.media("print", dark)
            for selector in ("#verdict .lead", "#verdict li", "#history-static svg", "#mesh-static image", "#distribution svg",
                             "#what-if table", ".card svg", "#provenance table"):
                box = page.evaluate(f"(b => [b.width, b.height])(document.querySelector('{selector}').getBoundingClientRect())")
                true(box[0] > 20 and box[1] > 8, f"{selector} is {box} on paper")
            for selector in ("nav", "#history-live", "#mesh-live", "#provenance button", ".show-me"):
                true(not page.evaluate(f"document.querySelector('{selector}').checkVisibility()"), f"{selector} is on paper")
            true(page.evaluate("document.documentElement.scrollWidth <= innerWidth"), "the page is wider than paper")
            equal(page.evaluate("getComputedStyle(document.querySelector('#verdict .lead')).color"), "rgb(0, 0, 0)", "ink")
            page.media("screen", dark)
            pdf = page.printed()
            true(pdf.startswith(b"%PDF") and len(re.findall(rb"/Type\s*/Page\b", pdf)) >= 2, "a document of some pages")
            true(b"/Image" in pdf, "the picture of the mesh is in it")
            equal(page.said(), [], "messages")


def report_of(folder):
    """Writes the page of a run's folder, which must not fail, and returns it."""
    result = subprocess.run([os.environ["RINGWATCH"], "report", folder], capture_output=True, text=True, check=False)
    equal((result.returncode, result.stderr), (0, ""), f"ringwatch report {folder.name}")
    return folder / "report.html"


def check_damaged(browser, chromium, run):
    """Folders that lack something or are damaged, and one of a run that was killed: a page without a message."""
    del chromium
    folder = run.parent
    csv = (run / "history.csv").read_text()
    lines = csv.splitlines(keepends=True)
    frame = sorted((run / "frames").iterdir())[1].relative_to(run)
    wrong = json.dumps({"verdict": 3, "events": [1, {"kind": 2}], "mesh": [], "notes": {}, "scene": "x", "provenance": [],
                        "discrete_forces": [], "first_violated": True})
    cases = {
        "half a row": {"history.csv": csv[:-9]},
        "no row": {"history.csv": lines[0]},
        "one row": {"history.csv": "".join(lines[:2])},
        "two rows of one time": {"history.csv": lines[0] + lines[1] + lines[1]},
        "rows of nothing": {"history.csv": lines[0] + "x,y\n" * 3 + lines[1].replace(lines[1].split(",")[2], "nan")},
        "numbers out of range": {"history.csv": lines[0] + lines[1].replace(lines[1].split(",")[3], "1e400") + lines[2]},
        "half a frame": {frame: (run / frame).read_bytes()[:900]},
        "no frames": {"run.pvd": None},
        "half a list of frames": {"run.pvd": (run / "run.pvd").read_text()[:200]},
        "half a summary": {"summary.json": '{"verdict": '},
        "a summary of other types": {"summary.json": wrong},
        "no summary": {"summary.json": None},
        "a summary alone": {"history.csv": None, "run.pvd": None},
        "no history": {"history.csv": None},
    }
    for name, changes in cases.items():
        copy = folder / name.replace(" ", "_")
        shutil.copytree(run, copy)
        for file, content in changes.items():
            if content is None:
                (copy / file).unlink()
            elif isinstance(content, bytes):
                (copy / file).write_bytes(content)
            else:
                (copy / file).write_text(content)
        browser.open(report_of(copy))
        browser.wait_for(READY)
        equal((browser.said(), browser.requests()), ([], []), f"messages and requests with {name}")
        true(browser.evaluate("document.querySelector('#verdict .lead').textContent.length > 20"), f"no verdict with {name}")
        true(browser.evaluate("document.documentElement.scrollWidth <= innerWidth"), f"too wide with {name}")

    # Killed while it writes.
    (folder / "long.toml").write_text(SCENE.replace("end = 0.05", "end = 1e6").replace("every = 5e-3", "every = 0.05").replace(
        "velocity = [0.5, 0, 0]", "velocity = [1e-9, 0, 0]"))
    with subprocess.Popen([os.environ["RINGWATCH"], "run", "long.toml", "--out", "killed", "--quiet"], cwd=folder) as process:
        try:
            history, end = folder / "killed" / "history.csv", time.monotonic() + 60
            while not history.exists() or history.stat().st_size < 50000 or not (folder / "killed" / "run.pvd").exists():
                true(time.monotonic() < end and process.poll() is None, "the run writes its history while it goes on")
                time.sleep(0.05)
        finally:
            process.kill()
    equal(process.returncode, -signal.SIGKILL, "how the run ended")
    true(not (folder / "killed" / "summary.json").exists(), "a killed run has no summary")
    browser.open(report_of(folder / "killed"))
    browser.wait_for(READY)
    equal(browser.said(), [], "messages of the killed run")
    equal(browser.evaluate("document.querySelector('#verdict-title').textContent"), "No end on record", "the title")
    true(browser.evaluate("ringwatchReport.history.range()[1] > 0 && ringwatchReport.mesh.frames.length > 0"),
         "the killed run's history and frames are shown")


def check_long_history(browser, chromium, run):
    """A million rows: the page holds some of them, every spike among them, says so, and shows them."""
    del chromium
    rows, spike = 1_000_000, 654_321
    head = (run / "history.csv").read_text().split("\n", 1)[0]
    count = len(head.split(","))
    folder = run.parent / "long_history"
    folder.mkdir()
    with open(folder / "history.csv", "w", encoding="ascii") as file:
        file.write(head + "\n")
        for i in range(rows):
            safe = 1e-5 if i == spike else 1e-3 + 1e-6 * (i * 7919 % 101)
            cells = [str(i), repr(i * 1e-3), "0.0009", repr(safe), repr(2 * safe), "0:7", "1", "2", "3", "0", "5", "0"]
            file.write(",".join((cells + [""] * count)[:count]) + "\n")
    browser.open(report_of(folder))
    browser.wait_for(READY)
    equal(browser.said(), [], "messages")
    text = browser.evaluate("document.getElementById('history').textContent")
    true(f"{rows} rows" in text, "the page says how many rows there are")
    true("history.csv" in browser.evaluate("document.getElementById('provenance').textContent"), "and where all of them are")
    report = json.loads(browser.evaluate("document.getElementById('report').textContent"))
    equal(report["history"]["allRows"], rows, "rows of the file")
    true(1000 < report["history"]["rows"] < 25000, f"rows of the page: {report['history']['rows']}")
    low, high = browser.evaluate("ringwatchReport.history.range()")
    true(low == 0 and abs(high - (rows - 1) * 1e-3) < 1e-6, f"the picture shows {low} to {high} s")
    # The slider at the row of the spike tells it.
    at = browser.evaluate("ringwatchReport.history.rowOf(%d)" % spike)
    true(at >= 0, "the row of the spike is in the page")
    browser.evaluate("(() => { const s = document.querySelector('#history-live input[type=range]'); s.value = %d;"
                     " s.dispatchEvent(new Event('input')); })()" % at)
    true("safe 1e-5 s" in browser.evaluate("ringwatchReport.history.readout()"), "the spike's numbers")


CHECKS = {"opens": check_opens, "still": check_still, "mesh": check_mesh, "history": check_history,
          "other_pages": check_other_pages, "live": check_live, "terminal": check_terminal, "firefox": check_firefox,
          "accessible": check_accessible, "keyboard": check_keyboard, "prints": check_prints, "damaged": check_damaged,
          "long_history": check_long_history}


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
            print("skipped: there is no axe-core; scripts/setup --browser installs it")
            return SKIPPED
        more = [sys.argv[3]]
    with tempfile.TemporaryDirectory() as folder:
        run = make_run(program, pathlib.Path(folder))
        if name in ("mesh", "history", "keyboard", "damaged", "long_history"):
            with Browser(chromium) as browser:
                CHECKS[name](browser, chromium, run, *more)
        else:
            CHECKS[name](None, chromium, run, *more)
    return 0


if __name__ == "__main__":
    sys.exit(main())
