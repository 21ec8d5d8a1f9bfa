#!/usr/bin/env python3
"""tests/list_tests.cmake writes every case of a program once, with its labels, and fails on a pattern that selects none.
Cases that skip themselves, or that a build without VTK cannot run, are skipped by ctest. A test with parameters is one
test, as is a suite whose cases go together, which is as good as the worst of its cases.

usage: list_tests_test.py CMAKE CTEST
"""
import os
import pathlib
import subprocess
import sys
import tempfile

# Stands for a GoogleTest program: lists its cases by the patterns of --gtest_filter.
PROGRAM = """#!/usr/bin/env python3
import fnmatch, os, sys
CASES = ["Plain.First", "Plain.Second", "Plain.Third", "All/Any.Holds/tet4", "All/Any.Holds/hex8", "All/Any.Fails/tet4",
         "All/Any.Fails/hex8", "Typed/0.Holds", "Costly.One", "Costly.Two",
         "Shared.One", "Shared.Two"]
if "--gtest_brief=1" in sys.argv:  # runs a share of the fast or of the slow ones, or what GTEST_FILTER chooses
    print("filter", sys.argv[2])
    sys.exit(os.environ["GTEST_TOTAL_SHARDS"] != "3" or os.environ["GTEST_SHARD_INDEX"] == "1")
if "--gtest_list_tests" not in sys.argv:  # runs a case
    chosen = sys.argv[1].partition("=")[2]
    print({"Plain.First": "fine", "Plain.Second": "wrong", "Plain.Third": "[  SKIPPED ] Plain.Third", "Typed/0.Holds": "fine",
           "Shared.*": "[  SKIPPED ] Shared.Two", "All/Any.Holds/*": "[  SKIPPED ] All/Any.Holds/hex8", "All/Any.Fails/*": "[  SKIPPED ] All/Any.Fails/hex8"}.get(
        chosen, "ringwatch: frames: this build is without VTK; install it"))
    sys.exit(chosen not in ("Plain.First", "Plain.Third", "All/Any.Holds/*", "Typed/0.Holds"))
positive, _, negative = sys.argv[2].partition("=")[2].partition("-")
def matches(case, patterns):
    return any(fnmatch.fnmatchcase(case, p) for p in patterns.split(":") if p)
suite = None
for case in CASES:
    if matches(case, positive or "*") and not matches(case, negative):
        if case.split(".")[0] != suite:
            suite = case.split(".")[0]
            print(suite + ".")
        print("  " + case.split(".")[1] + ("  # GetParam() = 4" if suite == "All/Any" else ""))
"""


def listing(cmake, folder, slow, together="", shards=0):
    program, output = folder / "program", folder / "cases.cmake"
    program.write_text(PROGRAM)
    program.chmod(0o755)
    script = pathlib.Path(__file__).resolve().parent.parent / "list_tests.cmake"
    run = subprocess.run([cmake, "-D", f"PROGRAM={program}", "-D", "FOLDER=plain", "-D", f"SLOW={slow}", "-D",
                          f"TOGETHER={together}", "-D", f"SHARDS={shards}", "-D", f"OUTPUT={output}", "-P", str(script)],
                         capture_output=True, text=True)
    return run, output.read_text() if output.exists() else None


def expect(condition, what):
    if not condition:
        sys.exit(what)


def main():
    cmake = sys.argv[1]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        run, text = listing(cmake, folder, "Plain.Second:Plain.S*:All/Any.Holds/hex8", "Costly:Shared")
        expect(run.returncode == 0, run.stderr)
        speeds = {}
        for line in text.splitlines():
            if line.startswith("add_test("):
                test = line.split("[=[")[1].split("]=]")[0]
                expect(test not in speeds, f"{test} is written twice")
            else:
                speeds[test] = line.split('LABELS "')[1].split('"')[0]
        expect(speeds == {"plain.Plain.First": "plain;fast", "plain.Plain.Second": "plain;slow", "plain.Plain.Third": "plain;fast",
                          "plain.All/Any.Holds": "plain;slow", "plain.All/Any.Fails": "plain;fast",
                          "plain.Typed/0.Holds": "plain;fast", "plain.Costly": "plain;slow", "plain.Shared": "plain;slow"}, f"lists {speeds}")
        (folder / "CTestTestfile.cmake").write_text('include("cases.cmake")\n')
        ran = subprocess.run([sys.argv[2], "--test-dir", str(folder)], capture_output=True, text=True).stdout
        results = {words[3]: line.split(maxsplit=4)[4] for line in ran.splitlines()
                   if len(words := line.split()) > 4 and words[1] == "Test"}
        for case, what in [("Plain.First", "Passed"), ("Plain.Second", "***Failed"), ("Plain.Third", "***Skipped"),
                           ("All/Any.Holds", "Passed"), ("All/Any.Fails", "***Failed"), ("Typed/0.Holds", "Passed"),
                           ("Costly", "***Skipped"), ("Shared", "***Failed")]:
            expect(what in results.get(f"plain.{case}", ""), f"{case} is not {what}:\n{ran}")
        for slow, together, what in [("Plain.Fourth*", "", '"Plain.Fourth*"'), ("Plain.*:Any.*", "", '"Any.*"'),
                                     ("", "Cheap", "suite Cheap")]:
            run, text = listing(cmake, folder, slow, together)
            expect(run.returncode != 0 and what in run.stderr and text is None,
                   f"{slow} {together}: status {run.returncode}, {run.stderr}")
        def shares(environment={}):
            ran = subprocess.run([sys.argv[2], "--test-dir", str(folder), "--verbose"], capture_output=True, text=True,
                                 env=os.environ | environment).stdout
            return ([(line.split()[3], "Passed" in line) for line in ran.splitlines() if " Test #" in line],
                    [line.partition("--gtest_filter=")[2] for line in ran.splitlines() if ": filter " in line])
        run, text = listing(cmake, folder, "Plain.*:Costly.*", "Costly", 3)
        expect(run.returncode == 0 and text.count('LABELS "plain;fast"') == 3 and text.count('LABELS "plain;slow"') == 3,
               f"{run.stderr}{text}")
        results, filters = shares()
        expect(results == [(f"plain.{speed}_{k}", k != 1) for speed in ("fast", "slow") for k in range(3)], results)
        expect(filters == ["-Plain.*:Costly.*"] * 3 + ["Plain.*:Costly.*"] * 3, filters)
        _, filters = shares({"GTEST_FILTER": "Plain.First"})
        expect(filters == ["Plain.First"] * 6, filters)
        # A program whose cases are all fast, or all slow, has no tests of the others.
        for slow, speed in [("", "fast"), ("*", "slow")]:
            run, text = listing(cmake, folder, slow, shards=3)
            expect(run.returncode == 0 and shares()[0] == [(f"plain.{speed}_{k}", k != 1) for k in range(3)], f"{run.stderr}{text}")
    print("cases are listed once; patterns without a case are refused")


main()
