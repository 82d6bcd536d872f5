#!/usr/bin/env python3
"""Do other people's readers see in vox's files what vox put there?

    python3 tests/readers/check.py VOX DATA NODE_MODULES

Converts every building under DATA to every format that vox writes, and counts the blocks of each result with readers
that vox shares no code with. `strict_check.py` beside DATA (in ../tools) must accept each file, and is asked for the
input too where it can read it. Exits with 1 where a file is refused or a count differs.

tests/readers/run.sh installs what this needs and calls it.
"""

import collections
import importlib.util
import json
import os
import pathlib
import subprocess
import sys
import tempfile

import count

HERE = pathlib.Path(__file__).parent

# What is converted to: the ending of the file, and the options that go with it.
TARGETS = {
    "schem v2": (".schem", []),
    "schem v3": (".schem", ["--schem-version", "3"]),
    "litematic v6": (".litematic", []),
    "litematic v7": (".litematic", ["--litematic-version", "7"]),
    "structure": (".nbt", []),
}

# Who reads what. The sizes are what a reader gets through in a minute, in cells.
PYTHON = {
    "schem v2": ["litemapy (sponge)", "mcschematic"],
    "litematic v6": ["litemapy"],
    "litematic v7": ["litemapy"],
    "structure": ["litemapy (structure)"],
}
PYTHON_CELLS = 300_000
NODE = {
    "schem v2": ["nucleation", "prismarine"],
    "schem v3": ["nucleation"],
    "litematic v6": ["nucleation"],
    "litematic v7": ["nucleation"],
    "structure": ["deepslate"],
}
NODE_CELLS = 3_000_000
# A structure lists every block by itself: at a kilobyte each in Python, large ones fit in memory without their air only.
STRUCTURE_CELLS = 300_000
WITHOUT_AIR = ["--air", "void"]

# Properties that count from 1.
FROM_ONE = ("candles=", "delay=", "distance=", "eggs=", "flower_amount=", "layers=", "pickles=", "segment_amount=")

# Faults of the readers, each looked up in its source, and whether a file with these states is one for them.
FAULTS = {
    "litemapy (sponge)": [
        ("takes each byte of the block data for a block", lambda of: len(of["states"]) > 128),
    ],
    "prismarine": [
        ("knows no blocks of this data version", lambda of: of["data_version"] < 1519),
        ("knows no blocks of mods", lambda of: any(not state.startswith("minecraft:") for state in of["states"])),
        ("counts properties from 0", lambda of: any(key in state for state in of["states"] for key in FROM_ONE)),
    ],
}


# What is left to a long run, with READERS=all: a checker in Python takes a minute for each such file.
SHORT_RUN_BYTES = 100_000


def inputs(data):
    patterns = ["houses/*/*", "builds/*", "sigi/*.schematic"]
    found = sorted(path for pattern in patterns for path in data.glob(pattern))
    long_run = os.environ.get("READERS") == "all"
    fits = lambda path: long_run or path.stat().st_size <= SHORT_RUN_BYTES
    return [path for path in found if path.suffix not in (".txt", ".md") and fits(path)]


