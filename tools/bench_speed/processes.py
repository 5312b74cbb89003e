"""Whole programs, from scene file to image file: lavaray against POV-Ray 3.7, the same scene, size and threads.

POV-Ray gets the same surfaces and lights, so it traces the same camera and shadow rays. But its highlights have the
light's colour, and no light of its own adds to the ambient colour where it is not blocked: it draws a plain version
of the scene with grey highlights and without that. How far that picture is from lavaray's of the plain version is
reported, to show that both do the same work.
"""

import json
import math
import os
import re
import shutil
import subprocess
import tempfile
import time
from pathlib import Path
from statistics import median

from bench_error.tables import number, table

BUNNY_SIDE = 1024  # pixels


class ProgramError(Exception):
    """A program has failed; the message says all that is known."""


def parse(text):
    """The blocks of a scene file in the plain form of the format: (kind, {key: words})."""
    blocks = []
    for line in text.splitlines()[1:]:
        key, colon, words = line.partition(":")
        if colon:
            blocks[-1][1][key.strip()] = words.split()
        elif line.strip():
            blocks.append((line.strip(), {}))
    return blocks


def image_size(lavaray, file):
    """Width and height of a scene's picture, according to the program."""
    with tempfile.TemporaryDirectory() as folder:
        facts = Path(folder) / "facts.json"
        found = subprocess.run([lavaray, file, "--check", "--json", facts], capture_output=True, text=True, check=False)
        if found.returncode != 0:
            raise ProgramError(found.stderr.strip())
        picture = json.loads(facts.read_text())["picture"]
    return picture["width"], picture["height"]


def bunny_scene(mesh):
    """The bunny, on a plane, between two lights."""
    points = [tuple(map(float, line.split()[1:4])) for line in mesh.read_text().splitlines() if line.startswith("v ")]
    low, high = ([pick(column) for column in zip(*points)] for pick in (min, max))
    size = max(h - l for l, h in zip(low, high))
    x, y, z = ((l + h) / 2 for l, h in zip(low, high))
    focal_length = (BUNNY_SIDE + 0.5) / (2 * math.tan(math.radians(22.5)))

    def at(dx, dy, dz):
        return f"{x + dx * size:.6f} {y + dy * size:.6f} {z + dz * size:.6f}"

    blocks = [
        f"camera\npos: {at(0, 0.05, 1.9)}\nfov: 45\nf: {focal_length:.6f}\na: 1",
        f"plane\nnor: 0 1 0\npos: 0 {low[1]:.6f} 0\namb: 0.05 0.05 0.05\ndif: 0.5 0.5 0.5\nspe: 0 0 0\nshi: 1",
        f"mesh\nfile: {mesh}\namb: 0.05 0.05 0.05\ndif: 0.8 0.7 0.6\nspe: 0.3 0.3 0.3\nshi: 20",
        *(f"light\npos: {place}\namb: 0 0 0\ndif: {v} {v} {v}\nspe: {v} {v} {v}"
          for place, v in ((at(-2, 3, 2.5), 0.6), (at(3, 2, 1.5), 0.3))),
    ]
    return "\n".join([str(len(blocks)), *blocks]) + "\n"


def plain(text):
    """The scene as POV-Ray can draw it; see above."""
    lines, kind = [], ""
    for line in text.splitlines():
        key, colon, words = line.partition(":")
        kind = kind if colon else line.strip()
        if kind == "light" and key.strip() == "amb":
            line = "amb: 0 0 0"
        elif kind != "light" and key.strip() == "spe":
            mean = sum(map(float, words.split())) / 3
            line = f"spe: {mean!r} {mean!r} {mean!r}"
        lines.append(line)
    return "\n".join(lines) + "\n"


def vector(words):
    return "<" + ",".join(repr(float(word)) for word in words) + ">"


def finish(block):
    """POV-Ray multiplies a material's ambient colour by its pigment, so that is divided out."""
    pigment = [max(float(word), 1e-6) for word in block["dif"]]
    ambient = [float(word) / p for word, p in zip(block["amb"], pigment)]
    shininess = max(float(block["shi"][0]), 1e-3)
    return (f"pigment {{ rgb {vector(pigment)} }} finish {{ ambient rgb {vector(ambient)} diffuse 1 "
            f"phong {block['spe'][0]} phong_size {shininess!r} }}")


def mesh2(obj):
    """For meshes without normals."""
    vertices, faces = [], []
    for line in obj.splitlines():
        words = line.split()
        if words and words[0] == "v":
            vertices.append(vector(words[1:4]))
        elif words and words[0] == "f":
            corners = [int(word.split("/")[0]) - 1 for word in words[1:]]
            faces += [f"<{corners[0]},{a},{b}>" for a, b in zip(corners[1:], corners[2:])]
    return (f"vertex_vectors {{ {len(vertices)}, {','.join(vertices)} }}\n"
            f"face_indices {{ {len(faces)}, {','.join(faces)} }}\n")


