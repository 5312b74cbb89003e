#!/usr/bin/python3
"""python_test.py PACKAGES PROGRAMS SCENES: the Python package in the folder PACKAGES as its users see it.

PROGRAMS holds lavaray, whose pictures are to be the same; SCENES the project's scenes.
"""

import importlib.util
import os
import re
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest
from pathlib import Path

import numpy

sys.dont_write_bytecode = True
PACKAGES, PROGRAMS, SCENES = (Path(argument).resolve() for argument in sys.argv[1:4])
sys.path.insert(0, str(PACKAGES))
import lavaray  # noqa: E402

BALL = """4
camera
pos: 0 2 10
fov: 40
f: 300
a: 1.5
sphere
pos: 0 1 0
rad: 1
amb: 0.8 0.2 0.1
dif: 0.8 0.2 0.1
spe: 0.5 0.5 0.5
shi: 30
plane
nor: 0 1 0
pos: 0 0 0
amb: 0.1 0.1 0.1
dif: 0.5 0.5 0.5
spe: 0 0 0
shi: 0
light
pos: 5 9 6
amb: 0.2 0.2 0.2
dif: 1 1 1
spe: 1 1 1
"""
RED = lavaray.Material((0.8, 0.2, 0.1), (0.8, 0.2, 0.1), (0.5, 0.5, 0.5), 30)
CAMERA = lavaray.Camera((0, 2, 10), 40, 300, 1.5)
LIGHT = lavaray.Light((5, 9, 6), (0.2, 0.2, 0.2))
TETRAHEDRON = numpy.array([[-1, 0, 1], [1, 0, 1], [0, 0, -1], [0, 2, 0]], dtype=float)
SIDES = numpy.array([[0, 1, 3], [1, 2, 3], [2, 0, 3], [0, 2, 1]])


class Pictures(unittest.TestCase):
    def test_are_those_of_the_program(self):
        with tempfile.TemporaryDirectory() as folder:
            for name, arguments, options in (
                ("showcase.txt", ["--width", "120"], {"width": 120}),
                ("extensions.txt", ["--width", "90", "--spp", "4", "--filter", "tent"],
                 {"width": 90, "spp": 4, "filter": "tent"}),
                ("torus.txt", ["--width", "100", "--crop", "20,10,60,50", "--view", "normal"],
                 {"width": 100, "crop": (20, 10, 60, 50), "view": "normal"}),
            ):
                file = Path(folder) / "program.pfm"
                subprocess.run([PROGRAMS / "lavaray", SCENES / name, "-q", "-o", file, *arguments], check=True)
                picture = lavaray.render(SCENES / name, **options)
                self.assertEqual(picture.dtype, numpy.float32)
                numpy.testing.assert_array_equal(picture, lavaray.read_image(file), name)

    def test_of_objects_are_those_of_the_text(self):
        scene = lavaray.Scene(CAMERA)
        grey = lavaray.Material((0.1, 0.1, 0.1), (0.5, 0.5, 0.5))
        scene.add(lavaray.Sphere((0, 1, 0), 1, RED), lavaray.Plane(material=grey), LIGHT)
        numpy.testing.assert_array_equal(lavaray.render(scene), lavaray.render(lavaray.Scene.parse(BALL)))

    def test_of_a_mesh_are_those_of_its_triangles(self):
        mesh = lavaray.Scene(CAMERA).add(lavaray.Mesh(TETRAHEDRON, SIDES, material=RED), LIGHT)
        triangles = lavaray.Scene(CAMERA).add(LIGHT)
        for side in SIDES:
            triangles.add(lavaray.Triangle(TETRAHEDRON[side], RED))
        picture = lavaray.render(mesh)
        self.assertGreater(picture.max(), 0.5)
        numpy.testing.assert_array_equal(picture, lavaray.render(triangles))

    def test_of_arrays_that_are_not_contiguous(self):
        wide = numpy.zeros((4, 6), dtype=numpy.float32)
        wide[:, ::2] = TETRAHEDRON
        view = lavaray.Mesh(wide[:, ::2], SIDES.astype(numpy.uint8)[::1], material=RED)
        plain = lavaray.Mesh(TETRAHEDRON, SIDES, material=RED)
        pictures = [lavaray.render(lavaray.Scene(CAMERA).add(mesh, LIGHT)) for mesh in (view, plain)]
        numpy.testing.assert_array_equal(*pictures)

    def test_tell_how_they_came_about(self):
        picture = lavaray.Renderer().render(lavaray.Scene.parse(BALL), spp=4, count_rays=True)
        height, width, _ = picture.image.shape
        self.assertEqual(picture.camera_rays, 4 * height * width)
        self.assertEqual(picture.samples_per_pixel, 4)
        self.assertEqual(picture.stop_reason, "finished")
        self.assertGreater(picture.shadow_rays, 0)

    def test_in_files_and_beside_each_other(self):
        picture = lavaray.render(lavaray.Scene.parse(BALL))
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "picture.pfm"
            lavaray.write_image(picture, file)
            numpy.testing.assert_array_equal(lavaray.read_image(file), picture)
        other = picture.copy()
        other[5, 7, 1] += 0.25
        difference = lavaray.compare(other, picture)
        self.assertEqual((difference.differing, difference.largest_at), (1, (7, 5)))
        self.assertAlmostEqual(difference.largest, 0.25, 6)
        self.assertEqual(lavaray.flip_map(other, picture).shape, picture.shape[:2])


