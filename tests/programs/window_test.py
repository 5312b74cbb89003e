#!/usr/bin/env python3
"""window_test.py PROGRAMS SCENES WORK: `lavaray --display` on a virtual screen, with real keys and a real mouse.

Needs Xvfb and xdotool; skips itself by name where one is not installed.
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys

sys.dont_write_bytecode = True  # leaves no __pycache__ in the checkout
sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / 'support'))
from checks import fail, make_anew, until

SECONDS = 60


class Screen:
    def __enter__(self):
        reading, writing = os.pipe()
        self.server = subprocess.Popen(['Xvfb', '-displayfd', str(writing), '-noreset', '-screen', '0', '800x600x24'],
                                       pass_fds=[writing], stderr=subprocess.DEVNULL)
        os.close(writing)
        with os.fdopen(reading) as numbers:
            os.environ['DISPLAY'] = ':' + numbers.readline().strip()
        return self

    def __exit__(self, *_):
        self.server.terminate()
        self.server.wait()


def xdotool(*arguments):
    return subprocess.run(['xdotool', *map(str, arguments)], capture_output=True, text=True).stdout.strip()


def window_of(process):
    def look():
        if process.poll() is not None:
            fail(f'it ended with {process.returncode} before its window was there')
        return xdotool('search', '--name', 'extensions').split('\n')[0]
    return until(look, 'a window', SECONDS)


def title(window):
    return xdotool('getwindowname', window)


def start(programs, scenes, folder, *options):
    return subprocess.Popen([programs / 'lavaray', scenes / 'extensions.txt', '--display', '-o', folder / 'shown.ppm',
                             '-q', *options])


def main():
    programs, scenes, work = (pathlib.Path(argument).resolve() for argument in sys.argv[1:])
    for tool in ('Xvfb', 'xdotool'):
        if not shutil.which(tool):
            print(f'skipped: {tool} is not installed')
            sys.exit(77)
    make_anew(work)
    picture = work / 'shown.ppm'
    helped = subprocess.run([programs / 'lavaray', '--display', scenes / 'facets.txt', '-o', picture, '-q'],
                            env={**os.environ, 'DISPLAY': ':99999'}, capture_output=True, text=True)
    if 'built without windows' in helped.stderr:
        print('skipped: lavaray is built without windows (libx11-dev)')
        sys.exit(77)
    if helped.returncode != 5 or 'screen' not in helped.stderr or not picture.exists():
        fail(f'without a screen: exit code {helped.returncode}, {helped.stderr}')

    with Screen():
        # A finished picture stays until a key, the value under the mouse is in the title, and the wheel zooms.
        for key in ('q', 'Escape'):
            render = start(programs, scenes, work, '--width', '300', '--spp', '1')
            window = window_of(render)
            until(lambda: title(window).startswith('extensions.txt: 1 spp'), 'the final title', SECONDS)
            xdotool('mousemove', '--window', window, 100, 50)
            shown = until(lambda: re.search(r'\| 100,50: (\S+) (\S+) (\S+)', title(window)), 'the value of a pixel', SECONDS)
            data = picture.read_bytes()
            width = int(data.split(b'\n')[1].split()[0])
            pixel = data[len(data) % (3 * width) + 3 * (50 * width + 100):][:3]
            for value, byte in zip(shown.groups(), pixel):
                if abs(float(value) * 255 - byte) > 1.1:
                    fail(f'the title says {shown.group(0)}, the picture {list(pixel)}')
            for _ in range(4):
                xdotool('click', 4)
            xdotool('mousemove', '--window', window, 200, 100)
            zoomed = until(lambda: re.search(r'\| (?!100,50)(\d+),(\d+): ', title(window)), 'a zoomed title', SECONDS)
            expected = (100 + 100 / 1.25 ** 4, 50 + 50 / 1.25 ** 4)
            if abs(int(zoomed.group(1)) - expected[0]) > 3 or abs(int(zoomed.group(2)) - expected[1]) > 3:
                fail(f'after zooming the mouse is at {zoomed.group(0)}, expected {expected}')
            xdotool('key', '--window', window, key)
            if render.wait(SECONDS) != 0:
                fail(f'{key}: exit code {render.returncode}')

        # A picture that grows, and is kept when the window is closed before its end.
        picture.unlink()
        render = start(programs, scenes, work, '--spp', '100000')
        window = window_of(render)
        first = until(lambda: re.search(r': (\S+) spp, (\d+) %, [\d:]+ left', title(window)), 'progress in the title', SECONDS)
        until(lambda: float(re.search(r': (\S+) spp', title(window)).group(1)) > float(first.group(1)), 'growth', SECONDS)
        xdotool('key', '--window', window, 'q')
        if render.wait(SECONDS) != 130 or not picture.exists():
            fail(f'closed before its end: exit code {render.returncode}')

        # --watch: an edit shows in the window.
        scene = work / 'extensions.txt'
        shutil.copy(scenes / 'extensions.txt', scene)
        render = start(programs, work, work, '--width', '200', '--spp', '1', '--watch')
        window = window_of(render)
        until(lambda: 'extensions.txt: 1 spp' in title(window), 'the final title', SECONDS)
        before = picture.read_bytes()
        scene.write_text(re.sub(r'dif:.*', 'dif: 0.2 0.7 0.2', scene.read_text()))
        until(lambda: picture.read_bytes() != before, 'a new picture', SECONDS)
        xdotool('key', '--window', window, 'q')
        if render.wait(SECONDS) != 0:
            fail(f'--watch: exit code {render.returncode}')
    print('figure: a window under Xvfb: value under the mouse, zoom, growth, q, Esc, --watch')


main()
