"""CalculiX: its own test decks as scenes, its assembled matrices in our bracket, its results audited.

usage: calculix_test.py decks|rules|matrices|steps|forces|rubber|audit RINGWATCH DECKS_OF_OURS
"""

import collections
import gzip
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

what, ringwatch, here = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])
work = pathlib.Path(tempfile.mkdtemp(prefix="ringwatch-calculix-"))


def call(*arguments):
    return subprocess.run([ringwatch, *map(str, arguments)], cwd=work, capture_output=True, text=True)


def run_ccx(name):
    if shutil.which("ccx") is None:
        print("skipped: calculix-ccx is not installed (scripts/setup --foreign)")
        sys.exit(77)
    environment = {**os.environ, "OMP_NUM_THREADS": "1"}
    return subprocess.run(["ccx", name], cwd=work, capture_output=True, text=True, env=environment, timeout=300)


KINDS = {"C3D4": "tet4", "C3D6": "wedge6", "C3D8": "hex8", "C3D10": "tet10", "C3D20": "hex20", "C3D20R": "hex20"}


def mesh_lines(type_, points, cells):
    """*NODE and *ELEMENT of a mesh, and its material on all elements."""
    lines = ["*NODE, NSET=Nall"] + [f"{i + 1}, {x:.12g}, {y:.12g}, {z:.12g}" for i, (x, y, z) in enumerate(points)]
    lines.append(f"*ELEMENT, TYPE={type_}, ELSET=Eall")
    for e, cell in enumerate(cells):
        words = [str(e + 1)] + [str(n + 1) for n in cell]
        lines += [", ".join(words[i : i + 16]) + ("," if i + 16 < len(words) else "") for i in range(0, len(words), 16)]
    return lines + ["*MATERIAL, NAME=m", "*ELASTIC", "1e6, 0.3", "*DENSITY", "1000.", "*SOLID SECTION, ELSET=Eall, MATERIAL=m"]


def solid_decks():
    """Writes CalculiX's own test decks and what they include; the texts of those with solid elements, by name."""
    folder = pathlib.Path("/usr/share/doc/calculix-ccx-test/examples/test")
    files = sorted(folder.glob("*.inp")) + sorted(folder.glob("*.inp.gz")) if folder.exists() else []
    if not files:
        print("skipped: calculix-ccx-test is not installed (scripts/setup --foreign)")
        sys.exit(77)
    texts = {}
    for file in files:
        name = file.name.removesuffix(".gz")
        data = gzip.open(file).read() if file.suffix == ".gz" else file.read_bytes()
        (work / name).write_bytes(data)
        texts[name] = data.decode("latin-1")
    solid = {}
    for name, text in sorted(texts.items()):
        types = set(re.findall(r"^\*ELEMENT[^\n]*?TYPE\s*=\s*([A-Za-z0-9]+)", text, re.M | re.I))
        if any(kind.upper().startswith("C3D") for kind in types):
            solid[name] = text
    return solid


def decks():
    count, reasons = collections.Counter(), collections.Counter()
    for name, text in solid_decks().items():
        result = call("inspect", name, "--metric", "pressure-wave", "--density", "1") if "*DENSITY" not in text.upper() else call(
            "inspect", name, "--metric", "pressure-wave", "--json", "-"
        )
        count["solid"] += 1
        if result.returncode == 0:
            count["understood"] += 1
            if "*DENSITY" in text.upper():
                check_counts(name, text, json.loads(result.stdout))
                count["counted"] += 1
        else:
            assert result.returncode == 2, (name, result)
            line = result.stderr.strip()
            assert "\n" not in line and re.search(rf"{re.escape(name)}(:\d+)?: ", line), (name, line)
            reasons[reason_of(line)] += 1
            count["refused"] += 1
        ran = call("run", name, "--out", "out", "--set", "integrator.end=1e-300", "--quiet")
        assert ran.returncode in (0, 1, 2, 3), (name, ran)
        count["run" if ran.returncode != 2 else "not run"] += 1
    print(dict(count))
    for reason, times in reasons.most_common():
        print(f"{times:4d}  {reason}")
    assert count["solid"] == count["understood"] + count["refused"]
    assert count["counted"] >= 40
    # The figures of the document are these.
    text = (here / "../../docs/decks.md").read_text()
    written = re.search(r"Of the (\d+) of .*? understands (\d+) and refuses (\d+) by line; (\d+) have", text)
    assert written, "docs/decks.md has no figures"
    found = (count["solid"], count["understood"], count["refused"], count["run"])
    assert tuple(map(int, written.groups())) == found, (written.groups(), found)


