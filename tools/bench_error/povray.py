"""POV-Ray as a peer: the benchmark's scenes in its scene language, and its runs.

A scene is a peer only where POV-Ray draws the very formula of the scene format. What stands in the way:

- Ambient light of lamps: POV-Ray has no term that the lamp's being blocked decides alone, without the normal.
- Colours above 1: POV-Ray 3.7 takes the mean of a pixel's samples before it clamps, lavaray after.
- Lamps with a radius: a round area light is another formula, the mean visibility times the mean shading, of points
  that lie denser along the diagonals. With 33 x 33 points an image of `penumbra`, one ray through each pixel's
  centre, is 0.0017 (RMSE) from lavaray's, where point lights on anything but a mesh make it 0.0002 at most.
- Highlights of another colour than the lamp: phong is one number.

For the first two a variant of the scene is drawn by both programs. POV-Ray turns interpolated normals that are seen
from behind, lavaray only those of faces that are, so that on a mesh's silhouettes some pixels differ.
"""

import dataclasses
import os
import shutil
import subprocess
from dataclasses import dataclass

from bench_error.experiment import PEERS, Contestant
from bench_error.images import read_ppm, rmse
from bench_error.running import ProgramError, Run, timed

# Thresholds (+A) and depths (+R), chosen from a grid of both for the smallest error at equal time. Method 1 takes R x R
# samples in a pixel, method 2 up to 2^(R-1) + 1 on a side; depth 1 is no more than one sample a pixel. Threshold 0
# refines every pixel: what lies between the first samples is found by nothing else.
LADDERS = {
    "povray-am1": ((0.3, 1), (0.3, 2), (0.1, 3), (0.03, 4), (0.03, 6), (0.03, 9), (0.0, 3), (0.0, 5), (0.0, 9)),
    "povray-am2": ((0.3, 1), (0.3, 2), (0.1, 3), (0.03, 3), (0.03, 4), (0.01, 4), (0.01, 5), (0.0, 3), (0.0, 4),
                   (0.0, 5)),
}
QUICK_DEPTHS = {"povray-am1": 9, "povray-am2": 4}

# Jitter only added error (the grid above, with and without). Antialias_Gamma 1: the default, 2.5, compares samples
# as a screen shows them, lavaray's error is of the values themselves. Written without gamma, 16 bits a channel.
OPTIONS = ("-J", "+AG1", "+FP16", "File_Gamma=1", "-D", "-P", "-V", "-C", "+Q9")

# As lavaray: a ray is dropped below this weight, and at the depth of its default --max-depth (8 mirrors).
GLOBALS = "#version 3.7;\nglobal_settings { assumed_gamma 1 max_trace_level 9 adc_bailout 1e-4 }"

DIM = 0.7  # of the lamps in a variant: then no sample of `mesh`, the brightest, is above 1
EQUAL = 0.01  # RMSE of one ray through each pixel's centre; what is above is another picture
PIGMENT_FLOOR = 1e-6


class NotEqual(Exception):
    """POV-Ray cannot show the scene as the scene format demands; the message says why."""


@dataclass(frozen=True)
class Peers:
    files: dict  # scene name -> .pov file
    differences: dict  # scene name -> RMSE between the two programs' images with one ray a pixel
    left_out: dict  # scene name -> why


class PovRay:
    """Runs it with as many threads as lavapipe has. POV-Ray's front end sleeps for about 0.6 s, which is no processor
    time."""

    def __init__(self, path, size):
        self.path = os.path.abspath(path)  # it runs in other folders
        self.threads = os.environ.get("LP_NUM_THREADS") or os.cpu_count()
        self.size = [f"+W{size[0]}", f"+H{size[1]}", f"+WT{self.threads}"]
        said = subprocess.run([path, "--version"], capture_output=True, text=True, check=False)
        lines = (said.stdout + said.stderr).splitlines()
        self.version = next((line.strip() for line in lines if line.startswith("POV-Ray")), "POV-Ray")

    def render(self, file, options):
        """Runs in the scene's folder, where POV-Ray's rules let it write, and which is also its home, so that no
        settings of the user apply."""
        output = file.with_suffix(".ppm")
        output.unlink(missing_ok=True)
        command = [self.path, f"+I{file.name}", f"+O{output.name}", *self.size, *OPTIONS, *options]
        cpu, wall = timed(command, folder=file.parent, environment={"HOME": str(file.parent.resolve())})
        if not output.exists():
            raise ProgramError(f"{self.path} ended well, but wrote no {output}")
        return Run(read_ppm(output), cpu, wall)


def find(name, size):
    """None if it is not installed."""
    path = shutil.which(name)
    return PovRay(path, size) if path else None


def contestants(quick):
    return [Contestant(method, f"+A{threshold} +R{depth}") for method in PEERS
            for threshold, depth in LADDERS[method] if not quick or depth <= QUICK_DEPTHS[method]]


def peer_scenes(scenes, size):
    """The scenes, or variants of them, of pictures of this size, that both can show, with their texts for POV-Ray, [(scene, text)]; and
    name -> reason of the others."""
    found, left_out = [], {}
    for scene in scenes:
        for candidate in (scene, variant(scene)):
            try:
                found.append((candidate, scene_text(candidate, size)))
                left_out.pop(scene.name, None)
                break
            except NotEqual as reason:
                left_out[scene.name] = str(reason)
    return found, left_out


