#!/usr/bin/env python3
"""Long runs with every handler on bodies with bad elements: which are lost, and what they do to energy, momentum and motion.

    bench/handled_runs.py PROGRAM [--out DIR] [--jobs N] [--steps 10000] [--seconds S]
        [--longest S] [--bodies NAME …] [--laws NAME …] [--loads NAME …] [--factors N …] [--handlers NAME …]
        [--method symplectic-euler] [--most-rise SHARE] [--most-fall SHARE] [--resume]

PROGRAM is `ringwatch`; nothing else is needed. Every body is run with every law and load, in steps of so many times its
critical step at rest, by every handler, with on_violation = "handle"; and by the plain scheme at a half of its critical
step, which is what they are compared with. A run is *lost* when it does not come to its end, or its energy balance rises
by more than a tenth of the largest energy, or goes off for good; *wrongly told* when it is lost and its exit status is 0
or its verdict "certified".

rise, fall: the largest error of the energy balance over the largest energy. By symplectic-euler velocities are half a step
behind positions, and the energy of both swings by a share of the first order of the step; with --method verlet both are
of one time. momentum: of bodies that nothing holds, the
largest change of what the load leaves as it is, over its size: angular momentum where they spin, linear momentum across
the fall where they are dropped. error: over the time of the plain run, the motion of the middle and of the high end
against the low end, means over nodes: the root mean square of its difference to the plain run over that of the plain run;
of pulled bodies over the whole run, at equal shares of the pull.

time: of the processor, of one thread, which other programs change little.

With --seconds no run begins after so long; runs are made in random order, those of factors 2 and 5 before the others,
and tables are of those that were made. Bodies are made here; those named tetgen-… by the program tetgen, and they are
left out, by name, where there is none. DIR gets the rows (runs.csv), tables.md and, for each body, the time of a run
over plain's against its error, medians over laws and loads (work_and_error.svg). Each run is noted as it ends
(made.jsonl): with --resume those that are noted there with the same options are not made again.

With --most-rise and --most-fall the exit status is 1 where a run that came to its end, of a handler, has an energy
balance that rises or falls by more, as a share of the largest energy, or is wrongly told; such runs are printed.
"""
import argparse
import concurrent.futures
import csv
import itertools
import json
import math
import os
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time

YOUNG, POISSON, DENSITY = 30e3, 0.3, 1000.0
LAWS = ["stvk", "corotational", "neo-hookean", "stable-neo-hookean"]
FACTORS = [2, 5, 3, 8]  # the first two are run first
SIZE = 0.2  # m, of a body along x
# Of the wave speed √(E/ρ) = 5.5 m/s: fast enough to strain a body by tens of percent.
SPEED = 1.0
PULL = 0.4  # of its length, in the run
LOADS = {
    "held": {"fix": [{"where": "x < LOW"}], "force": [{"where": "all", "acceleration": [0, 0, -3.0]}]},
    "dropped": {"initial": [{"where": "x < MIDDLE", "velocity": [SPEED / 2, 0, 0]}],
                "force": [{"where": "all", "acceleration": [0, 0, -9.81]}]},
    "spinning": {"initial": [{"where": "all", "angular_velocity": [0, 10.0, 20.0], "point": [SIZE / 2, 0, 0]}]},
    "pulled": {"fix": [{"where": "x < LOW"}],
               "move": [{"where": "x > HIGH", "velocity": ["PULL", 0, 0]}]},
}
HANDLERS = {
    "plain, half": None,
    "imex": {"method": "imex"},
    "imex, linear": {"method": "imex", "solver": "linear"},
    "local-time-stepping": {"method": "local-time-stepping"},
    "fe-pbd": {"method": "fe-pbd"},
    "modal-filter": {"method": "modal-filter"},
    "mass-scaling": {"method": "mass-scaling"},
}
LOST = 0.1  # of the largest energy
PROBE_EVERY = 20  # steps
PROBES = {"low": "x < LOW_THIRD", "middle": "x > LOW_THIRD and x < HIGH_THIRD", "high": "x > HIGH_THIRD"}

