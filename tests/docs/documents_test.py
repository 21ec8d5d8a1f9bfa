#!/usr/bin/env python3
"""Holds README.md, CHANGELOG.md, all of docs/ and bench/, and the files that CONTRIBUTING.md names, to the program and to the repository.

usage: documents_test.py links|lists|words|guides|commands SOURCE_DIR PROGRAM [PAGE ...]    PAGE: only this one, of a check of single pages

links     every relative link, its heading included, and every file that is named in code leads somewhere
lists     commands, options, topics, scene keys and lists of names in the documents are those of `ringwatch help TOPIC`, and
          what stands in TOML is valid by the schema of scenes
words     documents, help texts, messages and docstrings of Python have none of the words that only a diary or a former name needs
guides    the pages of docs/ are short; they, all other documents and the paper tell neither days nor machines nor what was once otherwise
commands  every command in a fenced block runs, or is listed below with the reason why it does not, and a text block behind it is
          what it prints
"""
import ast
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import tomllib

sys.path.append("/usr/lib/python3/dist-packages")  # where Debian has jsonschema, whichever python3 comes first
import jsonschema  # noqa: E402

# A command that takes long or needs something, and what is run in its place: (shell command, exit status).
SUBSTITUTES = {
    # The scene is made to run unstable.
    "ringwatch run examples/stretch_bar.toml --out out/stretch_bar":
        ("ringwatch run examples/stretch_bar.toml --out out/stretch_bar", 1),
    "ringwatch run examples/stretch_bar.toml --out out/stretch_bar --live":
        ("ringwatch run examples/stretch_bar.toml --out out/stretch_bar --live", 1),
    "ringwatch audit out/stretch_bar/run.pvd --scene examples/stretch_bar.toml --report out/audit.html":
        ("ringwatch audit out/stretch_bar/run.pvd --scene examples/stretch_bar.toml --report out/audit.html", 1),
    "ringwatch run examples/rolling_ring.toml --out out/rolling_ring":
        ("ringwatch run examples/rolling_ring.toml --out out/rolling_ring --set integrator.end=0.01", 0),
    "ringwatch run start.toml --out start": ("ringwatch run start.toml --out start", 1),
    # The rule is unsafe.
    "ringwatch judge --metric pressure-wave --elements tet4 --shapes 5 --worst worst":
        ("ringwatch judge --metric pressure-wave --elements tet4 --shapes 5 --worst worst", 1),
    # As it stands: `timeout` says 124 when it had to stop the run, which the command behind it resumes.
    "timeout -s INT 1 ringwatch run pull.toml --out pull_stopped --set integrator.end=5":
        ("timeout -s INT 1 ringwatch run pull.toml --out pull_stopped --set integrator.end=5", 124),
    "ringwatch compare examples/swinging_bar.toml --integrators all --out out/compare":
        ("ringwatch compare examples/swinging_bar.toml --integrators symplectic-euler,verlet --out out/compare "
         "--set mesh.cells=[4,1,1] --set integrator.end=0.02", 0),
    "ringwatch compare examples/swinging_bar.toml --set mesh.generate=graded --set mesh.grading=20 --set 'mesh.cells=[40,6,6]' "
    "--set integrator.end=0.1 --integrators verlet --handlers all --out out/handlers":
        ("ringwatch compare examples/swinging_bar.toml --set mesh.generate=graded --set mesh.grading=4 --set 'mesh.cells=[4,1,1]' "
         "--set integrator.end=0.02 --integrators verlet --handlers all --out out/handlers", 0),
    # Of another body.
    "ringwatch-check --expect 0123456789abcdef bar.certificate": ("ringwatch-check --expect 0123456789abcdef bar.certificate", 1),
}

