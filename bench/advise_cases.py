#!/usr/bin/env python3
"""Whether `ringwatch advise` is right: its best against runs of every way to the end of the scene.

Takes scenes of bars, balls and cubes, with slivers, jittered, graded and regular, by several laws, each at several times the critical
step. Runs each by `ringwatch run` for --steps steps with every handler and implicit integrator at that step, and explicit at its own
step. Of the runs that reach the end with their energy in balance and err by no more than --error, the one that takes the least
processor time, watched in threshold mode, is
the best measured; advise is right where its own takes at most 1.2 times as long, or where it says that none of them keeps the error. Errors are the largest at a sixteenth of the time and
its multiples, over the largest displacement there, against Verlet at a quarter of the proven step. A run that takes more than --patience
times as long as explicit is given up. Writes all of it as JSON (--json) and prints a Markdown table.

Needs the Python module: PYTHONPATH=build/release/python.
"""
import argparse
import itertools
import json
import math
import pathlib
import resource
import subprocess
import sys
import tempfile
import time

import numpy as np

import ringwatch as rw

SAMPLES = 16  # of the error
RIGHT = 1.2
LAWS = ["stvk", "corotational", "neo-hookean"]
FACTORS = [2, 3, 5, 8]
HANDLERS = ["imex", "local-time-stepping", "fe-pbd", "modal-filter", "mass-scaling"]
IMPLICIT = ["implicit-euler", "arkode-dirk", "cvode-bdf"]
UNWATCHED = {"monitor.mode": "bracket", "monitor.bracket": "false"}
OWN_SHARE = 0.95  # of the proven step

SCENE = """
{mesh}
[material]
model = "{law}"
young = 30e3
poisson = 0.3
density = 1000.0
[integrator]
method = "verlet"
step = {step!r}
end = {end!r}
[monitor]
mode = "threshold"
on_violation = "warn"
{support}
[[force]]
where = "all"
acceleration = [0.0, 0.0, {load}]
[output]
picture = false
history_every = 16
"""
BAR_SUPPORT = '[[fix]]\nwhere = "x < 1e-9"'
BALL_SUPPORT = '[[fix]]\nwhere = "z < -0.03"'


def grid_tetrahedra(cells):
    """Nodes of a grid of cells (in cells) and Kuhn's six tetrahedra of each."""
    nx, ny, nz = cells
    number = lambda i, j, k: i + (nx + 1) * (j + (ny + 1) * k)
    nodes = np.array([[i, j, k] for k in range(nz + 1) for j in range(ny + 1) for i in range(nx + 1)], float)
    tetrahedra = []
    for k, j, i in itertools.product(range(nz), range(ny), range(nx)):
        for order in itertools.permutations(range(3)):
            corner, path = [i, j, k], [number(i, j, k)]
            for axis in order:
                corner[axis] += 1
                path.append(number(*corner))
            a, b, c, d = (nodes[n] for n in path)
            if np.dot(np.cross(b - a, c - a), d - a) < 0:
                path[2], path[3] = path[3], path[2]
            tetrahedra.append(path)
    return nodes, np.array(tetrahedra), number


def write_tetgen(path, nodes, tetrahedra):
    with open(f"{path}.node", "w") as file:
        file.write(f"{len(nodes)} 3 0 0\n")
        file.writelines(f"{n} {x!r} {y!r} {z!r}\n" for n, (x, y, z) in enumerate(nodes.tolist()))
    with open(f"{path}.ele", "w") as file:
        file.write(f"{len(tetrahedra)} 4 0\n")
        file.writelines(f"{n} {' '.join(map(str, t))}\n" for n, t in enumerate(tetrahedra.tolist()))
    return f'[mesh]\nfile = "{path}.ele"'


def bar_with_slivers(path):
    """Every third inner node on the axis is pulled most of the way to its neighbour."""
    nodes, tetrahedra, number = grid_tetrahedra((20, 4, 4))
    for i in range(2, 18, 3):
        nodes[number(i, 2, 2), 0] += 0.95
    return write_tetgen(path, nodes * 0.01, tetrahedra), BAR_SUPPORT, -0.5


def ball_with_slivers(path):
    nodes, tetrahedra, number = grid_tetrahedra((8, 8, 8))
    for i, j, k in ((2, 4, 4), (4, 3, 4), (5, 5, 3), (4, 4, 6)):
        nodes[number(i, j, k), 0] += 0.95
    x, y, z = (nodes / 4 - 1).T
    ball = 0.05 * np.array([x * np.sqrt(1 - y**2 / 2 - z**2 / 2 + y**2 * z**2 / 3), y * np.sqrt(1 - z**2 / 2 - x**2 / 2 + z**2 * x**2 / 3),
                            z * np.sqrt(1 - x**2 / 2 - y**2 / 2 + x**2 * y**2 / 3)]).T
    return write_tetgen(path, ball, tetrahedra), BALL_SUPPORT, -8.0


