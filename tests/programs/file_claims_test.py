#!/usr/bin/env python3
"""file_claims_test.py PROGRAMS SCENES SHADERS WORK: no program ever writes a file that it reads.

Each program, each option that names a file to write, against each file that is read, by each way to name a file: its
own name, another path, a symbolic link, one of several, a hard link. All are refused with exit code 2, the message has
both names, and every file has the bytes that it had.
"""

import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import time

sys.dont_write_bytecode = True  # leaves no __pycache__ in the checkout
sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / 'support'))
from checks import demand, finish, make_anew

SECONDS = 60  # that anything may take on a busy machine

programs, scenes, shaders, work = (pathlib.Path(argument).resolve() for argument in sys.argv[1:])


def run(*command, **options):
    return subprocess.run([str(word) for word in command], cwd=work, capture_output=True, text=True, **options)


def contents():
    return {file: file.read_bytes() for file in work.rglob('*') if file.is_file()}


def other_names(name):
    """Other names of the file, of which some end as a picture or film must."""
    ending = pathlib.Path(name).suffix
    links = work / 'links'
    shutil.rmtree(links, ignore_errors=True)
    links.mkdir()
    (links / f'symbolic{ending}').symlink_to(work / name)
    (links / f'second{ending}').symlink_to(f'symbolic{ending}')
    (links / 'folder').symlink_to((work / name).parent)
    os.link(work / name, links / f'hard{ending}')
    return [name, f'./{name}', f'links/../{name}', work / name, f'links/symbolic{ending}', f'links/second{ending}',
            f'links/folder/{pathlib.Path(name).name}', f'links/hard{ending}']


def refused(what, read, command, option):
    """Writing to `read` by that option of the command."""
    for name in other_names(read):
        before = contents()
        found = run(*command, option, name)
        demand(found.returncode == 2, f'{what} as {name}: exit code {found.returncode}, {found.stderr}')
        demand(re.search(rf'{re.escape(str(name))} would replace .*{re.escape(read)}', found.stderr),
              f'{what}: both names are told: {found.stderr}')
        demand(contents() == before, f'{what}: nothing has changed')


def try_all():
    lavaray, diff, merge = (programs / name for name in ('lavaray', 'lavaray-diff', 'lavaray-merge'))
    # A scene and a mesh may be called anything, and so may an include.
    mesh_scene = (scenes / 'torus.txt').read_text().replace('torus.obj', 'mesh.ppm')
    shutil.copy(scenes / 'torus.obj', work / 'mesh.ppm')
    shutil.copytree(shaders, work / 'shaders')
    for name in ('scene.ppm', 'scene.film'):
        (work / name).write_text(mesh_scene)
    small = ['--width', '16']
    for name in ('kept.film', 'part.png', 'part.bmp', 'part.pfm', 'part.ppm'):
        demand(run(lavaray, 'scene.ppm', *small, '-o', name).returncode == 0, f'{name} is made')
    render = [lavaray, 'scene.ppm', *small]
    with_shaders = [*render, '--shaders', 'shaders', '-o', 'free.png']
    demand(run(*with_shaders).returncode == 0, 'other names are free')

    refused('the scene', 'scene.ppm', render, '--output')
    refused('the mesh', 'mesh.ppm', render, '-o')
    refused('the scene for a film', 'scene.film', [lavaray, 'scene.film', *small], '-o')
    for option in ('--json', '--checkpoint'):
        for read in ('scene.ppm', 'mesh.ppm'):
            refused(f'{option} {read}', read, [*render, '-o', 'free.png'], option)
    for read in ('shaders/render.comp', 'shaders/shade.glsl'):
        refused(f'the shader {read}', read, with_shaders, '--json')
    refused('the JSON of --check', 'scene.ppm', [lavaray, 'scene.ppm', '--check'], '--json')
    refused('the JSON of --check', 'mesh.ppm', [lavaray, 'scene.ppm', '--check'], '--json')
    resume = [lavaray, 'scene.ppm', *small, '--resume', 'kept.film']
    refused('the film', 'kept.film', resume, '-o')
    refused('the film', 'kept.film', [*resume, '-o', 'free.png'], '--json')
    refused('the scene while resuming', 'scene.ppm', [*resume, '-o', 'free.png'], '--checkpoint')
    found = run(*resume, '-o', 'free.png', '--checkpoint', './kept.film')
    demand(found.returncode == 0, f'a checkpoint is resumed into itself: {found.stderr}')
    for name in ('part.png', 'part.bmp', 'part.ppm', 'part.pfm'):
        refused('an image', name, [diff, name, 'part.png'], '-o')
        refused('a reference', name, [diff, 'part.png', name], '-o')
        for option in ('--report', '--json'):
            refused(f'an image by {option}', name, [diff, name, 'part.png'], option)
    shutil.copy(work / 'kept.film', work / 'film.png')
    refused('a part', 'film.png', [merge, 'film.png'], '-o')

    # By a default name, and by the shell.
    shutil.copy(work / 'scene.ppm', work / 'default.bmp')
    before = contents()
    for command in ([lavaray, 'default.bmp'], ['sh', '-c', f'{lavaray} scene.ppm --width 16 -o - >>scene.ppm']):
        found = run(*command)
        demand(found.returncode == 2 and 'which is read' in found.stderr, f'{command}: {found}')
        demand(contents() == before, f'{command}: nothing has changed')


