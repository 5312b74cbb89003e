"""Where to cut a picture so that its parts take about equal time."""

import subprocess
import tempfile
from array import array
from pathlib import Path

# Rows of the small picture that says what each row of the large one costs.
ESTIMATE_ROWS = 96
# What a row costs beside the tests of its rays, as a share of the mean row's tests: where there is nothing to test, its
# samples are taken nevertheless.
BESIDE_TESTS = 0.2


def read_pfm(file):
    """Width, height and the red values of a PFM file, rows from the top."""
    magic, size, scale, data = file.read_bytes().split(b"\n", 3)
    if magic != b"PF":
        raise ValueError(f"{file} is no PFM file of colours")
    width, height = map(int, size.split())
    values = array("f", data)
    if float(scale) > 0:
        values.byteswap()
    rows = [values[3 * width * y:3 * width * (y + 1):3] for y in reversed(range(height))]
    return width, height, rows


def row_costs(lavaray, scene, options, height):
    """Relative cost of each row of the picture, by what the rays of a small one test."""
    with tempfile.TemporaryDirectory() as folder:
        picture = Path(folder) / "cost.pfm"
        subprocess.run([lavaray, scene, *options, "--view", "cost", "--height", str(min(height, ESTIMATE_ROWS)),
                        "-o", picture, "-q"], check=True)
        _, _, rows = read_pfm(picture)
    tests = [sum(row) for row in rows]
    return [row + BESIDE_TESTS * sum(tests) / len(tests) for row in tests]


def equal_cuts(costs, height, parts):
    """The first rows of `parts` strips of a picture of `height` rows, and its height, so that each strip has about
    the same part of the costs and at least one row. `costs` may be of fewer rows, spread over the picture."""
    if parts > height:
        raise ValueError(f"{parts} parts of {height} rows; at most {height} are possible")
    total = sum(costs) or 1.0
    scale = height / len(costs)
    cuts = [0]
    before = 0.0  # cost of the rows before the one that is looked at
    row = 0
    for part in range(1, parts):
        wanted = total * part / parts
        while row < len(costs) - 1 and before + costs[row] < wanted:
            before += costs[row]
            row += 1
        share = (wanted - before) / costs[row] if costs[row] > 0 else 0.0
        cut = round((row + min(max(share, 0.0), 1.0)) * scale)
        cuts.append(min(max(cut, cuts[-1] + 1), height - (parts - part)))
    return cuts + [height]


def interleaved(count):
    """0 .. count - 1 in an order in which neighbours are far apart: by reversed bits (van der Corput). Where the
    estimate is wrong for a region, its parts do not come one after the other."""
    bits = max(1, (count - 1).bit_length())
    order = (int(format(i, f"0{bits}b")[::-1], 2) for i in range(1 << bits))
    return [i for i in order if i < count]
