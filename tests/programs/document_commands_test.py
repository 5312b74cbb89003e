#!/usr/bin/env python3
"""document_commands_test.py PROGRAMS SOURCE SCRATCH: runs the commands of the documents.

A block of code that begins with ```sh is run, by bash, and must exit with 0; one that cannot be run by a test says why:
```sh not run: REASON. No command of the project's stands in an indented block, where nothing would run it. Blocks run in
the project's folder, or what looks like it: the scenes, shaders and tools, and what the documents call the reader's own
files. Exits with 77 (skipped) where numpy is missing. SCRATCH is made anew."""
import importlib.util
import os
import pathlib
import re
import shutil
import subprocess
import sys

sys.dont_write_bytecode = True  # leaves no __pycache__ in the checkout
sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from checks import check, finish, make_anew, skip
from documents import blocks, documents

programs, source, scratch = (pathlib.Path(argument).resolve() for argument in sys.argv[1:4])
if importlib.util.find_spec("numpy") is None:
    skip("numpy is missing")
make_anew(scratch)


def furnish(folder):
    """The reader's own files, by the names that the documents give them."""
    folder.mkdir()
    for name in ("scenes", "shaders", "tools"):
        (folder / name).symlink_to(source / name)
    scene = (source / "scenes/spheres.txt").read_text()
    for name in ("scene.txt", "poster.txt", "frames/1.txt", "frames/2.txt", "sweep/1.txt"):
        (folder / name).parent.mkdir(exist_ok=True)
        (folder / name).write_text(scene)
    picture = folder / "new.png"
    subprocess.run([programs / "lavaray", folder / "scene.txt", "--width", "90", "-q", "-o", picture], check=True)
    for name in ("old.png", "actual.png", "reference.png", "pictures/1.png", "expected/1.png", "references/1.png"):
        (folder / name).parent.mkdir(exist_ok=True)
        shutil.copy(picture, folder / name)
    for name in ("first", "second"):
        subprocess.run([programs / "lavaray-diff", picture, folder / "old.png", "--json", folder / f"{name}.json"], check=True,
                       stdout=subprocess.DEVNULL)
    return folder


environment = os.environ | {"PATH": f"{programs}:{os.environ['PATH']}"}
run, kept = 0, []
for document in documents(source):
    name = str(document.relative_to(source))
    folder = None
    for line, kind, lines in blocks(document.read_text()):
        commands = "\n".join(lines)
        place = f"{name}:{line}"
        if kind is None:
            ours = re.search(r"^(?:[A-Z_]+=\S* |sudo )*(?:lavaray(?:-diff|-merge)? |tools/).*", commands, re.MULTILINE)
            check(not ours, f"{place}: put this into a block that begins with ```sh: {ours and ours.group()}")
        elif kind == "sh":
            folder = folder or furnish(scratch / name.replace("/", "-"))
            found = subprocess.run(["bash", "-eu", "-o", "pipefail", "-c", commands], cwd=folder, env=environment,
                                   stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=300)
            check(found.returncode == 0, place, found)
            run += 1
        elif kind.startswith("sh"):
            check(re.fullmatch(r"sh not run: .{8,}", kind), f"{place}: ```{kind} is neither ```sh nor ```sh not run: REASON")
            kept.append(f"{place} {kind[3:]}")
print(f"{run} blocks run", *kept, sep="\n")
check(run >= 5, f"{run} blocks were run")
finish()
