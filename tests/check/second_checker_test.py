#!/usr/bin/env python3
"""ringwatch-check and the second checker agree: on certificates of all elements, laws, rules and proofs, and on what is made of them.

  second_checker_test.py RINGWATCH RINGWATCH_CHECK TESTS [--trials N] [--seed S] [--keep FOLDER]

TESTS, ringwatch_test_check, tampers with N certificates by the grammar of the format. ringwatch-check accepts what the second
checker proves, and nothing else. What they differ in is kept in FOLDER.
"""
import argparse
import concurrent.futures
import functools
import itertools
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import second_checker as second  # noqa: E402

ELEMENTS = {"tet4": [None], "hex8": [None, "selective", "hourglass", "gauss-3x3x3"], "wedge6": [None, "selective", "fierz2013"],
            "pyramid5": [None, "jacobi-2x2x1"], "tet10": [None], "hex20": ["gauss-2x2x2"]}
LAWS = list(second.LAWS)
# The runs whose frames are the deformed states.
SCENE = """
[mesh]
file = "{mesh}"
[material]
model = "{law}"
young = 30e3
poisson = 0.3
density = 1000
[integrator]
step = "auto"
end = 0.03
[monitor]
on_violation = "warn"
certificates = 1000
[[fix]]
where = "x < 1e-6"
[[move]]
where = "x > 0.1 - 1e-6"
velocity = [0.5, 0.3, 0]
"""
MATERIAL = ["--young", "30e3", "--poisson", "0.3", "--density", "1000"]


def call(*line, folder):
    return subprocess.run(list(map(str, line)), cwd=folder, capture_output=True, check=False)


class Certificates:
    def __init__(self, ringwatch, folder):
        self.ringwatch, self.folder, self.made = ringwatch, folder, {}

    def make(self):
        cases = [(element, rule, law) for element, rules in ELEMENTS.items() for rule in rules for law in LAWS]
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            list(pool.map(self.of_case, itertools.count(), cases))
        return self.made

    def of_case(self, number, case):
        element, rule, law = case
        mesh, rules = f"{number}.msh", ["--rule", f"{element}={rule}"] if rule else []
        self.run("mesh", "generate", "bar", "--size", "0.1", "0.05", "0.05", "--cells", "2" if number % 2 else "1", "1", "1", "--element", element,
                 *(["--jitter", "0.1"] if number % 3 else []), "-o", mesh)
        for proof in ([], ["--exact"], ["--prove", "1e-4"], ["--prove", "1"])[number % 2 :: 2]:
            held = ["--fix", ("x < 1e-6", "x < 1e-6:xz")[number % 5 == 0]]
            # Where a step is proven unstable the exit status is 1.
            self.run("inspect", mesh, *MATERIAL, "--model", law, *rules, *held, *proof, "--certificate", f"{number}.certificate", most=1)
            self.made["-".join(map(str, [*case, *proof]))] = (self.folder / f"{number}.certificate").read_bytes()
        scene = SCENE.format(mesh=mesh, law=law).replace("density", f'rules = ["{element}={rule}"]\ndensity' if rule else "density")
        (self.folder / f"{number}.toml").write_text(scene)
        self.run("run", f"{number}.toml", "--out", f"run-{number}", "--quiet", "--set", "output.picture=false", most=3)
        # The first one is at rest, the others are not; the last ones of a run come before and at the first violated step.
        for file in sorted((self.folder / f"run-{number}/certificates").iterdir())[1:]:
            self.made["-".join(map(str, [*case, file.stem]))] = file.read_bytes()

    def run(self, *line, most=0):
        ended = call(self.ringwatch, *line, folder=self.folder)
        assert 0 <= ended.returncode <= most, f"{line}: {ended.stderr.decode()}"


