#!/usr/bin/env python3
"""Holds paper/ to what the Journal of Open Source Software asks for: length, sections, and an entry for each citation.

usage: paper_test.py SOURCE_DIR
"""
import pathlib
import re
import sys

MOST_WORDS = 1000  # of the text, the metadata and the list of references not counted
SECTIONS = {"Summary", "Statement of need", "State of the field", "References"}
FIELDS = {"title", "tags", "authors", "affiliations", "bibliography"}
NEEDED = {"article": {"author", "title", "journal", "year"}, "book": {"author", "title", "publisher", "year"},
          "phdthesis": {"author", "title", "school", "year"}, "techreport": {"author", "title", "institution", "year"},
          "manual": {"author", "title", "organization", "year"}, "inproceedings": {"author", "title", "booktitle", "year"}}


def entries(text):
    """key -> (kind, names of fields)."""
    return {key: (kind, set(re.findall(r"^  (\w+) = \{.+\},?$", body, re.M)))
            for kind, key, body in re.findall(r"^@(\w+)\{(\w+),\n(.*?)^\}$", text, re.M | re.S)}


def citations(text):
    return set(re.findall(r"@(\w+)", re.sub(r"\S+@\S+\.\S+", "", text)))


def faults_of(paper, proofs, bib, folder):
    faults = []
    metadata, text = paper.split("---\n", 2)[1:]
    if missing := FIELDS - set(re.findall(r"^(\w+):", metadata, re.M)):
        faults.append(f"paper.md: the metadata has no {sorted(missing)}")
    if missing := SECTIONS - set(re.findall(r"^# (.*)$", text, re.M)):
        faults.append(f"paper.md: there are no sections {sorted(missing)}")
    words = len(text.split())
    if words > MOST_WORDS:
        faults.append(f"paper.md: {words} words; at most {MOST_WORDS}")
    known, cited = entries(bib), citations(text) | citations(proofs)
    if bib.count("\n@") + bib.startswith("@") != len(known):
        faults.append("paper.bib: an entry is not readable or doubled")
    faults += [f"paper.bib: there is no {key}, which is cited" for key in sorted(cited - set(known))]
    faults += [f"paper.bib: {key} is not cited" for key in sorted(set(known) - cited)]
    for key, (kind, fields) in known.items():
        if missing := NEEDED.get(kind, {"a known kind"}) - fields:
            faults.append(f"paper.bib: {key}: a {kind} needs {sorted(missing)}")
    faults += [f"proofs.md: the link {target} leads nowhere" for target in re.findall(r"\]\(([^)#:]+)\)", proofs)
               if not (folder / target).exists()]
    return faults


def main():
    folder = pathlib.Path(sys.argv[1]) / "paper"
    paper, proofs, bib = ((folder / name).read_text(encoding="utf-8") for name in ("paper.md", "proofs.md", "paper.bib"))
    # What the test is for is noticed.
    seeded = {"words": (paper + " word" * MOST_WORDS, proofs, bib), "there is no nobody2000": (paper + " [@nobody2000]", proofs, bib),
              "is not cited": (paper, proofs, bib + "\n@book{unread1999,\n  author = {A},\n  title = {B},\n  publisher = {C},\n  year = {1999}\n}\n"),
              "needs": (paper, proofs, bib.replace("  year = {1972}\n", "")), "leads nowhere": (paper, proofs + "[x](none.md)", bib)}
    for said, changed in seeded.items():
        if not any(said in fault for fault in faults_of(*changed, folder)):
            sys.exit(f"the seeded fault is not noticed: {said}")
    faults = faults_of(paper, proofs, bib, folder)
    if faults:
        sys.exit("\n".join(faults))


if __name__ == "__main__":
    main()
