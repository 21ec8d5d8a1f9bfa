#!/usr/bin/env python3
"""What the monitor costs along runs with a budget of 0.1, and how wide the bracket is.

Jittered bars of 100 000 elements and jittered and regular ones of 20 000, five times as long as wide, of cubes of 1 cm, are pulled, pushed or turned
at one end from rest for 1000 steps, or slower for 10 000. Prints two Markdown tables, and a third one of runs of `ringwatch`: a bar of wedges,
hexahedra, pyramids and tetrahedra, and what TetGen makes of a bumpy ball without quality bounds (left out, by name, where there is no
tetgen), pulled as slowly as the others, and dropped on a plane at 0.5 m/s. There cost is that of `ringwatch run` over the same run
without a monitor, by steps 1000 to 2000. Cost is the time of the monitor at all observations but the first over that
of the steps alone, taken by turns in one run; in brackets the same counted (WorkAccount). Width is safe over optimistic less 1, in
size, %: median, worst. Beside them stand figures without a limit, from before. At the last step: how far the safe and the optimistic side
lie from those from scratch, %, and the width of these.
"""
import argparse
import concurrent.futures
import json
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile

import handled_runs
import run_cost

MESHES = {
    "tetrahedra, five a cell": ("5_a_cell", "tet4"),
    "tetrahedra, six a cell": ("6_a_cell", "tet4"),
    "hexahedra": ("1_a_cell", "hex8"),
    "wedges": ("2_a_cell", "wedge6"),
    "pyramids": ("6_a_cell", "pyramid5"),
}
# How a row is watched and moved.
RUNS = {
    "slow pull": ("bracket_0.1", "slow"),
    "pull ten times slower, 10 000 steps": ("bracket_0.1", "slower"),
    "slow pull, budget 0": ("bracket_0", "slow"),
    "fast pull": ("bracket_0.1", "fast"),
    "twist": ("bracket_0.1", "twist"),
    "compression": ("bracket_0.1", "compression"),
    "fast pull, budget 0.3": ("bracket_0.3", "fast"),
    "threshold at 0.8 of the critical step": ("threshold", "slow_close"),
}
# Without a limit, on a quiet EPYC with AVX-512: cost in bracket mode; hexahedra and wedges of 5000 elements.
COST_BEFORE = {
    ("tetrahedra, five a cell", "slow pull"): "0.22", ("tetrahedra, five a cell", "fast pull"): "0.93",
    ("tetrahedra, six a cell", "slow pull"): "1.0", ("tetrahedra, six a cell", "fast pull"): "7.2",
    ("hexahedra", "slow pull"): "7.2", ("hexahedra", "fast pull"): "21",
    ("wedges", "slow pull"): "6.2", ("wedges", "fast pull"): "14",
}
# Without a limit: safe side below the exact step in a slow pull to 1.4 times the length, jitter 0.2, medians, %.
LAWS = ("stvk", "neo-hookean", "corotational")
SAFE_BEFORE = {
    ("tetrahedra, five a cell", "jittered"): ("4.1", "3.7", "4.3"), ("tetrahedra, five a cell", "regular"): ("9.9", "7.8", "8.4"),
    ("tetrahedra, six a cell", "jittered"): ("10.3", "11.7", "12.3"), ("tetrahedra, six a cell", "regular"): ("12.8", "15.7", "17.5"),
    ("hexahedra", "jittered"): ("7.0", "12.5", "17.8"), ("hexahedra", "regular"): ("6.3", "14.9", "18.2"),
    ("wedges", "jittered"): ("5.1", "8.5", "7.6"), ("wedges", "regular"): ("4.8", "9.2", "7.0"),
    ("pyramids", "regular"): ("10.5", "20.3", "20.4"),
}


# Of the scenes.
SLIVERS = "-pO1a4.2e-8"  # switches of TetGen, some 100 000 tetrahedra
MIXED = (17 * 5, 17, 17)  # cells, 3.75 elements each in the mean
STEPS, ROUNDS = 1000, 3
PLAIN = run_cost.VARIANTS["plain"]
WATCHED = {key: value for key, value in PLAIN.items() if key != "monitor.bracket"}
LOADS = {
    "slow pull": run_cost.PULL,
    "dropped": """
[[initial]]
where = "all"
velocity = [0, 0, -0.5]
[[obstacle]]
kind = "plane"
point = [0, 0, {bottom}]
normal = [0, 0, 1]
[[contact]]
where = "all"
""",
}


def run(program, name):
    command = [program, f"--benchmark_filter=^table/{name}/threads:1/", "--benchmark_format=json"]
    done = subprocess.run(command, check=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE, env={**os.environ, "OMP_NUM_THREADS": "1"})
    found = json.loads(done.stdout)["benchmarks"]
    if len(found) == 1 and found[0].get("error_occurred"):
        raise SystemExit(f"{name}: {found[0]['error_message']}")
    if len(found) != 1:
        raise SystemExit(f"{name}: {len(found)} runs of that name in {program}; 1 was expected")
    return found[0]


def widths(result):
    return f"{-100 * result['median_width']:.1f}, {-100 * result['worst_width']:.0f}" if "median_width" in result else "-"


def beside_scratch(result):
    if "scratch_width" not in result:
        return "-"
    safe, optimistic, width = (100 * result[key] for key in ("safe_to_scratch", "optimistic_to_scratch", "scratch_width"))
    return f"{safe:.1f}, {optimistic:+.1f}; {-width:.1f}"


