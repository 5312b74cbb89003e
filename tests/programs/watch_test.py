#!/usr/bin/env python3
"""watch_test.py PROGRAMS SCENES SHADERS WORK: `lavaray --watch` with real edits of the scene, its mesh and the shaders.

Edits are made in place and by rename, good ones and broken ones. The process must stay alive, keep the last good
picture where an edit is broken, tell of that once as `file:line: message`, make nothing anew that did not change,
and not grow. LAVARAY_STRESS=full makes 100 random edits in place of 20.
"""

import os
import pathlib
import random
import re
import resource
import shutil
import signal
import subprocess
import sys
import time

sys.dont_write_bytecode = True  # leaves no __pycache__ in the checkout
sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / 'support'))
from checks import demand, fail, finish, make_anew

SECONDS = 60  # that anything may take on a busy machine


class Watched:
    """A lavaray under --watch, and what it has said."""

    def __init__(self, program, arguments, folder):
        self.log = folder / 'log'
        self.stream = open(self.log, 'w')
        self.process = subprocess.Popen([program, *arguments, '--watch'], cwd=folder, stderr=self.stream)
        self.position = 0

    def said(self):
        text = self.log.read_text()[self.position:]
        return text[:text.rfind('\n') + 1]

    def wait_for(self, pattern):
        """Waits for a line that matches, and returns all that was said up to it since the last wait."""
        end = time.monotonic() + SECONDS
        while time.monotonic() < end:
            if self.process.poll() is not None:
                fail(f'it ended with {self.process.returncode} after\n{self.log.read_text()}')
            text = self.said()
            found = re.search(pattern + r'.*\n', text)
            if found:
                self.position += found.end()
                return text[:found.end()]
            time.sleep(0.01)
        fail(f'nothing like {pattern!r} in\n{self.said()}')

    def memory(self):
        return status_number(self.process.pid, 'VmRSS') / 1024

    def compiler(self):
        """The process that compiles shaders."""
        found = [process for process in processes() if status_number(process, 'PPid') == self.process.pid]
        demand(len(found) == 1, f'one process for compiling: {found}')
        return found[0]

    def stop(self):
        """Ctrl-C, of which all processes of a terminal hear."""
        compiler = self.compiler()
        for process in (compiler, self.process.pid):
            os.kill(process, signal.SIGINT)
        code = self.process.wait(SECONDS)
        demand(compiler not in processes(), 'no process is left')
        return code


def processes():
    return [int(folder.name) for folder in pathlib.Path('/proc').iterdir() if folder.name.isdigit()]


def status_number(process, entry):
    """Of /proc/PROCESS/status; 0 where the process has ended."""
    try:
        status = pathlib.Path(f'/proc/{process}/status').read_text()
    except (FileNotFoundError, ProcessLookupError):
        return 0
    found = re.search(rf'^{entry}:\s+(\d+)', status, re.M)
    return int(found.group(1)) if found else 0


def edit_in_place(file, text):
    file.write_text(text)


def edit_by_rename(file, text):
    temporary = file.with_name('.' + file.name + '.swp')
    temporary.write_text(text)
    temporary.rename(file)


EDITS = [edit_in_place, edit_by_rename]