class Errors(unittest.TestCase):
    def check(self, kind, words, function, *arguments, **options):
        with self.assertRaises(lavaray.Error) as raised:
            function(*arguments, **options)
        self.assertEqual(raised.exception.kind, kind)
        self.assertIn(words, str(raised.exception))
        return raised.exception

    def test_name_file_and_line(self):
        error = self.check("input", "exactly 3", lavaray.Scene.parse, BALL.replace("pos: 5 9 6", "pos: 5 9"), "ball")
        self.assertEqual((error.file, error.line), ("ball", 22))
        error = self.check("input", "cannot be read", lavaray.render, "missing.txt")
        self.assertEqual((error.file, error.line), ("missing.txt", None))

    def test_of_options(self):
        scene = lavaray.Scene.parse(BALL)
        self.check("usage", "allowed are color", lavaray.render, scene, view="colour")
        self.check("usage", "allowed is 1 to", lavaray.render, scene, spp=0)
        self.check("device", "no such", lavaray.Renderer("no such").render, scene)

    def test_of_objects(self):
        scene = lavaray.Scene()
        for faces in ([[0, 1]], [[0.0, 1.0, 2.0]], [[0, 1, 4]], [[0, 1, -1]], [0, 1, 2]):
            self.check("input", "a mesh's faces", scene.add, lavaray.Mesh(TETRAHEDRON, faces))
        self.check("input", "(n, 3) is needed", scene.add, lavaray.Mesh(TETRAHEDRON[:, :2], SIDES))
        self.check("input", "3 are needed", scene.add, lavaray.Triangle(TETRAHEDRON))
        self.check("input", "must be numbers", scene.add, lavaray.Sphere(("a", "b", "c")))
        self.check("input", "allowed are Plane", scene.add, RED)
        self.check("usage", "(height, width, 3)", lavaray.write_image, numpy.zeros((3, 3)), "x.png")


# Long enough to be stopped in.
LONG = {"spp": 1 << 20, "width": 400}


class Running(unittest.TestCase):
    def test_progress_stops_it(self):
        shares = []
        picture = lavaray.Renderer().render(lavaray.Scene.parse(BALL), progress=lambda share: shares.append(share), **LONG)
        self.assertEqual(picture.stop_reason, "interrupted")
        self.assertTrue(shares and 0 <= shares[0] <= 1)

    def test_what_progress_raises_arrives(self):
        def refuse(share):
            raise KeyError(share)

        with self.assertRaises(KeyError):
            lavaray.render(lavaray.Scene.parse(BALL), progress=refuse, **LONG)

    def test_control_c(self):
        threading.Timer(0.5, os.kill, (os.getpid(), signal.SIGINT)).start()
        begin = time.monotonic()
        with self.assertRaises(KeyboardInterrupt):
            lavaray.render(lavaray.Scene.parse(BALL), **LONG)
        self.assertGreater(time.monotonic() - begin, 0.4)

    def test_other_threads_run_meanwhile(self):
        ticks = []
        stop = threading.Event()

        def tick():
            while not stop.wait(0.01):
                ticks.append(1)

        thread = threading.Thread(target=tick)
        thread.start()
        lavaray.render(lavaray.Scene.parse(BALL), time_limit=1.0, **LONG)
        stop.set()
        thread.join()
        self.assertGreater(len(ticks), 10)

    def test_threads_share_a_renderer(self):
        renderer = lavaray.Renderer()
        scene = lavaray.Scene.read(SCENES / "torus.txt")
        expected = renderer.render(scene, width=100).image
        pictures = [None] * 4

        def render(index):
            pictures[index] = renderer.render(scene, width=100).image

        threads = [threading.Thread(target=render, args=(index,)) for index in range(len(pictures))]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for picture in pictures:
            numpy.testing.assert_array_equal(picture, expected)


