#!/usr/bin/env python3
"""Builds the site, which stops at a warning and follows its links, and opens its pages in a browser, all of them narrow and one of each
folder wide: pictures load, formulas are typeset, no page is wider than its window, no script fails.

usage: site_test.py SOURCE_DIR WORK_DIR     exit status 77: a program is missing
"""
import pathlib
import shutil
import subprocess
import sys

SOURCE, WORK = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
sys.path.insert(0, str(SOURCE / "tests/app"))
from browser import Browser, find_chromium  # noqa: E402

# In a page: images that did not load, formulas that failed or were left as they are.
BROKEN = "[...document.images].filter(i => !i.complete || !i.naturalWidth).map(i => i.src)"
FORMULAS = r"""[...document.querySelectorAll('.katex-error')].map(e => e.innerText).concat(
    [...document.querySelectorAll('.arithmatex')].filter(e => !e.querySelector('.katex')).map(e => e.innerText),
    (document.querySelector('article') ?? document.body).innerText.match(/\$\$|\\\(|\\\[/g) || [])"""
WIDER = "document.documentElement.scrollWidth - document.documentElement.clientWidth"


# What the search of a page that is opened from disk works with: how many entries of its index have the word, and whether its worker starts.
SEARCH = """__search.index.then(index => { new Worker(__search.worker).terminate();
    return index.docs.filter(entry => entry.text.includes('Cholesky')).length; })"""


def main():
    missing = [program for program in ("git", "mkdocs", "doxygen", "linkchecker", "codespell") if not shutil.which(program)]
    if missing or not (SOURCE / ".git").exists():
        print(f"not built: there is no {', '.join(missing) or 'clone'}; scripts/setup --site installs what the site needs")
        return 77
    # That every notebook runs is python.notebook's to find.
    built = subprocess.run([SOURCE / "scripts/site", WORK, "bar_run"], capture_output=True, text=True, check=False)
    if built.returncode:
        print(built.stdout + built.stderr)
        return 1
    root, faults = WORK / "html", []
    pages = sorted(p for p in root.rglob("*.html") if p.relative_to(root).parts[0] != "api" and p.name != "404.html")
    chromium = find_chromium()
    if chromium is None:
        print(f"{len(pages)} pages; not opened: there is no chromium (scripts/setup --browser)")
        return 0
    formulas = 0
    for width, opened in ((1400, {page.parent: page for page in pages}.values()), (390, pages)):
        with Browser(chromium, width, 900) as browser:
            for page in opened:
                browser.open(page)
                formulas += browser.evaluate("document.querySelectorAll('.katex').length")
                found = [f"picture {source}" for source in browser.evaluate(BROKEN)]
                found += [f"formula {text}" for text in browser.evaluate(FORMULAS)]
                found += browser.said()
                if (wider := browser.evaluate(WIDER)) > 0:
                    found.append(f"{wider} pixels wider than the window")
                faults += [f"{page.relative_to(root)}, {width} pixels wide: {text[:200]}" for text in found]
    with Browser(chromium, 1400, 900) as browser:
        browser.open(root / "docs/run.html")
        if not browser.evaluate(SEARCH):
            faults.append("the search has no entry with Cholesky")
    print("\n".join(faults) or f"no fault on {len(pages)} pages, with {formulas} formulas")
    return 1 if faults or not formulas else 0


if __name__ == "__main__":
    sys.exit(main())
