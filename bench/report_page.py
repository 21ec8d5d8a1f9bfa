#!/usr/bin/env python3
"""How large the report's page is, how long writing it takes, and when a browser shows it.

  bench/report_page.py build/release/bin/ringwatch [--sizes] [--elements N ...]

Pages of a folder that holds next to nothing, of 100 000 and a million rows of random numbers, the worst there can be, and of runs of
tetrahedra, four frames each with steps, von Mises stress and stretch of the elements. Prints a Markdown table: bytes; wall time of
`ringwatch report`, the least of three; milliseconds from asking for the page until it is read and until history and mesh are drawn, in a
headless Chromium that draws by software, the median of three. Ends with status 1 where a page is larger than its limit.
--sizes leaves browser and times out, and takes the steps of elements by their heights, which are quicker to compute and as large.
"""
import argparse
import json
import os
import pathlib
import random
import statistics
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "tests" / "app"))
from browser import Browser, find_chromium  # noqa: E402

MB = 1_000_000
# Limits of the page, bytes: without data; of 100 000 rows; of a million elements.
EMPTY, ROWS, ELEMENTS = 1 * MB, 2 * MB, 10 * MB

SCENE = """
[mesh]
generate = "bar"
size = [{length}, {width}, {width}]
cells = [{long}, {cells}, {cells}]
jitter = 0.15
[material]
model = "stvk"
young = 30e3
poisson = 0.3
density = 1000
[integrator]
step = 2e-5
end = 6e-5
[monitor]
mode = "{mode}"
metric = "pressure-wave"
[[fix]]
where = "x < 1e-6"
[[move]]
where = "x > {length} - 1e-6"
velocity = [0.5, 0, 0]
[output]
every = 2e-5
fields = {fields}
picture = false
energy = false
"""


def make_run(program, folder, elements, sizes):
    """A bar twice as long as wide of about so many tetrahedra, five a cell; returns its folder and their number."""
    cells = max(1, round((elements / 10) ** (1 / 3)))
    fields = ["pressure-wave" if sizes else "critical_step", "von_mises", "max_stretch"]
    text = SCENE.format(length=0.02 * cells, width=0.01 * cells, long=2 * cells, cells=cells, fields=json.dumps(fields),
                        mode="metric" if sizes else "bracket")
    (folder / "bar.toml").write_text(text)
    run = folder / f"run_{elements}"
    subprocess.run([program, "run", "bar.toml", "--out", run.name, "--quiet"], cwd=folder, check=False)
    return run, sum(json.loads((run / "summary.json").read_text())["mesh"]["elements"].values())


def make_history(folder, rows):
    """Rows of random numbers, as a run writes them."""
    history = folder / f"history_{rows}"
    history.mkdir()
    numbers = random.Random(1)
    with open(history / "history.csv", "w", encoding="ascii") as file:
        file.write("step,time_s,h_s,safe_s,optimistic_s,controlling_element,kinetic_J,strain_J,external_work_J,balance_error_J,"
                   "elements_refreshed,handled_elements,metric_step_s,verdict,dissipated_J\n")
        for i in range(rows):
            values = [repr(numbers.random()) for _ in range(8)]
            file.write(f"{i},{i * 1e-4!r},{1e-4 * numbers.random()!r},{values[0]},{values[1]},0:{numbers.randrange(5000)},"
                       f"{','.join(values[2:6])},{numbers.randrange(10000)},{numbers.randrange(100)},{values[6]},certified,{values[7]}\n")
    return history


def write_page(program, folder, times):
    """Bytes of the page and the least wall time of writing it, s."""
    best = float("inf")
    for _ in range(times):
        begin = time.monotonic()
        subprocess.run([program, "report", folder], check=True, stdout=subprocess.DEVNULL)
        best = min(best, time.monotonic() - begin)
    return (folder / "report.html").stat().st_size, best


def open_page(chromium, page):
    """Milliseconds until the page is read, and until history and mesh are drawn."""
    read, drawn = [], []
    for _ in range(3):
        with Browser(chromium) as browser:
            browser.open(page)
            browser.wait_for("globalThis.ringwatchReport?.ready === true", 120)
            if browser.said():
                raise SystemExit(f"{page}: the page says {browser.said()}")
            drawn.append(browser.evaluate("ringwatchReport.readyAfter"))
            read.append(browser.evaluate("performance.getEntriesByType('navigation')[0].domInteractive"))
    return statistics.median(read), statistics.median(drawn)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=lambda name: str(pathlib.Path(name).resolve()))
    parser.add_argument("--sizes", action="store_true", help="bytes alone, for a test")
    parser.add_argument("--elements", type=int, nargs="*", default=None, help="of the runs; default 10 000, 100 000 and 1 000 000")
    options = parser.parse_args()
    elements = options.elements if options.elements is not None else [1_000_000] if options.sizes else [10_000, 100_000, 1_000_000]
    chromium = None if options.sizes else find_chromium()
    if not options.sizes and chromium is None:
        raise SystemExit("there is no chromium; scripts/setup --browser installs it, --sizes does without")
    too_large = []
    print("| page | bytes | at most | written in (s) | read (ms) | history and mesh (ms) |\n|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        os.chdir(folder)
        empty = folder / "empty"
        empty.mkdir()
        (empty / "summary.json").write_text("{}")
        cases = [("a folder that holds next to nothing", lambda: empty, EMPTY),
                 ("100 000 rows", lambda: make_history(folder, 100_000), ROWS)]
        if not options.sizes:
            cases.append(("1 000 000 rows", lambda: make_history(folder, 1_000_000), ROWS))
        for count in elements:
            cases.append((None, lambda count=count: make_run(options.program, folder, count, options.sizes), ELEMENTS))
        for title, make, limit in cases:
            made = make()
            if title is None:
                made, count = made
                title = f"{count} tetrahedra"
            size, seconds = write_page(options.program, made, 1 if options.sizes else 3)
            row = [title, str(size), str(limit)]
            if options.sizes:
                row += ["", "", ""]
            else:
                read, drawn = open_page(chromium, made / "report.html")
                row += [f"{seconds:.2f}", f"{read:.0f}", f"{drawn:.0f}"]
            print("| " + " | ".join(row) + " |", flush=True)
            if size > limit:
                too_large.append(title)
    if too_large:
        raise SystemExit(f"too large: {', '.join(too_large)}")


if __name__ == "__main__":
    main()