class Shaders(unittest.TestCase):
    TEXT = ('#version 460\n#extension GL_GOOGLE_include_directive : require\n#include "pixel.glsl"\n'
            "void main() {\n  const Pixel pixel = thisPixel();\n  if (pixel.isThere) setPixel(pixel, VALUE);\n}\n")

    def test_run_and_are_taken_up_anew(self):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "own.comp"
            file.write_text(self.TEXT.replace("VALUE", "vec3(pixel.position, -1.0)"))
            shader = lavaray.Shader(file)
            self.assertIn(file, shader.files)
            renderer = lavaray.Renderer()
            scene = lavaray.Scene.parse(BALL)
            values = renderer.run(shader, scene, width=60, crop=(10, 20, 30, 25))
            self.assertEqual(values.shape, (5, 20, 3))
            y, x = numpy.mgrid[20:25, 10:30]
            numpy.testing.assert_array_equal(values, numpy.stack([x, y, -numpy.ones_like(x)], axis=-1))
            file.write_text(self.TEXT.replace("VALUE", "nope"))
            with self.assertRaises(lavaray.Error) as caught:
                shader.reload()
            self.assertEqual((caught.exception.kind, caught.exception.file, caught.exception.line), ("input", str(file), 6))
            numpy.testing.assert_array_equal(renderer.run(shader, scene, width=60)[0, 0], [0, 0, -1])
            file.write_text(self.TEXT.replace("VALUE", "vec3(constants.seed)"))
            self.assertTrue(shader.reload())
            self.assertEqual(renderer.run(shader, scene, width=60, seed=7).min(), 7)
            self.assertEqual(shader.take_warnings(), [])


class Document(unittest.TestCase):
    def test_program_of_the_shaders_runs(self):
        text = (SCENES.parent / "docs" / "shaders.md").read_text()
        (program,) = re.findall(r"^```python\n(.*?)^```", text, re.DOTALL | re.MULTILINE)
        (shader,) = re.findall(r"^```glsl\n(.*?)^```", text, re.DOTALL | re.MULTILINE)
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "scenes").symlink_to(SCENES)
            (Path(folder) / "heat.comp").write_text(shader)
            environment = {**os.environ, "PYTHONPATH": str(PACKAGES)}
            subprocess.run([sys.executable, "-c", program], cwd=folder, env=environment, check=True)
            picture = lavaray.read_image(Path(folder) / "heat.png")
        self.assertEqual(picture.shape[1], 300)
        self.assertEqual(picture.max(), 1)
        self.assertGreater(len(numpy.unique(picture.reshape(-1, 3), axis=0)), 20)

    def test_programs_run(self):
        text = (SCENES.parent / "docs" / "python.md").read_text()
        programs = re.findall(r"^```python\n(.*?)^```", text, re.DOTALL | re.MULTILINE)
        self.assertEqual(len(programs), 3)
        if not importlib.util.find_spec("matplotlib"):
            print("skipped: matplotlib is missing, for the program that plots")
            programs = [program for program in programs if "matplotlib" not in program]
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "scenes").symlink_to(SCENES)
            environment = {**os.environ, "PYTHONPATH": str(PACKAGES), "MPLBACKEND": "Agg"}
            for program in programs:
                subprocess.run([sys.executable, "-c", program], cwd=folder, env=environment, check=True)
                for name in re.findall(r'"(\w+\.png)"', program):
                    self.assertGreater((Path(folder) / name).stat().st_size, 1000, name)


class Types(unittest.TestCase):
    @unittest.skipUnless(importlib.util.find_spec("mypy"), "mypy is missing")
    def test_pass_mypy(self):
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "use.py").write_text(
                "import lavaray\n"
                "scene = lavaray.Scene(lavaray.Camera((0, 0, 5))).add(lavaray.Sphere())\n"
                "picture: lavaray.Picture = lavaray.Renderer().render(scene, spp=4)\n"
                "print(picture.image.shape, lavaray.compare(picture.image, picture.image).rmse)\n")
            run = subprocess.run([sys.executable, "-m", "mypy", "--strict", "--cache-dir", folder, "use.py",
                                  str(PACKAGES / "lavaray")], cwd=folder, env={**os.environ, "MYPYPATH": str(PACKAGES)},
                                 capture_output=True, text=True)
            self.assertEqual(run.returncode, 0, run.stdout + run.stderr)

    def test_everything_is_explained(self):
        for name in lavaray.__all__:
            if not name.startswith("_"):
                self.assertTrue(getattr(lavaray, name).__doc__, name)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
