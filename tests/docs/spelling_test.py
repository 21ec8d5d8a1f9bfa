#!/usr/bin/env python3
"""Every word of README.md, CHANGELOG.md, CONTRIBUTING.md, docs/, bench/ and the other pages is in hunspell's British or American
dictionary or in tests/docs/words.txt, in small letters and without 's.

usage: spelling_test.py SOURCE_DIR [--unknown]     exit status 77: hunspell is missing; --unknown: lists those that are
missing there
"""
import pathlib
import re
import shutil
import subprocess
import sys

DICTIONARIES = "en_GB,en_US"
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from documents_test import Documents  # noqa: E402


def prose(lines):
    """The lines without code, formulas, links' targets and HTML."""
    text, fenced = [], False
    for line in lines:
        if line.startswith("```"):
            fenced = not fenced
            line = ""
        text.append("" if fenced or line.startswith("    ") and "|" not in line and not line.lstrip().startswith(("-", "*")) else line)
    joined = "\n".join(text)

    def blank(match):
        return "\n" * match[0].count("\n") or " "

    for pattern in (r"\$\$.*?\$\$", r"\$[^$\n]*(?:\n[^$\n]+)?\$", r"`[^`]*`", r"<!--.*?-->", r"(?<=\])\([^)\s]*\)", r"https?://\S+", r"<[^<>\n]+>",
                    r"\b\d{4}-\d\d-\d\d-[\w-]+",
                    r"\b[\w-]+\.(?:md|csv|json|toml|png|svg|js|cpp|h|py|inp|txt|cff)\b"):
        joined = re.sub(pattern, blank, joined, flags=re.S)
    return joined.split("\n")


def main():
    source = pathlib.Path(sys.argv[1]).resolve()
    known = subprocess.run(["hunspell", "-D"], input="", capture_output=True, text=True, check=False).stderr if shutil.which("hunspell") else ""
    if missing := [d for d in DICTIONARIES.split(",") if f"/{d}" not in known]:
        print(f"not checked: hunspell has no dictionary {', '.join(missing)} (scripts/setup --site)")
        return 77
    documents = Documents(source, "")
    places = {}
    for path in [*documents.paths, *documents.project]:
        for number, line in enumerate(prose(documents.lines(path)), 1):
            for word in re.findall(r"[^\W\d_](?:[^\W\d_]|['’](?=[^\W\d_]))*", line):
                if re.fullmatch(r"[A-Za-zÀ-ɏ'’]+", word):  # no formula
                    places.setdefault(word.replace("’", "'"), f"{path.relative_to(source)}:{number}")
    result = subprocess.run(["hunspell", "-i", "utf-8", "-d", DICTIONARIES, "-l"], input="\n".join(places), capture_output=True,
                            text=True, check=True)
    unknown = {word: word.lower().removesuffix("'s") for word in result.stdout.split()}
    listed = (source / "tests/docs/words.txt").read_text(encoding="utf-8").split()
    if sys.argv[2:] == ["--unknown"]:
        print("\n".join(sorted(set(unknown.values()) - set(listed))))
        return 0
    faults = [f"{places.get(word, '?')}: {word}" for word, plain in sorted(unknown.items()) if plain not in listed]
    print("\n".join(faults) or f"no unknown word among {len(places)} in {len(documents.paths) + len(documents.project)} pages")
    return 1 if faults or len(places) < 1000 else 0


if __name__ == "__main__":
    sys.exit(main())