def pov_scene(text, folder, size):
    """A plain scene in POV-Ray's language; mesh files are relative to the folder, `size` is the picture's."""
    parts = ["#version 3.7;\nglobal_settings { assumed_gamma 1 }"]
    for kind, block in parse(text):
        if kind == "camera":
            width, height = size
            # Not mirrored: POV-Ray's own default looks along +z.
            parts.append(f"camera {{ location {vector(block['pos'])} direction <0,0,{-float(block['f'][0])!r}> "
                         f"right <{width},0,0> up <0,{height},0> }}")
        elif kind == "light":
            parts.append(f"light_source {{ {vector(block['pos'])} rgb {vector(block['dif'])} }}")
        elif kind == "plane":
            parts.append(f"plane {{ {vector(block['nor'])}, 0 translate {vector(block['pos'])} {finish(block)} }}")
        elif kind == "sphere":
            parts.append(f"sphere {{ {vector(block['pos'])}, {block['rad'][0]} {finish(block)} }}")
        elif kind == "triangle":
            corners = ", ".join(vector(block[corner]) for corner in ("v1", "v2", "v3"))
            parts.append(f"triangle {{ {corners} {finish(block)} }}")
        elif kind == "mesh":
            obj = (folder / " ".join(block["file"])).read_text()
            parts.append(f"mesh2 {{ {mesh2(obj)} {finish(block)} }}")
    return "\n".join(parts) + "\n"


def run(command, environment):
    """Processor and wall seconds of one process: wait4 counts one child, getrusage all that there ever were."""
    start = time.perf_counter()
    with open(os.devnull, "r+b") as nothing:
        child = subprocess.Popen(command, stdin=nothing, stdout=nothing, stderr=nothing,
                                 env={**os.environ, **environment})
        _, status, usage = os.wait4(child.pid, 0)
    child.returncode = os.waitstatus_to_exitcode(status)
    if child.returncode != 0:
        line = " ".join(str(word) for word in command)
        raise ProgramError(f"{line}\nfailed with exit code {child.returncode}; run it to see why")
    return usage.ru_utime + usage.ru_stime, time.perf_counter() - start


def scene_files(shared, out):
    """(name, scene file) pairs, and what is skipped, each with its reason."""
    files, skipped = [], []
    mesh, course = shared / "meshes/stanford-bunny.obj", shared / "course/scene5.txt"
    if mesh.exists():
        file = out / "bunny.txt"
        file.write_text(bunny_scene(mesh.resolve()))
        files.append(("bunny", file))
    else:
        skipped.append(f"bunny: {mesh} is not there")
    if course.exists():
        files.append(("scene5", course))
    else:
        skipped.append(f"scene5: {course} is not there")
    return files, skipped


def contestants(name, file, lavaray, povray, out, device, threads):
    """(name, command, environment, image) of each."""
    image = out / f"{name}-lavaray.ppm"
    command = [lavaray, file, "-q", "-o", image, *device]
    result = [("lavaray", command, {}, image),
              ("lavaray, cold shader cache", command, {"MESA_SHADER_CACHE_DISABLE": "true"}, image)]
    if povray:
        text = file.read_text()
        width, height = image_size(lavaray, file)
        pov, image = out / f"{name}.pov", out / f"{name}-povray.ppm"
        pov.write_text(pov_scene(plain(text), file.parent, (width, height)))
        # Its own defaults, except for threads, no anti-aliasing, no window, and values without gamma.
        command = [povray, f"+I{pov}", f"+O{image}", "+FP", f"+W{width}", f"+H{height}", f"+WT{threads}", "-A", "-D",
                   "-GA", "File_Gamma=1.0"]
        result.append(("povray", command, {}, image))
    return result


def difference(lavaray, diff, file, image, out, device):
    """Root-mean-square difference, 0..1, between POV-Ray's and lavaray's images of the plain scene."""
    scene, own = out / f"{file.stem}-plain.txt", out / f"{file.stem}-plain.ppm"
    scene.write_text(plain(file.read_text()))
    run([lavaray, scene, "-q", "-o", own, *device], {})
    text = subprocess.run([diff, image, own], capture_output=True, text=True, check=False).stdout
    found = re.search(r"RMSE +(\S+)", text)
    if not found:
        raise ProgramError(f"{diff} says nothing of the RMSE of {image} and {own}")
    return float(found.group(1))


def measure(lavaray, diff, shared, out, rounds, device):
    povray = shutil.which("povray")
    threads = len(os.sched_getaffinity(0))
    files, skipped = scene_files(shared, out)
    if not povray:
        skipped.append("POV-Ray: there is no povray (Debian's package povray)")
    results = {"threads": threads, "rounds": rounds, "skipped": skipped, "scenes": []}
    for name, file in files:
        runs = contestants(name, file, lavaray, povray, out, device, threads)
        times = {contestant[0]: {"cpu": [], "wall": []} for contestant in runs}
        for turn in range(rounds + 1):  # the first is not counted
            for contestant, command, environment, _ in runs:
                cpu, wall = run(command, environment)
                if turn > 0:
                    times[contestant]["cpu"].append(cpu)
                    times[contestant]["wall"].append(wall)
        rmse = difference(lavaray, diff, file, runs[-1][3], out, device) if povray else None
        results["scenes"].append({"name": name, "difference": rmse, "times": times})
    return results


def report(results):
    rows = []
    for scene in results["scenes"]:
        for name, times in scene["times"].items():
            rmse = number(scene["difference"]) if name == "povray" else None
            cells = [number(pick(times[clock])) for clock in ("cpu", "wall") for pick in (min, median)]
            rows.append((f"{scene['name']}: {name}", *cells, rmse))
    header = ("seconds, scene file to image file", "cpu min", "median", "wall min", "median", "RMSE of plain scene")
    title = f"Whole programs, {results['threads']} threads, {results['rounds']} rounds after one that is not counted"
    skipped = "".join(f"skipped {reason}\n" for reason in results["skipped"])
    return table(title, header, rows) + skipped
