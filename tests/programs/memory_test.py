#!/usr/bin/env python3
"""memory_test.py PROGRAMS SCENES WORK: how a render's peak memory grows with the picture's size.

Rows of one sample a pixel are in the file before the others are traced, so nothing of them may grow with the picture;
several samples a pixel need their sums, 32 bytes each, and no copy of the picture beside them.
"""

import os
import pathlib
import subprocess
import sys

sys.dont_write_bytecode = True  # leaves no __pycache__ in the checkout
sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / 'support'))
from checks import fail, make_anew

SMALL, LARGE = 1000, 3000  # pixels a side
# Beside the pixels the driver's buffers may grow, up to the largest piece of work, and the table of tiles.
OTHER_BYTES = 20e6


def peak(command):
    with open('stdout', 'wb') as stdout:
        child = subprocess.Popen(command, stdout=stdout)
        _, status, usage = os.wait4(child.pid, 0)
    if status != 0:
        fail(f'{command} ended with status {status}')
    return 1024 * usage.ru_maxrss


def main():
    programs, scenes, work = (pathlib.Path(argument).resolve() for argument in sys.argv[1:])
    make_anew(work)
    os.chdir(work)
    failed = False
    formats = ['a.bmp', 'a.png', 'a.ppm', 'a.pfm', '-']
    for options, outputs, most in [([], formats, 1), (['--normalize'], formats, 14), (['--spp', '2'], formats, 34)]:
        for output in outputs:
            def bytes_at(side):
                size = ['--width', str(side), '--height', str(side)]
                return peak([programs / 'lavaray', '-q', scenes / 'spheres.txt', *size, *options, '-o', output])
            growth = bytes_at(LARGE) - bytes_at(SMALL)
            pixels = LARGE**2 - SMALL**2
            print(f'figure: {output} {" ".join(options)}: {growth / pixels:.1f} bytes a pixel')
            if growth > most * pixels + OTHER_BYTES:
                print(f'FAILED: at most {most} bytes a pixel are expected')
                failed = True
    sys.exit(failed)


main()