RULES = {
    "shortest edge": "pressure-wave:shortest-edge",
    "diameter": "pressure-wave:cell-diameter",
    "CalculiX": "pressure-wave:calculix",
    "dilatational": "dilatational-mode",
    "V / max A": "pressure-wave:volume-over-area",
    "least height": "pressure-wave",
    "nodal": "pressure-wave:nodal",
}


def rules():
    """Step rules of other solvers over the exact step, on those of CalculiX's decks that give a density."""
    shares = {rule: [] for rule in RULES}
    metrics = [word for metric in RULES.values() for word in ("--metric", metric)]
    for name, text in solid_decks().items():
        if "*DENSITY" not in text.upper():
            continue
        result = call("inspect", name, "--json", "-", "--global", *metrics)
        if result.returncode != 0:
            continue
        step = json.loads(result.stdout)["critical_step"]
        exact = step["global"]
        if exact is None or not exact > 0:
            continue
        assert step["safe"] <= exact * (1 + 1e-9), (name, step)
        for rule, metric in RULES.items():
            shares[rule].append((step["metrics"][metric] / exact, name))
    number = len(shares["nodal"])
    print(f"{number} decks; step of each rule over the exact one")
    text, figures = (here / "../../docs/foreign_solvers.md").read_text(), []
    for rule, found in shares.items():
        found.sort()
        unsafe = sum(share > 1 + 1e-9 for share, _ in found)
        row = f"| {unsafe} | {found[0][0]:.3f} | {found[number // 2][0]:.3f} | {found[-1][0]:.3f} | `{found[-1][1]}` |"
        print(rule, row)
        figures.append((rule, row))
    assert f"of the {number} decks" in text, number
    for rule, row in figures:  # rules of the same figures may share a row
        assert any(rule in line and row in line for line in text.splitlines()), (rule, row)


def reason_of(line):
    line = re.sub(r"^ringwatch: ", "", line)
    line = line.split("; and ")[0]
    return re.sub(r"^[^ ]*: ", "", line)[:90]


def check_counts(name, text, read):
    """Nodes and elements, counted here by another reading of the deck."""
    nodes, elements, keyword, left = set(), 0, "", 0
    for line in text.splitlines():
        line = line.strip()
        if line.startswith("**") or not line:
            continue
        if line.startswith("*"):
            keyword = line.upper().replace(" ", "")
            size = re.search(r"TYPE=[A-Z]*3D(\d+)", keyword)
            left = 0
            continue
        words = [word for word in line.split(",") if word.strip()]
        if re.match(r"\*NODE(,|$)", keyword):
            nodes.add(int(words[0]))
        elif keyword.startswith("*ELEMENT,") and size:
            if left == 0:
                elements += 1
                left = int(size[1]) + 1
            left -= len(words)
    assert read["mesh"]["nodes"] <= len(nodes), name
    assert sum(read["mesh"]["elements"].values()) == elements, (name, read["mesh"]["elements"], elements)


def bar(kind, jitter="0.15"):
    """A bar of one element type, distorted: nodes, elements."""
    result = call("mesh", "generate", "bar", "--size", "0.16,0.04,0.04", "--cells", "3,2,2", "--element", kind, "--jitter",
                  jitter, "-o", "bar.msh")
    assert result.returncode == 0, result.stderr
    import meshio

    mesh = meshio.read(work / "bar.msh")
    return mesh.points, mesh.cells[0].data


