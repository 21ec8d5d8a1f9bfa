"""What the program does when the system refuses it one call, an allocation, an open, a write, a thread, …, or a signal comes before one.

  failing_calls_test.py PROGRAM LIBRARY [--most N] [--cases NAME …] [--calls KIND …]

Of every case below the n-th call of each kind fails, for all n or N of them evenly apart; the disk is full, or read-only. The program then ends with the exit
status of the case without a fault, or with 1 or 2 and one line, a run with 4 at a signal; every file is the former one, the whole new one
or whole as far as it goes, and nothing else is left, but parts of files where a signal ended the program; a run that was ended and has a
checkpoint goes on to the bytes of the one that was not.
"""
import argparse
import concurrent.futures
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

SCENE = """
[mesh]
file = "bar.msh"
[material]
model = "stvk"
young = 30e3
poisson = 0.3
density = 1000
[integrator]
method = "symplectic-euler"
step = 1e-3
end = 0.02
[monitor]
certificates = 10
[[fix]]
where = "x < 1e-6"
[[move]]
where = "x > 0.2 - 1e-6"
velocity = [1, 0, 0]
[[probe]]
name = "all"
what = "displacement"
where = "all"
[output]
every = 0.01
checkpoint_every = 0.005
picture = false
"""
DECK = """*NODE
1, 0, 0, 0
2, 1, 0, 0
3, 0, 1, 0
4, 0, 0, 1
*ELEMENT, TYPE=C3D4, ELSET=E
1, 1, 2, 3, 4
"""
FLEX = """<mujoco><worldbody><flexcomp name="soft" type="grid" dim="3" count="3 2 2" spacing=".1 .1 .1" mass="1" radius="0">
<elasticity young="5e4" poisson="0.2"/></flexcomp></worldbody></mujoco>
"""
MATERIAL = ["--young", "30e3", "--poisson", "0.3", "--density", "1000"]
BAR = ["mesh", "generate", "bar", "--size", "0.2", "0.04", "0.04", "--cells", "5", "1", "1"]
# What is in the folder before each case: the commands that make it.
BEFORE = [[*BAR, "-o", "bar.msh"], ["run", "scene.toml", "--out", "done"], ["run", "scene.toml", "--out", "old", "--set", "integrator.end=0.01"]]
CASES = {
    "run": ["run", "scene.toml", "--out", "old"],
    "resume": ["run", "--resume", "part"],
    "live": ["run", "scene.toml", "--out", "old", "--report"],
    "inspect": ["inspect", "bar.msh", *MATERIAL, "--global", "--json", "old.json", "--vtu", "old.vtu", "--certificate", "old.certificate"],
    "exact": ["inspect", "bar.msh", *MATERIAL, "--exact", "--certificate", "old.certificate", "--report", "old.html"],
    "deck": ["inspect", "deck.inp", *MATERIAL],
    "generate": [*BAR, "-o", "old.msh"],
    "convert": ["mesh", "convert", "bar.msh", "old.vtu"],
    "check": ["mesh", "check", "bar.msh"],
    "compare": ["compare", "scene.toml", "--integrators", "verlet", "--step", "1e-3,5e-4", "--json", "old.json", "--report", "old.html"],
    "report": ["report", "done"],
    "audit": ["audit", "done/run.pvd", "--scene", "scene.toml", "--json", "old.json", "--junit", "old.xml", "--report", "old.html"],
    "suggest": ["suggest", "scene.toml", "--frame", "1/60", "--json", "old.json"],
    "scale-mass": ["scale-mass", "scene.toml", "--step", "8e-3", "--json", "old.json"],
    "repair": ["mesh", "repair", "bar.msh", "old.msh"],
    "advise": ["advise", "scene.toml", "--step", "8e-3", "--run-steps", "10", "--json", "old.json"],
    "mujoco": ["inspect", "soft.xml", "--json", "old.json"],
    "judge": ["judge", "bar.msh", "--metric", "single-element", "--json", "old.json", "--junit", "old.xml", "--report", "old.html"],
    "init": ["init", "new.toml", "--mesh", "bar.msh", *MATERIAL],
    "examples": ["examples", "stretch_bar"],
    "schema": ["schema", "scene"],
}
CALLS = ["allocation", "memory", "open", "write", "short", "fsync", "rename", "read", "mmap", "thread", "signal"]
# Folders on a disk of their own: with so many pages left, or read-only. `unshare` and a mount take root.
DISKS = ["full", "read-only"]
ON_DISK = ["unshare", "--mount", "sh", "-c", """
disk=$1 size=$2 option=$3 folder=$PWD; shift 3
mount -t tmpfs -o size="${size}k" tmpfs "$disk" && cp -r . "$disk" && mount -o "remount,$option" "$disk" || exit 99
(cd "$disk" && exec "$@"); status=$?
find . -mindepth 1 -delete; cp -r "$disk/." .; exit $status""", "sh"]
PAGE = 4096
INTERRUPTED = 4  # the exit status
# Alike to the byte in every run; others tell of times.
SAME_BYTES = {".csv", ".vtu", ".pvd", ".msh", ".certificate"}
SECONDS = 120