# Kuhn's six tetrahedra of a cube, by its corners as bits x y z.
KUHN = [(0, a, a | b, 7) if sign > 0 else (0, a | b, a, 7)
        for (a, b), sign in {(1, 2): 1, (2, 1): -1, (2, 4): 1, (4, 2): -1, (4, 1): 1, (1, 4): -1}.items()]


def bar(cells, jitter, seed, size=(SIZE, 0.04, 0.04), grading=1.0):
    """Nodes and tetrahedra of a bar; inner nodes moved by a share of a cell."""
    chance = random.Random(seed)
    nodes, number = [], {}
    for k, j, i in itertools.product(*(range(c + 1) for c in reversed(cells))):
        at = [i / cells[0], j / cells[1], k / cells[2]]
        at[0] **= grading
        inner = all(0 < n < c for n, c in zip((i, j, k), cells))
        number[i, j, k] = len(nodes)
        nodes.append([s * (a + (jitter * (chance.random() * 2 - 1) / c if inner else 0))
                      for s, a, c in zip(size, at, cells)])
    tetrahedra = []
    for i, j, k in itertools.product(*map(range, cells)):
        corner = [number[i + (b & 1), j + (b >> 1 & 1), k + (b >> 2)] for b in range(8)]
        tetrahedra += [[corner[b] for b in t] for t in KUHN]
    return nodes, tetrahedra, number


def bar_with_slivers(flatness, every):
    """Some inner nodes are pulled nearly into a face beside them."""
    nodes, tetrahedra, number = bar((10, 2, 2), 0, 0)
    for i in range(2, 9, every):
        one, other = nodes[number[i, 1, 1]], nodes[number[i + 1, 1, 1]]
        one[0] += flatness * (other[0] - one[0])
    return nodes, tetrahedra


def ball(cells, jitter, seed):
    """A cube of cells, blown up to a ball that is as long as a bar."""
    nodes, tetrahedra, _ = bar((cells,) * 3, jitter, seed, (2.0,) * 3)
    for node in nodes:
        x = [v - 1 for v in node]
        largest, norm = max(map(abs, x)), math.hypot(*x)
        scale = largest / norm if norm else 0
        node[:] = [SIZE / 2 * (v * scale + 1) for v in x]
    return nodes, tetrahedra


def bumpy_surface(rings):
    """Triangles of a ball with bumps, thin at its poles, as decimated scans are in places."""
    points = [[0.0, 0.0, 1.0]]
    segments = 2 * rings
    for r in range(1, rings):
        for s in range(segments):
            theta, phi = math.pi * r / rings, 2 * math.pi * s / segments
            radius = 1 + 0.25 * math.sin(3 * theta) * math.cos(4 * phi)
            points.append([radius * math.sin(theta) * math.cos(phi), radius * math.sin(theta) * math.sin(phi),
                           radius * math.cos(theta)])
    points.append([0.0, 0.0, -1.0])
    at = lambda r, s: 1 + (r - 1) * segments + s % segments
    faces = [[0, at(1, s), at(1, s + 1)] for s in range(segments)]
    for r in range(1, rings - 1):
        for s in range(segments):
            faces += [[at(r, s), at(r + 1, s), at(r + 1, s + 1)], [at(r, s), at(r + 1, s + 1), at(r, s + 1)]]
    last = len(points) - 1
    faces += [[last, at(rings - 1, s + 1), at(rings - 1, s)] for s in range(segments)]
    return [[SIZE / 2 * (v + 1.25) / 1.25 for v in p] for p in points], faces