def matrices():
    """The stiffness that CalculiX assembles, with our lumped masses, lies in the bracket of inspect."""
    import numpy as np
    import support

    support.need("meshio")
    for type_, kind in KINDS.items():
        points, cells = bar(kind)
        lines = mesh_lines(type_, points, cells)
        held = [str(i + 1) for i in np.flatnonzero(points[:, 0] < 1e-9)]
        lines += ["*NSET, NSET=held"] + [", ".join(held[i : i + 16]) for i in range(0, len(held), 16)]
        lines += ["*BOUNDARY", "held, 1, 3", "*STEP", "*FREQUENCY, SOLVER=MATRIXSTORAGE", "1", "*END STEP"]
        (work / "m.inp").write_text("\n".join(lines) + "\n")
        result = run_ccx("m")
        assert (work / "m.sti").exists(), result.stdout[-500:]
        dofs = [line.split(".") for line in (work / "m.dof").read_text().split()]
        rows = np.loadtxt(work / "m.sti")
        K = np.zeros((len(dofs), len(dofs)))
        i, j = rows[:, 0].astype(int) - 1, rows[:, 1].astype(int) - 1
        K[i, j] = rows[:, 2]
        K[j, i] = rows[:, 2]
        read = call("inspect", "m.inp", "--json", "-", "--global", "--metric", "pressure-wave")
        assert read.returncode == 0, read.stderr
        step = json.loads(read.stdout)["critical_step"]
        # Their stiffness with the masses of our body, row sums: those that a bracket is about.
        import ringwatch as rw

        body = rw.Body(rw.load_mesh(str(work / "m.inp")), rw.Material("linear", young=1e6, poisson=0.3, density=1000))
        mass = np.array([body.lumped_mass[int(node) - 1] for node, _ in dofs])
        exact = support.exact_step(K, mass, np.arange(len(dofs)))
        print(f"{type_}: safe {step['safe']:.6e} exact {exact:.6e} ours {step['global']:.6e} optimistic {step['optimistic']:.6e}")
        assert step["safe"] <= exact * (1 + 1e-6) and exact * (1 - 1e-6) <= step["optimistic"], type_
        assert abs(step["global"] / exact - 1) < 3e-6, type_


def steps():
    """The step that CalculiX prints for *DYNAMIC, EXPLICIT is our metric of its name."""
    import support

    support.need("meshio")
    for type_, kind in KINDS.items():
        points, cells = bar(kind)
        lines = mesh_lines(type_, points, cells)
        deck = "\n".join(lines + ["*BOUNDARY", "1, 1, 3", "*STEP, NLGEOM, INC=1", "*DYNAMIC, EXPLICIT", "1e-3, 2e-3, 1e-12, 1e-3"])
        printed = []
        for alpha in ("", ", ALPHA=0."):
            (work / "s.inp").write_text(deck.replace("EXPLICIT", "EXPLICIT" + alpha) + "\n*END STEP\n")
            output = run_ccx("s").stdout
            printed.append(float(re.search(r"COURANT initial stable time increment:\s*(\S+)", output)[1]))
        read = call("inspect", "s.inp", "--json", "-", "--metric", "pressure-wave:calculix", "--global")
        assert read.returncode == 0, read.stderr
        found = json.loads(read.stdout)["critical_step"]
        ours, exact = found["metrics"]["pressure-wave:calculix"], found["global"]
        print(f"{type_}: CalculiX {printed[0]:.6e} s, our metric {ours:.6e} s, {printed[0] / exact:.3f} of the true step")
        assert abs(ours / printed[0] - 1) < 1e-6, type_
        # The factor of ALPHA = -0.05, its default.
        assert abs(printed[1] / printed[0] - 1.0223135) < 1e-6, (type_, printed)


