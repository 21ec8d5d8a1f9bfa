#!/usr/bin/env python3
"""Figures as data: one JSON a run in bench/results, by bench/results/schema.json, and one page of the latest, bench/results/README.md.

usage: results.py new RUN.json MADE_BY                 an empty run of this machine
       results.py add RUN.json SUBJECT COMMAND         its figures of a subject: the Markdown tables of standard input
       results.py page [--check]                       writes the page; --check only says whether it is what the runs make it

A subject that is *shown* in any run has a section on the page, with the latest figures of each machine.
"""
import datetime
import json
import os
import pathlib
import platform
import re
import subprocess
import sys

RESULTS = pathlib.Path(__file__).resolve().parent / "results"
ROWS = 40  # that the page has of a table; the others are in the data


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
        return subprocess.run(command, capture_output=True, text=True, check=False).stdout.split("\n")[0]
    model = re.search(r"^model name\s*: (.*)$", pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8"), re.M)
    return {"date": str(datetime.date.today()), "machine": re.sub(r"[^a-z0-9]+", "-", re.sub(r"^[\d-]+-", "", pathlib.Path(path).stem).lower()), "what": made_by,
            "taken": {"machine": f"{os.cpu_count()} cores", "processor": model[1] if model else platform.processor(), "system": platform.platform(),
                      "compiler": said(os.environ.get("CXX", "c++"), "--version"), "commit": said("git", "describe", "--always", "--dirty"),
                      "load": f"{os.getloadavg()[0]:.1f} at the start", "made_by": made_by},
            "measurements": []}


def page():
    runs = [(path, json.loads(path.read_text(encoding="utf-8"))) for path in sorted(RESULTS.glob("20*.json"))]
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
    elif command == "page" and rest in ([], ["--check"]):
        readme = RESULTS / "README.md"
        if not rest:
            readme.write_text(page(), encoding="utf-8")
        elif readme.read_text(encoding="utf-8") != page():
            sys.exit("bench/results/README.md is not what its runs make it: bench/results.py page")
    else:
        sys.exit(__doc__)


if __name__ == "__main__":
    main()
