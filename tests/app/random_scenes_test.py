"""Random scenes of all features together, through the command line.

  random_scenes_test.py PROGRAM [--scenes N] [--seed S] [--seconds T] [--keep FOLDER]

Scenes take turns with the pairs of FEATURES, and draw others beside. Of each: the program ends with a known exit status; it refuses what its
table does, in one line that names two that do not go together, and leaves nothing behind; what it runs has a summary, no error ends it, and each feature has acted where it reaches its end;
safe <= optimistic in every row; *stable* in the summary is exit status 0; two threads give the bytes of one; a run that is killed or stopped
at a random moment and resumed with two threads gives the bytes of the one that was not. Scenes that fail are kept in FOLDER.
"""
import argparse
import collections
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
import time

# A scene takes far below a second; a machine may be busy.
SECONDS = 300
# How often a feature is drawn although it does not go with others.
UNFITTED = 0.1
ELASTIC = ["stvk", "neo-hookean", "corotational", "linear", "stable-neo-hookean"]
RUBBERS = {"mooney-rivlin": {"c10": 1e5, "c01": 2e4, "bulk": 2e6}, "yeoh": {"c10": 1e5, "c20": -1e3, "c30": 1e3, "bulk": 2e6}}
TETRAHEDRAL = ["fe-pbd", "modal-filter"]  # which take nothing but tet4 of laws that turn with it
HANDLERS = ["local-time-stepping", "imex", "mass-scaling", *TETRAHEDRAL]
QUADRATIC = ["tet10", "hex20"]
METHODS = [*5 * ["symplectic-euler", "verlet"], "rkn4", "pefrl", "yoshida4", "rk4"]
# Of the program's table of what goes together, with how often each is drawn beside the pair of a scene.
FEATURES = {"handlers": 0.05, "loads and motions that change in time": 0.1, "pressures": 0.05, "springs and contact": 0.1, "surfaces in contact": 0.1,
            "moving obstacles": 0.1, "dashpots and friction": 0.05, "elements that damp": 0.1, "proofs with Rayleigh damping": 0.1, "rigid bodies": 0.1, "cuts": 0.05,
            "elements that erode": 0.1, "rules of uniform strain": 0.05, "laws without young and poisson": 0.1, "whole masses of nodes": 0.05, "certificates along a run": 0.1,
            "runs that go back": 0.05, "steps that are reduced": 0.1, "steps that are held": 0.05, "checkpoints": 0.2, "frames between steps": 0.1,
            "probes": 0.1, "reactions": 0.1, "metrics": 0.1, "budgets of the monitor": 0.2}
PAIRS = list(itertools.combinations(FEATURES, 2))
# Ways to answer a violation, of which a scene has one.
ON_VIOLATION = {"runs that go back": "repeat", "steps that are reduced": "reduce-step"}
LISTS = ["fix", "move", "initial", "force", "pressure", "mass", "mass_damping", "rigid", "spring", "obstacle", "contact", "cut", "probe"]


def value_text(value):
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, list):
        return "[" + ", ".join(map(value_text, value)) + "]"
    return json.dumps(value) if isinstance(value, str) else repr(value)