def variant(scene):
    """The scene with lamps that have no ambient light and that are dimmed, so that nothing is clamped."""
    blocks = [scene.text.split("\n", 1)[0]]
    for kind, keys in parse(scene.text):
        if kind == "light":
            dimmed = {key: [str(DIM * float(word)) for word in keys[key]] for key in ("dif", "spe")}
            keys = {**keys, "amb": ["0.0"] * 3, **dimmed}
        blocks.append("\n".join([kind, *(f"{key}: {' '.join(words)}" for key, words in keys.items())]))
    return dataclasses.replace(scene, name=f"{scene.name}-peer", hard=f"{scene.name} as POV-Ray can show it",
                               text="\n".join(blocks) + "\n", variant=True)


def prepare(povray, program, texts, files, left_out, progress):
    """Writes the .pov files beside the scene `files`, and compares the programs' images of one ray a pixel, so that
    what is not the same picture is no peer. `texts` as of peer_scenes."""
    peers = Peers({}, {}, dict(left_out))
    for scene, text in texts:
        name = scene.name
        progress(f"POV-Ray's image of {name}")
        file = files[name].with_suffix(".pov")
        file.write_text(text)
        difference = rmse(povray.render(file, ["-A"]).image, program.render(files[name], ["--spp", "1"]).image)
        if difference > EQUAL:
            peers.left_out[name] = f"the images differ by {difference:.2g} (RMSE of one ray a pixel)"
        else:
            peers.files[name] = file
            peers.differences[name] = difference
    return peers


def parse(text):
    """(kind, {key: words}) of each block of a scene of the benchmark."""
    blocks = []
    for line in text.splitlines()[1:]:
        key, colon, words = line.partition(":")
        if colon:
            blocks[-1][1][key] = words.split()
        else:
            blocks.append((line, {}))
    return blocks


def scene_text(scene, size):
    """The scene, whose picture has this size, in POV-Ray's language. Raises NotEqual."""
    writers = {"light": light, "plane": plane, "sphere": sphere, "triangle": triangle}
    parts = [GLOBALS]
    for kind, keys in parse(scene.text):
        if kind == "mesh":
            parts.append(f"mesh2 {{ {mesh(scene.meshes[keys['file'][0]])}{texture(keys)} }}")
        elif kind == "camera":
            parts.append(camera(keys, size))
        else:
            parts.append(writers[kind](keys))
    return "\n".join(parts) + "\n"


def vector(values):
    return f"<{','.join(str(value) for value in values)}>"


def camera(keys, size):
    """With explicit vectors, left- and right-handed coordinates are the same."""
    width, height = size
    return (f"camera {{ location {vector(keys['pos'])} direction <0,0,{-float(keys['f'][0])}> right <{width},0,0> "
            f"up <0,{height},0> }}")


def light(keys):
    if "rad" in keys:
        raise NotEqual("lamps with a radius: POV-Ray's area lights are another formula")
    if any(float(word) for word in keys["amb"]):
        raise NotEqual("ambient light of lamps")
    if keys["dif"] != keys["spe"]:
        raise NotEqual("lamps with a colour of their own for highlights")
    return f"light_source {{ {vector(keys['pos'])} rgb {vector(keys['dif'])} }}"


def plane(keys):
    return f"plane {{ {vector(keys['nor'])}, 0 translate {vector(keys['pos'])} {texture(keys)} }}"


def sphere(keys):
    return f"sphere {{ {vector(keys['pos'])}, {keys['rad'][0]} {texture(keys)} }}"


def triangle(keys):
    corners = ", ".join(vector(keys[key]) for key in ("v1", "v2", "v3"))
    return f"triangle {{ {corners} {texture(keys)} }}"


def texture(keys):
    """The pigment multiplies ambient and diffuse light, so that the ambient colour is divided by it and it must not
    be black; the error of that is below what an image can hold. A finish without diffuse light and without phong
    spares POV-Ray the shadow rays."""
    ambient, diffuse, highlight = ([float(word) for word in keys[key]] for key in ("amb", "dif", "spe"))
    if len(set(highlight)) > 1:
        raise NotEqual("coloured highlights")
    pigment = [max(channel, PIGMENT_FLOOR) for channel in diffuse]
    finish = [f"ambient rgb {vector(a / p for a, p in zip(ambient, pigment))}", f"diffuse {1 if any(diffuse) else 0}"]
    if highlight[0] > 0:
        finish.append(f"phong {highlight[0]} phong_size {keys['shi'][0]}")
    if any(float(word) for word in keys.get("ref", ())):
        finish.append(f"reflection {{ rgb {vector(keys['ref'])} }}")
    return f"pigment {{ rgb {vector(pigment)} }} finish {{ {' '.join(finish)} }}"


def mesh(obj):
    """The lists of a mesh2. Faces are convex, so that fans are lavaray's triangles, too."""
    vertices, normals, corners = [], [], []
    for line in obj.splitlines():
        kind, *words = line.split() or [""]
        if kind == "v":
            vertices.append(vector(words[:3]))
        elif kind == "vn":
            normals.append(vector(words))
        elif kind == "f":
            face = [[int(index) - 1 if index else None for index in word.split("/")] for word in words]
            corners += [(face[0], b, c) for b, c in zip(face[1:], face[2:])]
    lists = [("vertex_vectors", vertices), ("face_indices", [vector(c[0] for c in t) for t in corners])]
    if all(len(corner) == 3 for t in corners for corner in t):
        lists.insert(1, ("normal_vectors", normals))
        lists.append(("normal_indices", [vector(c[2] for c in t) for t in corners]))
    return "".join(f"{name} {{ {len(items)}, {', '.join(items)} }}\n" for name, items in lists)