def try_two_outputs():
    lavaray = programs / 'lavaray'
    (work / 'there.ppm').write_text('old')
    (work / 'way').symlink_to(work)
    (work / 'soon.json').symlink_to('new.ppm')
    before = contents()
    for first, option, second in (('new.ppm', '--json', 'way/new.ppm'), ('new.ppm', '--json', 'soon.json'),
                                  ('new.ppm', '--checkpoint', './new.ppm'), ('there.ppm', '--json', 'way/there.ppm'),
                                  ('new.film', '--checkpoint', 'new.film')):
        found = run(lavaray, 'scene.ppm', '-o', first, option, second)
        demand(found.returncode == 2 and f'--output {first} and {option} {second} are the same file' in found.stderr,
              f'{first} and {second}: {found}')
        demand(contents() == before, f'{first} and {second}: nothing has changed')
    for option in ('--json', '--checkpoint'):
        with open(work / 'stream', 'wb') as stream:
            found = subprocess.run([lavaray, 'scene.ppm', '-o', '-', option, 'stream'], cwd=work, stdout=stream,
                                   stderr=subprocess.PIPE, text=True, check=False)
        demand(found.returncode == 2 and f'--output - and {option} stream are the same file' in found.stderr,
              f'stdout: {found}')
        (work / 'stream').unlink()
    for options in (['-o', ''], ['--json', ''], ['--checkpoint', ''], ['--resume', ''], ['--shaders', ''],
                    ['--json', '-'], ['--checkpoint', '-']):
        found = run(lavaray, 'scene.ppm', *options)
        demand(found.returncode == 2 and options[0].strip('-') in found.stderr, f'{options}: {found}')
    demand(contents() == before, 'no file of a name that is none')
    (work / 'soon.ppm').symlink_to('later/soon.ppm')
    found = run(lavaray, 'scene.ppm', '--width', '16', '-o', 'soon.ppm')
    demand(found.returncode == 5 and 'soon.ppm: cannot be written: No such file' in found.stderr, f'{found}')
    (work / 'later').mkdir()
    demand(run(lavaray, 'scene.ppm', '--width', '16', '-o', 'soon.ppm').returncode == 0, 'a link to what is not there')
    demand((work / 'soon.ppm').is_symlink() and (work / 'later' / 'soon.ppm').stat().st_size > 100, 'the link stays')


def try_watching():
    """A scene that begins to name the output as its mesh."""
    log = work / 'log'
    scene = work / 'watched.txt'
    text = (scenes / 'torus.txt').read_text()
    shutil.copy(scenes / 'torus.obj', work / 'torus.obj')
    scene.write_text(text)

    def wait_for(words, count=1):
        end = time.monotonic() + SECONDS
        while log.read_text().count(words) < count:
            if watching.poll() is not None or time.monotonic() > end:
                sys.exit(f'FAILED: not {count} of {words!r} in {log.read_text()}')
            time.sleep(0.02)

    with open(log, 'w') as stream:
        watching = subprocess.Popen([programs / 'lavaray', 'watched.txt', '-o', 'watched.ppm', '--width', '16', '--watch'],
                                    cwd=work, stderr=stream)
    wait_for('wrote watched.ppm')
    shutil.copy(scenes / 'torus.obj', work / 'watched.ppm')
    before = (work / 'watched.ppm').read_bytes()
    scene.write_text(text.replace('torus.obj', 'watched.ppm'))
    wait_for('--output watched.ppm would replace the mesh watched.ppm')
    demand((work / 'watched.ppm').read_bytes() == before, 'the mesh stays')
    scene.write_text(text + '\n')
    wait_for('wrote watched.ppm', 2)
    demand((work / 'watched.ppm').read_bytes()[:2] == b'P6', 'another mesh, and the picture is written again')
    watching.send_signal(signal.SIGINT)
    demand(watching.wait(SECONDS) == 0, 'the watching ends as ever')


def main():
    make_anew(work)
    try_all()
    try_two_outputs()
    try_watching()
    finish()


main()
