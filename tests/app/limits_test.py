"""What the program does at the edges: bodies of no, one and two elements, steps above 2^31, names with blanks and letters of any language,
a small stack, many threads.

usage: limits_test.py few|steps|names|stack|threads RINGWATCH RINGWATCH_CHECK
"""
import itertools
import json
import math
import os
import pathlib
import struct
import subprocess
import sys
import tempfile
import time

POINTS = [(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0), (1.0, 1.0, 1.0)]
CELLS = [(0, 1, 2, 3), (1, 2, 3, 4)]
YOUNG, POISSON, DENSITY = 30e3, 0.3, 1000.0
MATERIAL = ["--young", YOUNG, "--poisson", POISSON, "--density", DENSITY]
SCENE = """[mesh]
file = "{mesh}"
[material]
model = "linear"
young = 30e3
poisson = 0.3
density = 1000
[integrator]
step = 1e-3
end = 0.01
[[initial]]
where = "x < 0.5"
velocity = [1, 0, 0]
[output]
every = 0.005
picture = false
"""
LARGE = 2**31 + 3


def mesh_text(elements):
    nodes = POINTS[: 5 if elements > 1 else 4]
    return "".join(["$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n", f"{len(nodes)}\n", *(f"{i} {x} {y} {z}\n" for i, (x, y, z) in enumerate(nodes, 1)),
                    f"$EndNodes\n$Elements\n{elements}\n", *(f"{e} 4 0 " + " ".join(str(n + 1) for n in cell) + "\n" for e, cell in enumerate(CELLS[:elements], 1)),
                    "$EndElements\n"])


def critical_step(elements):
    """2/sqrt of the highest eigenvalue, s: Hooke's law at one point, a quarter of the mass at each node, by the power method."""
    shear, first = YOUNG / (2 * (1 + POISSON)), YOUNG * POISSON / ((1 + POISSON) * (1 - 2 * POISSON))
    size = 3 * (5 if elements > 1 else 4)
    stiffness, mass = [[0.0] * size for _ in range(size)], [0.0] * size
    for cell in CELLS[:elements]:
        p = [POINTS[n] for n in cell]
        e = [[p[a][i] - p[0][i] for i in range(3)] for a in (1, 2, 3)]
        cross = [[e[(k + 1) % 3][(i + 1) % 3] * e[(k + 2) % 3][(i + 2) % 3] - e[(k + 1) % 3][(i + 2) % 3] * e[(k + 2) % 3][(i + 1) % 3] for i in range(3)] for k in range(3)]
        six = sum(e[0][i] * cross[0][i] for i in range(3))  # six times the volume
        gradients = [[x / six for x in row] for row in cross]
        gradients.insert(0, [-sum(g[i] for g in gradients) for i in range(3)])
        for a, b in itertools.product(range(4), repeat=2):
            ga, gb = gradients[a], gradients[b]
            dot = sum(x * y for x, y in zip(ga, gb))
            for i, j in itertools.product(range(3), repeat=2):
                stiffness[3 * cell[a] + i][3 * cell[b] + j] += abs(six) / 6 * (first * ga[i] * gb[j] + shear * ga[j] * gb[i] + shear * dot * (i == j))
        for n, i in itertools.product(cell, range(3)):
            mass[3 * n + i] += DENSITY * abs(six) / 6 / 4
    v, value = [math.sin(1 + i * i) for i in range(size)], 0.0
    for _ in range(2000):
        w = [sum(k / math.sqrt(mass[i] * mass[j]) * v[j] for j, k in enumerate(row)) for i, row in enumerate(stiffness)]
        value = math.sqrt(sum(x * x for x in w))
        v = [x / value for x in w]
    return 2 / math.sqrt(value)