def tetgen(switches, folder):
    """The mesh that tetgen makes of the bumpy ball; None where there is no tetgen."""
    if not shutil.which("tetgen"):
        return None
    points, faces = bumpy_surface(9)
    name = folder / ("surface" + switches)
    lines = [f"{len(points)} 3 0 0"] + [f"{i} {x} {y} {z}" for i, (x, y, z) in enumerate(points)]
    lines += [f"{len(faces)} 0"] + [f"1 0\n3 {a} {b} {c}" for a, b, c in faces] + ["0", "0"]
    name.with_suffix(".poly").write_text("\n".join(lines) + "\n")
    subprocess.run(["tetgen", switches, str(name.with_suffix(".poly"))], check=True, stdout=subprocess.DEVNULL)
    rows = lambda suffix: [line.split() for line in name.with_suffix(suffix).read_text().splitlines()
                           if line.strip() and not line.startswith("#")][1:]
    nodes = [[float(v) for v in row[1:4]] for row in rows(".1.node")]
    return nodes, [[int(v) for v in row[1:5]] for row in rows(".1.ele")]


def write_msh(file, nodes, tetrahedra):
    """MSH 2.2. Tetrahedra of the other handedness are turned round."""
    def turned(t):
        a, b, c, d = (nodes[n] for n in t)
        u, v, w = ([p - q for p, q in zip(x, a)] for x in (b, c, d))
        volume = (u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) +
                  u[2] * (v[0] * w[1] - v[1] * w[0]))
        return t if volume > 0 else [t[0], t[2], t[1], t[3]]
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$Nodes", str(len(nodes))]
    lines += [f"{i + 1} {x!r} {y!r} {z!r}" for i, (x, y, z) in enumerate(nodes)]
    lines += ["$EndNodes", "$Elements", str(len(tetrahedra))]
    lines += [f"{i + 1} 4 2 1 1 " + " ".join(str(n + 1) for n in turned(t)) for i, t in enumerate(tetrahedra)]
    file.write_text("\n".join(lines + ["$EndElements", ""]))


def bodies(folder):
    """By name: the mesh and the cuts of its run."""
    cut = lambda x, slope: {"time": 0.02, "point": [x, 0, 0.025], "normal": [1, slope, 0.1], "snap": 0.1}
    plain = lambda mesh: (mesh, [])
    return {
        "bar, jitter": plain(bar((10, 2, 2), 0.3, 3)[:2]),
        "bar, more jitter": plain(bar((12, 3, 3), 0.4, 5)[:2]),
        "bar, graded": plain(bar((10, 2, 2), 0, 0, grading=2.0)[:2]),
        "bar, one sliver": plain(bar_with_slivers(0.98, 9)),
        "bar, slivers": plain(bar_with_slivers(0.95, 3)),
        "bar, flat slivers": plain(bar_with_slivers(0.995, 2)),
        "ball": plain(ball(4, 0.2, 1)),
        "ball, jitter": plain(ball(4, 0.45, 2)),
        "tetgen -p": plain(tetgen("-p", folder)),
        "tetgen -pY": plain(tetgen("-pY", folder)),
        "tetgen -pq": plain(tetgen("-pq", folder)),
        "bar, cut": (bar((10, 2, 2), 0.15, 7)[:2], [cut(0.09, 0.2), cut(0.13, -0.3)]),
    }


def toml(value):
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{k} = {toml(v)}" for k, v in value.items()) + " }"
    if isinstance(value, list):
        return "[" + ", ".join(map(toml, value)) + "]"
    return json.dumps(value)


def scene(mesh, cuts, law, load, handler, method, step, end, extent):
    """The text of a scene. extent: of the body along x."""
    low, high = extent
    place = {"LOW_THIRD": f"{low + (high - low) / 3:g}", "HIGH_THIRD": f"{high - (high - low) / 3:g}",
             "LOW": f"{low + 0.08 * (high - low):g}", "HIGH": f"{high - 0.08 * (high - low):g}",
             "MIDDLE": f"{(low + high) / 2:g}", '"PULL"': f"{PULL * (high - low) / end:.17g}"}
    sections = {
        "mesh": {"file": str(mesh)},
        "material": {"model": law, "young": YOUNG, "poisson": POISSON, "density": DENSITY},
        "integrator": {"method": method, "step": step, "end": end},
        "monitor": {"mode": "threshold", "on_violation": "handle" if handler else "warn"},
        "output": {"picture": False, "history_every": 20, "probe_every": PROBE_EVERY},
    }
    if handler:
        sections["handler"] = handler
    lines = [f"[{name}]\n" + "\n".join(f"{k} = {toml(v)}" for k, v in keys.items()) for name, keys in sections.items()]
    probes = [{"what": "displacement", "name": name, "where": where} for name, where in PROBES.items()]
    probes += [{"what": what, "name": "body_" + what} for what in ("momentum", "angular_momentum")]
    for name, tables in list(LOADS[load].items()) + [("cut", cuts), ("probe", probes)]:
        for table in tables:
            lines.append(f"[[{name}]]\n" + "\n".join(f"{k} = {toml(v)}" for k, v in table.items()))
    text = "\n".join(lines) + "\n"
    for word, value in place.items():
        text = text.replace(word, value)
    return text


