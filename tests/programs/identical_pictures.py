#!/usr/bin/env python3
"""identical_pictures.py BEFORE_DIR AFTER_DIR [--quick] [--scratch DIR]: whether two builds write the same files.

BEFORE_DIR and AFTER_DIR hold lavaray, lavaray-diff and lavaray-merge of two builds. Both render all of the project's
scenes, the course's where there are any, and each option of the programs' --help-table at two values or more, with all
of these scenes. Every file that they write, their exit codes and what they say is compared byte for byte, apart from
what masked(), MASKED_KEYS and same() name. An option of the table that has neither values nor a reason in
identical_pictures_options.py is a failure. --quick takes three scenes in place of all. Exits with 1 where anything
differs.
"""
import argparse
from concurrent.futures import ThreadPoolExecutor
import json
import pathlib
import re
import shutil
import struct
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True  # leaves no __pycache__ in the checkout
import identical_pictures_options as options

PROJECT = pathlib.Path(__file__).resolve().parents[2]
QUICK_SCENES = ("extensions", "handout", "torus")  # mirrors and a spherical light; nothing of that; a mesh
DIFFERS = 10  # lavaray-diff's exit code
CHECKSUM_BYTES = 16  # of a film, at its end
# What another run of the same program, or one that cuts the work otherwise, writes differently. Dispatches are cut by
# the clock.
MASKED_KEYS = ("seconds", "steps", "peakBytes", "bufferBytes", "dispatches", "activity", "perSecond",
               "lanesInUse")


def scenes_of(quick):
    ours = sorted((PROJECT / "scenes").glob("*.txt"))
    if quick:
        return [scene for scene in ours if scene.stem in QUICK_SCENES]
    return ours + sorted((PROJECT.parent / "shared" / "course").glob("scene*.txt"))


def table(programs, program):
    """The option table: the last of each option's names."""
    text = subprocess.run([programs / program, "--help-table"], capture_output=True, text=True, check=True).stdout
    rows = [line.split("\t") for line in text.splitlines()]
    return [row[1].split(", ")[-1] for row in rows if row[0] == "option"]


def masked(text, programs, folder):
    """Text without the folders of this build and without what the clock and the memory make of it."""
    for path, name in ((folder, "SCRATCH"), (programs, "PROGRAMS")):
        text = text.replace(str(path), name)
    text = re.sub(r"(?m)^.* % .* elapsed.*\n", "", text)  # progress, after half a second
    text = re.sub(r"(?m)^  (idle|host waits|a second|lanes in use) +\w.*\n", "", text)
    text = re.sub(r" *\d+(\.\d+)? (s|ms|MiB|MB)\b", r" # \2", text)
    text = re.sub(r"(?m)^(  (?:read scene|build|wait for device|render|write image|all)) +[\d.]+$", r"\1 #", text)
    return re.sub(r"(?m)^(  dispatches) +\d+$", r"\1 #", text)


def without_masked_keys(value):
    if isinstance(value, dict):
        return {key: without_masked_keys(entry) for key, entry in value.items() if key not in MASKED_KEYS}
    return [without_masked_keys(entry) for entry in value] if isinstance(value, list) else value


def png_chunks(data):
    """All chunks but the text that says how long the render took."""
    at, chunks = 8, []
    while at < len(data):
        (size,) = struct.unpack_from(">I", data, at)
        chunk = data[at + 4 : at + 8 + size]
        if not chunk.startswith(b"tEXtSeconds\0"):
            chunks.append(chunk)
        at += 12 + size
    return chunks


def film_parts(data):
    """The header, without the fingerprint of the shader's words, which are no picture, and the sums."""
    start = data.index(b"\n") + 1 + 8
    end = start + struct.unpack("<Q", data[start - 8 : start])[0]
    header = json.loads(data[start:end])
    header["identity"] = [entry for entry in header["identity"] if entry[0] != "shader"]
    return json.dumps(header), data[end:-CHECKSUM_BYTES]