def main():
    programs, scenes, shaders, work = (pathlib.Path(argument).resolve() for argument in sys.argv[1:])
    make_anew(work)
    for name in ('torus.txt', 'torus.obj'):
        shutil.copy(scenes / name, work)
    shutil.copytree(shaders, work / 'shaders')
    shutil.copytree(work, work / 'slow')
    time.sleep(0.5)  # Files that change while the program starts count as changed, and it draws a second picture.
    scene, mesh, shader = work / 'torus.txt', work / 'torus.obj', work / 'shaders' / 'render.comp'
    picture = work / 'torus.ppm'
    lavaray = Watched(programs / 'lavaray', ['torus.txt', '-o', 'torus.ppm', '--width', '120', '--shaders', 'shaders'],
                      work)
    lavaray.wait_for('wrote torus.ppm: read scene .*, compile shaders .*, render')
    original = picture.read_bytes()
    scene_text, mesh_text, shader_text = scene.read_text(), mesh.read_text(), shader.read_text()

    # The worked example of docs/command-line.md: another background.
    blue = shader_text.replace('vec3 color = path.color[r];', 'vec3 color = path.color[r] + vec3(0.0, 0.0, 0.25);')
    demand(blue != shader_text, 'render.comp has the line that the document edits')
    for edit in EDITS:
        edit(shader, blue)
        said = lavaray.wait_for('wrote torus.ppm')
        demand('changed: shaders/render.comp' in said, f'the changed file is named: {said}')
        demand('read scene' not in said, f'a shader edit reads no scene: {said}')
        demand(picture.read_bytes().split(b'\n', 3)[3][:3] == bytes([0, 0, 63]), 'the sky is blue')
        edit(shader, shader_text)
        lavaray.wait_for('wrote torus.ppm')
        demand(picture.read_bytes() == original, 'the shader is as before, and so is the picture')

        # An include that does not compile: the picture stays, and the include is named, once.
        include = work / 'shaders' / 'shade.glsl'
        include_text = include.read_text()
        edit(include, include_text + '\nfloat broken( { return 1.0; }\n')
        line = include_text.count('\n') + 2
        said = lavaray.wait_for(rf'shaders/shade.glsl:{line}: ')
        time.sleep(0.3)
        said += lavaray.said()
        demand(said.count('shade.glsl:') == 1, f'it is said once: {said}')
        demand(picture.read_bytes() == original, 'a broken shader leaves the picture alone')
        edit(include, include_text)
        lavaray.wait_for('wrote torus.ppm')

        # A scene that is wrong, then one with another light: nothing but that is made anew.
        edit(scene, scene_text.replace('fov:', 'fow:'))
        lavaray.wait_for(r'torus.txt:\d+: ')
        demand(picture.read_bytes() == original, 'a broken scene leaves the picture alone')
        edit(scene, re.sub(r'dif:.*', 'dif: 0.1 0.9 0.1', scene_text))
        said = lavaray.wait_for('wrote torus.ppm')
        demand('compile shaders' not in said, f'a scene edit compiles no shader: {said}')
        demand(picture.read_bytes() != original, 'another light, another picture')
        edit(scene, scene_text)
        lavaray.wait_for('wrote torus.ppm')
        demand(picture.read_bytes() == original, 'the scene is as before, and so is the picture')

        edit(mesh, mesh_text.replace('f ', 'f 0/', 1))
        lavaray.wait_for(r'torus.obj:\d+: ')
        edit(mesh, re.sub(r'^v (\S+)', lambda found: f'v {float(found.group(1)) / 2}', mesh_text, flags=re.M))
        said = lavaray.wait_for('wrote torus.ppm')
        demand('changed: torus.obj' in said, f'the changed mesh is named: {said}')
        demand(picture.read_bytes() != original, 'another mesh, another picture')
        edit(mesh, mesh_text)
        lavaray.wait_for('wrote torus.ppm')
        demand(picture.read_bytes() == original, 'the mesh is as before, and so is the picture')

    # A scene of few primitives has a shader of its own, compiled when the scene becomes one.
    few = re.sub(r'mesh\nfile: .*', 'sphere\npos: 0 0 -5\nrad: 1', scene_text)
    demand(few != scene_text, 'the scene has a mesh to replace')
    edit_in_place(scene, few)
    said = lavaray.wait_for('wrote torus.ppm')
    demand('compile shaders' in said, f'another kind of scene, another shader: {said}')
    fresh = subprocess.run([programs / 'lavaray', 'torus.txt', '-o', '-', '--width', '120', '-q'], cwd=work,
                           stdout=subprocess.PIPE, check=True)
    demand(picture.read_bytes() == fresh.stdout, 'the picture is that of the built-in shader')
    edit_in_place(scene, scene_text)
    lavaray.wait_for('wrote torus.ppm')
    demand(picture.read_bytes() == original, 'the mesh is back, and so is the picture')

    # A good edit, and before its picture is done a broken one: the good one still gets its picture.
    slow = Watched(programs / 'lavaray', ['torus.txt', '-o', 'slow.ppm', '--width', '120', '--spp', '1500', '--shaders',
                                          'shaders'], work / 'slow')
    slow.wait_for('wrote slow.ppm')
    before = (work / 'slow' / 'slow.ppm').read_bytes()
    edit_in_place(work / 'slow' / 'torus.txt', re.sub(r'dif:.*', 'dif: 0.1 0.1 0.9', scene_text))
    slow.wait_for('changed: torus.txt')
    time.sleep(0.1)
    edit_in_place(work / 'slow' / 'shaders' / 'render.comp', shader_text + 'broken(')
    slow.wait_for('shaders/render.comp:')
    slow.wait_for('wrote slow.ppm')
    demand((work / 'slow' / 'slow.ppm').read_bytes() != before, 'the good edit is in the picture')
    code = slow.stop()
    demand(code == 0, f'Ctrl-C ends it cleanly, not with {code}')

    # An interface that is not the program's is refused.
    interface = work / 'shaders' / 'interface.h'
    interface_text = interface.read_text()
    edit_in_place(interface, interface_text.replace('kBindingLights = 5u', 'kBindingLights = 6u'))
    lavaray.wait_for(r'interface.h:\d+: ')
    edit_in_place(interface, interface_text)
    lavaray.wait_for('wrote torus.ppm')

    # A compiler that ends in the middle of its work, here for want of memory. (A sanitizer needs more than any limit
    # leaves.)
    compiler = lavaray.compiler()
    kibibytes = status_number(compiler, 'VmSize')
    if kibibytes < 1 << 30:
        before = resource.prlimit(compiler, resource.RLIMIT_AS)
        resource.prlimit(compiler, resource.RLIMIT_AS, ((kibibytes + 1024) * 1024, before[1]))
        line = 'vec3 color = path.color[r];'
        edit_in_place(shader, shader_text.replace(line, line + ' color.x += sin(color.y * 1.5 + 2.0);' * 30000))
        lavaray.wait_for(r'lavaray: shaders/render.comp: the shader compiler ended in the middle of it \(')
        demand(picture.read_bytes() == original, 'a compiler that ends leaves the picture alone')
        resource.prlimit(compiler, resource.RLIMIT_AS, before)
        edit_in_place(shader, shader_text + '\n')
        lavaray.wait_for('wrote torus.ppm')
        demand(picture.read_bytes() == original, 'the next edit is compiled as ever')
        edit_in_place(shader, shader_text)
        lavaray.wait_for('wrote torus.ppm')

    # Edits at random, each followed by a good one.
    count = 100 if os.environ.get('LAVARAY_STRESS') == 'full' else 20
    chance = random.Random(1)
    files = sorted((work / 'shaders').glob('*.glsl')) + [shader, scene, mesh]
    begin = lavaray.memory()
    for i in range(count):
        file = chance.choice(files)
        text = file.read_text()
        place = chance.randrange(len(text))
        length = chance.randrange(1, 20)
        junk = ''.join(chance.choice('{}();x0.,\n#/*') for _ in range(chance.randrange(0, 8)))
        chance.choice(EDITS)(file, text[:place] + junk + text[place + length:])
        time.sleep(chance.uniform(0.0, 0.4))
        chance.choice(EDITS)(file, text)
        # The last thing that it says is that the good state is drawn, even if the broken one was never noticed.
        lavaray.wait_for('wrote torus.ppm')
        end = time.monotonic() + SECONDS
        while picture.read_bytes() != original and time.monotonic() < end:
            time.sleep(0.05)
        demand(picture.read_bytes() == original, f'after edit {i} of {file.name} the picture is the good one')
        time.sleep(0.3)
        lavaray.position += len(lavaray.said())
        # The first pipelines that differ from the program's make the driver take some 20 MiB, once.
        if i + 1 == count // 2:
            begin = lavaray.memory()
    growth = lavaray.memory() - begin
    print(f'figure: {count} random edits: alive, memory grew by {growth:.1f} MiB in the second half')
    demand(growth < 8, f'memory grew by {growth} MiB')
    # One more, after whose picture there is nothing left to draw, so that Ctrl-C ends no render.
    edit_in_place(scene, scene_text + '\n')
    lavaray.wait_for(r'changed: torus.txt(?s:.*?)wrote torus.ppm')
    code = lavaray.stop()
    demand(code == 0, f'Ctrl-C ends it cleanly, not with {code}')
    finish()


main()