def numbers(file, columns):
    """The rows of some columns in which all are finite numbers."""
    with file.open() as opened:
        reader = csv.reader(opened)
        heading = next(reader)
        at = [heading.index(c) for c in columns]
        for row in reader:
            try:
                values = [float(row[i]) for i in at]
            except (ValueError, IndexError):
                continue
            yield values


def energies(file):
    """Largest rise and fall of the balance over the largest energy, as the program has it, and what was dissipated."""
    rise = fall = largest = dissipated = 0.0
    names = ["balance_error_J", "kinetic_J", "strain_J", "external_work_J", "dissipated_J"]
    for error, kinetic, strain, work, dissipated in numbers(file, names):
        if not math.isfinite(error):
            return math.inf, 0.0, 0.0
        largest = max(largest, kinetic + abs(strain), abs(work))
        rise, fall = max(rise, error), max(fall, -error)
    return (rise / largest, fall / largest, dissipated / largest) if largest else (0.0, 0.0, 0.0)


def motion(file):
    """Of the middle and of the high end against the low end: times, and six numbers each."""
    names = [f"{name}.displacement_{axis}_m" for name in PROBES for axis in "xyz"]
    rows = [(t, [b - a for end in (3, 6) for a, b in zip(u[:3], u[end:end + 3])])
            for t, *u in numbers(file, ["time_s"] + names)]
    return [r[0] for r in rows], [r[1] for r in rows]


def change_of_momentum(file, load):
    """Largest change of what the load leaves as it is, over its size; empty where supports take part."""
    if load == "spinning":
        names = [f"body_angular_momentum.angular_momentum_{axis}_kg m2/s" for axis in "xyz"]
    elif load == "dropped":
        names = [f"body_momentum.momentum_{axis}_kg m/s" for axis in "xy"]
    else:
        return ""
    rows = list(numbers(file, names))
    size = math.hypot(*rows[0]) if rows else 0
    return max(math.dist(row, rows[0]) for row in rows) / size if size else ""


def difference(of, reference):
    """Of two motions over the time of both, over the size of the reference; empty where there is none."""
    times, values = of
    known, wanted = reference
    if not times or not known:
        return ""
    square = whole = 0.0
    k = 0
    for t, value in zip(times, values):
        if t > known[-1]:
            break
        while k + 2 < len(known) and known[k + 1] < t:
            k += 1
        share = (t - known[k]) / (known[k + 1] - known[k]) if len(known) > 1 else 0
        there = [a + share * (b - a) for a, b in zip(wanted[k], wanted[min(k + 1, len(known) - 1)])]
        square += sum((a - b) ** 2 for a, b in zip(value, there))
        whole += sum(b * b for b in there)
    return math.sqrt(square / whole) if whole else ""


