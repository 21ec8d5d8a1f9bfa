"""The data package of `ringwatch verify --out`: tables, types and units are those of the JSON report, certificates are proven,
and `rw.load_study` gives arrays of the same numbers."""
import csv
import json
import math
import pathlib
from typing import Any

import numpy as np
import pytest

import ringwatch as rw
from support import BUILD, PROGRAM, call

STUDIES = ("atlas", "histories")
# Of the SI with its usual prefixes, %, degrees, and costs of an element.
UNITS = {"1", "%", "s", "us", "ms", "Hz", "rad/s", "J", "mm", "°", "ns an element", "% of displacement"}
MISSING = ("", "-")


@pytest.fixture(scope="module", name="made")
def _made(tmp_path_factory: pytest.TempPathFactory) -> Any:
    """Folder, data package and JSON report of two studies."""
    folder = tmp_path_factory.mktemp("studies")
    call(PROGRAM, "verify", *STUDIES, "--quick", "--out", folder / "out", "--json", folder / "report.json")
    return (folder / "out", json.loads((folder / "out/datapackage.json").read_text(encoding="utf-8")),
            json.loads((folder / "report.json").read_text(encoding="utf-8"))["studies"])


def tables(report: Any) -> dict[str, Any]:
    """The rows of all tables of the JSON report, by the name of the resource."""
    return {f"{study}.{name}": rows for study, found in report.items() for name, rows in found["tables"].items()}


def rows_of(folder: pathlib.Path, resource: Any) -> list[dict[str, str]]:
    with (folder / resource["path"]).open(encoding="utf-8", newline="") as opened:
        return list(csv.DictReader(opened))


def number(value: Any) -> float:
    """Of JSON, where nan and inf are texts."""
    return float(value)


def test_the_package_says_what_it_is(made: Any) -> None:
    _, package, _ = made
    assert package["name"] == "ringwatch-verify" and all(study in package["title"] for study in STUDIES)
    assert package["version"] == rw.__version__ and rw.__version__ in package["description"]
    assert package["licenses"][0]["name"] == "BSD-3-Clause" and "verify atlas histories" in package["description"]


def test_every_table_is_there_cell_by_cell(made: Any) -> None:
    folder, package, report = made
    expected = tables(report)
    resources = {r["name"]: r for r in package["resources"]}
    assert set(resources) == set(expected) | {f"{study}.checks" for study in STUDIES}
    for name, rows in expected.items():
        fields = {f["name"]: f["type"] for f in resources[name]["schema"]["fields"]}
        found = rows_of(folder, resources[name])
        assert len(found) == len(rows) > 0 and list(fields) == list(rows[0])
        for one, other in zip(found, rows):
            for column, value in other.items():
                if fields[column] == "string" or one[column] in MISSING:
                    assert one[column] == str(value)
                else:
                    assert float(one[column]) == number(value) or math.isnan(number(value))


def test_types_are_those_of_the_cells(made: Any) -> None:
    _, package, report = made
    expected, seen = tables(report), set()
    for resource in package["resources"]:
        for field in resource["schema"]["fields"]:
            values = [row[field["name"]] for row in expected.get(resource["name"], [])]
            kinds = {type(v) for v in values if v not in MISSING and v not in ("nan", "inf", "-inf")}
            if kinds:
                assert field["type"] == ("string" if str in kinds else "number" if float in kinds else "integer")
            seen.add(field["type"])
    assert seen == {"string", "number", "integer"}


def test_units_and_descriptions(made: Any) -> None:
    _, package, _ = made
    for resource in package["resources"]:
        assert resource["title"]
        for field in resource["schema"]["fields"]:
            assert field["description"]
            if field["type"] == "string":
                assert "unit" not in field
                continue
            assert field["unit"] in UNITS, (resource["name"], field)
            assert field["unit"] == "1" or field["name"].endswith(f" ({field['unit']})")


def test_checks_are_those_of_the_report(made: Any) -> None:
    folder, package, report = made
    for study in STUDIES:
        (resource,) = [r for r in package["resources"] if r["name"] == f"{study}.checks"]
        rows, checks = rows_of(folder, resource), report[study]["checks"]
        assert [r["check"] for r in rows] == [c["name"] for c in checks]
        assert [r["passed"] for r in rows] == [str(int(c["passed"])) for c in checks]


def test_every_certificate_is_proven_of_its_body(made: Any) -> None:
    folder, _, report = made
    bodies = {run["run"]: run["body"] for run in report["histories"]["tables"]["runs"]}
    points = report["histories"]["tables"]["points"]
    assert len(points) >= 3 * len(bodies) >= 9
    assert len({point["certificate"] for point in points}) == len(points) == len(list(folder.rglob("*.certificate")))
    for point in points:
        said = call(BUILD / "bin/ringwatch-check", "--expect", bodies[point["run"]], folder / point["certificate"]).stdout
        # The step that the checker prints is rounded down to ten digits.
        assert f"{point['certified (s)']:.6g}" in said or any(
            abs(float(word) - point["certified (s)"]) <= 1e-8 * point["certified (s)"]
            for word in said.split() if word.replace(".", "").replace("e-", "").isdigit())


def test_arrays(made: Any) -> None:
    folder, _, report = made
    data, points = rw.load_study(folder), report["histories"]["tables"]["points"]
    assert set(data) == set(tables(report)) | {f"{study}.checks" for study in STUDIES}
    found = data["histories.points"]
    assert found["exact (s)"].dtype == np.float64 and found["step"].dtype == np.int64
    for column, values in found.items():
        assert values.shape == (len(points),)
        assert values.tolist() == [point[column] for point in points]
    assert (found["safe (s)"] <= found["exact (s)"] * (1 + 1e-9)).all()


def test_what_cannot_be_read_is_told_in_a_line(made: Any, tmp_path: pathlib.Path) -> None:
    folder, package, _ = made
    with pytest.raises(rw.InputError, match=r"datapackage\.json.*give the folder of ringwatch verify --out"):
        rw.load_study(tmp_path)
    (resource,) = [r for r in package["resources"] if r["name"] == "histories.runs"]
    text = (folder / resource["path"]).read_text(encoding="utf-8")
    (tmp_path / "datapackage.json").write_text(json.dumps({"resources": [resource]}), encoding="utf-8")
    for damaged, said in (("", ":1: the columns are"), (text.replace("h (s)", "h"), ":1: the columns are"),
                          (text.splitlines()[0] + "\na\n", "must be of type")):
        (tmp_path / resource["path"]).write_text(damaged, encoding="utf-8")
        with pytest.raises(rw.InputError, match=said):
            rw.load_study(tmp_path)
    (tmp_path / "datapackage.json").write_text("{}", encoding="utf-8")
    with pytest.raises(rw.InputError, match="must be a data package"):
        rw.load_study(tmp_path)
