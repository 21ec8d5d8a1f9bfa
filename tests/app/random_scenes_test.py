"""Random scenes of all features together, through the command line.

  random_scenes_test.py PROGRAM [--scenes N] [--seed S] [--keep FOLDER]

Scenes take turns with the pairs of FEATURES, and draw others beside. Of each: the program ends with a known exit status; what it refuses is
one line, and it leaves nothing behind; what it runs has a summary, no error ends it, and each feature has acted where it reaches its end;
safe <= optimistic in every row; *stable* in the summary is exit status 0; two threads give the bytes of one; a run that is killed or stopped
at a random moment and resumed with two threads gives the bytes of the one that was not. Scenes that fail are kept in FOLDER.
"""
import argparse
import collections
import csv
import itertools
import json
import os
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time

# A scene takes far below a second; a machine may be busy.
SECONDS = 300
# How often features are left as they were drawn, although the program refuses them together.
UNFITTED = 0.1
ELASTIC = ["stvk", "neo-hookean", "corotational", "linear", "stable-neo-hookean"]
RUBBERS = {"mooney-rivlin": {"c10": 1e5, "c01": 2e4, "bulk": 2e6}, "yeoh": {"c10": 1e5, "c20": -1e3, "c30": 1e3, "bulk": 2e6}}
HANDLERS = ["local-time-stepping", "imex", "fe-pbd", "modal-filter", "mass-scaling"]
QUADRATIC = ["tet10", "hex20"]
ONE_FORCE = ["symplectic-euler", "verlet"]
NOT_WITH_HANDLERS = ["contact", "obstacle", "spring", "pressure", "rigid", "erosion", "cut", "mass_damping"]
# What must act, each with how often it is drawn beside the pair of a scene.
FEATURES = {"erosion": 0.1, "cut": 0.1, "surfaces": 0.2, "obstacle": 0.3, "certificates": 0.15, "damping": 0.2, "material damping": 0.15,
            "checkpoints": 0.4, "spring": 0.15, "handler": 0.2}
PAIRS = list(itertools.combinations(FEATURES, 2))
LISTS = ["fix", "move", "initial", "force", "pressure", "mass", "mass_damping", "rigid", "spring", "obstacle", "contact", "cut", "probe"]


def value_text(value):
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, list):
        return "[" + ", ".join(map(value_text, value)) + "]"
    return json.dumps(value) if isinstance(value, str) else repr(value)


