#!/usr/bin/env python3
"""tuning_test.py PROGRAMS SCENES SCRATCH: the way to trace is chosen by --tuning, by LAVARAY_TUNING, or by what was
measured on the device and kept in the user's cache folder; whatever it is, the picture has the same bits."""
import json
import os
import pathlib
import subprocess
import sys

sys.dont_write_bytecode = True  # leaves no __pycache__ in the checkout
sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from checks import check, demand, finish

programs, scenes, scratch = (pathlib.Path(argument).resolve() for argument in sys.argv[1:4])
scratch.mkdir(parents=True, exist_ok=True)
cache = scratch / "cache"
WAYS = [f"{scene},{rays}" for scene in ("texels", "storage") for rays in (1, 2, 4)]


def render(*arguments, size=64, code=0, **variables):
    """What a verbose run says."""
    environment = {name: value for name, value in os.environ.items() if name != "LAVARAY_TUNING"}
    result = subprocess.run(
        [programs / "lavaray", scenes / "torus.txt", "--width", str(size), "-v", "-o", "picture.pfm", *arguments],
        cwd=scratch, capture_output=True, text=True, env=environment | {"XDG_CACHE_HOME": str(cache)} | variables)
    check(result.returncode == code, f"{arguments} with {variables} exits with {code}", result)
    return result.stderr


def tuning(said):
    lines = [line for line in said.splitlines() if line.startswith("tuning: ")]
    demand(len(lines) == 1, f"one line tells of the tuning:\n{said}")
    return lines[0].removeprefix("tuning: ")


def kept_files():
    return sorted((cache / "lavaray").glob("tuning*.txt"))


def check_choices():
    check(tuning(render()).endswith("none was measured on this device"), "nothing is measured for a small picture")
    check(not kept_files(), "nothing is kept of what was not measured")
    for way in WAYS:
        check(tuning(render("--tuning", way)) == f"{way}, as asked for", f"the option chooses {way}")
        check(tuning(render(LAVARAY_TUNING=way)) == f"{way}, as asked for", f"the variable chooses {way}")
    check(tuning(render("--tuning", "texels", LAVARAY_TUNING="storage,1")) == "texels,4, as asked for",
          "the option goes first, and takes as many rays as usual")
    for wrong in ("texel", "storage,3", "texels,", ""):
        said = render("--tuning", wrong, code=2)
        check("texels or storage" in said, f"what is allowed is said of '{wrong}': {said}")
    check("texels or storage" in render(LAVARAY_TUNING="fast", code=2), "and of a wrong variable")


def check_bits():
    """Of a picture that is large enough for rays to be traced together."""
    pictures = set()
    for way in WAYS:
        render("--tuning", way, "--json", "report.json", size=2700)
        pictures.add((scratch / "picture.pfm").read_bytes())
        device = json.loads((scratch / "report.json").read_text())["device"]
        check(f"{device['sceneReadAs']},{device['raysPerInvocation']}" == way, f"the report tells of {way}: {device}")
    check(len(pictures) == 1, f"every way makes the same picture, not {len(pictures)}")


def check_measured():
    said = tuning(render("--tuning", "measure"))
    check("measured on this device: " in said and "not kept" not in said, f"it is measured and kept: {said}")
    demand(len(kept_files()) == 1, f"one file is kept: {kept_files()}")
    file, = kept_files()
    check(tuning(render()) == said, "a later run takes what was measured")

    lines = file.read_text().splitlines()
    file.write_text("\n".join([lines[0], "texels,4 2.0", "storage,2 1.0"]) + "\n")
    check(tuning(render()).startswith("storage,2, measured"), "the fastest is taken")
    file.write_text("\n".join([lines[0], "texels,4 1.0", "storage,2 0.97"]) + "\n")
    check(tuning(render()).startswith("texels,4, measured"), "what is faster by next to nothing is not")
    for spoilt in (["lavaray 0.0.1, another driver", "storage,2 1.0"], [lines[0], "storage,3 1.0"],
                   [lines[0], "storage,2 -1"], [lines[0], "storage,2"], [lines[0]], []):
        file.write_text("\n".join(spoilt) + "\n")
        check(tuning(render()).endswith("none was measured on this device"), f"what does not fit is not taken: {spoilt}")


LONG = ("--spp", "64", "--time-limit", "0.01")  # by the number of its rays


def check_long_render():
    for file in kept_files():
        file.unlink()
    said = tuning(render(*LONG, size=1600))
    check("measured on this device: " in said, f"it is measured before a long render: {said}")
    check(tuning(render()) == said, "and kept for others")


def check_without_folder():
    """A run neither fails nor warns where nothing can be kept, and measures on request only."""
    (scratch / "no-folder").write_text("a file")
    for variables in ({"XDG_CACHE_HOME": str(scratch / "no-folder")}, {"XDG_CACHE_HOME": "", "HOME": ""}):
        check(tuning(render(*LONG, size=1600, **variables)).endswith("none was measured on this device"),
              f"nothing is measured for one long render: {variables}")
        said = render("--tuning", "measure", **variables)
        check("not kept: " in tuning(said) and "warning" not in said, f"{variables}: {said}")


for old in kept_files():
    old.unlink()
check_choices()
check_bits()
check_measured()
check_long_render()
check_without_folder()
finish()