def run(program, folder, case, longest):
    path = folder / case["id"]
    path.mkdir()
    (path / "scene.toml").write_text(case["text"])
    row = {k: case[k] for k in ("body", "law", "load", "factor", "handler", "step")}
    with (path / "errors").open("w") as errors:
        process = subprocess.Popen([program, "run", path / "scene.toml", "--out", path / "out", "--quiet", "--threads", "1"],
                                   stdout=subprocess.DEVNULL, stderr=errors)
    killer = threading.Timer(longest, process.kill)
    killer.start()
    _, status, usage = os.wait4(process.pid, 0)
    killer.cancel()
    process.returncode = os.waitstatus_to_exitcode(status)
    errors = (path / "errors").read_text().strip()
    row |= {"exit": process.returncode, "seconds": round(usage.ru_utime + usage.ru_stime, 4)}
    if process.returncode == -signal.SIGKILL:
        row |= {"exit": "", "verdict": "too slow", "lost": True, "wrongly_told": False}
    elif process.returncode == 2:
        row |= {"verdict": "refused", "reason": errors.splitlines()[-1][-300:] if errors else ""}
    else:
        try:
            summary = json.loads((path / "out/summary.json").read_text())
            rise, fall, dissipated = energies(path / "out/history.csv")
            done_whole = summary["end_time"] >= case["end"] * (1 - 1e-9)
            lost = not done_whole or summary["energy_runaway"] is not None or rise > LOST
            kinds = [event["kind"] for event in summary["events"]]
            handler = summary["handler"] or {}
            row |= {"verdict": summary["verdict"], "steps": summary["steps"], "whole": done_whole, "lost": lost,
                    "wrongly_told": lost and (process.returncode == 0 or summary["verdict"] == "certified"),
                    "rise": rise, "fall": fall, "dissipated": dissipated, "certified": summary["certified_steps"],
                    "handled": handler.get("handled_elements", 0), "selections": handler.get("selections", ""),
                    "added_mass": handler.get("added_mass_percent", ""),
                    "implicit": handler.get("implicit_steps", handler.get("nonlinear_steps", "")), "parts": handler.get("most_parts", ""),
                    "energy_balance": "energy-balance" in kinds,
                    "inverted": "inverted" in kinds, "indefinite": "indefinite" in kinds,
                    "reason": "" if done_whole else str(summary.get("exit_text") or "")[:300],
                    "momentum": change_of_momentum(path / "out/probes.csv", case["load"]),
                    "motion": motion(path / "out/probes.csv")}
        except (OSError, KeyError, ValueError) as error:
            row |= {"verdict": "no result", "lost": True, "wrongly_told": process.returncode == 0,
                    "reason": f"{error}; {errors[-200:]}"}
    shutil.rmtree(path)
    return row


def note_errors(rows):
    """Against the plain runs that were not lost."""
    for row in rows:
        if row["load"] == "pulled" and "motion" in row:  # by as much in every run: at shares of the run
            times, values = row["motion"]
            row["motion"] = [t / (row["step"] * row["steps"]) for t in times], values
    plain = {(r["body"], r["law"], r["load"]): r["motion"] for r in rows
             if r["handler"] == "plain, half" and not r.get("lost", True)}
    for row in rows:
        reference = plain.get((row["body"], row["law"], row["load"]))
        motion = row.pop("motion", None)
        if reference and motion and row["handler"] != "plain, half" and not row["lost"]:
            row["error"] = difference(motion, reference)


def key_of(row):
    return tuple(row[k] for k in ("body", "law", "load", "factor", "handler", "step"))


def noted(file, study):
    """The runs that a study has noted in a file, by key; the last line may be cut off. None of another study."""
    lines = file.read_text().splitlines() if file.exists() else []
    if lines and json.loads(lines[0]) != study:
        raise SystemExit(f"{file}: is of the study {lines[0]}, not of {json.dumps(study)}; take another --out or leave --resume out")
    rows = {}
    for line in lines[1:]:
        try:
            row = json.loads(line)
        except ValueError:
            break
        rows[key_of(row)] = row
    return rows


def critical_step(program, mesh, law):
    done = subprocess.run([program, "inspect", str(mesh), "--young", str(YOUNG), "--poisson", str(POISSON), "--density",
                           str(DENSITY), "--model", law, "--json", "-", "--threads", "1"],
                          capture_output=True, text=True, check=True)
    return json.loads(done.stdout)["critical_step"]["safe"]