class Drawn:
    """A scene as it is drawn: tables of each name."""

    def __init__(self, seed, table):
        self.random = random.Random(seed)
        self.tables = collections.defaultdict(list)
        self.table = table
        self.pair = PAIRS[seed % len(PAIRS)]
        self.features = set(self.pair)
        for name in self.random.sample(list(FEATURES), len(FEATURES)):
            if self.chance(FEATURES[name]) and (self.chance(UNFITTED) or self.fits(name)):
                self.features.add(name)
        methods = [name for name in METHODS if not any(name in table[feature]["not_by"] for feature in self.features)]
        self.method = self.one_of(*METHODS) if self.chance(UNFITTED) or not methods else self.one_of(*methods)
        self.draw()

    def fits(self, name):
        """Whether a feature goes with those that the scene has."""
        return name not in self.features and self.features.isdisjoint(self.table[name]["not_with"]) and \
            not (name in ON_VIOLATION and self.features & set(ON_VIOLATION))

    def refused(self):
        """What the program refuses of the scene, as pairs of names: by its table, and what a handler does not take."""
        proven = all(monitor.get("mode") != "metric" for monitor in self.tables["monitor"])
        untaken = [(handler["method"], word) for handler in self.tables["handler"] if handler["method"] in TETRAHEDRAL
                   for word in self.untaken()]
        return untaken + [(name, other) for name in self.features for other in [*self.table[name]["not_with"], *self.table[name]["not_by"]]
                if (other in self.features or other == self.method) and (proven or name != "proofs with Rayleigh damping")]

    def untaken(self):
        """The scene's elements and laws that TETRAHEDRAL handlers do not take."""
        return ({self.element} - {"tet4"}) | ({material["model"] for material in self.tables["material"]} & {"linear"})

    def words(self, name):
        """What a refusal may call a feature or an integrator."""
        return {name, self.table[name]["part_of"] if name in self.table else name}

    def has(self, *names):
        return not self.features.isdisjoint(names)

    def chance(self, share):
        return self.random.random() < share

    def one_of(self, *values):
        return self.random.choice(values)

    def add(self, table, /, **keys):
        self.tables[table].append({key: value for key, value in keys.items() if value is not None})

    def mesh(self):
        element = self.one_of("tet4", "tet4", "hex8", "wedge6", "pyramid5", "tet10", "hex20")
        self.element = element = "tet4" if self.has("cuts") else "hex8" if self.has("rules of uniform strain") else element
        cells, jitter = self.one_of(1, 2) if element in QUADRATIC else self.one_of(2, 3), self.one_of(0.0, 0.2)
        kind = "stack" if self.has("surfaces in contact") else self.one_of("bar", "bar", "cube")
        if kind == "bar":
            self.add("mesh", generate=kind, element=element, size=[0.2, 0.1, 0.1], cells=[2 * cells, cells, cells], jitter=jitter)
        elif kind == "cube":
            self.add("mesh", generate=kind, element=element, size=0.1, cells=cells, jitter=jitter)
        else:
            self.add("mesh", generate=kind, element=element, size=[0.2, 0.1, 0.1], cells=[4, 2, 2], upper_size=[0.1, 0.1, 0.1],
                     upper_cells=[2, 2, 2], gap=self.one_of(0.001, 0.004))
        return kind

    def material(self, **place):
        model = self.one_of(*RUBBERS if self.has("laws without young and poisson") else ELASTIC)
        keys = RUBBERS.get(model) or {"young": self.one_of(3e5, 1e6), "poisson": self.one_of(0.0, 0.3, 0.45)}
        self.add("material", model=model, density=self.one_of(1000.0, 1500.0), **keys, **place,
                 rules=["hex8=uniform-strain"] if self.has("rules of uniform strain") else None,
                 **self.one_of({"stiffness_damping": 1e-5} if "young" in keys else {"mass_damping": 5.0}, {"shear_viscosity": 1.0},
                               {"mass_damping": 5.0}) if self.has("elements that damp") else {})

    def draw(self):
        kind = self.mesh()
        if kind == "cube" or not self.chance(0.3):
            self.material()
        elif kind == "stack":
            self.material(set="lower")
            self.material(set="upper")
        else:
            self.material(where="x < 0.1")
            self.material(where="x >= 0.1")
        handled, held = self.has("handlers"), self.has("steps that are held")
        steps = ["auto"] if held else [4e-4] if handled else [2e-5, 5e-5, 1e-4] + ([] if self.has("runs that go back") else ["auto"])
        step = self.one_of(*steps)
        self.add("integrator", method=self.method, step=step, end=self.one_of(3e-3, 6e-3), hold=True if held else None)
        if self.has("proofs with Rayleigh damping"):
            self.add("damping", **self.one_of({"mass": 5.0}, {"stiffness": 1e-5}))
        metric = self.has("metrics") and step != "auto" and not handled and not self.has("certificates along a run", *ON_VIOLATION)
        answer = [ON_VIOLATION[name] for name in ON_VIOLATION if name in self.features]
        self.add("monitor", on_violation=answer[0] if answer else self.one_of("stop", "warn", *["handle"] * handled),
                 mode=self.one_of("threshold", "metric") if metric else None, metric="pressure-wave" if self.has("metrics") else None,
                 every=self.one_of(2, 7) if self.chance(0.3) else None, budget=self.one_of(0.0, 0.1, 0.5) if self.has("budgets of the monitor") else None,
                 certificates=self.one_of(1, 5) if self.has("certificates along a run") else None)
        if handled:
            unfit = TETRAHEDRAL if self.untaken() and not self.chance(UNFITTED) else []
            handlers = ["imex", "mass-scaling"] if self.has("proofs with Rayleigh damping") else HANDLERS
            self.add("handler", method=self.one_of(*(name for name in handlers if name not in unfit)))
        self.supports_and_loads(kind)
        self.contact(kind, step)
        self.add("output", every=1e-3, checkpoint_every=self.one_of(4e-4, 1e-3) if self.has("checkpoints") else None,
                 exact_times=True if self.has("frames between steps") else None, history_every=5 if self.chance(0.3) else None,
                 fields=["critical_step", "von_mises"] if self.chance(0.3) else None, picture=False, reactions=True if self.has("reactions") else None)

    def supports_and_loads(self, kind):
        end, torn, rigid = 0.1 if kind == "cube" else 0.2, self.has("elements that erode"), self.has("rigid bodies")
        if torn or self.has("reactions") or self.chance(0.5):
            self.add("fix", where="x < 1e-6")
        if torn or (not rigid and self.chance(0.3)):
            self.add("move", where=f"x > {end} - 1e-6 and z < 0.1 + 1e-6", velocity=[self.one_of(2.0, 5.0) if torn else self.one_of(1.0, -1.0, 5.0), 0, 0])
        if kind == "stack":
            self.add("initial", where="z > 0.1 + 1e-6", velocity=[0, 0, -8.0])
        else:
            self.add("initial", where="all", velocity=[0, 0, self.one_of(-1.0, -5.0)], angular_velocity=[0, 20.0, 5.0] if self.chance(0.5) else None)
        self.add("force", where="all", acceleration=[0, 0, -9.81],
                 factor="cos(2*pi*100*t)" if self.has("loads and motions that change in time") else None)
        if self.has("pressures"):
            self.add("pressure", where="z > 0.0999", pressure=self.one_of(1e3, 2e4))
        if self.has("whole masses of nodes"):
            self.add("mass", where="x < 0.05", nodal_mass=1.0)
        if rigid:
            self.add("rigid", name="head", where="x > 0.03 and x < 0.08")
        if self.has("cuts"):
            self.add("cut", time=self.one_of(5e-4, 1e-3), point=[0.05, 0.05, 0.05], normal=[1, 0.3, 0])
        if torn:
            self.add("erosion", inverted=True, max_stretch=self.one_of(1.005, 1.02), every=self.one_of(1, 1, 2))
        if self.has("probes"):
            self.add("probe", name="all", what="displacement", where="all")

    def contact(self, kind, step):
        damped = self.has("dashpots and friction")
        if self.has("springs and contact") or (damped and not self.has("moving obstacles", "surfaces in contact")):
            self.add("spring", where="x > 0.08", stiffness=self.one_of(100.0, 1e4), damping=0.5 if damped else None)
        settings = {"friction": 0.3 if damped else None, "damping": 0.1 if damped else None, "step": 5e-5 if step == "auto" else None}
        if self.has("moving obstacles"):
            # A block that comes down would press the one below, which rests, onto it late.
            self.add("obstacle", kind="plane", point=[0, 0, -0.0005 if kind != "stack" else 0.0], normal=[0, 0, 1], velocity=[0, 0, 1.0])
            self.add("contact", **settings)
        if self.has("surfaces in contact"):
            self.add("contact", **{"with": "surface"}, **settings)

    def text(self):
        lines = []
        for name, tables in self.tables.items():
            for table in tables:
                lines.append(f"[[{name}]]" if name in LISTS or len(tables) > 1 else f"[{name}]")
                lines += [f"{key} = {value_text(value)}" for key, value in table.items()]
        return "\n".join(lines) + "\n"


