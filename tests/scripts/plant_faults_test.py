#!/usr/bin/env python3
"""scripts/plant_faults --check finds every way in which a fault no longer fits the sources, and what it plants is C++."""
import importlib.machinery
import importlib.util
import pathlib
import subprocess
import sys
import tempfile

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "scripts/plant_faults"
LOADER = importlib.machinery.SourceFileLoader("plant_faults", str(SCRIPT))
plant_faults = importlib.util.module_from_spec(importlib.util.spec_from_loader("plant_faults", LOADER))
LOADER.exec_module(plant_faults)

SOURCE = "#pragma once\nint sum(int a, int b) {\n  int s = a + b;\n  if (s < 0) s = 0;\n  return s;\n}\n"
SOUND = {"name": "a sign", "file": "sum.h", "text": "int s = a + b;", "part": "a + b", "fault": "a - b", "tests": ["base:Sum.*"]}


def check(*faults):
    """The script's exit status and output for a list of faults."""
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        (root / "scripts").mkdir()
        (root / "sum.h").write_text(SOURCE)
        text = "\n".join("[[fault]]\n" + "\n".join(f"{key} = {value!r}" for key, value in fault.items()) for fault in faults)
        (root / "scripts/planted_faults.toml").write_text(text + "\n")
        result = subprocess.run([sys.executable, SCRIPT, "--check", "--root", root], capture_output=True, text=True)
        return result.returncode, result.stdout + result.stderr


def expect(status, words, *faults):
    got, output = check(*faults)
    assert got == status and words in output, f"{faults}: status {got}, {output}"


expect(0, "2 faults fit", SOUND, {**SOUND, "name": "a negative sum", "text": "if (s < 0) s = 0;", "fault": "", "part": "s = 0"})
expect(1, "there is no such file", {**SOUND, "file": "product.h"})
expect(1, "its text is there 0 times", {**SOUND, "text": "int s = b + a;", "part": "b + a"})
expect(1, "its text is there 3 times", {**SOUND, "text": "s ", "part": "s"})
expect(1, "its part is in its text 0 times", {**SOUND, "part": "a * b"})
expect(1, "changes nothing", {**SOUND, "fault": "a + b"})
expect(1, "overlaps", SOUND, {**SOUND, "name": "a factor", "part": "a + b;", "fault": "2 * a;"})
expect(1, "twice in the list", SOUND, {**SOUND, "fault": "a"})

# What is planted compiles, and does what it should with and without the fault's number.
faults = [{**SOUND, "number": 1, "place": (SOURCE.index("a + b"), SOURCE.index("a + b") + 5)},
          {"name": "no floor", "text": "if (s < 0) s = 0;", "fault": "", "number": 2,
           "place": (SOURCE.index("if (s"), SOURCE.index("if (s") + len("if (s < 0) s = 0;"))}]
with tempfile.TemporaryDirectory() as folder:
    place = pathlib.Path(folder)
    (place / "ringwatch/base").mkdir(parents=True)
    (place / "ringwatch" / plant_faults.SWITCH).write_text(plant_faults.SWITCH_TEXT)
    (place / "sum.h").write_text(plant_faults.with_faults(SOURCE, faults))
    (place / "main.cpp").write_text('#include "sum.h"\nint main() { return 10 * sum(2, 1) + (sum(-3, 1) < 0); }\n')
    subprocess.run(["c++", "-std=c++20", "-I", place, place / "main.cpp", "-o", place / "main"], check=True)
    for number, wanted in [(0, 30), (1, 10), (2, 31)]:
        got = subprocess.run([place / "main"], env={"RINGWATCH_PLANTED": str(number)}).returncode
        assert got == wanted, f"fault {number}: {got}, not {wanted}"
print("plant_faults --check finds what does not fit")
