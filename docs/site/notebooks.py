#!/usr/bin/env python3
"""Makes a page of each notebook of examples/: runs it, and writes text, code and what came of it as Markdown.

usage: notebooks.py FOLDER [NAME ...]     the pages, FOLDER/examples/NAME.md, and their pictures; without nbclient or the module, and but for
                                          the NAMEs where some are given, they have code alone
"""
import base64
import importlib.util
import json
import pathlib
import sys

SOURCE = pathlib.Path(__file__).resolve().parents[2]


def has(name):
    return importlib.util.find_spec(name) is not None


def page(path, folder, run):
    if run:
        import nbclient
        import nbformat

        notebook = nbformat.read(path, as_version=4)
        nbclient.NotebookClient(notebook, timeout=600, resources={"metadata": {"path": str(folder)}}).execute()
    else:
        notebook = json.loads(path.read_text(encoding="utf-8"))
    lines, pictures = [], 0
    for cell in notebook["cells"]:
        source = "".join(cell["source"])
        if cell["cell_type"] == "markdown":
            lines += [source, ""]
            continue
        lines += ["```python", source, "```", ""]
        for output in cell["outputs"]:
            if output.get("name") == "stdout":
                lines += ["```text", output["text"].rstrip(), "```", ""]
            elif "image/png" in output.get("data", {}):
                picture = f"{path.stem}_{pictures}.png"
                (folder / picture).write_bytes(base64.b64decode(output["data"]["image/png"]))
                lines += [f"![Picture {pictures + 1} of this notebook]({picture})", ""]
                pictures += 1
    lines.append(f"The notebook is `examples/{path.name}`.")
    (folder / f"{path.stem}.md").write_text("\n".join(lines) + "\n", encoding="utf-8")


def main():
    folder, chosen = pathlib.Path(sys.argv[1]) / "examples", sys.argv[2:]
    run = all(has(name) for name in ("nbclient", "ipykernel", "matplotlib", "ringwatch"))
    if not run:
        print("notebooks: not run, since nbclient, matplotlib (scripts/setup --notebook) or the module ringwatch is missing")
    for path in sorted((SOURCE / "examples").glob("*.ipynb")):
        page(path, folder, run and (not chosen or path.stem in chosen))


if __name__ == "__main__":
    main()
