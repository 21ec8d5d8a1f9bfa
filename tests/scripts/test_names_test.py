"""Every test has a name without dumps of its parameters, the label of its folder, and one of the labels fast and slow; those that
docs/reliability.md names exist, and so do its stages of scripts/nightly.

usage: test_names_test.py CTEST BUILD_DIR SOURCE_DIR
"""
import fnmatch
import json
import pathlib
import re
import subprocess
import sys

listed = subprocess.run([sys.argv[1], "--test-dir", sys.argv[2], "--show-only=json-v1"], capture_output=True, text=True,
                        check=True)
tests = json.loads(listed.stdout)["tests"]
faults = []
for test in tests:
    name = test["name"]
    labels = next((p["value"] for p in test.get("properties", []) if p["name"] == "LABELS"), [])
    if name.endswith("_NOT_BUILT"):  # GoogleTest's cases are known only once their program is built
        continue
    if re.search(r"[#<>\s]|GetParam|-byte|/[0-9]+$", name):
        faults.append(f"{name}: give its test suite a name generator")
    if ("fast" in labels) == ("slow" in labels):
        faults.append(f"{name}: has the labels {labels}, not one of fast and slow")
    if name.split(".")[0] not in labels:
        faults.append(f"{name}: has not the label of its folder")
source = pathlib.Path(sys.argv[3])
stages = re.search(r"^stages=\((.*)\)$", (source / "scripts/nightly").read_text(encoding="utf-8"), re.MULTILINE)[1].split()
names = [test["name"] for test in tests]
# What is not built or not configured here has none.
folders = {name.split(".")[0] for name in names} - {name.removesuffix("_NOT_BUILT") for name in names if name.endswith("_NOT_BUILT")}
promises = re.findall(r"^\| (.*?) \| (.*?) \| .*? \| (.*?) \| .*? \|$", (source / "docs/reliability.md").read_text(encoding="utf-8"), re.MULTILINE)[2:]
for promise, by, nightly in promises:
    patterns = re.findall(r"`(.*?)`", by)
    faults += [f"docs/reliability.md: there is no test {pattern}" for pattern in patterns
               if pattern.split(".")[0] in folders and not fnmatch.filter(names, pattern)]
    faults += [f"docs/reliability.md: there is no stage {stage}" for stage in re.findall(r"`(.*?)`", nightly) if stage not in stages]
    if not patterns and by != "all":
        faults.append(f"docs/reliability.md: no test of: {promise}")
if len(promises) < 10:
    faults.append(f"docs/reliability.md: only {len(promises)} promises are read")
print("\n".join(faults) or f"{len(tests)} tests are named and labelled")
sys.exit(1 if faults or not tests else 0)
