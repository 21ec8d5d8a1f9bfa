"""Every example in SI and, its numbers multiplied, in other systems of units, through the command line.

  units_test.py PROGRAM EXAMPLES

The units of keys are those of the schema. One of SI is 1024 mm here and not 1000, and so on: numbers times a power of two are not rounded, so that all of a
history and all counts must be the same to the last bit: a number of the program's own that has a unit would show. Labels must name the system's units.
"""
import csv
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import tomllib

CUBE_ROOTS = 1e-12  # of the largest number, thousands of times its rounding: glibc's cbrt rounds otherwise where an exponent changes its sign
BASES = {"m": (1, 0, 0), "kg": (0, 1, 0), "s": (0, 0, 1), "N": (1, 1, -2), "Pa": (-1, 1, -2), "J": (2, 1, -2)}  # of length, mass and time
# What one of SI is in the system, of length, mass and time, by the nearest power of two, and what labels call s and J.
SYSTEMS = {"mm-t-s": ((2**10, 2**-10, 1), "_s", "_mJ"), "mm-kg-ms": ((2**10, 1, 2**10), "_ms", "_J"),
           "cm-g-us": ((2**7, 2**10, 2**20), "_us", "_Mbar cm3"), "none": ((1, 1, 1), "", "")}


def factor(unit, sizes):
    value = 1.0
    for sign, base, power in re.findall(r"(^|[ /])(kg|Pa|[msNJ])([23]?)(?![a-z])", unit):
        for exponent, size in zip(BASES[base], sizes):
            value *= size ** (exponent * int(power or 1) * (-1 if sign == "/" else 1))
    return value


def multiplied(value, by):
    if isinstance(value, list):
        return [multiplied(item, by) for item in value]
    return value * by if isinstance(value, (int, float)) and not isinstance(value, bool) and by != 1 else value


def in_units(scene, schema, name):
    """The scene with its numbers multiplied."""
    sizes = SYSTEMS[name][0]
    result = {}
    for section, content in scene.items():
        form = schema["properties"][section]
        forms = [one.get("items", one) for one in form.get("anyOf", [form])]
        keys = {key: rule for one in forms for key, rule in one["properties"].items()}

        def table(entries):
            new = {}
            for key, value in entries.items():
                unit = re.search(r"; in ([^;]+)$", keys[key].get("description", ""))
                new[key] = multiplied(value, factor(unit[1], sizes) if unit else 1)
                if key == "where":
                    new[key] = re.sub(r"\b([xyz])\b", rf"(\1/{sizes[0]})", value)
            return new
        result[section] = [table(entries) for entries in content] if isinstance(content, list) else table(content)
    return {"units": {"system": name}, **result}


def toml(scene):
    lines = []
    for section, content in scene.items():
        for table in content if isinstance(content, list) else [content]:
            lines.append(f"[[{section}]]" if isinstance(content, list) else f"[{section}]")
            lines += [f"{key} = {json.dumps(value)}" for key, value in table.items()]
    return "\n".join(lines) + "\n"


def main(program, examples):
    folder = pathlib.Path(tempfile.mkdtemp())
    schema = json.loads(subprocess.run([program, "schema", "scene"], check=True, capture_output=True, text=True).stdout)

    def run(scene, name):
        (folder / f"{name}.toml").write_text(toml(scene))
        done = subprocess.run([program, "run", folder / f"{name}.toml", "--out", folder / name, "--threads", "1"], capture_output=True, text=True)
        assert done.returncode in (0, 1), done.stderr
        with (folder / name / "history.csv").open() as stream:
            head, *rows = csv.reader(stream)
        return json.loads((folder / name / "summary.json").read_text()), head, rows, done.stdout

    cases = [(path, "mm-t-s") for path in sorted(examples.glob("*.toml"))] + [(examples / "swinging_bar.toml", name) for name in SYSTEMS]
    compared = 0
    for example, name in cases:
        scene = tomllib.loads(example.read_text())
        scene.setdefault("output", {})["picture"] = False
        sizes, time, energy = SYSTEMS[name]
        si, head, rows, text = run(scene, "si")
        other, other_head, other_rows, other_text = run(in_units(scene, schema, name), "other")
        assert other_head == [re.sub("_J$", energy, re.sub("_s$", time, column)) for column in head], other_head
        first = re.search(r"to t = \S+( [a-z]+)?[,;]", other_text)
        assert (first[1] or "").strip() == time.strip("_"), other_text
        for count in ("steps", "certified_steps", "watched_steps", "exit_reason", "exit_status", "verdict"):
            assert si[count] == other[count], (example, name, count, si[count], other[count])
        assert len(rows) == len(other_rows)
        share = CUBE_ROOTS if "bulk_viscosity" in scene.get("damping", {}) else 0
        largest = {unit: max(abs(float(value or 0)) for row in rows for column, value in zip(head, row) if column.endswith(unit)) for unit in ("_s", "_J")}
        for number, (row, other_row) in enumerate(zip(rows, other_rows)):
            for column, value, other_value in zip(head, row, other_row):
                same = value == other_value
                if value and other_value and column[-2:] in largest:
                    same |= abs(float(other_value) / factor(column[-1], sizes) - float(value)) <= share * largest[column[-2:]]
                assert same, (example.name, name, number, column, value, other_value)
                compared += 1
    print(f"{compared} numbers of {len(cases)} runs are the same")


main(sys.argv[1], pathlib.Path(sys.argv[2]))