class Trials:
    def __init__(self, program, library, folder):
        self.program, self.library, self.folder = program, library, folder
        self.template = folder / "template"
        self.template.mkdir()
        (self.template / "scene.toml").write_text(SCENE)
        (self.template / "deck.inp").write_text(DECK)
        (self.template / "soft.xml").write_text(FLEX)
        for command in BEFORE:
            self.succeeds(command)
        for command in (CASES["inspect"], ["report", "done", "--out", "old.html"]):
            self.succeeds(command)
        shutil.copy(self.template / "bar.msh", self.template / "old.msh")
        # A run that ends early and has a checkpoint: its last frame cannot be renamed.
        stop = ["run", "scene.toml", "--out", "part"]
        count = self.run(self.template, stop, "rename", None)[1]
        shutil.rmtree(self.template / "part")
        ended, _ = self.run(self.template, stop, "rename", count - 3)
        assert ended.returncode == 1 and (self.template / "part/checkpoint.bin").exists(), ended.stderr

    def succeeds(self, command):
        made, _ = self.run(self.template, command, None, None)
        assert made.returncode == 0, f"{command}: {made.stderr}"

    def run(self, folder, command, kind, at):
        """How the command ended, and how many calls of the kind it made, None where it did not come to count them."""
        count = folder / "count"
        settings = {} if kind not in CALLS else {"LD_PRELOAD": self.library, "FAIL_CALL": kind, "FAIL_COUNT": str(count)}
        if at is not None:
            settings["FAIL_AT"] = str(at)
        line = [self.program, *command]
        if kind in DISKS:
            disk = self.folder / f"disk-{folder.parent.name}"
            disk.mkdir()
            size = (pages(contents(folder)) + (at or 0)) * PAGE // 1024 if kind == "full" else 10 * 1024
            line = [*ON_DISK, disk, str(size), "rw" if kind == "full" else "ro", *line]
        ended = subprocess.run(line, cwd=folder, capture_output=True, text=True, timeout=SECONDS, check=False,
                               env={**os.environ, "OMP_NUM_THREADS": "2" if kind == "thread" else "1", "OMP_WAIT_POLICY": "passive", **settings})
        calls = int(count.read_text()) if count.exists() else None
        count.unlink(missing_ok=True)
        return ended, calls

    def trial(self, name, kind, at, whole):
        """What is wrong, a line each."""
        with tempfile.TemporaryDirectory(dir=self.folder) as place:
            folder = pathlib.Path(place) / "case"
            shutil.copytree(self.template, folder)
            try:
                ended, _ = self.run(folder, CASES[name], kind, at)
            except subprocess.TimeoutExpired:
                return ["it hangs"]
            faults = self.faults_of_ending(name, kind, ended, whole["ended"])
            faults += self.faults_of_files(name, ended, contents(folder), whole)
            if kind in CALLS:  # a checkpoint names its mesh, which was on the disk
                faults += self.faults_of_resumption(name, folder, whole)
            return [f"{fault} (status {ended.returncode}: {ended.stderr.strip()[-300:]})" for fault in faults]

    @staticmethod
    def faults_of_ending(name, kind, ended, whole):
        if kind == "signal" and (ended.returncode == -signal.SIGTERM or (ended.returncode == INTERRUPTED and CASES[name][0] == "run")):
            return []
        if ended.returncode == whole.returncode and ended.stderr == whole.stderr:
            lines, wanted = ended.stdout.splitlines(), whole.stdout.splitlines()
            return [] if len(lines) == len(wanted) or any(line.startswith("note: ") for line in lines) else [f"{len(lines)} lines, not {len(wanted)}, on standard output"]
        if ended.returncode not in (1, 2, whole.returncode):
            return ["no status of an error"]
        lines = ended.stderr.splitlines()
        if len(lines) == 2 and lines[0].startswith("ringwatch: --report: "):
            lines = lines[1:]  # a page that cannot be written has a line of its own
        return [] if len(lines) == 1 and lines[0].startswith("ringwatch: ") else [f"{len(lines)} lines on standard error"]

    def faults_of_files(self, name, ended, files, whole):
        former, new, faults = whole["former"], whole["files"], []
        done = ended.returncode == whole["ended"].returncode and not ended.stderr
        runs = CASES[name][0] == "run"
        refused = runs and ended.returncode == 2  # before it began
        for path in sorted(former.keys() | new.keys() | files.keys()):
            content = files.get(path)
            if content is None:
                if done and path in new:
                    faults.append(f"{path} is missing")
                elif path in former and (not runs or refused):
                    faults.append(f"the former {path} is gone")
            elif ended.returncode < 0 and (".part-" in path.name or path.name == "run.lock"):
                continue  # the next run takes them away
            elif path not in former and path not in new and path.name != "checkpoint.bin":
                faults.append(f"{path} is left behind")
            elif content not in (former.get(path), new.get(path)) or (done and content != new.get(path) and path.suffix in SAME_BYTES):
                if done and path.suffix in SAME_BYTES:
                    faults.append(f"{path} differs")
                elif not readable(path, content, new.get(path, b"")):
                    faults.append(f"{path} is half written")
                elif refused:
                    faults.append(f"{path} has changed although nothing began")
        if runs and ended.returncode in (1, INTERRUPTED) and "summary.json" not in ended.stderr:
            summary = files.get(pathlib.Path(CASES[name][-1] if name == "resume" else "old") / "summary.json")
            if summary is None or json.loads(summary)["exit_status"] != ended.returncode:
                faults.append("the summary does not tell of the end")
        return faults

    def faults_of_resumption(self, name, folder, whole):
        out = "part" if name == "resume" else "old"
        if CASES[name][0] != "run" or not (folder / out / "checkpoint.bin").exists():
            return []
        ended, _ = self.run(folder, ["run", "--resume", out], None, None)
        if ended.returncode != 0:
            return [f"it does not go on: {ended.stderr}"]
        files = contents(folder / out)
        return [f"resumed: {path} differs" for path, content in files.items()
                if path.suffix in SAME_BYTES and content != whole["files"][out / path]]

    def whole(self, name, kind):
        """The case without a fault, and how many calls of the kind it makes."""
        with tempfile.TemporaryDirectory(dir=self.folder) as place:
            folder = pathlib.Path(place) / "case"
            shutil.copytree(self.template, folder)
            ended, calls = self.run(folder, CASES[name], kind if kind in CALLS else None, None)
            if kind == "full":  # as many pages as what is new takes, where nothing old is given back
                former = contents(self.template)
                calls = pages({path: content for path, content in contents(folder).items() if former.get(path) != content})
            elif kind == "read-only":
                calls = 1
            assert ended.returncode in (0, 3) and calls is not None, f"{name}, {kind}: {ended.returncode}, {ended.stderr}"
            return {"ended": ended, "former": contents(self.template), "files": contents(folder)}, calls


