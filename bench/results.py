#!/usr/bin/env python3
"""Figures as data: one JSON a run in bench/results, by bench/results/schema.json, and one page of the latest, bench/results/README.md.

usage: results.py new RUN.json MADE_BY                 an empty run of this machine
       results.py add RUN.json SUBJECT COMMAND         its figures of a subject: the Markdown tables of standard input
       results.py stage RUN.json STAGE LOG STATUS SECONDS   what a stage of scripts/nightly has told, in place of what the run has of it
       results.py page [--check]                       writes the page; --check only says whether it is what the runs make it

The page is bench/results/README.md, and the column *last run* of docs/reliability.md. A subject that is *shown* in any run has a section on the page, with the latest figures of each machine.
"""
import datetime
import json
import os
import pathlib
import platform
import re
import subprocess
import sys

SOURCE = pathlib.Path(__file__).resolve().parent.parent
RESULTS, RELIABILITY = SOURCE / "bench/results", SOURCE / "docs/reliability.md"
ROWS = 40  # that the page has of a table; the others are in the data
NIGHTLY = {"subject": "Nightly stages", "shown": True, "reads": "What each stage of `scripts/nightly` has tried; findings are trials that broke a promise.",
           "columns": ["stage", "command", "trials", "of", "findings", "seconds", "cores", "version"]}
# Of the log of a stage: what a trial is, and the numbers of them that its processes tell. The last pattern is of findings.
TRIALS = {
    "studies": [("checks", r"^(\d+) checks, "), ("", r"^\d+ checks, (\d+) failed")],
    "handlers": [("runs", r"(\d+) of \d+ runs, \d+ steps each"), ("", r"^(?:off: )()")],
    "ranks": [("bodies", r"^(\d+) random bodies"), ("", r"^\[  FAILED  \] ()\S+ \(")],
    "states": [("elements", r"^(\d+) elements in \d+ states,"), ("watched runs", r"states along (\d+) runs"), ("", r", (\d+) wrong,")],
    "calls": [("calls", r"'\w[\w-]*': (\d+)"), ("", r"\}; (\d+) of them badly")],
    "certificates": [("certificates", r"^(\d+) tampered with: "), ("by the second checker", r"^(\d+) tampered with, "), ("", r"(\d+) badly$|is proven, and not true()")],
    "fuzz": [("inputs", r"^inputs: (\d+)"), ("", r"targets with findings: (\d+)")],
    "kills": [("kills", r"^(\d+) kills"), ("resumptions", r"(\d+) resumptions"), ("", r"^\[  FAILED  \] ()\S+ \(")],
    "scenes": [("scenes", r"^(\d+) scenes: "), ("", r"; (\d+) failed; acted")],
    "coverage": [("lines", r"^coverage: (\d+) lines"), ("branches", r"^coverage: \d+ lines, (\d+) branches"), ("", r"; (\d+) folders below")],
    "faults": [("faults", r"of (\d+) faults were noticed"), ("", r"^NOT CAUGHT()")],
}
TESTS = [("tests", r"tests failed out of (\d+)"), ("", r"(\d+) tests failed out of")]  # of the other stages


def written(run):
    """A row a line, so that a change of figures can be read."""
    rows, text = [], json.dumps(run, ensure_ascii=False)
    held = json.loads(text)
    for measurement in held["measurements"]:
        for key in ("columns", "rows"):
            lines = [measurement[key]] if key == "columns" else measurement[key]
            rows += [json.dumps(line, ensure_ascii=False) for line in lines]
            marks = [f"\0{len(rows) - len(lines) + i}\0" for i in range(len(lines))]
            measurement[key] = marks[0] if key == "columns" else marks
    return re.sub(r'"\\u0000(\d+)\\u0000"', lambda m: rows[int(m[1])], json.dumps(held, ensure_ascii=False, indent=1)) + "\n"