class Tries:
    def __init__(self, program, folder, limits=""):
        self.program, self.folder, self.limits, self.environment = program, folder, limits, dict(os.environ)

    def call(self, *words, most=1):
        """What a command says that ends by the status 0, or at most `most`."""
        command = ["sh", "-c", self.limits + 'exec "$0" "$@"', self.program, *map(str, words)]
        ended = subprocess.run(command, cwd=self.folder, env=self.environment, capture_output=True, text=True, timeout=300, check=False)
        assert 0 <= ended.returncode <= most, (words, ended.returncode, ended.stderr)
        return ended

    def commands(self, name):
        """Every command that reads or writes files, each of files whose names begin alike."""
        mesh, scene, out = f"{name}.msh", f"{name}.toml", f"{name} out"
        return [["inspect", mesh, *MATERIAL, "--metric", "all", "--global", "--exact", "--report", f"{name}.html", "--json", f"{name}.json", "--vtu", f"{name}.vtu",
                 "--certificate", f"{name}.certificate"],
                ["mesh", "check", mesh], ["mesh", "repair", mesh, f"{name} repaired.msh"], ["mesh", "convert", mesh, f"{name} converted.vtu"],
                ["mesh", "convert", "--binary", mesh, f"{name} binary.msh"], ["mesh", "check", f"{name} binary.msh"],
                ["run", scene, "--out", out, "--report"], ["report", out, "--out", f"{name} page.html"], ["inspect", out, "--frame", 1],
                ["suggest", scene, "--json", f"{name} suggest.json"], ["advise", scene, "--json", f"{name} advise.json"],
                ["scale-mass", scene, "--step", 1e-2, "--json", f"{name} mass.json"], ["compare", scene, "--out", f"{name} compare", "--report", f"{name} compare.html"],
                ["judge", mesh, "--metric", "single-element", "--worst", f"{name} worst", "--report", f"{name} judge.html", "--junit", f"{name} judge.xml"],
                ["judge", mesh, "--command", "cat {mesh} {mesh.vtu} {mesh.inp} >/dev/null && echo 1e-9"],
                ["audit", f"{out}/run.pvd", "--scene", scene, "--report", f"{name} audit.html"], ["init", f"{name} new.toml", "--mesh", mesh, *MATERIAL],
                *(["run", scene, "--out", f"{out} {handler}", "--set", f'handler.method="{handler}"', "--set", "integrator.step=0.1", "--set", "integrator.end=1"]
                  for handler in ("local-time-stepping", "imex", "mass-scaling"))]

    def write(self, name, elements):
        (self.folder / f"{name}.msh").write_text(mesh_text(elements), encoding="utf-8")
        (self.folder / f"{name}.toml").write_text(SCENE.format(mesh=f"{name}.msh"), encoding="utf-8")


def few(program, folder, checker):
    tries = Tries(program, folder)
    for elements in (1, 2):
        name = f"of {elements}"
        tries.write(name, elements)
        for words in tries.commands(name):
            tries.call(*words, most=3)
        found = json.loads(tries.call("inspect", f"{name}.msh", *MATERIAL, "--model", "linear", "--exact", "--json", "-").stdout)["critical_step"]
        exact = critical_step(elements)
        assert found["exact"]["safe"] <= exact * (1 + 1e-9) and exact <= found["exact"]["optimistic"] * (1 + 1e-9), (elements, exact, found["exact"])
        assert found["exact"]["optimistic"] < 1.00001 * found["exact"]["safe"]
        subprocess.run([checker, f"{name}.certificate"], cwd=folder, check=True, stdout=subprocess.DEVNULL)
    tries.write("of 0", 0)
    for words in tries.commands("of 0"):
        ended = tries.call(*words, most=2)
        assert ended.returncode == 2 and ended.stderr.count("\n") == 1 and ended.stderr.startswith("ringwatch: "), (words, ended.stderr)
    assert sorted(path.name for path in folder.iterdir() if path.name.startswith("of 0")) == ["of 0.msh", "of 0.toml"]


def seal(text):
    """The bytes of a checkpoint with their checksum, FNV-1a by words."""
    value, prime, whole = 0xCBF29CE484222325, 0x100000001B3, len(text) // 8 * 8
    for (word,) in struct.iter_unpack("<Q", text[:whole]):
        value = (value ^ word) * prime % 2**64
        value ^= value >> 32
    for byte in text[whole:]:
        value = (value ^ byte) * prime % 2**64
    return text + struct.pack("<Q", value)


def later(data, by):
    """A checkpoint whose number of steps is larger, and that number."""
    assert seal(data[:-8]) == data
    begin = data.index(b"\n") + 9
    (size,) = struct.unpack("<Q", data[begin - 8 : begin])
    head, rest = data[begin : begin + size], data[begin + size : -8]
    at = head.index(b"\x65steps", head.index(b"\x66result")) + 6  # texts of CBOR, and a number behind the second
    width = {0x18: 1, 0x19: 2, 0x1A: 4, 0x1B: 8}.get(head[at], 0)
    steps = (int.from_bytes(head[at + 1 : at + 1 + width], "big") if width else head[at]) + by
    head = head[:at] + b"\x1b" + steps.to_bytes(8, "big") + head[at + 1 + width :]
    return steps, seal(data[: begin - 8] + struct.pack("<Q", len(head)) + head + rest)


def killed_at_checkpoint(program, folder, *words):
    running = subprocess.Popen([program, "run", *words, "--quiet"], cwd=folder)
    file = folder / "out/checkpoint.bin"
    while running.poll() is None and not file.exists():
        time.sleep(0.005)
    running.kill()
    running.wait()
    return file