class Drawn:
    """A scene as it is drawn: tables of each name."""

    def __init__(self, seed):
        self.random = random.Random(seed)
        self.tables = collections.defaultdict(list)
        self.features = {name for name, share in FEATURES.items() if name in PAIRS[seed % len(PAIRS)] or self.chance(share)}
        self.draw()
        if not self.chance(UNFITTED):
            self.fit()

    def chance(self, share):
        return self.random.random() < share

    def one_of(self, *values):
        return self.random.choice(values)

    def add(self, table, /, **keys):
        self.tables[table].append({key: value for key, value in keys.items() if value is not None})

    def mesh(self):
        element = self.one_of("tet4", "tet4", "hex8", "wedge6", "pyramid5", "tet10", "hex20")
        if "cut" in self.features:
            element = "tet4"
        cells, jitter = self.one_of(1, 2) if element in QUADRATIC else self.one_of(2, 3), self.one_of(0.0, 0.2)
        kind = "stack" if "surfaces" in self.features else self.one_of("bar", "bar", "cube")
        if kind == "bar":
            self.add("mesh", generate=kind, element=element, size=[0.2, 0.1, 0.1], cells=[2 * cells, cells, cells], jitter=jitter)
        elif kind == "cube":
            self.add("mesh", generate=kind, element=element, size=0.1, cells=cells, jitter=jitter)
        else:
            self.add("mesh", generate=kind, element=element, size=[0.2, 0.1, 0.1], cells=[4, 2, 2], upper_size=[0.1, 0.1, 0.1],
                     upper_cells=[2, 2, 2], gap=self.one_of(0.001, 0.004))
        return kind, element

    def material(self, **place):
        model = self.one_of(*ELASTIC, *RUBBERS)
        keys = RUBBERS.get(model) or {"young": self.one_of(3e5, 1e6), "poisson": self.one_of(0.0, 0.3, 0.45)}
        self.add("material", model=model, density=self.one_of(1000.0, 1500.0), **keys, **place,
                 **self.one_of({"stiffness_damping": 1e-5} if "young" in keys else {"mass_damping": 5.0}, {"shear_viscosity": 1.0},
                               {"mass_damping": 5.0}) if "material damping" in self.features else {})

    def draw(self):
        kind, element = self.mesh()
        if not self.chance(0.3):
            self.material(rules=["hex8=uniform-strain"] if element == "hex8" and self.chance(0.3) else None)
        elif kind == "stack":
            self.material(set="lower")
            self.material(set="upper")
        else:
            self.material(where="x < 0.05")
            self.material(where="x >= 0.05")
        self.add("integrator", method=self.one_of(*5 * ONE_FORCE, "rkn4", "pefrl", "yoshida4", "rk4", "explicit-euler"),
                 step=self.one_of(2e-5, 5e-5, 1e-4, "auto"), end=self.one_of(3e-3, 6e-3))
        if "damping" in self.features:
            self.add("damping", **self.one_of({"mass": 5.0}, {"stiffness": 1e-5}, {"bulk_viscosity": True}, {"mass": 2.0, "stiffness": 5e-6}))
        mode = self.one_of("threshold", "metric") if self.chance(0.3) else None
        self.add("monitor", on_violation=self.one_of("stop", "warn", "reduce-step", "repeat", "handle"), mode=mode,
                 metric="pressure-wave" if mode == "metric" else None, every=self.one_of(2, 7) if self.chance(0.3) else None,
                 budget=self.one_of(0.0, 0.1, 0.5) if self.chance(0.3) else None,
                 certificates=self.one_of(1, 5) if "certificates" in self.features else None)
        if "handler" in self.features:
            self.add("handler", method=self.one_of(*HANDLERS))
        self.supports_and_loads(kind, element)
        self.add("output", every=1e-3, checkpoint_every=self.one_of(4e-4, 1e-3) if "checkpoints" in self.features else None,
                 exact_times=True if self.chance(0.2) else None, history_every=5 if self.chance(0.3) else None,
                 fields=["critical_step", "von_mises"] if self.chance(0.3) else None, picture=False)

    def supports_and_loads(self, kind, element):
        end = 0.1 if kind == "cube" else 0.2
        torn = "erosion" in self.features
        if torn or self.chance(0.5):
            self.add("fix", where="x < 1e-6")
        if torn or self.chance(0.3):
            self.add("move", where=f"x > {end} - 1e-6 and z < 0.1 + 1e-6", velocity=[self.one_of(2.0, 5.0) if torn else self.one_of(1.0, -1.0, 5.0), 0, 0],
                     factor="sin(2*pi*100*t)" if not torn and self.chance(0.4) else None)
        if kind == "stack":
            self.add("initial", where="z > 0.1 + 1e-6", velocity=[0, 0, -8.0])
        elif "obstacle" in self.features or self.chance(0.4) or not ("move" in self.tables):
            self.add("initial", where="all", velocity=[0, 0, self.one_of(-1.0, -5.0)],
                     angular_velocity=[0, 20.0, 5.0] if self.chance(0.5) else None)
        if self.chance(0.4):
            self.add("force", where="all", acceleration=[0, 0, -9.81])
        if self.chance(0.2):
            self.add("pressure", where="z > 0.0999", pressure=self.one_of(1e3, 2e4))
        if self.chance(0.2):
            self.add("mass", where="x < 0.05", mass=0.1)
        if self.chance(0.15):
            self.add("mass_damping", where="x < 0.05", rate=20.0)
        if self.chance(0.2):
            self.add("rigid", name="head", where=self.one_of("x > 0.12", "z > 0.08", "x < 0.03"))
            if self.chance(0.3):
                self.add("fix", rigid="head", components=self.one_of("xyz", "xz", "y"), turns=self.one_of(True, False),
                         axis=[0, 1.0, 0.3] if self.chance(0.3) else None)
            elif self.chance(0.4):
                self.add("move", rigid="head", velocity=[self.one_of(1.0, -2.0), 0, 0], components=self.one_of("xyz", "x"),
                         factor="sin(2*pi*100*t)" if self.chance(0.4) else None, **self.one_of({}, {"turns": True}, {"angular_velocity": [0, 0, 5.0]}))
        if "spring" in self.features:
            self.add("spring", where="x > 0.08", stiffness=self.one_of(100.0, 1e4), damping=0.5 if self.chance(0.4) else None)
        if "obstacle" in self.features:
            # A block that comes down would press the one below, which rests, onto it late.
            self.add("obstacle", kind="plane", point=[0, 0, -0.0005 if kind != "stack" else 0.0], normal=[0, 0, 1])
            self.add("contact", friction=0.3 if self.chance(0.4) else None, damping=0.1 if self.chance(0.4) else None)
        if "surfaces" in self.features:
            self.add("contact", **{"with": "surface"}, friction=0.2 if self.chance(0.3) else None)
        elif self.chance(0.1):
            self.add("contact", **{"with": "surface"})
        if "erosion" in self.features:
            self.add("erosion", inverted=True, max_stretch=self.one_of(1.005, 1.02), every=self.one_of(1, 1, 4))
        if "cut" in self.features:
            self.add("cut", time=self.one_of(5e-4, 1e-3), point=[0.05, 0.05, 0.05], normal=[1, 0.3, 0])
        if self.chance(0.3):
            self.add("probe", name="all", what="displacement", where="all")

    def fit(self):
        """Takes out most of what is refused together."""
        integrator, monitor = self.tables["integrator"][0], self.tables["monitor"][0]
        if "handler" in self.tables:
            self.fit_handler(integrator, monitor)
        elif monitor["on_violation"] == "handle":
            monitor["on_violation"] = "warn"
        if monitor["on_violation"] == "repeat" and (integrator["step"] == "auto" or monitor.get("mode") == "metric"
                                                    or "erosion" in self.tables or "cut" in self.tables):
            monitor["on_violation"] = "reduce-step"
        if monitor["on_violation"] == "repeat":
            self.tables["output"][0].pop("checkpoint_every", None)
        if integrator["step"] == "auto":
            monitor.pop("mode", None)
            monitor.pop("metric", None)
            for contact in self.tables["contact"]:
                contact["step"] = 5e-5
        if integrator["method"] not in ONE_FORCE and not self.chance(0.1):
            integrator["method"] = self.one_of(*ONE_FORCE)
        if "erosion" in self.tables:
            self.remove("cut", "pressure")
            self.tables["output"][0].pop("checkpoint_every", None)
        if "cut" in self.tables:
            self.remove("contact", "obstacle", "spring", "pressure", "rigid", "mass_damping")
            self.tables["output"][0].pop("checkpoint_every", None)
        if any(name in self.tables for name in ("erosion", "handler", "contact", "spring", "mass_damping", "rigid")) or self.elements_damp() or \
                monitor.get("mode") == "metric":
            monitor.pop("certificates", None)
        if "rigid" in self.tables:
            self.remove("cut")
            for name in ("fix", "move"):  # of nodes
                guides = [table for table in self.tables.get(name, []) if "rigid" in table]
                self.remove(name)
                if guides:
                    self.tables[name] = guides

    def elements_damp(self):
        return any(key in material for material in self.tables["material"] for key in ("stiffness_damping", "shear_viscosity", "mass_damping")) or \
            any("bulk_viscosity" in damping for damping in self.tables.get("damping", []))

    def drawn(self):
        """The features that are still there."""
        has = {"erosion": "erosion" in self.tables, "cut": "cut" in self.tables, "obstacle": "obstacle" in self.tables,
               "surfaces": "surfaces" in self.features and any("with" in contact for contact in self.tables.get("contact", [])),
               "certificates": "certificates" in self.tables["monitor"][0], "damping": "damping" in self.tables,
               "material damping": self.elements_damp(), "spring": "spring" in self.tables, "handler": "handler" in self.tables,
               "checkpoints": "checkpoint_every" in self.tables["output"][0]}
        return {name for name in self.features if has[name]}

    def fit_handler(self, integrator, monitor):
        self.remove(*NOT_WITH_HANDLERS)
        integrator["method"] = self.one_of(*ONE_FORCE)
        if integrator["step"] != "auto":
            integrator["step"] = 4e-4
        if self.tables["handler"][0]["method"] in ("fe-pbd", "modal-filter"):
            self.remove("damping")
        for key in ("stiffness_damping", "shear_viscosity", "mass_damping"):
            for material in self.tables["material"]:
                material.pop(key, None)
        for damping in self.tables.get("damping", []):
            damping.pop("bulk_viscosity", None)
        if not any(self.tables.get("damping", [])):
            self.remove("damping")
        for move in self.tables["move"]:
            move.pop("factor", None)
        self.tables["output"][0].pop("checkpoint_every", None)
        if monitor["on_violation"] in ("reduce-step", "repeat"):
            monitor["on_violation"] = "warn"
        if monitor.get("mode") == "metric":
            monitor.pop("mode")
            monitor.pop("metric")

    def remove(self, *names):
        for name in names:
            self.tables.pop(name, None)

    def text(self):
        lines = []
        for name, tables in self.tables.items():
            for table in tables:
                lines.append(f"[[{name}]]" if name in LISTS or len(tables) > 1 else f"[{name}]")
                lines += [f"{key} = {value_text(value)}" for key, value in table.items()]
        return "\n".join(lines) + "\n"


