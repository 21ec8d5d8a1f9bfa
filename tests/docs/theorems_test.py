#!/usr/bin/env python3
"""Holds the docstrings to docs/theory/: a header that states a bound names its theorem, and every theorem that the sources name exists.
The lists of docs/theory/README.md have every theorem.

usage: theorems_test.py SOURCE_DIR
"""
import pathlib
import re
import sys

# Folders whose headers state bounds, and the words by which they do.
BOUNDS = ("monitor", "integrators", "handlers", "extensions")
STATES_A_BOUND = re.compile(r"\b(proven|proves|safe)\b")
CITATION = re.compile(r"\bTheorems? (\d+(?:(?:, | and | to )\d+)*)(?:, (docs/theory/\w+\.md))?")


def theorems(source):
    """number -> page."""
    pages = {}
    for page in sorted((source / "docs/theory").glob("*.md")):
        for number in re.findall(r"^## Theorem (\d+):", page.read_text(encoding="utf-8"), re.M):
            assert int(number) not in pages, f"{page.name} and {pages[int(number)]} both have Theorem {number}"
            pages[int(number)] = f"docs/theory/{page.name}"
    return pages


def comments(text):
    """(line, text) of every run of comments, its lines joined."""
    begin, block = 0, []
    for number, line in enumerate([*text.split("\n"), ""], 1):
        comment = re.search(r"(?:^|\s)//[/!]?<?\s?(.*)", line)
        if comment:
            begin = begin if block else number
            block.append(comment[1].strip())
        elif block:
            yield begin, " ".join(block)
            block = []


def cited(numbers):
    """The theorems of "8", "8 and 9" or "14 to 19 and 21"."""
    found = set()
    for part in re.split(r", | and ", numbers):
        first, _, last = part.partition(" to ")
        found |= set(range(int(first), int(last or first) + 1))
    return found


def faults_of_lists(source, pages):
    """What the two tables of the README get wrong: the theorems of each page, and a line on each theorem."""
    text, faults = (source / "docs/theory/README.md").read_text(encoding="utf-8"), []
    for page, listed in re.findall(r"^\| \[(\w+\.md)\]\(\1\) \| .* \| (\d.*) \|$", text, re.M):
        own = {number for number, of in pages.items() if of.endswith("/" + page)}
        if cited(listed) != own:
            faults.append(f"docs/theory/README.md: {page} has the theorems {sorted(own)}, not {listed}")
    lines = [int(number) for number in re.findall(r"^\| \[(\d+)\]\(\w+\.md#theorem-\1-", text, re.M)]
    if lines != sorted(pages):
        faults.append(f"docs/theory/README.md: lines of the theorems {sorted(set(pages) ^ set(lines)) or lines} are missing, doubled or out of order")
    return faults


def main():
    source = pathlib.Path(sys.argv[1])
    pages, faults, citations = theorems(source), [], 0
    if sorted(pages) != list(range(1, len(pages) + 1)):
        faults.append(f"docs/theory: theorems are not numbered 1 to {len(pages)}: {sorted(pages)}")
    faults += faults_of_lists(source, pages)
    folders = [line.split(":")[0].strip() for line in (source / "cmake/layers.txt").read_text(encoding="utf-8").splitlines()]
    folders = sorted(folder for folder in folders if folder and (source / folder).is_dir())
    for path in sorted(p for folder in folders for p in (source / folder).rglob("*") if p.suffix in (".h", ".cpp", ".cuh", ".cu")):
        name, states, cites = path.relative_to(source).as_posix(), None, False
        for line, comment in comments(path.read_text(encoding="utf-8")):
            states = states or (line if STATES_A_BOUND.search(comment) else None)
            for match in CITATION.finditer(comment):
                citations, cites = citations + 1, True
                for number in sorted(cited(match[1])):
                    if number not in pages:
                        faults.append(f"{name}:{line}: there is no Theorem {number}")
                    elif match[2] and pages[number] != match[2]:
                        faults.append(f"{name}:{line}: Theorem {number} is in {pages[number]}, not in {match[2]}")
        if path.suffix == ".h" and name.split("/")[0] in BOUNDS and states and not cites:
            faults.append(f"{name}:{states}: states a bound and names no theorem of docs/theory")
    print("\n".join(faults) or f"theorems: no fault in {citations} citations of {len(pages)} theorems")
    return 1 if faults or not citations else 0


if __name__ == "__main__":
    sys.exit(main())