# Commands that are not run, by their first word: why not. A script must pass `bash -n` or compile; a benchmark program
# must be a target of bench/.
NOT_RUN = {
    "scripts/demo": "installs packages and builds; CI runs it, and the README's commands behind it",
    "scripts/gpu": "needs a GPU machine",
    "compute-sanitizer": "needs a GPU machine",
    "RINGWATCH_ROUNDING_TRIALS=200": "measures for minutes",
    "RINGWATCH_TAMPERED_CERTIFICATES=100000": "tries for minutes; the tests try some hundreds",
    "RINGWATCH_ELEMENT_CHECKS=10000000": "tries for hours; the tests try some thousands",
    "RINGWATCH_HISTORY_CHECKS=1000000": "tries for an hour; the tests try some thousands",
    "bench/compare.py": "compares results of the benchmark programs",
    "cmake": "configures and builds",
    "module": "of the machines that have it; names differ from site to site",
    "srun": "of the machines that have SLURM",
    "mpirun": "refuses root unless told; tests/distributed and examples.embed_ranks run it",
    "PYTHONPATH=build/release/python": "tests/python imports the module from the build tree",
    'PYTHONPATH="$PWD/build/release/python"': "opens a browser; tests/python runs the notebooks",
    "build/release/bin/ringwatch_bench_body": "bench",
}


# Words of laboratory diaries, former private names, and words that the field does not use: no text for users has them. A name that is
# still accepted may stand behind "Older name".
WORDS = {
    "wanted": "say what is required", "missed": "say what happens", "busy": "give the load with the figures, in bench/results",
    "anew": "again", "afresh": "again", "hence": "so", "lest": "so that … not", "whoever": "who", "nobody": "no one", "somebody": "someone",
    "spoilt": "damaged", "hottest": "highest", "trough": "minimum", "for people": "human-readable", "peers": "other programs",
    "retarget": "rebuild", "flooded": "too many violations", "poison": "NaN guard",
    "lazy bound": "incremental certificate", "kept selection": "incremental selection", "leave their balls": "leave their validity balls",
    "left their balls": "left their validity balls", "leave its ball": "leaves its validity ball", "left its ball": "left its validity ball",
    "hot spot": "local mode", "looked at": "examined", "looks at": "examines", "books": "energy balance, or textbooks",
    "keepbooks": "energyBalance.update", "steer": "aim at", "steers": "aims at", "steered": "aimed at", "ease": "relaxBound", "eases": "relaxes",
}


# How many lines a page of docs/ may have: what a reader takes in at once. 150 where the page is not named here.
GUIDE_LINES, LONGEST_GUIDE = {"monitor.md": 90, "performance.md": 50, "cluster.md": 100, "gallery.md": 180}, 150
LONGEST_STUDY = 90  # of docs/studies: a short paper
# How wide its lines may be, so that a change of a sentence can be read, and its rows of tables, so that a cell stays one thought.
WIDEST_PROSE, WIDEST_ROW = 170, 220
TERMS_OF_THE_GLOSSARY, RELEASE_BULLETS = 45, 30
# What dates a page.
DATED = {
    "a day": r"\b(January|February|March|April|May|June|July|August|September|October|November|December) 20\d\d|\b20\d\d-\d\d",
    "a machine": r"\b(Xeon|EPYC|Ryzen|[ABH][12]00)\b",
    "history": r"\b(now|recently|formerly|previously|nowadays|used to|until then|at first it|since a change|was mended|were mended|earlier version)\b",
}


# Pages whose text blocks are drawings.
DRAWINGS = {"docs/architecture.md"}


def alike(documented, printed):
    """Whether two lines are the same; numbers to 1e-6, since the last digits are the machine's, and … stands for anything."""
    number = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?"
    pattern = "".join(
        ".*" if part == "…" else f"({number})" if re.fullmatch(number, part) else re.escape(part)
        for part in re.split(rf"(…|{number})", documented.strip()) if part)
    match = re.fullmatch(pattern, printed.strip())
    if not match:
        return False
    numbers = [part for part in re.findall(rf"…|{number}", documented) if part != "…"]
    return all(abs(float(a) - float(b)) <= 1e-6 * abs(float(a)) for a, b in zip(numbers, match.groups()))


