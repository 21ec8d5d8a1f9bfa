#!/usr/bin/env python3
"""Compares result files of the benchmark programs, or prints one.

usage: compare.py BEFORE.json [AFTER.json] [--filter REGEX] [--match] [--markdown] [--pivot]

Files come from --benchmark_format=json or --benchmark_out=FILE. Of repetitions the least CPU time counts, since other
programs only ever add to it. A ratio below 1 is faster. With --match only rows of both files are printed.
"""
import argparse
import json
import re
import sys

NANOSECONDS = {"ns": 1, "us": 1e3, "ms": 1e6, "s": 1e9}


def read(path):
    """Name -> (least CPU time, ns; elements or 0; error, floor in ns, iterations an element and ratio, or None)."""
    try:
        with open(path, encoding="utf-8") as file:
            rows = json.load(file)["benchmarks"]
    except (OSError, ValueError, KeyError) as problem:
        sys.exit(f"{path}: no benchmark results: {problem}")
    best = {}
    for row in rows:
        if row.get("run_type") == "aggregate" or "error_message" in row or "cpu_time" not in row:
            continue
        manual = row["run_name"].endswith("/manual_time")  # the row has taken its time itself
        time = row["real_time" if manual else "cpu_time"] * NANOSECONDS[row["time_unit"]]
        name = re.sub(r"(/iterations:\d+)?(/repeats:\d+)?(/(real|manual)_time)?$", "", row["run_name"]).removesuffix("/threads:1")
        if name not in best or time < best[name][0]:
            best[name] = (time, row.get("elements", 0), row.get("error"), row.get("floor_ns"), row.get("iterations_each"), row.get("ratio"))
    return best


def shown(entry):
    if entry is None:
        return f"{'-':>12} {'-':>9}"
    time, elements, error = entry[:3]
    each = time / elements if elements else time
    return f"{each:12.4g} {'' if error is None else format(error, '9.1e'):>9}"


def show(results, names, width, markdown):
    """One file's rows: ns an element where the row counts elements, error, floor, time over floor, iterations, and the row's own ratio."""
    bar = " | " if markdown else " "
    heads = ["row".ljust(width), "ns".rjust(9), "error".rjust(8), "floor".rjust(8), "over".rjust(6), "iterations".rjust(10), "ratio".rjust(7)]
    print(("| " if markdown else "") + bar.join(heads) + (" |" if markdown else ""))
    if markdown:
        print("|" + "---|" * len(heads))
    for name in names:
        time, elements, error, floor, iterations, ratio = results[name]
        each = time / elements if elements else time
        cells = [name.ljust(width), f"{each:9.4g}", "" if error is None else f"{error:.1e}"]
        cells += [f"{floor:.3g}", f"{each / floor:.1f}"] if floor else ["", ""]
        cells += [f"{iterations:.1f}" if iterations else "", f"{ratio:.3g}" if ratio else ""]
        widths = (width, 9, 8, 8, 6, 10, 7)
        print(("| " if markdown else "") + bar.join(c.rjust(w) if c != cells[0] else c for c, w in zip(cells, widths)) + (" |" if markdown else ""))


def pivot(results, names):
    """A Markdown table with a column for each last part of the names: ns (error)."""
    rows, columns = {}, []
    for name in names:
        head, last = name.rsplit("/", 1)
        if last not in columns:
            columns.append(last)
        time, elements, error = results[name][:3]
        each = time / elements if elements else time
        rows.setdefault(head, {})[last] = f"{each:.3g}" + ("" if error is None else f" ({error:.0e})")
    print("| ns (error) | " + " | ".join(columns) + " |\n|" + "---|" * (len(columns) + 1))
    for head, cells in rows.items():
        print(f"| `{head}` | " + " | ".join(cells.get(column, "") for column in columns) + " |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("before")
    parser.add_argument("after", nargs="?")
    parser.add_argument("--filter", default="", help="only rows whose name matches")
    parser.add_argument("--match", action="store_true", help="only rows of both files")
    parser.add_argument("--markdown", action="store_true", help="of one file: a table for a document")
    parser.add_argument("--pivot", action="store_true", help="of one file: a column for each last part of the names")
    options = parser.parse_args()
    before = read(options.before)
    after = read(options.after) if options.after else None
    names = [n for n in {**before, **(after or {})} if re.search(options.filter, n)]
    if options.match and after is not None:
        names = [n for n in names if n in before and n in after]
    if not names:
        sys.exit("no rows to show")
    width = max(map(len, names))
    if after is None and options.pivot:
        pivot(before, names)
        return
    if after is None:
        show(before, names, width, options.markdown)
        return
    print(f"{'':{width}} {'before, ns':>12} {'error':>9} {'after, ns':>12} {'error':>9} {'ratio':>7}")
    for name in names:
        a, b = before.get(name), after.get(name)
        ratio = f"{b[0] / a[0]:7.3f}" if a and b else f"{'-':>7}"
        print(f"{name:{width}} {shown(a)} {shown(b)} {ratio}")


if __name__ == "__main__":
    main()
