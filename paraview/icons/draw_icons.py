#!/usr/bin/env python3
"""Draws the icons of the filters, each in all sizes in one file.

    python3 draw_icons.py --folder FOLDER
"""

import argparse
import os
import struct
import zlib

import numpy as np

SIZES = (16, 24, 32, 48, 64)
FINE = 12  # points a pixel and axis
PERIODS = 5  # from pole to pole

TAWNY = np.array([0.93, 0.66, 0.28])
PALE = np.array([0.98, 0.95, 0.88])
DARK = np.array([0.20, 0.12, 0.07])
RIM = np.array([0.36, 0.22, 0.11])


class Ball:
    """An oblique ball: latitude and longitude at fine points of a square of `size` pixels."""

    def __init__(self, size):
        self.size = size
        at = (np.arange(size * FINE) + 0.5) / FINE - size / 2
        self.radius = size / 2 - size / 32
        x, y = np.meshgrid(at / self.radius, -at / self.radius)
        self.r = np.hypot(x, y)
        z = np.sqrt(np.clip(1 - self.r**2, 0, 1))
        self.light = np.clip(0.72 + 0.28 * (-0.5 * x + 0.6 * y + 0.62 * z), 0, 1)
        turn, tilt = np.radians(28), np.radians(38)
        x, y = np.cos(turn) * x + np.sin(turn) * y, np.cos(turn) * y - np.sin(turn) * x
        y, z = np.cos(tilt) * y + np.sin(tilt) * z, np.cos(tilt) * z - np.sin(tilt) * y
        self.latitude = np.arcsin(np.clip(y, -1, 1))
        self.longitude = np.arctan2(x, z)

    def pixels(self, marked, ground):
        """The ball in one colour with marks in another, an edge, and a transparent background."""
        color = np.where(marked[..., None], DARK, ground * self.light[..., None])
        rim = max(1.0, self.size / 28) / self.radius
        color = np.where((self.r > 1 - rim)[..., None], RIM, color)
        inside = (self.r <= 1).astype(float)
        blocks = (self.size, FINE, self.size, FINE)
        share = inside.reshape(blocks).mean(axis=(1, 3))
        sums = (color * inside[..., None]).reshape(*blocks, 3).mean(axis=(1, 3))
        return np.dstack([sums / np.maximum(share, 1e-9)[..., None], share])


def stripes(ball):
    return ball.pixels(np.cos(2 * PERIODS * ball.latitude) > 0, TAWNY)


def curves(ball):
    """Lines at least one pixel wide; the slope of the phase is a finite difference."""
    phase = PERIODS * ball.latitude / np.pi
    slope = np.hypot(*np.gradient(phase)) * FINE
    width = max(1.15, ball.size / 18)
    apart = np.abs(phase - np.round(phase)) / np.maximum(slope, 1e-9)
    return ball.pixels(apart < width / 2, PALE)


def samples(ball):
    """Dots on every parallel, spaced like the parallels."""
    step = np.pi / PERIODS
    row = np.round(ball.latitude / step)
    around = np.maximum(np.round(2 * np.pi * np.cos(row * step) / step), 1)
    place = ball.longitude * around / (2 * np.pi) + 0.5 * (row % 2)
    along = (place - np.round(place)) * 2 * np.pi / around * np.cos(ball.latitude)
    return ball.pixels(np.hypot(ball.latitude - row * step, along) < 0.29 * step, PALE)


def png(pixels):
    rows = np.round(255 * np.clip(pixels, 0, 1)).astype(np.uint8)

    def chunk(kind, data):
        check = zlib.crc32(kind + data)
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", check)

    height, width, _ = rows.shape
    lines = b"".join(b"\0" + row.tobytes() for row in rows)
    return (b"\x89PNG\r\n\x1a\n"
            + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0))
            + chunk(b"IDAT", zlib.compress(lines, 9)) + chunk(b"IEND", b""))


def ico(images):
    """Images of several sizes in one file, from which Qt selects."""
    head = struct.pack("<HHH", 0, 1, len(images))
    begin = len(head) + 16 * len(images)
    for size, data in images:
        head += struct.pack("<BBBBHHII", size, size, 0, 0, 1, 32, len(data), begin)
        begin += len(data)
    return head + b"".join(data for _, data in images)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--folder", required=True, help="write stripes.ico, curves.ico and samples.ico here")
    folder = parser.parse_args().folder
    for draw in (stripes, curves, samples):
        images = [(size, png(draw(Ball(size)))) for size in SIZES]
        with open(os.path.join(folder, draw.__name__ + ".ico"), "wb") as file:
            file.write(ico(images))


if __name__ == "__main__":
    main()