def pages(files):
    return sum(-(-len(content) // PAGE) for content in files.values())


def contents(folder):
    return {path.relative_to(folder): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def readable(path, content, whole):
    """Whether a file of a run that was ended is whole as far as it goes."""
    try:
        if path.suffix == ".json":
            return bool(json.loads(content))
        if path.suffix in (".pvd", ".xml"):
            return xml.etree.ElementTree.fromstring(content) is not None
    except ValueError:
        return False
    if path.suffix == ".csv":
        return whole.startswith(content) and (not content or content.endswith(b"\n"))
    if path.suffix == ".vtu":
        return content.rstrip().endswith(b"</VTKFile>")
    return path.suffix == ".html" and content.rstrip().endswith(b"</html>") or path.name == "checkpoint.bin"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program", type=lambda file: str(pathlib.Path(file).resolve()))
    parser.add_argument("library", type=lambda file: str(pathlib.Path(file).resolve()))
    parser.add_argument("--most", type=int, help="trials of a case and a kind of call, at most (all)")
    parser.add_argument("--cases", nargs="+", choices=CASES, default=list(CASES))
    parser.add_argument("--calls", nargs="+", choices=CALLS + DISKS)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        mounts = subprocess.run([*ON_DISK, name, "4", "rw", "true"], cwd=name, stderr=subprocess.DEVNULL, check=False).returncode == 0
    options.calls = options.calls or CALLS + (DISKS if mounts else [])
    tried = dict.fromkeys(options.calls, 0)
    failed = 0
    with tempfile.TemporaryDirectory() as name, concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        trials = Trials(options.program, options.library, pathlib.Path(name))
        for case in options.cases:
            for kind in options.calls:
                whole, count = trials.whole(case, kind)
                most = min(count, options.most or count)
                chosen = [count * (2 * k + 1) // (2 * most) for k in range(most)]
                tried[kind] += most
                for at, faults in zip(chosen, pool.map(lambda at: trials.trial(case, kind, at, whole), chosen)):  # noqa: B023
                    for fault in faults:
                        print(f"{case}: {kind} {at} of {count}: {fault}", flush=True)
                    failed += bool(faults)
    print(f"calls that failed: {tried}; {failed} of them badly")
    assert all(tried.values()), "a kind of call that no case makes shows nothing"
    sys.exit(failed > 0)


if __name__ == "__main__":
    main()
