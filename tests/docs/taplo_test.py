#!/usr/bin/env python3
"""Has taplo, which editors use, check scenes by the schema: the examples, and scenes whose first line names it as docs/machines.md says.

usage: taplo_test.py SOURCE_DIR PROGRAM     exit status 77: taplo is missing
"""
import pathlib
import shutil
import subprocess
import sys
import tempfile

source, program = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
taplo = shutil.which("taplo", path=source / "build/taplo/node_modules/.bin") or shutil.which("taplo")


def check(*files, folder):
    done = subprocess.run([taplo, "check", *files], cwd=folder, capture_output=True, text=True, check=False)
    return done.returncode, done.stdout + done.stderr


def main():
    if taplo is None:
        print("not checked: there is no taplo (scripts/setup --editor)")
        return 77
    examples = sorted(str(path.relative_to(source)) for path in (source / "examples").glob("*.toml"))
    status, said = check(*examples, folder=source)
    if status or f"total={len(examples)}" not in said or len(examples) < 5:
        print(said)
        return 1
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "scene.schema.json").write_text(
            subprocess.run([program, "schema", "scene"], capture_output=True, text=True, check=True).stdout, encoding="utf-8")
        first = next(line for line in (source / "docs/machines.md").read_text(encoding="utf-8").split("\n") if line.startswith("#:schema"))
        good = (source / examples[0]).read_text(encoding="utf-8")
        for text, expected in ((good, 0), (good.replace("young = ", "youngs = "), 1), (good.replace('"bar"', '"barn"'), 1)):
            (folder / "scene.toml").write_text(f"{first}\n" + text.split("\n", 1)[1], encoding="utf-8")
            status, said = check("scene.toml", folder=folder)
            if (status != 0) != expected:
                print(f"taplo ends with {status}, not {expected}:\n{text}\n{said}")
                return 1
    print(f"{len(examples)} examples, and scenes with {first}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
