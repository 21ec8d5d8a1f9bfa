"""Every test has a name without dumps of its parameters, the label of its folder, and one of the labels fast and slow.

usage: test_names_test.py CTEST BUILD_DIR
"""
import json
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
print("\n".join(faults) or f"{len(tests)} tests are named and labelled")
sys.exit(1 if faults or not tests else 0)