class Checked:
    def __init__(self, checker, folder, keep):
        self.checker, self.folder, self.keep = checker, folder, keep

    def first(self, name, data):
        file = self.folder / f"{name}.tried"
        file.write_bytes(data)
        ended = call(self.checker, file, folder=self.folder)
        file.unlink()
        return ended.returncode

    def differ(self, name, data, what):
        print(f"{name}: {what}", flush=True)
        if self.keep:
            self.keep.mkdir(parents=True, exist_ok=True)
            (self.keep / f"{name}.certificate").write_bytes(data)


def genuine_faults(checked, made):
    failed = 0
    for name, data in made.items():
        first, (status, why) = checked.first("genuine", data), second.status(data)
        if (first, status) != (0, 0):
            checked.differ(name, data, f"ringwatch-check {first}, the second checker {status}: {why}")
            failed += 1
    return failed


def tampered_faults(checked, program, trials, seed, seconds):
    """Of what the test IsProvenOnlyWhereItIsTrue makes, in batches, each of its own seed."""
    failed, tried, accepted, batch, end = 0, 0, 0, 2000, time.monotonic() + seconds
    with concurrent.futures.ProcessPoolExecutor(os.cpu_count()) as pool:
        for first in range(0, trials, batch):
            if time.monotonic() > end:
                break
            with tempfile.TemporaryDirectory() as name:
                asked = {"RINGWATCH_TAMPERED_CERTIFICATES": str(min(batch, trials - first)), "RINGWATCH_TAMPERED_FOLDER": name, "RINGWATCH_SEED": str(seed)}
                made = subprocess.run([program, "--gtest_filter=TamperedCertificate.IsProvenOnly*"], env={**os.environ, **asked}, capture_output=True, check=False)
                assert made.returncode == 0, made.stdout.decode()
                for status, fault in pool.map(functools.partial(tampered_fault, checked, seed), sorted(pathlib.Path(name).iterdir()), chunksize=20):
                    tried, accepted, failed = tried + 1, accepted + (status == 0), failed + fault
            seed += 1
    print(f"{tried} tampered with, {accepted} of them still proven, {failed} badly")
    assert tried // 100 < accepted < tried // 2, "too few or too many are accepted to show anything"
    return failed


def tampered_fault(checked, seed, file):
    """What ringwatch-check says of a certificate, and whether the second checker says otherwise."""
    data, name = file.read_bytes(), f"tampered-{seed}-{file.stem}"
    first, (status, why) = checked.first(name, data), second.status(data)
    fault = first not in (0, 1, 2) or (first == 0) != (status == 0)
    if fault:
        checked.differ(name, data, f"ringwatch-check {first}, the second checker {status}: {why}")
    return first, fault


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("ringwatch", type=lambda file: pathlib.Path(file).resolve())
    parser.add_argument("checker", type=lambda file: pathlib.Path(file).resolve())
    parser.add_argument("tests", type=lambda file: pathlib.Path(file).resolve())
    parser.add_argument("--trials", type=int, default=2000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--seconds", type=float, default=math.inf, help="begin no batch after so long")
    parser.add_argument("--keep", type=pathlib.Path)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        made = Certificates(options.ringwatch, folder).make()
        checked = Checked(options.checker, folder, options.keep)
        failed = genuine_faults(checked, made) + tampered_faults(checked, options.tests, options.trials, options.seed, options.seconds)
        print(f"{len(made)} certificates; {failed} failed")
    sys.exit(failed > 0)


class Key:
    """Arguments of a tangent, by the values of their numbers."""

    def __init__(self, kind, X, x):
        self.arguments = kind, X, x
        points = tuple((weight, tuple((a.low, a.high) for row in g for a in row)) for g, weight in kind["points"])
        self.key = (kind["element"], kind["law"], kind["constants"], points, tuple((a.low, a.high) for rows in (X, x) for row in rows for a in row))

    def __hash__(self):
        return hash(self.key)

    def __eq__(self, other):
        return self.key == other.key


# The same element comes again and again.
TANGENT = second.element_tangent
CACHED = functools.lru_cache(10000)(lambda key: TANGENT(*key.arguments))
second.element_tangent = lambda kind, X, x: CACHED(Key(kind, X, x))

if __name__ == "__main__":
    main()