def strict(data):
    """The independent checker, as a function of a path."""
    spec = importlib.util.spec_from_file_location("strict_check", data / "../tools/strict_check.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module.check


def info(vox, path):
    """What vox says of a file: blocks by name and the size."""
    done = subprocess.run([vox, "info", "--json", path], capture_output=True, text=True, check=True)
    said = json.loads(done.stdout)
    return {
        "blocks": count.by_name(said["palette"]),
        "cells": said["size"][0] * said["size"][1] * said["size"][2],
        "states": [state for state, _ in said["palette"]],
        "data_version": said["data_version"] or 0,
    }


def thinned(vox, source, target):
    try:
        return WITHOUT_AIR if target == "structure" and info(vox, source)["cells"] > STRUCTURE_CELLS else []
    except subprocess.CalledProcessError:
        return []


def convert(vox, source, target, options):
    done = subprocess.run([vox, "convert", source, target, *options], capture_output=True, text=True)
    return None if done.returncode == 0 else done.stderr.strip()


def ask_node(questions, modules):
    """The answers of count.mjs to (reader, file) pairs."""
    # Node looks for modules beside the script.
    script = modules.parent / "count.mjs"
    script.write_text((HERE / "count.mjs").read_text())
    lines = "".join(f"{reader}\t{file}\n" for reader, file in questions)
    done = subprocess.run(["node", script], input=lines, capture_output=True, text=True, check=True)
    return [json.loads(line) for line in done.stdout.splitlines()]


def difference(expected, found):
    names = sorted(name for name in expected.keys() | found.keys() if expected.get(name, 0) != found.get(name, 0))
    return ", ".join(f"{name}: {expected.get(name, 0)} -> {found.get(name, 0)}" for name in names[:4])


class Tally:
    """How often each reader agreed on each format, and what went wrong."""

    def __init__(self):
        self.agreed, self.excused, self.wrong = collections.Counter(), collections.Counter(), []

    def compare(self, target, reader, path, expected, found, of):
        excuse = next((fault for fault, applies in FAULTS.get(reader, []) if applies(of)), None)
        if found == expected:
            self.agreed[target, reader] += 1
        elif excuse:
            self.excused[target, f"{reader} {excuse}"] += 1
        else:
            self.wrong.append(f"{path} ({target}), {reader}: {difference(expected, found)}")

    def report(self):
        for (target, reader), number in sorted(self.agreed.items()):
            print(f"  {target:<14}{reader:<28}{number:>4} files alike")
        for (target, excuse), number in sorted(self.excused.items()):
            print(f"  {target:<14}{number} files left out: {excuse}")
        for line in self.wrong:
            print(f"WRONG {line}")


def check_strictly(checker, path, target, of, tally):
    said = checker(str(path))
    if said["errors"]:
        tally.wrong.append(f"{path} ({target}): strict_check refuses it: {'; '.join(said['errors'][:3])}")
    else:
        tally.compare(target, "strict_check", path, of["blocks"], count.by_name(said["counts"].items()), of)


# Blocks that stand for others in files of the game and of Structurize.
STANDS_FOR_OTHERS = ("minecraft:jigsaw", "structurize:")


def check_source(checker, source, path, target, of, tally):
    """The checker sees in the input what vox wrote to the output."""
    said = checker(str(source))
    # Numeric ids, Bedrock's names and damaged files cannot be compared by name.
    if said["errors"] or said["kind"] in ("mcedit", "mcstructure"):
        return
    states = said["counts"]
    if not any(state.startswith(STANDS_FOR_OTHERS) for state in states):
        tally.compare(target, "strict_check of the input", path, count.by_name(states.items()), of["blocks"], of)


def check_python(path, target, of, tally):
    for reader in PYTHON.get(target, []) if of["cells"] <= PYTHON_CELLS else []:
        try:
            found = count.READERS[reader](str(path))
        except Exception as error:
            found = {f"{type(error).__name__}: {error}": 1}
        tally.compare(target, reader, path, of["blocks"], found, of)


def main(vox, data, modules):
    data, modules = pathlib.Path(data).resolve(), pathlib.Path(modules).resolve()
    checker, tally, questions = strict(data), Tally(), []
    with tempfile.TemporaryDirectory() as folder:
        for source in inputs(data):
            for target, (ending, options) in TARGETS.items():
                path = pathlib.Path(folder) / f"{source.parent.name}-{source.name}-{target}{ending}"
                refused = convert(vox, source, path, options + thinned(vox, source, target))
                if refused and checker(str(source))["errors"]:
                    tally.excused[target, "strict_check refuses them, too"] += 1
                    continue
                if refused:
                    tally.wrong.append(f"{source} ({target}): {refused}")
                    continue
                of = info(vox, path)
                check_source(checker, source, path, target, of, tally)
                check_strictly(checker, path, target, of, tally)
                check_python(path, target, of, tally)
                if of["cells"] <= NODE_CELLS:
                    questions += [(reader, path, target, of) for reader in NODE.get(target, [])]
                else:
                    path.unlink()
        answers = ask_node([(reader, path) for reader, path, _, _ in questions], modules)
        for (reader, path, target, of), answer in zip(questions, answers, strict=True):
            found = answer.get("blocks") or {answer.get("error", "nothing"): 1}
            tally.compare(target, reader, path, of["blocks"], found, of)
    tally.report()
    print(f"{sum(tally.agreed.values())} passed, {len(tally.wrong)} failed")
    return 1 if tally.wrong or not tally.agreed else 0


if __name__ == "__main__":
    os.environ["NO_COLOR"] = "1"
    sys.exit(main(*sys.argv[1:]))