def generated(text, load):
    return lambda path: ("[mesh]\n" + text, BAR_SUPPORT, load)


MESHES = {
    "bar with slivers": bar_with_slivers,
    "ball with slivers": ball_with_slivers,
    "graded cube": generated('generate = "bar"\nsize = [0.05, 0.05, 0.05]\ncells = [10, 8, 8]\ngrading = 6', -8.0),
    "regular bar": generated('generate = "bar"\nsize = [0.2, 0.04, 0.04]\ncells = [20, 4, 4]', -0.5),
    "jittered bar": generated('generate = "bar"\nsize = [0.2, 0.04, 0.04]\ncells = [20, 4, 4]\njitter = 0.2', -0.5),
    "strongly jittered bar": generated('generate = "bar"\nsize = [0.2, 0.04, 0.04]\ncells = [20, 4, 4]\njitter = 0.3', -0.5),
}


class Case:
    def __init__(self, program, folder, mesh, law, factor, steps, error, patience):
        self.program, self.folder, self.error, self.patience = program, folder, error, patience
        self.name = f"{mesh}, {law}, {factor}"
        self.mesh, self.law, self.factor = mesh, law, factor
        text, support, load = MESHES[mesh](folder / "mesh")
        self.scene = folder / "scene.toml"
        write = lambda step, end: self.scene.write_text(SCENE.format(mesh=text, law=law, step=step, end=end, support=support, load=load))
        write(1e-9, 1.0)
        self.safe = json.loads(self.call("advise", "--json", "-"))["safe"]
        self.step, self.steps = factor * self.safe, steps - steps % SAMPLES
        self.end = self.step * self.steps
        write(self.step, self.end)

    def call(self, command, *arguments):
        done = subprocess.run([self.program, command, self.scene, "--threads", "1", *map(str, arguments)], capture_output=True, text=True)
        if done.returncode != 0:
            raise SystemExit(f"{self.name}: {command}: {done.stderr}")
        return done.stdout

    def equal_steps(self, h):
        return self.end / (SAMPLES * math.ceil(self.end / h / SAMPLES - 1e-9))

    def run(self, settings, limit=None, frames=0, steps=None):
        """The summary of a run, its positions at `frames` moments, and its processor time, s; None where it takes longer than `limit` s."""
        out = self.folder / "out"
        command = [self.program, "run", self.scene, "--out", out, "--threads", "1", "--quiet"]
        if frames:
            settings = settings | {"output.every": repr(self.end / frames), "output.fields": "[]"}
        if steps:
            settings = settings | {"integrator.end": repr(steps * float(settings.get("integrator.step", self.step)))}
        for key, value in settings.items():
            command += ["--set", f"{key}={value}"]
        subprocess.run(["rm", "-rf", out], check=True)
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        try:
            done = subprocess.run(command, timeout=limit, capture_output=True, text=True)
        except subprocess.TimeoutExpired:
            return None, None, None
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        if done.returncode not in (0, 1, 3):
            return {"refused": done.stderr.strip()}, None, seconds
        try:
            states = [rw.load_mesh(f).points for f in sorted((out / "frames").glob("*.vtu"))] if frames else None
        except rw.InputError:
            return {"refused": "lost: elements are inverted"}, None, seconds
        return json.loads((out / "summary.json").read_text()), states, seconds

    def outcome(self, settings, reference=None, limit=None):
        """Its error or why it was lost, and its positions."""
        summary, states, _ = self.run(settings, limit, frames=SAMPLES)
        if summary is None:
            return {"why_not": f"takes more than {self.patience} times as long as explicit"}, None
        if "refused" in summary:
            return {"why_not": summary["refused"]}, None
        if summary["exit_reason"] != "end":
            return {"why_not": "lost: " + summary["exit_text"]}, None
        if "energy-balance" in {e["kind"] for e in summary["events"]}:
            return {"why_not": "lost: energy out of balance"}, None
        row = {"steps": summary["steps"]}
        if reference is not None:
            if len(states) != len(reference):
                return {"why_not": f"{len(states)} frames instead of {len(reference)}"}, None
            largest = max(np.linalg.norm(x - reference[0]) for x in reference)
            row["error"] = max(np.linalg.norm(x - r) for x, r in zip(states, reference)) / largest
        return row, states

    def settings_of(self, way):
        if way == "verlet":
            return {"integrator.step": repr(self.equal_steps(OWN_SHARE * self.safe)), "monitor.on_violation": "reduce-step"}
        if way in HANDLERS:
            return {"handler.method": way, "monitor.on_violation": "handle"}
        return {"integrator.method": way, **UNWATCHED}

    def outcomes(self):
        finest = {"integrator.step": repr(self.equal_steps(self.safe / 4)), **UNWATCHED}
        _, reference = self.outcome(finest)
        if reference is None:
            raise SystemExit(f"{self.name}: no motion to compare with")
        begin = time.perf_counter()
        ways = {"verlet": self.outcome(self.settings_of("verlet"), reference)[0]}
        limit = self.patience * (time.perf_counter() - begin) + 1
        for way in HANDLERS + IMPLICIT:
            ways[way] = self.outcome(self.settings_of(way), reference, limit)[0]
        return ways

    def good(self, ways):
        return [n for n, w in ways.items() if "why_not" not in w and w["error"] <= self.error]

    def take_times(self, ways, rounds):
        """Of those within the error, in turns; a start is taken off, as the time of a run of a few steps."""
        times = {n: [] for n in self.good(ways)}
        for _ in range(rounds):
            for name in times:
                settings = self.settings_of(name)
                whole, start = self.run(settings)[2], self.run(settings, steps=SAMPLES)[2]
                times[name].append(whole - start)
        for name, values in times.items():
            ways[name]["seconds"] = min(values)

    def judge(self, ways):
        """Best measured, what advise says, and how many times as long that takes."""
        good = {n: ways[n]["seconds"] for n in self.good(ways)}
        best = min(good, key=good.get) if good else None
        advised = json.loads(self.call("advise", "--error", self.error, "--json", "-"))
        chosen = advised["best"]
        if chosen == best:  # or none of them keeps the error, and it says so
            return best, chosen, 1.0, advised
        return best, chosen, good[chosen] / good[best] if chosen in good and best else math.inf, advised


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", nargs="?", default="build/release/bin/ringwatch")
    parser.add_argument("--steps", type=int, default=2000)
    parser.add_argument("--error", type=float, default=0.01)
    parser.add_argument("--patience", type=float, default=1.5)
    parser.add_argument("--all", action="store_true", help="every law with every mesh and step (72); else a third of them")
    parser.add_argument("--rounds", type=int, default=3, help="of timed runs, the least of which counts")
    parser.add_argument("--cases", default="", help="only those whose name has this text")
    parser.add_argument("--measured", help="JSON of a run before: its runs are taken from there, advise is asked anew")
    parser.add_argument("--json", help="write results there")
    arguments = parser.parse_args()
    before = json.loads(pathlib.Path(arguments.measured).read_text()) if arguments.measured else {}
    results, right, count = {}, 0, 0
    print("| mesh | law | step/critical | best measured | advised | time/best | right |\n|---|---|---|---|---|---|---|", flush=True)
    for number, (mesh, factor, law) in enumerate(itertools.product(MESHES, FACTORS, LAWS)):
        turn = list(MESHES).index(mesh) + FACTORS.index(factor)
        if not arguments.all and LAWS.index(law) != turn % len(LAWS):
            continue
        if arguments.cases not in f"{mesh}, {law}, {factor}":
            continue
        with tempfile.TemporaryDirectory() as folder:
            case = Case(arguments.program, pathlib.Path(folder), mesh, law, factor, arguments.steps, arguments.error, arguments.patience)
            ways = before[case.name]["ways"] if case.name in before else case.outcomes()
            if any("seconds" not in ways[n] for n in case.good(ways)):
                case.take_times(ways, arguments.rounds)
            best, chosen, ratio, advised = case.judge(ways)
        count += 1
        right += ratio <= RIGHT
        print(f"| {mesh} | {law} | {factor} | {best} | {chosen} | {ratio:.2f} | {'yes' if ratio <= RIGHT else 'no'} |", flush=True)
        results[case.name] = {"ways": ways, "best": best, "advised": chosen, "ratio": ratio if math.isfinite(ratio) else None, "advice": advised}
        if arguments.json:
            pathlib.Path(arguments.json).write_text(json.dumps(results, indent=1))
    print(f"\nright in {right} of {count} cases")
    return 0 if right >= 0.9 * count else 1


if __name__ == "__main__":
    sys.exit(main())
