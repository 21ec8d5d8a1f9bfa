"""bench/results.py makes rows of what the stages of scripts/nightly tell, and the page of promises of the rows.

usage: nightly_results_test.py SOURCE_DIR
"""
import json
import pathlib
import re
import sys
import tempfile

source = pathlib.Path(sys.argv[1])
sys.path.insert(0, str(source / "bench"))
import results  # noqa: E402

# Of each stage: what its programs print, the exit status, and the trials and findings that a reader counts in it.
LOGS = {
    "studies": ("705 checks, 0 failed\nconclusion: 0 of 705 checks failed\n45 checks, 2 failed\n", 1, [(750, "checks")], 2),
    "handlers": ("| all | 0 of 16 |\n\n64 of 64 runs, 100000 steps each.\n", 0, [(64, "runs")], 0),
    "ranks": ("[  PASSED  ] 3 tests.\n1000 random bodies\n", 0, [(1000, "bodies")], 0),
    "states": ("500010 elements in 700 states, 10 of them along runs, 0 wrong, 2 without\n500020 elements in 710 states, 9 of them along runs, 1 wrong, 3 without\n"
               "90 elements in 800 states along 125 runs, 0 wrong, 3 runs ended\n", 1, [(1000030, "elements"), (125, "watched runs")], 1),
    "calls": ("run: open 3 of 9: x is half written\ncalls that failed: {'open': 20, 'short': 18, 'read-only': 2}; 1 of them badly\n"
              "calls that failed: {'allocation': 300}; 0 of them badly\n", 1, [(340, "calls")], 1),
    "certificates": ("500 tampered with: 60 are proven and true, 1 of them undecided\n500 tampered with: 70 are proven and true, 0 of them undecided\n"
                     "2000 tampered with, 400 of them still proven, 0 badly\n120 certificates; 0 failed\n", 0, [(1000, "certificates"), (2000, "by the second checker")], 0),
    "fuzz": ("msh 10 inputs 5/s  cov 9  corpus 3  no finding\ninputs: 123456, targets with findings: 2\n", 1, [(123456, "inputs")], 2),
    "kills": ("63 kills, 30 stops, 40 resumptions, 70 runs of them compared\n64 kills, 31 stops, 41 resumptions, 71 runs of them compared\n", 0,
              [(127, "kills"), (81, "resumptions")], 0),
    "scenes": ("scene of seed 7: two threads differ\n500 scenes: 400 with exit status 0; 60 resumed; 1 failed; acted: handlers 3\n", 1, [(500, "scenes")], 1),
    "faults": ("caught  a.cpp: b: t\nNOT CAUGHT  a.cpp: c: \n49 of 50 faults were noticed\n", 1, [(50, "faults")], 1),
    "coverage": ("monitor   6309 lines   93.8 %    7191 branches   86.5 % below\ncoverage: 17440 lines, 22919 branches; 1 folders below 95 % of lines or 85 % of branches\n", 1,
                 [(17440, "lines"), (22919, "branches")], 1),
    "asan": ("100% tests passed, 0 tests failed out of 900\n99% tests passed, 3 tests failed out of 90\n", 8, [(990, "tests")], 3),
    "headers": ("nothing is counted\n", 1, [(1, "run")], 1),
}
stages = re.search(r"^stages=\((.*)\)$", (source / "scripts/nightly").read_text(encoding="utf-8"), re.MULTILINE)[1].split()
assert results.TRIALS.keys() | LOGS.keys() <= set(stages) and results.TRIALS.keys() <= LOGS.keys()

run = {"measurements": []}
for name, (log, status, trials, findings) in LOGS.items():
    for _ in range(2):  # the second time in place of the first
        results.stage(run, name, log, status, 7)
    rows = [row for row in run["measurements"][0]["rows"] if row[0] == name]
    assert [(row[2], row[3]) for row in rows] == trials, (name, rows)
    assert all(row[4] == findings and row[5] == 7 for row in rows), (name, rows)
columns = run["measurements"][0]["columns"]
assert all(len(row) == len(columns) for row in run["measurements"][0]["rows"])

with tempfile.TemporaryDirectory() as folder:
    page = pathlib.Path(folder) / "page.md"
    page.write_text("| a promise | `t` | 3 | `kills` | old |\n| another | `t` | all | `asan`, `web` | |\n\ntext | with | bars\n", encoding="utf-8")
    results.RELIABILITY = page
    made = results.reliability([("first", {"measurements": [{"subject": "Nightly stages", "rows": [["kills", "", 5, "kills", 1, 1, 1, ""]]}]}), ("last", json.loads(json.dumps(run)))])
    assert made == ("| a promise | `t` | 3 | `kills` | 127 kills, 81 resumptions: no findings |\n"
                    "| another | `t` | all | `asan`, `web` | `asan`: 990 tests: 3 findings; `web`: none recorded |\n\ntext | with | bars\n"), made
print(f"{len(LOGS)} stages are read")
