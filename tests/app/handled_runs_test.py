#!/usr/bin/env python3
"""handled_runs_test.py STUDY PROGRAM: bench/handled_runs.py goes on where it was stopped, and not with another study's runs."""
import json
import pathlib
import subprocess
import sys
import tempfile

study, program = sys.argv[1:]


def run(out, *options, steps=60):
    return subprocess.run([sys.executable, study, program, "--out", out, "--steps", str(steps), "--bodies", "bar, jitter", "--laws", "stvk",
                           "--loads", "held", "--factors", "2", "3", "--handlers", "plain, half", "imex", *options],
                          capture_output=True, text=True, check=False)


with tempfile.TemporaryDirectory() as folder:
    out = pathlib.Path(folder)
    whole = run(out)
    assert whole.returncode == 0, whole.stderr
    assert whole.stdout.startswith("3 of 3 runs, 60 steps each."), whole.stdout
    notes = (out / "made.jsonl").read_text()
    lines = notes.splitlines()
    assert len(lines) == 4, notes
    assert all(json.loads(line)["verdict"] for line in lines[1:]), notes

    # Stopped while it noted its last run.
    (out / "made.jsonl").write_text(notes[:-20])
    rest = run(out, "--resume")
    assert rest.returncode == 0, rest.stderr
    again = (out / "made.jsonl").read_text().splitlines()
    assert again[:3] == lines[:3], "what was noted was made again"
    first, second = (dict(json.loads(rows[3]), seconds=0) for rows in (lines, again))
    assert first == second, (first, second)
    assert rest.stdout.startswith("3 of 3 runs, 60 steps each."), rest.stdout

    other = run(out, "--resume", steps=40)
    assert other.returncode != 0 and "made.jsonl" in other.stderr and '"steps": 40' in other.stderr, other.stderr
    assert (out / "made.jsonl").read_text().splitlines() == again