def number(text):
    text = text.strip()
    if re.fullmatch(r"-?\d+", text):
        return int(text)
    return float(text) if re.fullmatch(r"-?\d+(\.\d+)?(e[-+]?\d+)?", text) else text


def tables(text):
    for block in re.findall(r"(?:^\|.*\n?)+", text, re.M):
        head, _, *rows = [[cell.strip() for cell in line.strip().strip("|").split("|")] for line in block.strip().split("\n")]
        yield head, [[number(cell) for cell in row] for row in rows]


def new(path, made_by):
    def said(*command):
        try:
            return subprocess.run(command, capture_output=True, text=True, check=False, cwd=SOURCE).stdout.split("\n")[0] or "not noted"
        except FileNotFoundError:
            return "not noted"
    model = re.search(r"^model name\s*: (.*)$", pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8"), re.M)
    return {"date": str(datetime.date.today()), "machine": re.sub(r"[^a-z0-9]+", "-", re.sub(r"^[\d-]+-", "", pathlib.Path(path).stem).lower()), "what": made_by,
            "taken": {"machine": f"{os.cpu_count()} cores", "processor": model[1] if model else platform.processor(), "system": platform.platform(),
                      "compiler": said(os.environ.get("CXX", "c++"), "--version"), "commit": said("git", "describe", "--always", "--dirty"),
                      "load": f"{os.getloadavg()[0]:.1f} at the start", "made_by": made_by},
            "measurements": []}


def told(log, pattern):
    """The sum of the numbers that lines tell; a line that tells none counts one."""
    return sum(int(next((n for n in match.groups() if n), 1)) for match in re.finditer(pattern, log, re.M))


def stage(run, name, log, status, seconds):
    """Puts what a stage has told into a run."""
    *kinds, (_, bad) = TRIALS.get(name, TESTS)
    findings = max(told(log, bad), int(status != 0))
    version = re.search(r"^  VERSION ([\d.]+)$", (SOURCE / "CMakeLists.txt").read_text(encoding="utf-8"), re.M)[1]
    rows = [[name, f"scripts/nightly {name}", trials, what, findings, seconds, os.cpu_count(), version] for what, trials in ((what, told(log, of)) for what, of in kinds) if trials]
    held = next((m for m in run["measurements"] if m["subject"] == NIGHTLY["subject"]), None)
    if held is None:
        run["measurements"].append(held := {**NIGHTLY, "rows": []})
    held["rows"] = [row for row in held["rows"] if row[0] != name] + (rows or [[name, f"scripts/nightly {name}", 1, "run", findings, seconds, os.cpu_count(), version]])


def reliability(runs):
    """The page of promises with its column of last runs: the latest of each stage."""
    last = {}
    for _, run in runs:
        for measurement in run["measurements"]:
            if measurement["subject"] == NIGHTLY["subject"]:
                for name in dict.fromkeys(row[0] for row in measurement["rows"]):
                    rows = [row for row in measurement["rows"] if row[0] == name]
                    trials = ", ".join(f"{row[2]:,} {row[3]}".replace(",", "\u00a0") for row in rows)
                    last[name] = f"{trials}: {rows[0][4] or 'no'} finding{'s' * (rows[0][4] != 1)}"
    lines = RELIABILITY.read_text(encoding="utf-8").split("\n")
    for i, line in enumerate(lines):
        cells = line.split(" | ")
        names = re.findall(r"`(\w+)`", cells[-2]) if len(cells) == 5 else []
        if names:
            lines[i] = " | ".join([*cells[:-1], "; ".join((f"`{name}`: " if len(names) > 1 else "") + last.get(name, "none recorded") for name in names) + " |"])
    return "\n".join(lines)


def all_runs():
    return [(path, json.loads(path.read_text(encoding="utf-8"))) for path in sorted(RESULTS.glob("20*.json"))]


def page(runs):
    figures = {}
    for path, run in runs:
        for measurement in run["measurements"]:
            figures.setdefault(measurement["subject"], {}).setdefault(run["machine"], []).append((path, run, measurement))
    shown = [s for s, of in figures.items() if any(m.get("shown") for found in of.values() for _, _, m in found)]
    lines = ["# Results", "",
             "Made of the JSON files beside it by `bench/results.py page`; change those. Each is a run on one machine, valid by `schema.json`; `bench/figures` writes one on yours.",
             "Ratios within a table carry over to other machines, times do not; times of two runs do not compare.", ""]
    lines += [f"- [{subject}](#{re.sub(r'[^a-z0-9 -]', '', subject.lower()).replace(' ', '-')})" for subject in sorted(shown)]
    for subject in sorted(shown):
        lines += ["", f"## {subject}"]
        for machine, found in sorted(figures[subject].items()):
            last = [entry for entry in found if entry[0] == found[-1][0]]
            path, run, _ = last[0]
            lines += ["", f"**{run['taken']['processor']}, {run['taken']['machine']}, {run['date']}** ([data]({path.name}))"]
            for _, _, measurement in last:
                if not measurement.get("shown"):
                    continue
                if measurement.get("reads"):
                    lines += ["", measurement["reads"]]
                lines += ["", *(f"- `{command}`" for command in measurement.get("commands", []))]
                rows = [measurement["columns"], ["---"] * len(measurement["columns"]), *measurement["rows"][:ROWS]]
                lines += [""] if measurement.get("commands") else []
                lines += ["| " + " | ".join(str(cell).replace("|", "\\|") for cell in row) + " |" for row in rows]
                if len(measurement["rows"]) > ROWS:
                    lines += ["", f"{len(measurement['rows']) - ROWS} more rows in the data."]
            earlier = sorted({(run["date"], path.name) for path, run, _ in found if path != last[0][0]})
            if earlier:
                lines += ["", "Earlier: " + ", ".join(f"[{date}]({name})" for date, name in earlier) + "."]
    lines += ["", "## All runs", "", "| day | machine | what | subjects |", "| --- | --- | --- | --- |"]
    for path, run in runs:
        subjects = ", ".join(dict.fromkeys(m["subject"] for m in run["measurements"]))
        lines.append(f"| [{run['date']}]({path.name}) | `{run['machine']}` | {run['what']} | {subjects} |")
    return "\n".join(lines) + "\n"


def main():
    command, *rest = sys.argv[1:] or ["--help"]
    if command == "new" and len(rest) == 2:
        pathlib.Path(rest[0]).write_text(written(new(*rest)), encoding="utf-8")
    elif command == "add" and len(rest) == 3:
        path = pathlib.Path(rest[0])
        run, found = json.loads(path.read_text(encoding="utf-8")), list(tables(sys.stdin.read()))
        if not found:
            sys.exit(f"results.py: no table of {rest[1]} on standard input")
        run["measurements"] += [{"subject": rest[1], "shown": True, "commands": [rest[2]], "columns": head, "rows": rows} for head, rows in found]
        path.write_text(written(run), encoding="utf-8")
    elif command == "stage" and len(rest) == 5:
        path, name, log, status, seconds = pathlib.Path(rest[0]), rest[1], pathlib.Path(rest[2]), *map(int, rest[3:])
        run = json.loads(path.read_text(encoding="utf-8")) if path.exists() else new(path, "`scripts/nightly`")
        stage(run, name, log.read_text(encoding="utf-8", errors="replace"), status, seconds)
        path.write_text(written(run), encoding="utf-8")
    elif command == "page" and rest in ([], ["--check"]):
        runs = all_runs()
        for path, made in ((RESULTS / "README.md", page(runs)), (RELIABILITY, reliability(runs))):
            if not rest:
                path.write_text(made, encoding="utf-8")
            elif path.read_text(encoding="utf-8") != made:
                sys.exit(f"{path.relative_to(SOURCE)} is not what the runs make it: bench/results.py page")
    else:
        sys.exit(__doc__)


if __name__ == "__main__":
    main()