def scene_meshes(folder):
    """By name: the [mesh] of a scene and its nodes; None where the mesh cannot be made."""
    size = [0.01 * cells for cells in MIXED]
    generate = f'generate = "mixed"\nsize = {size}\ncells = {list(MIXED)}\njitter = 0.2'
    meshes = {"mixed": (generate, [[0, 0, 0], size])}
    made = handled_runs.tetgen(SLIVERS, folder)
    if made:
        handled_runs.write_msh(folder / "slivers.msh", *made)
        meshes["TetGen, with slivers"] = (f'file = "{folder / "slivers.msh"}"', made[0])
    else:
        meshes["TetGen, with slivers"] = None
    return meshes


def bracket_widths(history):
    """Widths of the brackets of a history, largest first."""
    return sorted((1 - safe / optimistic for safe, optimistic in handled_runs.numbers(history, ["safe_s", "optimistic_s"])), reverse=True)


def print_scenes(program):
    print("\n| `ringwatch run` | elements | run | cost | width, median, worst | certified steps |")
    print("|---" * 6 + "|")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for mesh, made in scene_meshes(folder).items():
            if not made:
                print(f"{mesh}: left out, there is no tetgen", file=sys.stderr)
                continue
            for load, text in LOADS.items():
                print(row_of_scene(program, folder, mesh, *made, load, text), flush=True)


def row_of_scene(program, folder, mesh, keys, nodes, load, text):
    low, high, bottom = min(n[0] for n in nodes), max(n[0] for n in nodes), min(n[2] for n in nodes)
    length = high - low
    load_text = text.format(low=low + 0.02 * length, high=high - 0.02 * length, bottom=bottom, speed=0.1 * length)
    scene = lambda step, end, load=load_text: run_cost.SCENE.format(mesh=keys, load=load, step=step, end=end)
    first = run_cost.run(program, folder, scene('"auto"', 1e-9, ""), {}, 1)
    step = 0.5 * first["safe_seen"]["least"]
    seconds, _ = run_cost.times_of_step(program, folder, lambda end: scene(step, end), {"plain": PLAIN, "watched": WATCHED}, step,
                                        STEPS, ROUNDS, 1)
    costs = [watched / plain - 1 for watched, plain in zip(seconds["watched"], seconds["plain"])]
    whole = run_cost.run(program, folder, scene(step, STEPS * step), {"output.history_every": "1"}, 1)
    width = bracket_widths(folder / "out" / "history.csv")
    elements = sum(whole["mesh"]["elements"].values())
    share = whole["certified_steps"] / whole["watched_steps"]
    return (f"| {mesh} | {elements} | {load} | {statistics.median(costs):.2f} ± {run_cost.half_spread(costs):.2f} | "
            f"{100 * width[len(width) // 2]:.1f}, {100 * width[0]:.0f} | {100 * share:.0f} % |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default="build/release/bin/ringwatch_bench_monitor", type=lambda path: pathlib.Path(path).resolve())
    parser.add_argument("--app", default="build/release/bin/ringwatch", type=lambda path: pathlib.Path(path).resolve())
    parser.add_argument("--scenes", action="store_true", help="the third table alone")
    parser.add_argument("--jobs", default=os.cpu_count(), type=int, help="runs at a time, one thread each")
    arguments = parser.parse_args()
    if not arguments.scenes:
        print_bars(arguments)
    print_scenes(arguments.app)


def print_bars(arguments):
    costs = {(mesh, what): f"{watch}/{move}/{cut}/jittered/{element}/stvk/100k"
             for mesh, (cut, element) in MESHES.items() for what, (watch, move) in RUNS.items()}
    laws = {(mesh, grid, law): f"bracket_0.1/slow/{cut}/{grid}/{element}/{law}/20k"
            for mesh, (cut, element) in MESHES.items() for grid in ("jittered", "regular") for law in LAWS}
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        waiting = {key: pool.submit(run, arguments.program, name) for key, name in {**costs, **laws}.items()}
        results = {key: job.result() for key, job in waiting.items()}
    print("| 100 000 elements | run | cost, counted | before | width, median, worst | certified steps | last step: safe, optimistic side to those from scratch; their width |")
    print("|---" * 7 + "|")
    for mesh, what in costs:
        result = results[mesh, what]
        print(f"| {mesh} | {what} | {result['over_step']:.2f} ({result['counted']:.2f}) | {COST_BEFORE.get((mesh, what), '-')} | "
              f"{widths(result)} | {100 * result['certified']:.0f} % | {beside_scratch(result)} |")
    print("\n| 20 000 elements, slow pull | | cost, counted | " + " | ".join(f"{law}: width, median, worst; safe side before" for law in LAWS) + " |")
    print("|---" * 6 + "|")
    for mesh in MESHES:
        for grid in ("jittered", "regular"):
            row = [results[mesh, grid, law] for law in LAWS]
            before = SAFE_BEFORE.get((mesh, grid), ("-",) * 3)
            cells = " | ".join(f"{widths(result)}; {old}" for result, old in zip(row, before))
            print(f"| {mesh} | {grid} | {row[0]['over_step']:.2f} ({row[0]['counted']:.2f}) | {cells} |")


if __name__ == "__main__":
    main()