def steps(program, folder, _):
    """History, frames, checkpoints and the page count on behind 2^31 steps, and the numbers of the motion stay."""
    tries = Tries(program, folder)
    tries.write("large", 2)
    options = ["large.toml", "--set", "integrator.end=40", "--set", "output.every=5", "--set", "output.checkpoint_every=10"]
    file = killed_at_checkpoint(program, folder, *options, "--out", "out")
    first, data = later(file.read_bytes(), LARGE)
    file.write_bytes(data)
    tries.call("run", "--resume", "out", "--quiet")
    tries.call("run", *options, "--out", "whole", "--quiet")
    columns = [[line.split(",") for line in (folder / out / "history.csv").read_text(encoding="utf-8").splitlines()[1:]] for out in ("out", "whole")]
    behind = [row for row in columns[0] if int(row[0]) >= LARGE]
    assert int(behind[0][0]) == first and behind[0][1:] == columns[1][len(columns[0]) - len(behind)][1:]
    assert [(int(row[0]) - LARGE, *row[1:]) for row in behind] == [(int(row[0]), *row[1:]) for row in columns[1][-len(behind) :]]
    made, whole = (json.loads((folder / out / "summary.json").read_text(encoding="utf-8")) for out in ("out", "whole"))
    assert made["steps"] == whole["steps"] + LARGE, (made["steps"], whole["steps"])
    page = tries.call("report", "out").stdout
    assert "conclusion: Stable" in page, page
    # The numbers of a checkpoint behind 2^31 steps are whole, too.
    for name in ("out", "whole"):
        (folder / name).rename(folder / f"{name} 1")
    file = killed_at_checkpoint(program, folder, *options, "--out", "out")
    file.write_bytes(later(file.read_bytes(), LARGE)[1])
    running = subprocess.Popen([program, "run", "--resume", "out", "--quiet"], cwd=folder)
    before = file.stat().st_mtime_ns
    while running.poll() is None and file.exists() and file.stat().st_mtime_ns == before:
        time.sleep(0.001)
    running.kill()
    running.wait()
    if file.exists():
        assert later(file.read_bytes(), 0)[0] > LARGE


def names(program, folder, checker):
    """Blanks, quotes and letters of any language in every name."""
    inner = folder / "a b 'c\" ü網格 ✓"
    inner.mkdir()
    tries = Tries(program, inner)
    name = "größe 網 'x\" ×"
    (inner / f"{name}.msh").write_text(mesh_text(2), encoding="utf-8")
    (inner / f"{name}.toml").write_text(SCENE.format(mesh=f"{name}.msh".replace('"', '\\"')), encoding="utf-8")
    for words in tries.commands(name):
        tries.call(*words, most=3)
    subprocess.run([checker, f"{name}.certificate"], cwd=inner, check=True, stdout=subprocess.DEVNULL)
    wrong = [path.name for path in folder.rglob("*") if "\ufffd" in path.name]
    assert not wrong and sorted(path.name for path in folder.iterdir()) == [inner.name], wrong


def stack(program, folder, _):
    tries = Tries(program, folder, limits="ulimit -s 256; ")
    tries.call("mesh", "generate", "ball", "-o", "small.msh")
    (folder / "small.toml").write_text(SCENE.format(mesh="small.msh").replace("1e-3", "1e-5").replace("0.01", "1e-4").replace("0.005", "1e-5"), encoding="utf-8")
    for words in tries.commands("small"):
        if "handler.method" not in " ".join(map(str, words)) and words[0] not in ("advise", "compare"):  # long on a ball
            tries.call(*words, most=3)


def threads(program, folder, _):
    """64 threads give the bytes of one, whatever the machine has."""
    tries = Tries(program, folder)
    tries.write("many", 2)
    tries.call("mesh", "generate", "bar", "--cells", 12, 4, 4, "-o", "many.msh")
    for count in (1, 64):
        tries.environment["OMP_NUM_THREADS"] = str(count)
        tries.call("run", "many.toml", "--out", f"out {count}", "--quiet", most=3)
        tries.call("inspect", "many.msh", *MATERIAL, "--exact", "--metric", "all", "--certificate", f"{count}.certificate", most=3)
    assert (folder / "1.certificate").read_bytes() == (folder / "64.certificate").read_bytes()
    assert (folder / "out 1/history.csv").read_bytes() == (folder / "out 64/history.csv").read_bytes()


def main():
    what, program, checker = sys.argv[1], *(str(pathlib.Path(file).resolve()) for file in sys.argv[2:])
    with tempfile.TemporaryDirectory() as folder:
        {"few": few, "steps": steps, "names": names, "stack": stack, "threads": threads}[what](program, pathlib.Path(folder), checker)


if __name__ == "__main__":
    main()
