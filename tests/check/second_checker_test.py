#!/usr/bin/env python3
"""ringwatch-check and the second checker agree: on certificates of all elements, laws, rules and proofs, and on what is made of them.

  second_checker_test.py RINGWATCH RINGWATCH_CHECK [--trials N] [--seed S] [--keep FOLDER]

N certificates are tampered with by the grammar of the format, most of them with a checksum that fits. ringwatch-check accepts
what the second checker proves, and nothing else. What they differ in is kept in FOLDER.
"""
import argparse
import concurrent.futures
import functools
import itertools
import os
import pathlib
import random
import struct
import subprocess
import sys
import tempfile

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
SPECIAL = [b"nan", b"inf", b"-inf", b"0", b"-0", b"1e308", b"1e-320", b"1e999", b"0x1p+99999", b"-1", b"", b"x", b"4294967297", b"1e3"]
SPECIAL_DOUBLES = [float("nan"), float("inf"), -float("inf"), 0.0, -0.0, 1e308, 5e-324, -1.0]


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


class Parts:
    """A certificate by its grammar: lines, and records of nodes and of elements."""

    def __init__(self, data):
        end = data.index(b"\nend\n") + 5
        self.lines = data[: end - 1].split(b"\n")
        certificate = second.read(data)
        count = len(certificate["nodes"])
        self.nodes = [data[end + 81 * i : end + 81 * (i + 1)] for i in range(count)]
        body, elements = data[end + 81 * count : -8], len(certificate["elements"])
        self.corners = [len(entry["nodes"]) for entry in certificate["elements"]]
        size = len(body) // elements  # the bodies that are tampered with are of one kind
        self.elements = [body[size * i : size * (i + 1)] for i in range(elements)]

    def bytes(self):
        data = b"\n".join(self.lines) + b"\n" + b"".join(self.nodes) + b"".join(self.elements)
        return data + struct.pack("<Q", second.hashed(data))


def number_near(chance, word):
    """Another number in place of a word of the header."""
    way = chance.random()
    try:
        value = float.fromhex(word.decode())
    except (ValueError, OverflowError):
        return chance.choice(SPECIAL)
    if way < 0.4:
        return chance.choice(SPECIAL)
    if way < 0.5 and word.isdigit():
        return str(int(word) + chance.choice([-1, 1, 2**31, 2**32])).encode()
    factor = 1 + chance.choice([-1, 1]) * 10 ** chance.uniform(-14, 1)
    return (value * factor).hex().encode()


def change_header(chance, parts, other):
    i = chance.randrange(len(parts.lines))
    words = parts.lines[i].split(b" ")
    way = chance.randrange(8)
    if way <= 3 and len(words) > 1:
        k = chance.randrange(1, len(words))
        words[k] = number_near(chance, words[k])
        parts.lines[i] = b" ".join(words)
    elif way == 4:
        parts.lines.insert(chance.randrange(len(parts.lines)), parts.lines[i])
    elif way == 5:
        del parts.lines[i]
    elif way == 6:
        j = chance.randrange(len(parts.lines))
        parts.lines[i], parts.lines[j] = parts.lines[j], parts.lines[i]
    else:
        line = next((line for line in parts.lines if line.startswith(b"kind ") and line.count(b" ") > 1), b"kind a b")
        words = line.split(b" ")
        words[chance.choice([1, 2])] = chance.choice([*ELEMENTS, *LAWS]).encode()
        parts.lines[min(6, len(parts.lines) - 1)] = chance.choice([b" ".join(words), *other.lines[6:7], line + b" ", line + b"\r"])


def change_records(chance, records, other):
    i, j = chance.randrange(len(records)), chance.randrange(len(records))
    way = chance.randrange(5)
    if way == 0:
        records[i], records[j] = records[j], records[i]
    elif way == 1:
        records.insert(i, records[j])
    elif way == 2:
        del records[i]
    elif way == 3:
        records[i] = records[j]
    else:
        records[i] = chance.choice(other)


