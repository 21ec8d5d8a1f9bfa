"""What `ringwatch verify --out` wrote, as arrays."""
from __future__ import annotations

import csv
import json
import os
import pathlib
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._errors import InputError

_TYPES: dict[str, Any] = {"number": np.float64, "integer": np.int64, "string": np.str_}


def load_study(folder: str | os.PathLike[str]) -> dict[str, dict[str, NDArray[Any]]]:
    """Reads the tables of a data package that `ringwatch verify STUDY --out DIR` wrote.

    folder: where datapackage.json lies, DIR. Returns tables by name, "STUDY.TABLE", and in each the columns by name, unit
    included, all of shape (rows,): float64 (NaN where a field is empty), int64 or texts, as datapackage.json says. Raises
    InputError where a file is missing or does not hold what datapackage.json says of it.
    """
    package = pathlib.Path(folder) / "datapackage.json"
    try:
        resources = json.loads(package.read_text(encoding="utf-8"))["resources"]
        return {r["name"]: _table(package.parent / r["path"], r["schema"]) for r in resources}
    except OSError as error:
        raise InputError(f"{error.filename}: {error.strerror}; give the folder of ringwatch verify --out") from None
    except (KeyError, TypeError, json.JSONDecodeError) as error:
        raise InputError(f"{package}: {error!r}; must be a data package of ringwatch verify --out") from None


def _table(file: pathlib.Path, schema: dict[str, Any]) -> dict[str, NDArray[Any]]:
    fields, missing = schema["fields"], schema["missingValues"]
    names = [field["name"] for field in fields]
    with file.open(encoding="utf-8", newline="") as opened:
        header, *rows = list(csv.reader(opened)) or [[]]
    if header != names:
        raise InputError(f"{file}:1: the columns are {header}; datapackage.json has {names}")
    columns = {}
    for at, field in enumerate(fields):
        kind = _TYPES[field["type"]]
        empty = "nan" if kind is np.float64 else ""
        try:
            texts = [empty if kind is not np.str_ and row[at] in missing else row[at] for row in rows]
            columns[field["name"]] = np.array(texts, dtype=np.str_).astype(kind)
        except (IndexError, ValueError) as error:
            raise InputError(f"{file}: {field['name']}: {error}; must be of type {field['type']}") from None
    return columns
