#!/usr/bin/env python3
"""image_files_test.py IMAGE_VALUES SCRATCH: what the readers make of every kind and variant of image file.

IMAGE_VALUES is the program that prints it. The files of image_cases.py must have exactly their values, or be refused with
their message; each of them, cut off anywhere, must be refused, or, where only what follows the pixels is missing, have the
same values. SCRATCH is made anew.
"""
import pathlib
import re
import sys

sys.dont_write_bytecode = True  # leaves no __pycache__ in the checkout
sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import image_cases
from checks import make_anew
from image_values import bits, read


def fault(case, result):
    """What is wrong with what was read of a case; nothing where all is right."""
    if isinstance(result, str):
        return f"refused: {result}"
    width, height, name, maxima, pixels = result
    expected = [[image_cases.as_float32(value) for value in pixel] for pixel in case.values]
    if (width, height, name) != (case.width, case.height, case.format):
        return f"a {name} of {width} x {height}"
    for channel, value in enumerate(case.values[0]):
        if maxima[channel] != (value[1] if isinstance(value, tuple) else 0):
            return f"maxima of {maxima}, expected {value}"
    if bits(pixels) != bits(expected):
        where = next(i for i, pair in enumerate(zip(pixels, expected)) if bits([pair[0]]) != bits([pair[1]]))
        return f"pixel {where} is {pixels[where]}, expected {expected[where]}"
    return None


def check_cut_off(program, scratch, case, whole):
    """Every beginning of the file."""
    files = []
    for length in range(len(case.data)):
        files.append(scratch / f"{length}-{case.name}")
        files[-1].write_bytes(case.data[:length])
    faults = 0
    for length, result in enumerate(read(program, files)):
        if isinstance(result, str):
            # A cut in a number of the text leaves another one.
            continue
        if bits(result[4]) == bits(whole[4]):
            continue
        text_is_cut = case.data[:2] in (b"P1", b"P2", b"P3") and length >= len(case.data.rstrip()) - 9
        if not text_is_cut:
            faults += 1
            print(f"FAILED: {case.name} cut off at {length} of {len(case.data)} bytes is read as something else")
    for file in files:
        file.unlink()
    return faults


def main():
    program, scratch = sys.argv[1], pathlib.Path(sys.argv[2])
    make_anew(scratch)
    faults = 0
    cases = list(image_cases.cases())
    assert len({case.name for case in cases}) == len(cases)
    for case in cases:
        (scratch / case.name).write_bytes(case.data)
    results = read(program, [scratch / case.name for case in cases])
    for case, result in zip(cases, results):
        if wrong := fault(case, result):
            faults += 1
            print(f"FAILED: {case.name}: {wrong}")
        else:
            faults += check_cut_off(program, scratch, case, result)
    refusals = list(image_cases.refusals())
    for case in refusals:
        (scratch / case.name).write_bytes(case.data)
    for case, result in zip(refusals, read(program, [scratch / case.name for case in refusals])):
        if not isinstance(result, str) or not re.search(f"{re.escape(case.name)}: .*{case.message}", result):
            faults += 1
            print(f"FAILED: {case.name}: {result if isinstance(result, str) else 'is read'}; expected: {case.message}")
    print(f"{len(cases)} files read, {len(refusals)} refused, {faults} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