def change_numbers(chance, records, form, first):
    """A number of a record: a special one, one beside it, or one far away."""
    i = chance.randrange(len(records))
    size = struct.calcsize("<" + form)
    at = first + size * chance.randrange(max(1, (len(records[i]) - first) // size))
    if at + size > len(records[i]):
        return
    record = bytearray(records[i])
    (value,) = struct.unpack_from("<" + form, record, at)
    if form == "d":
        factor = 1 + chance.choice([-1, 1]) * 10 ** chance.uniform(-14, 1)
        value = chance.choice(SPECIAL_DOUBLES) if chance.random() < 0.3 else value * factor
    else:
        value = chance.choice([value + 1, value - 1, -value, 0, chance.randrange(-100, 100)])
        most = 2 ** (8 * size - 1)
        value = max(-most, min(most - 1, value))
    struct.pack_into("<" + form, record, at, value)
    records[i] = bytes(record)


def tampered(seed, genuine):
    """One certificate that is made of genuine ones."""
    chance = random.Random(seed)
    parts, other = (Parts(chance.choice(genuine)) for _ in range(2))
    for _ in range(chance.choice([1, 1, 1, 2, 3])):
        way = chance.randrange(8)
        corners = 4 * parts.corners[0]
        if way <= 1:
            change_header(chance, parts, other)
        elif way == 2:
            change_records(chance, parts.nodes, other.nodes)
        elif way == 3:
            change_records(chance, parts.elements, other.elements)
        elif way == 4:
            change_numbers(chance, parts.nodes, "d", 0)
        elif way == 5:
            i = chance.randrange(len(parts.nodes))
            parts.nodes[i] = parts.nodes[i][:80] + bytes([chance.choice([0, 1, 4, 7, 8, 255])])
        elif way == 6 or len(parts.elements[0]) == corners:
            i = chance.randrange(len(parts.elements))
            parts.elements[i] = change_corner(chance, parts.elements[i], len(parts.nodes))
        elif b"nodal-bound" in parts.lines[1]:
            change_numbers(chance, parts.elements, *chance.choice([("d", corners), ("h", corners + 8)]))
        else:
            change_numbers(chance, parts.elements, "i", corners)
        if not parts.nodes or not parts.elements or len(parts.lines) < 8:
            break
    data = parts.bytes()
    way = chance.random()
    if way < 0.05:
        data = data[: chance.randrange(len(data))]
    elif way < 0.08:
        data += chance.choice([b"\0", data, b"\n" * 8])
    elif way < 0.1:
        at = chance.randrange(len(data))
        data = data[:at] + bytes([data[at] ^ 1 << chance.randrange(8)]) + data[at + 1 :]
    return data


def change_corner(chance, record, nodes):
    at = 4 * chance.randrange(4)
    return record[:at] + struct.pack("<i", chance.choice([-1, nodes, 2**31 - 1, chance.randrange(nodes)])) + record[at + 4 :]


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


def tampered_faults(checked, made, trials, seed):
    # The smallest ones of each proof.
    genuine = []
    for proof in (b"nodal-bound", b"exchange-bound", b"factorisation"):
        of_proof = sorted((data for data in made.values() if b"\nproof " + proof in data), key=len)
        assert len(of_proof) >= 6, f"{len(of_proof)} certificates by {proof}"
        genuine += of_proof[:6]
    failed, accepted = 0, 0
    with concurrent.futures.ProcessPoolExecutor(os.cpu_count()) as pool:
        for first, fault in pool.map(functools.partial(tampered_fault, checked, genuine), range(seed, seed + trials), chunksize=20):
            accepted += first == 0
            failed += fault
    print(f"{trials} tampered with, {accepted} of them still proven, {failed} badly")
    assert trials // 100 < accepted < trials // 2, "too few or too many are accepted to show anything"
    return failed


def tampered_fault(checked, genuine, seed):
    """What ringwatch-check says of a certificate, and whether the second checker says otherwise."""
    data, name = tampered(seed, genuine), f"tampered-{seed}"
    first, (status, why) = checked.first(name, data), second.status(data)
    fault = first not in (0, 1, 2) or (first == 0) != (status == 0)
    if fault:
        checked.differ(name, data, f"ringwatch-check {first}, the second checker {status}: {why}")
    return first, fault


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("ringwatch", type=lambda file: pathlib.Path(file).resolve())
    parser.add_argument("checker", type=lambda file: pathlib.Path(file).resolve())
    parser.add_argument("--trials", type=int, default=2000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--keep", type=pathlib.Path)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        made = Certificates(options.ringwatch, folder).make()
        checked = Checked(options.checker, folder, options.keep)
        failed = genuine_faults(checked, made) + tampered_faults(checked, made, options.trials, options.seed)
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