class Documents:
    def __init__(self, source, program):
        self.source = source
        self.program = program
        self.paths = [source / "README.md", source / "check/README.md", source / "examples/README.md",
                      *sorted((source / "docs").rglob("*.md")), *sorted((source / "bench").rglob("*.md"))]
        self.project = [source / "CONTRIBUTING.md", source / "CHANGELOG.md"]
        self.faults = []
        self.helps = {}
        self.schema = None

    def fault(self, path, line, text):
        self.faults.append(f"{path.relative_to(self.source)}:{line}: {text}")

    def lines(self, path):
        return path.read_text(encoding="utf-8").split("\n")

    def fences(self, path):
        """(language, number of the first line, lines) of every fenced block."""
        begin = None
        for number, line in enumerate(self.lines(path), 1):
            if line.startswith("```"):
                if begin is None:
                    begin, language, block = number + 1, line[3:].strip(), []
                else:
                    yield language, begin, block
                    begin = None
            elif begin is not None:
                block.append(line)

    def spans(self, path):
        """(line number, text) of every inline code span outside of fenced blocks."""
        text, fenced = [], False
        for line in self.lines(path):
            if line.startswith("```"):
                fenced = not fenced
            text.append("" if fenced or line.startswith("```") else line)
        joined = "\n".join(text)
        for match in re.finditer(r"`([^`]+)`", joined):
            yield joined.count("\n", 0, match.start()) + 1, " ".join(match[1].split())

    def commands(self, path):
        """(line number, command) of every fenced shell block; comments are left out, continued lines joined."""
        for language, first, block in self.fences(path):
            if language not in ("", "sh", "bash"):
                continue
            text = ""
            for number, line in enumerate(block, first):
                text += line
                if text.endswith("\\"):
                    text = text[:-1]
                    continue
                command = " ".join(re.sub(r"\s#.*$", "", text).split())
                if command:
                    yield number, command
                text = ""

    def ringwatch(self, *arguments):
        return subprocess.run([self.program, *arguments], capture_output=True, text=True, check=False)

    def anchors(self, path):
        """What links may name behind a #: the headings, as GitHub makes anchors of them."""
        found, fenced = set(), False
        for line in self.lines(path):
            fenced ^= line.startswith("```")
            if not fenced and (match := re.match(r"#+ +(.*)", line)):
                found.add(re.sub(r"[^\w\- ]", "", match[1].lower()).replace(" ", "-"))
        return found

    def help(self, *topic):
        if topic not in self.helps:
            result = self.ringwatch("help", *topic)
            self.helps[topic] = result.stdout if result.returncode == 0 else None
        return self.helps[topic]

    def names(self, topic):
        """The names that a topic lists."""
        return re.findall(r"^  ([\w./:-]+) ", self.help(topic) or "", re.M)

    # ---- links

    def check_links(self):
        for path in [*self.paths, *self.project]:
            text = "\n".join(self.lines(path))
            for match in re.finditer(r"\]\(([^)\s]+)\)", text):
                target, _, anchor = match[1].partition("#")
                if re.match(r"\w+:", match[1]):
                    continue
                to = path.parent / target if target else path
                if not to.exists() or (anchor and to.suffix == ".md" and anchor not in self.anchors(to)):
                    self.fault(path, text.count("\n", 0, match.start()) + 1, f"the link {match[1]} leads nowhere")
            top = {p.name for p in self.source.iterdir()}
            for line, span in self.spans(path):
                first = span.split("/")[0]
                if path.parent == self.source and re.fullmatch(r"\w+/", span) and first not in (*top, "build", "out"):
                    self.fault(path, line, f"there is no folder {span}")
                # What builds and runs leave is there or not.
                left = first in ("build", "out")
                if "/" not in span or first not in top or left or re.search(r"[\s*<>…]|NAME|FOLDER", span):
                    continue
                stem = self.source / span
                if not stem.exists() and not list(stem.parent.glob(stem.name + ".*")):
                    self.fault(path, line, f"there is no {span}")

        path, subfolders = self.first_column("CONTRIBUTING.md", "| subfolder |")
        there = {f"{p.parent.parent.name}/{p.parent.name}/" for folder in re.findall(
            r"^(\w+):", (self.source / "cmake/layers.txt").read_text(encoding="utf-8"), re.M)
            for p in self.source.glob(f"{folder}/*/*.*")}
        if there != set(subfolders):
            self.fault(path, 1, f"subfolders of folders: the document has {sorted(subfolders)}, there are {sorted(there)}")
        self.check_components()

    def check_components(self):
        """docs/embedding.md has every component, and in its row the headers of sources that it has of a folder with others."""
        path, found = self.first_column("docs/embedding.md", "| component |")
        rows = {name: next(line for line in path.read_text(encoding="utf-8").split("\n") if line.startswith(f"| `{name}` |"))
                for name in found}
        folders = re.findall(r"^(\w+):", (self.source / "cmake/layers.txt").read_text(encoding="utf-8"), re.M)
        lists = {p.parent: p.read_text(encoding="utf-8") for f in folders for p in (self.source / f).glob("**/CMakeLists.txt")}
        there = {name for text in lists.values() for name in re.findall(r"^ *ringwatch_(?:folder|library)\((\w+)", text, re.M)}
        if there != set(found):
            self.fault(path, 1, f"components: the document has {sorted(found)}, there are {sorted(there)}")
        for folder, text in lists.items():
            for variable, sources in re.findall(r"set\((of_\w+) ([^)]*)\)", text):
                owner = re.search(rf"ringwatch_(?:folder|library)\((\w+)[^()]*\$\{{{variable}\}}", text)
                if not owner:  # a list of app/, which is no component
                    continue
                for header in (folder / source.replace(".cpp", ".h") for source in sources.split()):
                    name = header.relative_to(self.source).as_posix()
                    if header.exists() and f"`{name}`" not in rows[owner[1]]:
                        self.fault(path, 1, f"{name} is of the component {owner[1]}, whose row does not have it")

    # ---- lists

    def check_invocation(self, path, line, command):
        """A `ringwatch …` of the text: its command, options and topic exist."""
        words = command.split()[1:]
        if not words or words[0].startswith("-"):
            return
        if words[0] == "help":
            if len(words) == 2 and words[1].isupper():  # stands for any
                return
            if self.help(*words[1:]) is None:
                self.fault(path, line, f"`{command}`: there is no such topic")
            return
        name = [words[0]]
        if words[0] == "mesh" and len(words) > 1:
            name.append(words[1])
        text = self.help(*name)
        if text is None:
            self.fault(path, line, f"`{command}`: there is no such command")
            return
        for option in re.findall(r"(?<!\S)--?[a-z][\w-]*", command):
            if not re.search(rf"(?<![\w-]){re.escape(option)}(?![\w-])", text):
                self.fault(path, line, f"`{command}`: there is no option {option}")
        if words[0] == "verify":
            for study in words[1:]:
                if re.fullmatch(r"[a-z0-9]+", study) and study not in (*self.names("studies"), "all"):
                    if words[words.index(study) - 1].startswith("--"):
                        continue
                    self.fault(path, line, f"`{command}`: there is no study {study}")

    def scene_keys(self):
        """section -> key -> what it may be, from the topic."""
        keys, section, key = {}, None, None
        for line in self.ringwatch("run", "--help-scene").stdout.split("\n"):
            if match := re.match(r"\[+(\w+)\]+ ", line):
                section = keys.setdefault(match[1], {})
            elif line.startswith("Mesh generators"):
                break
            elif section is not None and (match := re.match(r"  (\w+) ", line)):
                key = match[1]
                section[key] = None
            elif section is not None and (match := re.match(r"\s+one of: (.*)", line)):
                section[key] = match[1].split(", ")
        return keys

    def check_keys(self, path, keys):
        """Scene keys in TOML blocks and in code spans."""
        for language, first, block in self.fences(path):
            if language != "toml":
                continue
            self.check_scene(path, first, block)
            section = None
            for number, line in enumerate(block, first):
                if match := re.match(r"\s*\[+(\w+)\]+", line):
                    section = match[1]
                    if section not in keys:
                        self.fault(path, number, f"a scene has no section {section}")
                elif match := re.match(r"\s*(\w+)\s*=\s*([^#]*)(#.*)?", line):
                    self.check_key(path, number, keys, section, match[1], match[2] + (match[3] or ""))
                    proposed = re.findall(r'"([\w-]+)"', match[2] + (match[3] or ""))
                    if (section, match[1]) == ("handler", "method") and len(proposed) > 1 and set(proposed) != set(self.names("handlers")):
                        self.fault(path, number, f"the handlers are {self.names('handlers')}, not {proposed}")
        for line, span in self.spans(path):
            for section, key in re.findall(r"(?<![\w/.])(" + "|".join(keys) + r")\.([a-z]\w*)(?![\w/(.])", span):
                if key not in ("h", "cpp", "md", "cu"):
                    self.check_key(path, line, keys, section, key, "")
            for section, key, value in re.findall(r"\[+(\w+)\]+ (\w+) = (\S+)", span):
                self.check_key(path, line, keys, section, key, value)

    def check_scene(self, path, first, block):
        """A scene, or the part of one that a page is about, against the schema: names, types and ranges of what is there."""
        try:
            scene = tomllib.loads("\n".join(block).replace("…", "0"))
        except tomllib.TOMLDecodeError as error:
            self.fault(path, first, f"is no TOML: {error}")
            return
        whole = {"mesh", "material", "integrator"} <= set(scene)
        if self.schema is None:
            self.schema = json.loads(self.ringwatch("schema", "scene").stdout)
        for error in jsonschema.Draft7Validator(self.schema).iter_errors(scene):
            if not whole:
                # What is left out would make a section incomplete, and a list of one point is short for a longer one.
                error = next((e for e in [error, *(error.context or [])] if e.validator in ("type", "enum", "minimum", "maximum",
                              "exclusiveMinimum", "exclusiveMaximum", "additionalProperties") and len(e.absolute_path) > 1), None)
                if error is None:
                    continue
            where = ".".join(str(part) for part in error.absolute_path)
            self.fault(path, first, f"{where or 'the scene'} is not valid: {error.message}")

    def check_key(self, path, line, keys, section, key, values):
        if section not in keys or key not in keys[section]:
            self.fault(path, line, f"a scene has no key {section}.{key}")
        elif keys[section][key]:
            for value in re.findall(r'"([\w-]+)"', values):
                if value not in keys[section][key] and value not in keys:
                    self.fault(path, line, f"{section}.{key} cannot be {value}")

    def first_column(self, name, header):
        """The code spans of the first column of a table."""
        path = self.source / name
        found, inside = [], False
        for line in self.lines(path):
            if line.startswith(header):
                inside = True
            elif inside and not line.startswith("|"):
                break
            elif inside and line.startswith("| `"):
                found += re.findall(r"`([^`]+)`", line.split("|")[1])
        return path, found

    def same(self, path, what, found, topic, names=None):
        expected = self.names(topic) if names is None else names
        if sorted(found) != sorted(expected):
            self.fault(path, 1, f"{what}: the document has {sorted(found)}, ringwatch help {topic} {sorted(expected)}")

    def check_lists(self):
        keys = self.scene_keys()
        for path in self.paths:
            for line, span in self.spans(path):
                if span.startswith("ringwatch "):
                    self.check_invocation(path, line, span)
            for line, command in self.commands(path):
                if command.startswith("ringwatch "):
                    self.check_invocation(path, line, command)
            if path != self.source / "docs/reference/json.md":  # has keys of other files; reference_test.py compares them
                self.check_keys(path, keys)

        readme = self.source / "README.md"
        self.same(*self.column("docs/elements.md", "| element | nodes", "elements"))
        path, _ = self.first_column("docs/elements.md", "| element | nodes")
        for match in re.finditer(r"^\| `(\w+)` \| (\d+) \| [^|]* \| (.*) \|$", "\n".join(self.lines(path)), re.M):
            entry = re.search(rf"^  {match[1]} +(\d+) nodes.*\n((?:    .*\n)*)", self.help("elements"), re.M)
            if entry is None or entry[1] != match[2]:
                self.fault(path, 1, f"{match[1]} has not {match[2]} nodes")
                continue
            rules = re.findall(r"^    ([\w-]+) ", entry[2], re.M)
            if rules != re.findall(r"`([\w-]+)`", match[3]):
                self.fault(path, 1, f"the rules of {match[1]} are {rules}")
        # A program without SUNDIALS has the explicit integrators only.
        path, integrators = self.first_column("docs/integrators.md", "| name | what")
        if "implicit-euler" in self.names("integrators"):
            self.same(path, "integrators", integrators, "integrators")
        elif not set(self.names("integrators")) <= set(integrators):
            self.fault(path, 1, "integrators are missing")
        path, schemas = self.first_column("docs/machines.md", "| schema | of")
        self.same(path, "schemas", schemas, "schema", re.findall(r"^  ([\w-]+) ", self.ringwatch("schema").stdout, re.M))
        path, modes = self.first_column("docs/monitor.md", "| `[monitor] mode`")
        self.same(path, "monitor.mode", modes, "scene", keys["monitor"]["mode"])
        path = self.source / "docs/handlers.md"
        headings = [line[3:] for line in self.lines(path) if line.startswith("## ")]
        for name in self.names("handlers"):
            if name not in headings:
                self.fault(path, 1, f"the handler {name} has no section")

        version = re.search(r"^  VERSION ([\d.]+)$", (self.source / "CMakeLists.txt").read_text(encoding="utf-8"), re.M)[1]
        cited = dict(re.findall(r"^([\w-]+): ([\w.-]+)$", (self.source / "CITATION.cff").read_text(encoding="utf-8"), re.M))
        if cited.get("version") != version:
            self.fault(self.source / "CITATION.cff", 1, f"the version is not {version}")
        changes = "\n".join(self.lines(self.source / "CHANGELOG.md"))
        released = changes.partition(f"\n## {version} ({cited.get('date-released')})\n")[2].partition("\n## ")[0]
        if not 0 < released.count("\n- ") <= RELEASE_BULLETS:
            self.fault(self.source / "CHANGELOG.md", 1, f"has no section {version} of the day in CITATION.cff, or one of more than {RELEASE_BULLETS} bullets")
        if f'version: "{version}"' not in (self.source / "packaging/conda/meta.yaml").read_text(encoding="utf-8"):
            self.fault(self.source / "packaging/conda/meta.yaml", 1, f"the version is not {version}")
        if f"Version {version.rpartition('.')[0]}:" not in "\n".join(self.lines(readme)):
            self.fault(readme, 1, f"does not say that this is version {version.rpartition('.')[0]}")

        results = self.source / "bench/results"
        schema = jsonschema.Draft7Validator(json.loads((results / "schema.json").read_text(encoding="utf-8")))
        runs = sorted(results.glob("20*.json"))
        for path in runs:
            run = json.loads(path.read_text(encoding="utf-8"))
            for error in schema.iter_errors(run):
                self.fault(path, 1, f"{'.'.join(map(str, error.absolute_path))} is not valid: {error.message}")
            for measurement in run["measurements"]:
                if any(len(row) != len(measurement["columns"]) for row in measurement["rows"]):
                    self.fault(path, 1, f"{measurement['subject']}: a row has not as many cells as there are columns")
            if not path.name.startswith(run["date"]):
                self.fault(path, 1, f"is not named by its day, {run['date']}")
        made = subprocess.run([sys.executable, self.source / "bench/results.py", "page", "--check"], capture_output=True, text=True, check=False)
        if made.returncode or not runs:
            self.faults.append(made.stderr.strip() or "bench/results has no run")

    def column(self, name, header, topic):
        path, found = self.first_column(name, header)
        return path, topic, found, topic

    # ---- words

    def check_words(self):
        pattern = re.compile(r"\b(" + "|".join(WORDS) + r")\b", re.I)

        results = self.source / "bench/results"
        for path in [*self.paths, *self.project]:
            if results in path.parents:  # records of their day
                continue
            text = "\n".join(self.lines(path))
            for match in pattern.finditer(re.sub(r"Older names?:?[^|\n]*", lambda m: " " * len(m[0]), text)):
                word = match[1].lower()
                self.fault(path, text.count("\n", 0, match.start()) + 1, f'"{match[1]}": {WORDS[word]}')
        help_texts = {"--help": self.ringwatch("--help").stdout}
        for name in self.names_of_topics_and_commands():
            help_texts[" ".join(name)] = self.help(*name) or ""
        for name, text in help_texts.items():
            for match in pattern.finditer(text):
                self.faults.append(f'ringwatch help {name}: "{match[1]}": {WORDS[match[1].lower()]}')
        for path in sorted((self.source / "python").rglob("*.py*")):
            if path.suffix not in (".py", ".pyi"):
                continue
            for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
                if isinstance(node, ast.Constant) and isinstance(node.value, str):
                    for match in pattern.finditer(node.value):
                        self.fault(path, node.lineno, f'"{match[1]}": {WORDS[match[1].lower()]}')
        # Messages: the texts in the sources of what users call.
        for folder in (self.source / "cmake/layers.txt").read_text(encoding="utf-8").splitlines():
            folder = folder.split(":")[0].strip()
            for path in sorted((self.source / folder).rglob("*.cpp")) if folder and (self.source / folder).is_dir() else []:
                if folder in ("tests", "bench") or "node_modules" in path.parts:
                    continue
                for number, line in enumerate(self.lines(path), 1):
                    code = line.split("//")[0]
                    for text in re.findall(r'"((?:[^"\\]|\\.)*)"', code):
                        for match in pattern.finditer(text):
                            self.fault(path, number, f'"{match[1]}": {WORDS[match[1].lower()]}')

    def names_of_topics_and_commands(self):
        topics = re.findall(r"^  ([a-z-]+) ", self.ringwatch("help", "help").stdout, re.M)
        commands = [c for c in re.findall(r"^  ([a-z]+) ", self.ringwatch("--help").stdout.split("Subcommands:")[-1], re.M)
                    if self.help(c) is not None]
        return [(name,) for name in dict.fromkeys([*topics, *commands])] + [("mesh", k) for k in ("generate", "convert", "check")]

    # ---- guides

    def check_guides(self):
        studies = self.source / "docs/studies"
        pages = [path for path in self.paths if path.parent in (self.source / "docs", studies)]
        others = [path for path in (*self.paths, *self.project, self.source / "SECURITY.md", *sorted((self.source / "check").glob("*.md")),
                                    *sorted((self.source / "paper").glob("*.md"))) if path not in pages]
        for path in dict.fromkeys(others):
            # Figures stand with their day and machine in bench/results, changes in the change log.
            if path.name != "CHANGELOG.md" and self.source / "bench/results" not in path.parents:
                self.check_dated(path)
        for path in pages:
            self.check_dated(path)
            lines, fenced = self.lines(path), False
            if len(lines) - 1 > (limit := LONGEST_STUDY if path.parent == studies else GUIDE_LINES.get(path.name, LONGEST_GUIDE)):
                self.fault(path, limit + 1, f"{len(lines) - 1} lines; at most {limit}")
            for number, line in enumerate(lines, 1):
                if line.startswith("```"):
                    fenced = not fenced
                if fenced:
                    continue
                told = re.sub(r"\]\([^)]*\)|`[^`]*`", "", line)
                row = line.lstrip().startswith("|")
                width, limit = (len(told), WIDEST_ROW) if row else (len(line), WIDEST_PROSE)
                if width > limit:
                    self.fault(path, number, f"{width} letters wide; at most {limit}")
        path = self.source / "docs/glossary.md"
        if path in pages:
            terms = sum(line.startswith("| **") for line in self.lines(path))
            if not 1 <= terms <= TERMS_OF_THE_GLOSSARY:
                self.fault(path, 1, f"{terms} terms; at most {TERMS_OF_THE_GLOSSARY}")
        for name in GUIDE_LINES:
            if not (self.source / "docs" / name).exists():
                self.faults.append(f"{pathlib.Path(__file__).name}: there is no guide {name} any more")

    def check_dated(self, path):
        fenced = False
        for number, line in enumerate(self.lines(path), 1):
            fenced ^= line.startswith("```")
            told = "" if fenced else re.sub(r"\]\([^)]*\)|`[^`]*`", "", line)
            for what, pattern in DATED.items():
                if match := re.search(pattern, told):
                    self.fault(path, number, f'"{match[0]}" tells {what}')

    # ---- commands

    def check_commands(self):
        unused = set(SUBSTITUTES) | set(NOT_RUN)
        bench = "".join(p.read_text(encoding="utf-8") for p in (self.source / "bench").rglob("CMakeLists.txt"))
        ran, outputs = set(), {}
        with tempfile.TemporaryDirectory() as folder:
            work = pathlib.Path(folder)
            shutil.copytree(self.source / "examples", work / "examples")
            (work / "build/release").mkdir(parents=True)
            (work / "build/release/bin").symlink_to(self.program.parent)
            checker = self.program.with_name("ringwatch-check")
            # The shell finds the program where the README's first block says that it is, and by that line alone.
            exports = "".join(f"{command}; " for _, command in self.commands(self.source / "README.md") if command.startswith("export "))
            for path in self.paths:
                self.write_scenes(path, work)
                listed = list(self.commands(path))
                # Commands in the running text count when they name a scene of the examples.
                listed += [(n, s) for n, s in self.spans(path) if re.match(r"ringwatch (run|compare|suggest|advise|scale-mass) examples/\S+\.toml", s)]
                for line, command in listed:
                    first = command.split()[0]
                    if first == "export" or first == "ringwatch-check" and not checker.exists():
                        continue  # the one is in every shell; the other may be built without Arb
                    if first in NOT_RUN:
                        unused.discard(first)
                        self.check_not_run(path, line, first, bench)
                        continue
                    unused.discard(command)
                    if command in ran:
                        continue
                    ran.add(command)
                    run, status = SUBSTITUTES.get(command, (command, 0))
                    result = subprocess.run(
                        ["bash", "-c", exports + run], cwd=work, capture_output=True,
                        text=True, check=False, timeout=600)
                    outputs[command] = result.stdout
                    if result.returncode != status:
                        self.fault(path, line, f"`{run}` ends with {result.returncode}, not {status}: {result.stderr.strip()}")
        for path in self.paths:
            if path.parent != self.source / "docs/reference":  # made from the program; reference_test.py compares them
                self.check_texts(path, outputs)
        for name in sorted(unused) if len(sys.argv) == 4 else ():
            self.faults.append(f"{pathlib.Path(__file__).name}: no document has the command `{name}` any more")

    def check_texts(self, path, outputs):
        """A text block has commands, or what the commands of the block before it print, or lines of a file that the paragraph before it names."""
        commands = None
        for language, first, block in self.fences(path):
            if language in ("", "sh", "bash"):
                commands = [command for number, command in self.commands(path) if first <= number < first + len(block)]
            if language != "text" or path.relative_to(self.source).as_posix() in DRAWINGS:
                continue
            if all(line.startswith("ringwatch ") for line in block):
                for number, line in enumerate(block, first):
                    self.check_invocation(path, number, line)
                continue
            paragraph = next(line for line in reversed(self.lines(path)[:first - 2]) if line)
            files = [self.source / s for s in re.findall(r"`([\w./]+)`", paragraph) if (self.source / s).is_file()]
            if files:
                text, what = files[0].read_text(encoding="utf-8"), files[0].name
            elif commands is not None:
                text, what = "\n".join(outputs.get(command, "") for command in commands), "the output"
            else:
                self.fault(path, first, "nothing tells what this text is of")
                continue
            there = text.split("\n")
            for number, line in enumerate(block, first):
                if line in ("...", "…"):
                    continue
                place = next((i for i, one in enumerate(there) if alike(line, one)), None)
                if place is None:
                    self.fault(path, number, f"{what} does not go on with this line: {line}")
                    break
                there = there[place + 1:]

    def write_scenes(self, path, work):
        """The scenes that a page has its readers write."""
        lines = self.lines(path)
        for language, first, block in self.fences(path):
            if language == "toml" and first > 2 and (match := re.search(r"Write this as `([\w.]+)`:$", lines[first - 3])):
                (work / match[1]).write_text("\n".join(block) + "\n", encoding="utf-8")

    def check_not_run(self, path, line, first, bench):
        if NOT_RUN[first] == "bench":
            target = first.rsplit("/", 1)[1]
            if not re.search(rf"\b({target}|ringwatch_bench\({target.removeprefix('ringwatch_bench_')})\b", bench):
                self.fault(path, line, f"bench/ has no program {first}")
            return
        script = self.source / first
        if "/" not in first or "=" in first:
            return
        if not script.is_file() or not script.stat().st_mode & 0o100:
            self.fault(path, line, f"{first} is not a script that can be called")
        elif script.read_bytes().startswith(b"#!/usr/bin/env bash"):
            if subprocess.run(["bash", "-n", script], check=False).returncode:
                self.fault(path, line, f"{first} is not bash")


def main():
    check, source, program = sys.argv[1], pathlib.Path(sys.argv[2]).resolve(), pathlib.Path(sys.argv[3]).resolve()
    documents = Documents(source, program)
    if sys.argv[4:]:
        documents.paths = [source / page for page in sys.argv[4:]]
    {"links": documents.check_links, "lists": documents.check_lists, "words": documents.check_words, "guides": documents.check_guides,
     "commands": documents.check_commands}[check]()
    print("\n".join(documents.faults) or f"{check}: no fault in {len(documents.paths)} documents")
    return 1 if documents.faults else 0


if __name__ == "__main__":
    sys.exit(main())
