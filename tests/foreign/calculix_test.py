"""CalculiX: its own test decks as scenes, and its results audited.

usage: calculix_test.py decks|audit RINGWATCH DECKS_OF_OURS
"""

import collections
import gzip
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

what, ringwatch, here = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])
work = pathlib.Path(tempfile.mkdtemp(prefix="ringwatch-calculix-"))


def call(*arguments):
    return subprocess.run([ringwatch, *map(str, arguments)], cwd=work, capture_output=True, text=True)


def run_ccx(name):
    if shutil.which("ccx") is None:
        print("skipped: calculix-ccx is not installed (scripts/setup --foreign)")
        sys.exit(77)
    environment = {**os.environ, "OMP_NUM_THREADS": "1"}
    return subprocess.run(["ccx", name], cwd=work, capture_output=True, text=True, env=environment, timeout=300)


def decks():
    folder = pathlib.Path("/usr/share/doc/calculix-ccx-test/examples/test")
    files = sorted(folder.glob("*.inp")) + sorted(folder.glob("*.inp.gz")) if folder.exists() else []
    if not files:
        print("skipped: calculix-ccx-test is not installed (scripts/setup --foreign)")
        sys.exit(77)
    texts = {}
    for file in files:
        name = file.name.removesuffix(".gz")
        data = gzip.open(file).read() if file.suffix == ".gz" else file.read_bytes()
        (work / name).write_bytes(data)
        texts[name] = data.decode("latin-1")
    count, reasons = collections.Counter(), collections.Counter()
    for name, text in sorted(texts.items()):
        types = set(re.findall(r"^\*ELEMENT[^\n]*?TYPE\s*=\s*([A-Za-z0-9]+)", text, re.M | re.I))
        if not any(kind.upper().startswith("C3D") for kind in types):
            continue
        result = call("inspect", name, "--metric", "pressure-wave", "--density", "1") if "*DENSITY" not in text.upper() else call(
            "inspect", name, "--metric", "pressure-wave", "--json", "-"
        )
        count["solid"] += 1
        if result.returncode == 0:
            count["understood"] += 1
            if "*DENSITY" in text.upper():
                check_counts(name, text, json.loads(result.stdout))
                count["counted"] += 1
        else:
            assert result.returncode == 2, (name, result)
            line = result.stderr.strip()
            assert "\n" not in line and re.search(rf"{re.escape(name)}(:\d+)?: ", line), (name, line)
            reasons[reason_of(line)] += 1
            count["refused"] += 1
        ran = call("run", name, "--out", "out", "--set", "integrator.end=1e-300", "--quiet")
        assert ran.returncode in (0, 1, 2, 3), (name, ran)
        count["run" if ran.returncode != 2 else "not run"] += 1
    print(dict(count))
    for reason, times in reasons.most_common():
        print(f"{times:4d}  {reason}")
    assert count["solid"] == count["understood"] + count["refused"]
    assert count["understood"] >= 60 and count["counted"] >= 40 and count["run"] >= 5


def reason_of(line):
    line = re.sub(r"^ringwatch: ", "", line)
    line = line.split("; and ")[0]
    return re.sub(r"^[^ ]*: ", "", line)[:90]


def check_counts(name, text, read):
    """Nodes and elements, counted here by another reading of the deck."""
    nodes, elements, keyword, left = set(), 0, "", 0
    for line in text.splitlines():
        line = line.strip()
        if line.startswith("**") or not line:
            continue
        if line.startswith("*"):
            keyword = line.upper().replace(" ", "")
            size = re.search(r"TYPE=[A-Z]*3D(\d+)", keyword)
            left = 0
            continue
        words = [word for word in line.split(",") if word.strip()]
        if re.match(r"\*NODE(,|$)", keyword):
            nodes.add(int(words[0]))
        elif keyword.startswith("*ELEMENT,") and size:
            if left == 0:
                elements += 1
                left = int(size[1]) + 1
            left -= len(words)
    assert read["mesh"]["nodes"] <= len(nodes), name
    assert sum(read["mesh"]["elements"].values()) == elements, (name, read["mesh"]["elements"], elements)


def audit():
    """A bar that CalculiX pulls with the step that it chose at the start: it ends in NaN with exit status 0."""
    shutil.copy(here / "pulled_bar.inp", work)
    result = run_ccx("pulled_bar")
    assert result.returncode == 0, result.stdout[-500:]
    results = (work / "pulled_bar.frd").read_text()
    assert "NAN" in results, "CalculiX no longer loses this run"
    audited = call("audit", "pulled_bar.frd", "--scene", "pulled_bar.inp", "--json", "-")
    assert audited.returncode == 1, audited.stderr
    found = json.loads(audited.stdout)
    text = call("audit", "pulled_bar.frd", "--scene", "pulled_bar.inp").stdout
    print("\n".join(text.splitlines()[:12] + text.splitlines()[-8:]))
    chosen = float(re.search(r"SELECTED time increment:\s*(\S+)", result.stdout)[1])
    history = found["history"]
    assert abs(history[0]["step"] / chosen - 1) < 1e-4, (history[0]["step"], chosen)
    first, lost = found["first"]["violated"]["state"], found["first"]["lost"]["state"]
    # What one sees in the results: the largest displacement leaves the bar.
    seen = next(s["state"] for s in history if s["strain_energy"] is None or s["strain_energy"] > 10)
    print(f"proven unstable from state {first}, seen at state {seen}, lost at state {lost} of {len(history)}")
    assert first + 2 <= seen <= lost


{"decks": decks, "audit": audit}[what]()
shutil.rmtree(work)
