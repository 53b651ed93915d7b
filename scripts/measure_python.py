#!/usr/bin/python3
"""Measures what the package adds to the library: importing it, and frames.

    PYTHONPATH=build/release/python /usr/bin/python3 scripts/measure_python.py [MESH]

A frame through Python is compared with the time that the library's own stages take in the same
frames; MESH is a built-in torus of about 48,000 vertices unless it is given.
"""

import statistics
import subprocess
import sys
import time

import numpy as np

import brindle
from brindle import _core


def milliseconds_of(statement):
    """Of a program of its own; the median of nine."""
    program = f"import time; t = time.perf_counter(); {statement}; print(1000 * (time.perf_counter() - t))"
    return statistics.median(float(subprocess.run([sys.executable, "-c", program], check=True,
                                                  capture_output=True, text=True).stdout)
                             for _ in range(9))


def frames(surface, count=200):
    """Times by the clock and of the library's stages, in milliseconds, and copies of the input."""
    f = np.full(surface.vertex_count, surface.frequency_of(40), np.float32)
    fields = [surface.projected_field((np.cos(a), np.sin(a), 0.3)) for a in np.linspace(0, 0.5, 20)]
    animator = brindle.Animator(surface)
    animator.frame(fields[0], f)
    before = _core.converted_arrays()
    wall, inside = [], []
    for number in range(count):
        directions = fields[number % len(fields)]
        begin = time.perf_counter()
        animator.frame(directions, f)
        wall.append(1000 * (time.perf_counter() - begin))
        inside.append(sum(animator.milliseconds.values()))
    return statistics.median(wall), statistics.median(inside), _core.converted_arrays() - before


def main():
    print(f"import brindle              {milliseconds_of('import brindle'):7.1f} ms")
    print(f"... and the first function  {milliseconds_of('import brindle; brindle.shape'):7.1f} ms")
    print(f"import numpy, to compare    {milliseconds_of('import numpy'):7.1f} ms")
    surface = brindle.read(sys.argv[1]) if len(sys.argv) > 1 else brindle.shape("torus")
    wall, inside, copies = frames(surface)
    print(f"{surface}")
    print(f"frame through Python {wall:.2f} ms, the library's stages {inside:.2f} ms, ratio "
          f"{wall / inside:.3f}; arrays converted: {copies}")


if __name__ == "__main__":
    main()