class Trial:
    """The runs of one scene in one folder."""

    def __init__(self, program, folder, seed, table):
        self.program, self.folder, self.seed = program, folder, seed
        self.resumed = self.inert = False
        scene = Drawn(seed, table)
        self.features = scene.features
        self.refused = [(scene.words(name), scene.words(other)) for name, other in scene.refused()]
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
        found = [f"the table refuses {self.refused}"] if self.refused else []
        found += self.faults_of_results(whole.returncode)
        other = self.run(2, "scene.toml", "--out", "two")
        found += [f"two threads: {what}" for what in self.differences("two", whole.returncode, other)]
        return found + self.faults_of_resumption(whole.returncode, seconds), whole.returncode

    def faults_of_refusal(self, outcome):
        lines = outcome.stderr.strip().splitlines()
        found = [] if len(lines) == 1 else [f"a refusal of {len(lines)} lines: {outcome.stderr[:300]}"]
        if not any(all(any(word in outcome.stderr for word in words) for words in pair) for pair in self.refused):
            found.append(f"refused, and not for any of {self.refused}: {outcome.stderr[:300]}")
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
        self.inert = summary["exit_reason"] == "end" and not self.features <= self.acted
        return found

    def acting(self, summary, last):
        """The features that have left a trace in the results."""
        # A short run may have a row of its start alone.
        begins = last["step"] == "0"
        # What steps beyond the critical one dissipate may be negative.
        damped, worked = float(last["dissipated_J"] or 0) != 0 or begins, float(last["external_work_J"] or 0) != 0 or begins
        forces, erosion, files = summary["discrete_forces"] or {}, summary["erosion"] or {}, summary["files"]
        touched = forces.get("most_touching") or begins
        traces = {"handlers": summary["handler"], "loads and motions that change in time": worked, "pressures": worked, "springs and contact": forces,
                  "surfaces in contact": touched, "moving obstacles": touched, "dashpots and friction": damped, "elements that damp": damped,
                  "proofs with Rayleigh damping": damped, "cuts": summary["cuts"], "elements that erode": erosion.get("elements"),
                  "certificates along a run": any(name.startswith("certificates") for name in files), "runs that go back": summary["repeats"] is not None,
                  "probes": "probes.csv" in files, "reactions": "probes.csv" in files, "metrics": last["metric_step_s"]}
        traces |= {name: True for name in FEATURES if name not in traces}  # it leaves no trace of its own
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
    parser.add_argument("--seconds", type=float, default=math.inf, help="begin no scene after so long")
    parser.add_argument("--keep", type=pathlib.Path, help="folder for scenes that fail")
    options = parser.parse_args()
    schema = subprocess.run([options.program, "schema", "scene"], stdout=subprocess.PIPE, text=True, check=True).stdout
    table = json.loads(schema)["x-capabilities"]
    end = time.monotonic() + options.seconds
    statuses, resumed, inert, failed = collections.Counter(), 0, 0, 0
    acted = collections.Counter()
    for seed in range(options.seed, options.seed + options.scenes):
        if time.monotonic() > end:
            break
        with tempfile.TemporaryDirectory() as folder:
            trial = Trial(options.program, pathlib.Path(folder), seed, table)
            try:
                faults, status = trial.faults()
            except subprocess.TimeoutExpired:
                faults, status = [f"a run took more than {SECONDS} s"], None
            statuses[status] += 1
            resumed += trial.resumed
            inert += trial.inert
            acted.update(trial.acted)
            acted.update(" and ".join(pair) for pair in PAIRS if set(pair) <= trial.acted)
            for fault in faults:
                print(f"scene of seed {seed}: {fault}", flush=True)
            if faults:
                failed += 1
                if options.keep:
                    shutil.copytree(folder, options.keep / str(seed), dirs_exist_ok=True)
    scenes = statuses.total()
    print(f"{scenes} scenes: " + ", ".join(f"{count} with exit status {status}" for status, count in sorted(statuses.items(), key=str)) +
          f"; {resumed} resumed; {inert} in which something drawn did not act; {failed} failed; acted: " + ", ".join(f"{name} {acted[name]}" for name in FEATURES))
    missing = [name for name in FEATURES if not acted[name]] if scenes >= len(PAIRS) else []
    # Scenes that are all refused, or in which what was drawn does nothing, would show nothing.
    if failed or missing or statuses[0] < scenes / 4 or inert > scenes / 100:
        sys.exit(1)


if __name__ == "__main__":
    main()
