#!/usr/bin/env python3
"""Holds the tables of docs/studies/ to the data beside them: a comment <!-- FILE.csv --> stands before each table, whose header has
names of columns, and every row is that of the file with the same first cell, numbers rounded. A number in the text of a PAGE.md with a
comment <!-- TABLE --> behind it is one of PAGE.TABLE.csv.

usage: studies_test.py SOURCE_DIR
"""
import csv
import math
import pathlib
import re
import sys

LEAST_ROWS = 10  # of all pages: else nothing was compared


def rounded_alike(shown, exact):
    """Whether a text is a number rounded to the digits that it shows."""
    try:
        one, other = float(shown), float(exact)
    except ValueError:
        return shown == exact
    if math.isnan(one) or math.isnan(other):
        return math.isnan(one) and math.isnan(other)
    mantissa, _, power = shown.partition("e")
    digits = len(mantissa.partition(".")[2])
    return abs(one - other) <= 0.5001 * 10.0 ** (int(power or 0) - digits)


def rows_of(file):
    with file.open(encoding="utf-8", newline="") as opened:
        return list(csv.DictReader(opened))


def faults_of(page, text, folder):
    """Faults of a page, and how many rows and numbers of the text it has."""
    faults, rows = [], 0
    for match in re.finditer(r"(\d[\d.]*)(?: %)?<!-- ([\w-]+) -->", text):
        rows += 1
        file = f"{pathlib.Path(page).stem}.{match[2]}.csv"
        if not any(rounded_alike(match[1], cell) for row in rows_of(folder / file) for cell in row.values()):
            faults.append(f"{page}: {file} has no {match[1]}")
    for match in re.finditer(r"<!-- (\S+\.csv) -->\n((?:\|.*\n)+)", text):
        data = rows_of(folder / match[1])
        header, _, *lines = ([cell.strip() for cell in line.strip("|\n").split("|")] for line in match[2].splitlines())
        if missing := [name for name in header if name not in data[0]]:
            faults.append(f"{page}: {match[1]} has no columns {missing}")
            continue
        for cells in lines:
            rows += 1
            if not any(all(rounded_alike(cell, row[name]) for name, cell in zip(header, cells)) for row in data):
                faults.append(f"{page}: {match[1]} has no row {cells}")
    return faults, rows


def main():
    folder = pathlib.Path(sys.argv[1]) / "docs/studies"
    faults, rows = [], 0
    for page in sorted(folder.glob("*.md")):
        text = page.read_text(encoding="utf-8")
        found, count = faults_of(page.name, text, folder / "data")
        faults, rows = faults + found, rows + count
        # A digit that is changed is noticed.
        if count:
            table = re.search(r"<!-- \S+\.csv -->\n(?:\|.*\n){2}(\|.*\n)", text)
            changed = re.sub(r"(\d)(?= \|\n)", lambda digit: str((int(digit[1]) + 5) % 10), table[1])
            if changed != table[1] and not faults_of(page.name, text.replace(table[1], changed), folder / "data")[0]:
                faults.append(f"{page.name}: a changed digit is not noticed")
    if rows < LEAST_ROWS:
        faults.append(f"only {rows} rows were compared")
    if faults:
        sys.exit("\n".join(faults))


if __name__ == "__main__":
    main()