def forces():
    """Nodal forces of *DLOAD: the forces of CalculiX's elements in a static solution, where nodes are free, are those that
    our run starts with."""
    import numpy as np
    import support

    meshio = support.need("meshio")
    import ringwatch as rw

    h = 1e-6
    for type_, faces in {"C3D4": "1234", "C3D6": "12345", "C3D8": "123456", "C3D10": "1234", "C3D20": "123456"}.items():
        # CalculiX integrates wedges' weight at two points and pressure on their quadrilaterals at one, which is exact for regular
        # ones.
        points, cells = bar(KINDS[type_], "0" if type_ == "C3D6" else "0.15")
        mesh = rw.load_mesh(str(work / "bar.msh"))
        body = rw.Body(mesh, rw.Material("stvk", young=1e6, poisson=0.3, density=1000))
        lines = mesh_lines(type_, points, cells)
        # Those faces of the elements that belong to one element: the deck names them one by one, with pressures of their own.
        tetrahedron, hexahedron = ["123", "142", "243", "341"], ["1234", "5876", "1562", "2673", "3784", "4851"]
        corners = {
            "C3D4": tetrahedron,
            "C3D6": ["123", "456", "1254", "2365", "3146"],
            "C3D8": hexahedron,
            "C3D10": tetrahedron,
            "C3D20": hexahedron,
        }[type_]
        owners = collections.Counter(frozenset(cell[int(c) - 1] for c in face) for cell in cells for face in corners)
        loads = []
        for e, cell in enumerate(cells):
            for number, face in zip(faces, corners):
                if owners[frozenset(cell[int(c) - 1] for c in face)] == 1 and (7 * e + int(number)) % 3:
                    loads.append(f"{e + 1}, P{number}, {50.0 * (e % 3 + 1)}")
        # Our gravity acts on lumped masses, which those of quadratic elements are not the row sums of.
        gravity = ["Eall, GRAV, 9.81, 0., 0.6, -0.8"] if type_ in ("C3D4", "C3D6", "C3D8") else []
        free = points[:, 0] > 1e-9
        held = [str(i + 1) for i in np.flatnonzero(~free)]
        static = lines + ["*NSET, NSET=held"] + held + ["*BOUNDARY", "held, 1, 3", "*STEP", "*STATIC", "*DLOAD"] + loads + gravity
        (work / "f.inp").write_text("\n".join(static + ["*NODE PRINT, NSET=Nall", "RF", "*END STEP"]) + "\n")
        run_ccx("f")
        rows = [line.split() for line in (work / "f.dat").read_text().splitlines()]
        theirs = np.zeros(points.shape)
        for row in rows:
            if len(row) == 4 and row[0].isdigit():
                theirs[int(row[0]) - 1] = [float(word) for word in row[1:]]
        dynamic = lines + ["*STEP, NLGEOM", "*DYNAMIC, EXPLICIT, DIRECT", f"{h}, {h}", "*DLOAD"] + loads + gravity
        (work / "g.inp").write_text("\n".join(dynamic + ["*END STEP"]) + "\n")
        ran = call("run", "g.inp", "--out", f"out_{type_}", "--set", f"output.every={h}", "--set", "output.picture=false")
        assert ran.returncode in (0, 3), ran.stderr
        last = sorted((work / f"out_{type_}" / "frames").glob("*.vtu"))[-1]
        # One step of symplectic Euler from rest: v = h f / m.
        data = meshio.read(last).point_data
        ours = np.empty(points.shape)
        ours[data["originalNodeId"].ravel() - 1] = data["velocity"]
        ours *= np.asarray(body.lumped_mass)[:, None] / h
        error = np.abs(ours - theirs)[free].max() / np.abs(theirs[free]).max()
        print(f"{type_}: {len(loads)} faces, largest force {np.abs(theirs).max():.6e} N, relative difference {error:.1e}")
        assert len(loads) > 12 and error < 2e-6, type_