class Trial:
    """The runs of one scene in one folder."""

    def __init__(self, program, folder, seed):
        self.program, self.folder, self.seed = program, folder, seed
        self.resumed = False
        scene = Drawn(seed)
        self.features = scene.drawn()
        self.acted = set()
        (folder / "scene.toml").write_text(scene.text())

    def environment(self, threads):
        return {**os.environ, "OMP_NUM_THREADS": str(threads), "OMP_WAIT_POLICY": "passive"}

    def run(self, threads, *arguments):
        return subprocess.run([self.program, "run", *arguments], cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                              timeout=SECONDS, env=self.environment(threads), check=False)

    def faults(self):
        """What is wrong, a line each, and the exit status of the run."""
        begin = time.monotonic()
        whole = self.run(1, "scene.toml", "--out", "one")
        seconds = time.monotonic() - begin
        if whole.returncode == 2:
            return self.faults_of_refusal(whole), 2
        if whole.returncode not in (0, 1, 3):
            return [f"exit status {whole.returncode}: {whole.stderr[-300:]}"], whole.returncode
        found = self.faults_of_results(whole.returncode)
        other = self.run(2, "scene.toml", "--out", "two")
        found += [f"two threads: {what}" for what in self.differences("two", whole.returncode, other)]
        return found + self.faults_of_resumption(whole.returncode, seconds), whole.returncode

    def faults_of_refusal(self, outcome):
        lines = outcome.stderr.strip().splitlines()
        found = [] if len(lines) == 1 else [f"a refusal of {len(lines)} lines: {outcome.stderr[:300]}"]
        folder = self.folder / "one"
        if folder.exists() and any(folder.iterdir()):
            found.append(f"left files behind: {outcome.stderr[:200]}")
        return found

    def faults_of_results(self, status):
        found = []
        if not (self.folder / "one/summary.json").exists():
            return [f"no summary with exit status {status}"]
        last = {}
        with open(self.folder / "one/history.csv", newline="", encoding="utf-8") as file:
            for row in csv.DictReader(file):
                if row.get("safe_s") and row.get("optimistic_s") and float(row["safe_s"]) > float(row["optimistic_s"]):
                    found.append(f"step {row['step']}: safe {row['safe_s']} is above optimistic {row['optimistic_s']}")
            last = row
        summary = json.loads((self.folder / "one/summary.json").read_text(encoding="utf-8"))
        if summary["stable"] != (status == 0):
            found.append(f"stable is {summary['stable']} with exit status {status}")
        if summary["exit_reason"] == "failed":
            found.append(f"an error ended the run: {summary['exit_text']}")
        self.acted = self.features & self.acting(summary, last)
        if summary["exit_reason"] == "end":
            found += [f"{name} did not act" for name in sorted(self.features - self.acted)]
        return found

    def acting(self, summary, last):
        """The features that have left a trace in the results."""
        # A short run may have a row of its start alone.
        damped = float(last["dissipated_J"] or 0) > 0 or last["step"] == "0"
        forces, erosion = summary["discrete_forces"] or {}, summary["erosion"] or {}
        traces = {"erosion": erosion.get("elements"), "cut": summary["cuts"], "surfaces": forces.get("most_touching"), "obstacle": forces.get("most_touching"),
                  "certificates": any(name.startswith("certificates") for name in summary["files"]), "damping": damped,
                  "material damping": damped, "checkpoints": True, "spring": bool(forces), "handler": summary["handler"]}
        return {name for name, trace in traces.items() if trace}

    def differences(self, folder, status, outcome):
        found = [] if outcome.returncode == status else [f"exit status {outcome.returncode}, not {status}: {outcome.stderr[-200:]}"]
        names = {str(path.relative_to(self.folder / run)) for run in ("one", folder) for path in (self.folder / run).rglob("*")
                 if path.suffix in (".csv", ".vtu", ".pvd")}
        for name in sorted(names):
            first, second = self.folder / "one" / name, self.folder / folder / name
            if not first.exists() or not second.exists() or first.read_bytes() != second.read_bytes():
                found.append(f"{name} differs")
        return found

    def faults_of_resumption(self, status, seconds):
        if "checkpoint_every" not in (self.folder / "scene.toml").read_text():
            return []
        chance = random.Random(self.seed)
        with subprocess.Popen([self.program, "run", "scene.toml", "--out", "three"], cwd=self.folder, stdout=subprocess.DEVNULL,
                              stderr=subprocess.DEVNULL, env=self.environment(1)) as process:
            try:
                process.wait(chance.random() * seconds)
                return []
            except subprocess.TimeoutExpired:
                process.send_signal(chance.choice([signal.SIGKILL, signal.SIGTERM]))
        if not (self.folder / "three/checkpoint.bin").exists():
            return []
        self.resumed = True
        rest = self.run(2, "--resume", "three")
        return [f"resumed: {what}" for what in self.differences("three", status, rest)]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program", type=lambda file: str(pathlib.Path(file).resolve()))
    parser.add_argument("--scenes", type=int, default=int(os.environ.get("RINGWATCH_RANDOM_SCENES", str(len(PAIRS)))), help="how many (as many as there are pairs)")
    parser.add_argument("--seed", type=int, default=1, help="of the first scene (1)")
    parser.add_argument("--keep", type=pathlib.Path, help="folder for scenes that fail")
    options = parser.parse_args()
    statuses, resumed, failed = collections.Counter(), 0, 0
    acted = collections.Counter()
    for seed in range(options.seed, options.seed + options.scenes):
        with tempfile.TemporaryDirectory() as folder:
            trial = Trial(options.program, pathlib.Path(folder), seed)
            faults, status = trial.faults()
            statuses[status] += 1
            resumed += trial.resumed
            acted.update(trial.acted)
            acted.update(" and ".join(pair) for pair in PAIRS if set(pair) <= trial.acted)
            for fault in faults:
                print(f"scene of seed {seed}: {fault}", flush=True)
            if faults:
                failed += 1
                if options.keep:
                    shutil.copytree(folder, options.keep / str(seed), dirs_exist_ok=True)
    print(f"{options.scenes} scenes: " + ", ".join(f"{count} with exit status {status}" for status, count in sorted(statuses.items())) +
          f"; {resumed} resumed; {failed} failed; acted: " + ", ".join(f"{name} {acted[name]}" for name in FEATURES))
    missing = [name for name in FEATURES if not acted[name]] if options.scenes >= len(PAIRS) else []
    # Scenes that are all refused would show nothing.
    if failed or missing or statuses[0] < options.scenes / 4:
        sys.exit(1)


if __name__ == "__main__":
    main()
