#!/usr/bin/env python3
"""Writes presets/fields/*.fga from formulas. FGA is text: cells along x, y, z; the low corner; the high corner; a vector a cell,
x fastest. Run it after a change of a formula; the files are kept beside it so that nothing needs Python to run."""
import math
import pathlib

FIELDS = pathlib.Path(__file__).resolve().parent.parent / "presets" / "fields"


def swirl(x, y, z):
    """A dust devil in the cube [-1, 1]^3: turns about +y with most speed, 1, at half the radius; flows in below, up the middle and
    out above."""
    r = math.hypot(x, z)
    q = r / 0.5
    turn = 2 * q / (1 + q * q)
    outwards = 0.4 * y * min(1.0, 2 * r)
    up = 0.8 * math.exp(-4 * r * r) * (1 - 0.5 * y * y)
    if r < 1e-9:
        return 0.0, up, 0.0
    return (-z * turn + x * outwards) / r, up, (x * turn + z * outwards) / r


def write(name, formula, cells, low, high):
    def centre(axis, i):
        return low[axis] + (i + 0.5) * (high[axis] - low[axis]) / cells[axis]

    lines = [",".join(map(str, numbers)) + "," for numbers in (cells, low, high)]
    for k in range(cells[2]):
        for j in range(cells[1]):
            for i in range(cells[0]):
                v = formula(centre(0, i), centre(1, j), centre(2, k))
                lines.append(",".join(f"{c + 0.0:.3f}" for c in v) + ",")
    FIELDS.mkdir(exist_ok=True)
    (FIELDS / f"{name}.fga").write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    write("swirl", swirl, (10, 10, 10), (-1, -1, -1), (1, 1, 1))