def rubber():
    """What holds a corner of a brick of *HYPERELASTIC, all of whose nodes are moved by one gradient, is that of our run."""
    gradient = [[0.3, 0.1, 0], [0, -0.1, 0.05], [0, 0, 0.1]]
    corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
    moves = [f"{n + 1}, {c + 1}, {c + 1}, {sum(row[k] * X[k] for k in range(3)):.12g}"
             for n, X in enumerate(corners) for c, row in enumerate(gradient)]
    # CalculiX divides by D2 and D3: a large number stands for no such terms.
    for form, numbers, more in (("NEO HOOKE", "100., 0.02", ""), ("MOONEY-RIVLIN", "80., 20., 0.02", ""),
                                ("YEOH", "100., -1., 0.1, 0.02", ", 1e20, 1e20")):
        def deck(constants, procedure):
            lines = mesh_lines("C3D8", corners, [range(8)])
            lines[lines.index("*ELASTIC") : lines.index("*DENSITY")] = ["*HYPERELASTIC, " + form, constants]
            lines += ["*AMPLITUDE, NAME=a", "0., 0., 2., 2.", "*STEP, NLGEOM, INC=1000", *procedure, "*BOUNDARY, AMPLITUDE=a", *moves]
            return "\n".join(lines + ["*NODE PRINT, NSET=Nall", "RF", "*END STEP"]) + "\n"

        (work / "r.inp").write_text(deck(numbers + more, ["*STATIC", "0.05, 1."]))
        run_ccx("r")
        theirs = [float(word) for word in (work / "r.dat").read_text().splitlines()[-8].split()[1:]]
        (work / "o.inp").write_text(deck(numbers, ["*DYNAMIC, EXPLICIT, DIRECT", "0.01, 1.01"]))
        ran = call("run", "o.inp", "--out", "o", "--set", "output.picture=false", "--set", "output.reactions=true")
        assert ran.returncode == 0, ran
        columns, *rows = [line.split(",") for line in (work / "o/probes.csv").read_text().splitlines()]
        ours = [float(rows[-1][columns.index(f"fix.{i}.reaction_{c}_N")]) for i, c in enumerate("xyz")]
        print(f"{form}: {theirs} N, ours {ours} N")
        assert all(abs(a - b) < 1e-6 * abs(b) for a, b in zip(ours, theirs)), form  # of which they print seven digits


def audit():
    """A bar that CalculiX pulls with the step that it chose at the start: it ends in NaN with exit status 0."""
    shutil.copy(here / "pulled_bar.inp", work)
    result = run_ccx("pulled_bar")
    assert result.returncode == 0, result.stdout[-500:]
    results = (work / "pulled_bar.frd").read_text()
    assert "NAN" in results, "CalculiX no longer loses this run"
    audited = call("audit", "pulled_bar.frd", "--scene", "pulled_bar.inp", "--json", "-")
    assert audited.returncode == 1, audited.stderr
    found = json.loads(audited.stdout)
    text = call("audit", "pulled_bar.frd", "--scene", "pulled_bar.inp").stdout
    print("\n".join(text.splitlines()[:12] + text.splitlines()[-8:]))
    chosen = float(re.search(r"SELECTED time increment:\s*(\S+)", result.stdout)[1])
    history = found["history"]
    assert abs(history[0]["step"] / chosen - 1) < 1e-4, (history[0]["step"], chosen)
    first, lost = found["first"]["violated"]["state"], found["first"]["lost"]["state"]
    # What one sees in the results: the largest displacement leaves the bar.
    seen = next(s["state"] for s in history if s["strain_energy"] is None or s["strain_energy"] > 10)
    print(f"proven unstable from state {first}, seen at state {seen}, lost at state {lost} of {len(history)}")
    assert first + 2 <= seen <= lost


{"decks": decks, "rules": rules, "matrices": matrices, "steps": steps, "forces": forces, "rubber": rubber, "audit": audit}[what]()
shutil.rmtree(work)