def table(rows, of, title):
    """Share of runs lost, by `of` and handler."""
    names = [h for h in HANDLERS if any(r["handler"] == h for r in rows)]
    keys = sorted({r[of] for r in rows}, key=str)
    lines = [f"## {title}", "", f"| {of} | " + " | ".join(names) + " |", "|---" * (len(names) + 1) + "|"]
    for key in keys + ["all"]:
        cells = []
        for name in names:
            some = [r for r in rows if r["handler"] == name and key in (r[of], "all") and "lost" in r]
            cells.append(f"{sum(r['lost'] for r in some)} of {len(some)}" if some else "refused")
        lines.append(f"| {key} | " + " | ".join(cells) + " |")
    return "\n".join(lines) + "\n"


def plain_runs(rows):
    """By body, law and load."""
    return {(r["body"], r["law"], r["load"]): r for r in rows if r["handler"] == "plain, half"}


def median(values):
    return sorted(values)[len(values) // 2] if values else math.nan


def summary_table(rows):
    lines = ["## Of the runs that were not lost", "",
             "Medians and, after the comma, the largest.", "",
             "| handler | lost | wrongly told | rise of the energy balance (%) | fall (%) | error (%) | angular momentum, spinning | "
             "linear momentum, dropped | median time over plain's |",
             "|---|---|---|---|---|---|---|---|---|"]
    plain = plain_runs(rows)

    def two(values, scale=1.0):
        values = [v * scale for v in values if isinstance(v, float)]
        return f"{median(values):.2g}, {max(values):.2g}" if values else "–"

    for name in HANDLERS:
        some = [r for r in rows if r["handler"] == name and "lost" in r]
        if not some:
            continue
        kept = [r for r in some if not r["lost"]]
        shares = [share for r in kept if (share := share_of_plain(r, plain.get((r["body"], r["law"], r["load"]))))]
        momenta = lambda load: two([r.get("momentum", "") for r in kept if r["load"] == load])
        lines.append(f"| {name} | {sum(r['lost'] for r in some)} of {len(some)} | {sum(r['wrongly_told'] for r in some)} | "
                     f"{two([r['rise'] for r in kept], 100)} | {two([r['fall'] for r in kept], 100)} | "
                     f"{two([r.get('error', '') for r in kept], 100)} | {momenta('spinning')} | {momenta('dropped')} | "
                     f"{median(shares):.2g} |")
    return "\n".join(lines) + "\n"


def share_of_plain(row, plain):
    """Time of a simulated second over that of the plain run; nothing where that was lost."""
    if not plain or not plain.get("steps") or plain["lost"] or not row.get("steps"):
        return None
    factor = 1 if row["handler"] == "plain, half" else 0.5 / row["factor"]
    return row["seconds"] / row["steps"] * factor / (plain["seconds"] / plain["steps"])


def picture(rows):
    """SVG: a panel for each body, a line for each handler over its factors, with their numbers; hollow: most runs lost.

    Medians are of half of the laws and loads at least, and bodies without a plain run to compare with are left out.
    """
    colours = dict(zip(list(HANDLERS)[1:], ["#4269d0", "#97bbf5", "#3ca951", "#ff725c", "#a463f2", "#9c6b4e"]))
    plain = plain_runs(rows)
    width, height, across, left, top = 300, 230, 3, 52, 30
    decades_x, decades_y = (-4, 1), (-1, 1)  # of error and of time
    compared = {body: sum(p["body"] == body and not p.get("lost", True) for p in plain.values())
                for body in dict.fromkeys(r["body"] for r in rows)}
    names = sorted(body for body, count in compared.items() if count)
    at = lambda value, decades, size: (min(max(math.log10(value), decades[0]), decades[1]) - decades[0]) / (
        decades[1] - decades[0]) * size
    inner_x, inner_y = width - left - 12, height - top - 40
    out = []
    for number, body in enumerate(names):
        x0, y0 = number % across * width + left, number // across * height + top
        place = lambda error, time: (x0 + at(error, decades_x, inner_x), y0 + inner_y - at(time, decades_y, inner_y))
        out.append(f'<text x="{x0}" y="{y0 - 8}" font-weight="bold">{body}</text>')
        for k in range(decades_x[0], decades_x[1] + 1):
            x = place(10**k, 1)[0]
            out.append(f'<line x1="{x:.1f}" x2="{x:.1f}" y1="{y0}" y2="{y0 + inner_y}" stroke="#ddd"/>'
                       f'<text x="{x:.1f}" y="{y0 + inner_y + 14}" text-anchor="middle">{10.0**(k + 2):g}</text>')
        for k in range(decades_y[0], decades_y[1] + 1):
            y = place(1, 10**k)[1]
            out.append(f'<line x1="{x0}" x2="{x0 + inner_x}" y1="{y:.1f}" y2="{y:.1f}" stroke="{"#888" if k == 0 else "#ddd"}"/>'
                       f'<text x="{x0 - 4}" y="{y + 4:.1f}" text-anchor="end">{10.0**k:g}</text>')
        for handler, colour in colours.items():
            points = []
            for factor in sorted({r["factor"] for r in rows if r["handler"] == handler and r["body"] == body}):
                some = [r for r in rows if (r["body"], r["handler"], r["factor"]) == (body, handler, factor) and "lost" in r]
                kept = [(r["error"], share) for r in some if isinstance(r.get("error"), float) and r["error"] > 0 and
                        (share := share_of_plain(r, plain.get((r["body"], r["law"], r["load"]))))]
                if 2 * len(kept) >= compared[body]:
                    points.append((*place(*(median(list(v)) for v in zip(*kept))), factor, 2 * sum(r["lost"] for r in some) > len(some)))
            line = " ".join(f"{x:.1f},{y:.1f}" for x, y, *_ in points)
            out.append(f'<polyline points="{line}" fill="none" stroke="{colour}"/>')
            out += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3" stroke="{colour}" fill="{"white" if lost else colour}"/>'
                    f'<text x="{x + 4:.1f}" y="{y - 4:.1f}" fill="{colour}" font-size="9">{factor:g}</text>'
                    for x, y, factor, lost in points]
        out.append(f'<text x="{x0 + inner_x / 2}" y="{y0 + inner_y + 28}" text-anchor="middle">error (%)</text>')
        out.append(f'<text transform="translate({x0 - 34},{y0 + inner_y / 2}) rotate(-90)" text-anchor="middle">time over plain\'s</text>')
    bottom = (len(names) + across - 1) // across * height + 30
    for k, (handler, colour) in enumerate(colours.items()):
        x = left + k * 145
        out.append(f'<circle cx="{x}" cy="{bottom - 14}" r="4" fill="{colour}"/><text x="{x + 8}" y="{bottom - 10}">{handler}</text>')
    return (f'<svg xmlns="http://www.w3.org/2000/svg" width="{across * width}" height="{bottom}" font-family="sans-serif" '
            f'font-size="10"><rect width="100%" height="100%" fill="white"/>\n' + "\n".join(out) + "\n</svg>\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("out/handled_runs"))
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--steps", type=int, default=10000)
    parser.add_argument("--seconds", type=float, help="begin no run after so long; tables are of those that were made")
    parser.add_argument("--longest", type=float, default=200, help="seconds of a run; it is lost then")
    parser.add_argument("--method", default="symplectic-euler", choices=["symplectic-euler", "verlet"])
    parser.add_argument("--most-rise", type=float, help="of the energy balance over the largest energy")
    parser.add_argument("--most-fall", type=float, help="the same, downwards")
    parser.add_argument("--bodies", nargs="+")
    parser.add_argument("--laws", nargs="+", default=LAWS)
    parser.add_argument("--loads", nargs="+", default=list(LOADS), choices=list(LOADS))
    parser.add_argument("--factors", nargs="+", type=float, default=FACTORS)
    parser.add_argument("--handlers", nargs="+", default=list(HANDLERS), choices=list(HANDLERS))
    parser.add_argument("--resume", action="store_true", help="take the runs that DIR has noted, and make the others")
    options = parser.parse_args()
    begin = time.monotonic()
    options.out.mkdir(parents=True, exist_ok=True)
    notes = options.out / "made.jsonl"
    study = {"steps": options.steps, "method": options.method}
    made = noted(notes, study) if options.resume else {}
    with tempfile.TemporaryDirectory() as scratch:
        scratch = pathlib.Path(scratch)
        cases = []
        for number, (body, (mesh, cuts)) in enumerate(bodies(scratch).items()):
            if options.bodies and body not in options.bodies:
                continue
            if mesh is None:
                print(f"{body}: left out, there is no tetgen")
                continue
            file = scratch / f"body_{number}.msh"
            write_msh(file, *mesh)
            extent = min(n[0] for n in mesh[0]), max(n[0] for n in mesh[0])
            for law in options.laws:
                critical = critical_step(options.program, file, law)
                for load, handler in itertools.product(options.loads, options.handlers):
                    if cuts and load == "pulled":
                        continue  # what is cut off does not move: no energy to measure by
                    for factor in [0.5] if HANDLERS[handler] is None else options.factors:
                        # The same time for all, so many steps of the largest factor.
                        step = factor * critical
                        end = options.steps * step
                        cases.append({"id": str(len(cases)), "body": body, "law": law, "load": load, "factor": factor,
                                      "handler": handler, "step": step, "end": end,
                                      "text": scene(file, cuts, law, load, HANDLERS[handler], options.method, step, end,
                                                    extent)})
        random.Random(1).shuffle(cases)
        first = (0.5, *FACTORS[:2])
        cases.sort(key=lambda case: case["factor"] not in first)
        wanted = len(cases)
        rows = [made[key_of(case)] for case in cases if key_of(case) in made]
        cases = [case for case in cases if key_of(case) not in made]
        with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool, notes.open("w") as file:
            for row in (study, *made.values()):
                print(json.dumps(row), file=file)
            file.flush()
            late = lambda: options.seconds and time.monotonic() - begin > options.seconds
            work = lambda case: None if late() else run(options.program, scratch, case, options.longest)
            for count, row in enumerate(pool.map(work, cases), 1):
                if row:
                    rows.append(row)
                    print(json.dumps(row), file=file, flush=True)
                if sys.stderr.isatty() and count % 10 == 0:
                    print(f"\r{count} of {len(cases)} runs", end="", file=sys.stderr)
    note_errors(rows)
    columns = ["body", "law", "load", "factor", "handler", "step", "exit", "verdict", "steps", "whole", "lost", "wrongly_told",
               "rise", "fall", "dissipated", "error", "momentum", "energy_balance", "certified", "handled", "selections",
               "added_mass", "implicit", "parts", "inverted", "indefinite", "seconds", "reason"]
    with (options.out / "runs.csv").open("w", newline="") as file:
        writer = csv.DictWriter(file, columns)
        writer.writeheader()
        writer.writerows(rows)
    text = f"{len(rows)} of {wanted} runs, {options.steps} steps each.\n\n" + summary_table(rows)
    for of in ("law", "load", "factor", "body"):
        text += "\n" + table(rows, of, f"Lost, by {of}")
    (options.out / "tables.md").write_text(text)
    (options.out / "work_and_error.svg").write_text(picture(rows))
    print(text)
    off = [r for r in rows if r.get("wrongly_told") or r["handler"] != "plain, half" and r.get("whole") and (
        options.most_rise is not None and not r["rise"] <= options.most_rise or
        options.most_fall is not None and not r["fall"] <= options.most_fall)]
    for row in off:
        print("off: " + ", ".join(f"{k} {row[k]}" for k in ("body", "law", "load", "factor", "handler", "verdict", "rise", "fall")
                                  if k in row))
    if off and (options.most_rise is not None or options.most_fall is not None):
        sys.exit(1)


if __name__ == "__main__":
    main()
