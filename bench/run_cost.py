#!/usr/bin/env python3
"""What `ringwatch run` costs with energies and with the monitor, over the same run without, all in.

A bar five times as long as wide is pulled at one end, slowly (10 % of its length a second) or fast (80 %), at half of the safe step at
rest. A run of --steps and one of twice as many are timed by their own wall_time; the difference is the time of a step without the start,
what remains is the start, which holds the first observation. Variants of a round follow each other; printed are the medians over rounds
and, as the error, half the distance between their quartiles. Prints a Markdown table.
"""
import argparse
import json
import pathlib
import statistics
import subprocess
import tempfile

# element, elements a cell, jitter in cell sizes
CASES = {
    "tet4-5-jittered": ("tet4", 5, 0.2),
    "tet4-6": ("tet4", 6, 0.0),
    "hex8": ("hex8", 1, 0.0),
    "wedge6": ("wedge6", 2, 0.0),
}
PULLS = {"slow": 0.1, "fast": 0.8}  # lengths a second
# As users write them; the last is what a scene gets that says nothing.
VARIANTS = {
    "plain": {"output.energy": "false", "monitor.bracket": "false", "output.history_every": "1000000"},
    "energies": {"monitor.bracket": "false"},
    "threshold": {"monitor.mode": "threshold"},
    "default": {},
}
SCENE = """
[mesh]
{mesh}
[material]
model = "stvk"
young = 30e3
poisson = 0.3
density = 1000.0
[integrator]
step = {step}
end = {end}
[monitor]
on_violation = "warn"
{load}
[output]
picture = false
"""
BAR = """
generate = "bar"
size = [{length}, {width}, {width}]
cells = [{long}, {cells}, {cells}]
element = "{element}"
split = {split}
jitter = {jitter}
"""
PULL = """
[[fix]]
where = "x < {low}"
[[move]]
where = "x > {high}"
velocity = [{speed}, 0, 0]
"""
CELL = 0.01  # m


def run(program, folder, scene, keys, threads):
    """The summary of a run; keys: of the scene, set to other values."""
    path = folder / "scene.toml"
    path.write_text(scene)
    command = [program, "run", path, "--out", folder / "out", "--threads", str(threads), "--quiet"]
    for key, value in keys.items():
        command += ["--set", f"{key}={value}"]
    status = subprocess.run(command, check=False).returncode
    if status not in (0, 1, 3):  # stable, unstable, never certified
        raise SystemExit(f"{' '.join(map(str, command))}: exit status {status}")
    return json.loads((folder / "out" / "summary.json").read_text())


def half_spread(values):
    low, _, high = statistics.quantiles(values, n=4) if len(values) > 2 else (min(values), 0, max(values))
    return (high - low) / 2


def times_of_step(program, folder, scene_of, variants, step, steps, rounds, threads):
    """Seconds of a step, and of the start, by variant: a list of one number a round. scene_of: of the end of the run, s."""
    seconds = {name: [] for name in variants}
    starts = {name: [] for name in variants}
    for _ in range(rounds):
        for name, keys in variants.items():
            short, full = (run(program, folder, scene_of(step * count), keys, threads)["wall_time"]["total"]
                           for count in (steps, 2 * steps))
            seconds[name].append((full - short) / steps)
            starts[name].append(2 * short - full)
    return seconds, starts


def measure(arguments, folder, case, pull):
    element, split, jitter = CASES[case]
    long, width = 5 * arguments.cells, arguments.cells * CELL
    length, least = long * CELL, 1e-9
    mesh = BAR.format(length=length, width=width, long=long, cells=arguments.cells, element=element, split=split, jitter=jitter)
    load = PULL.format(low=least, high=length - least, speed=PULLS[pull] * length)
    scene = lambda step, end: SCENE.format(mesh=mesh, load=load, step=step, end=end)
    first = run(arguments.program, folder, scene('"auto"', 1e-9), {}, arguments.threads)
    step = 0.5 * first["safe_seen"]["least"]
    seconds, starts = times_of_step(arguments.program, folder, lambda end: scene(step, end), VARIANTS, step,
                                    arguments.steps, arguments.rounds, arguments.threads)
    elements = sum(first["mesh"]["elements"].values())
    plain = statistics.median(seconds["plain"])
    row = [f"{case}, {pull}", f"{elements}", f"{1e9 * plain / elements:.1f} ± {1e9 * half_spread(seconds['plain']) / elements:.1f}"]
    for name in list(VARIANTS)[1:]:
        ratios = [a / b for a, b in zip(seconds[name], seconds["plain"])]
        row.append(f"{statistics.median(ratios):.2f} ± {half_spread(ratios):.2f}")
    row.append(f"{(statistics.median(starts['default']) - statistics.median(starts['plain'])) / plain:.0f}")
    print("| " + " | ".join(row) + " |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default="build/release/bin/ringwatch", type=pathlib.Path)
    parser.add_argument("--cells", default=16, type=int, help="across the bar: 16 is 20480 cells")
    parser.add_argument("--steps", default=250, type=int)
    parser.add_argument("--threads", default=1, type=int)
    parser.add_argument("--rounds", default=3, type=int)
    parser.add_argument("case", nargs="*", metavar="CASE", help=", ".join(CASES) + "; all by default")
    arguments = parser.parse_args()
    for case in arguments.case:
        if case not in CASES:
            parser.error(f"{case!r} is no case; known are {', '.join(map(repr, CASES))}")
    names = [f"{name}, over plain" for name in list(VARIANTS)[1:]]
    print("| bar, pull | elements | plain step, ns an element | " + " | ".join(names) + " | start of the default run, plain steps |")
    print("|---" * (4 + len(names)) + "|")
    with tempfile.TemporaryDirectory() as folder:
        for case in arguments.case or CASES:
            for pull in PULLS:
                measure(arguments, pathlib.Path(folder), case, pull)


if __name__ == "__main__":
    main()