def same(before, after):
    a, b = before.read_bytes(), after.read_bytes()
    if a == b:
        return True
    if before.suffix == ".png":
        return png_chunks(a) == png_chunks(b)
    if before.suffix == ".json":
        return json.dumps(without_masked_keys(json.loads(a))) == json.dumps(without_masked_keys(json.loads(b)))
    if before.suffix == ".film":
        return film_parts(a) == film_parts(b)
    return False


def run(programs, folder, commands, scenes):
    """Runs commands in an empty folder of their own, and keeps there what they print to stdout. {scenes} stands for all
    scenes, {scene} for the first, {n} for the command's number. Returns the exit codes and what is said on stderr."""
    folder.mkdir(parents=True)
    said = []
    for number, (program, *arguments) in enumerate(commands):
        own = [argument.replace("{scene}", str(scenes[0])).replace("{n}", str(number)) for argument in arguments]
        words = [word for argument in own for word in (scenes if argument == "{scenes}" else [argument])]
        with open(folder / f"stdout.{number}", "wb") as stdout:
            result = subprocess.run([programs / program, *words], cwd=folder, stdout=stdout, stderr=subprocess.PIPE,
                                    stdin=subprocess.DEVNULL, text=True)
        said.append((result.returncode, masked(result.stderr, programs, folder)))
    return said


def compare(commands, folders, said):
    """How many comparisons were made, and the differences."""
    differences = [f"{' '.join(command)} says {b}, said {a}" for command, a, b in zip(commands, *said) if a != b]
    differences += [f"{' '.join(command)} fails: {code}, {text}" for command, (code, text) in zip(commands, said[0])
                    if code not in (0, DIFFERS)]
    files = [{file.relative_to(folder) for file in folder.rglob("*") if file.is_file()} for folder in folders]
    differences += [f"only one build writes {file}" for file in sorted(files[0] ^ files[1])]
    differences += [f"{file} differs" for file in sorted(files[0] & files[1])
                    if not same(folders[0] / file, folders[1] / file)]
    return len(commands) + len(files[0] | files[1]), differences


def coverage(programs):
    """What the option tables of the build and of this script do not share."""
    faults = []
    for program, entries in options.OPTIONS.items():
        known = set(table(programs, program))
        faults += [f"{program} {name}: neither values nor a reason to leave it out"
                   for name in sorted(known - set(entries))]
        faults += [f"{program} {name}: not in the option table" for name in sorted(set(entries) - known)]
        faults += [f"{program} {name}: fewer than two values" for name, values in entries.items()
                   if not isinstance(values, str) and len(values) < 2]
    return faults


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("before", type=pathlib.Path)
    parser.add_argument("after", type=pathlib.Path)
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--scratch", type=pathlib.Path, help="kept; default: a temporary folder")
    arguments = parser.parse_args()
    builds = arguments.before.resolve(), arguments.after.resolve()
    temporary = tempfile.TemporaryDirectory(prefix="identical-pictures-")
    scratch = (arguments.scratch or pathlib.Path(temporary.name)).resolve()
    shutil.rmtree(scratch, ignore_errors=True)

    failures = coverage(builds[1])
    for failure in failures:
        print(f"FAILED: {failure}")
    scenes = scenes_of(arguments.quick)
    comparisons = 0
    trials = list(options.trials())
    for number, (name, commands) in enumerate(trials):
        folders = [scratch / side / f"{number:03}" for side in ("before", "after")]
        with ThreadPoolExecutor(2) as pool:
            said = list(pool.map(run, builds, folders, [commands] * 2, [scenes] * 2))
        count, differences = compare(commands, folders, said)
        comparisons += count
        failures += differences
        for difference in differences:
            print(f"DIFFERENT: {name}: {difference}", flush=True)
        if not differences:
            for folder in folders:
                shutil.rmtree(folder)
    for program, entries in options.OPTIONS.items():
        for name, reason in entries.items():
            if isinstance(reason, str):
                print(f"left out: {program} {name}: {reason}")
    print(f"{len(scenes)} scenes, {len(trials)} trials, {comparisons} comparisons, {len(failures)} failures")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
