#!/usr/bin/python3
"""Errors of noisy fields as given and smoothed (--field-smoothing), with branches.

    PYTHONPATH=build/release/python scripts/measured_table.py [--shape trefoil,resolution=100]

Prints rows in Markdown. The truth is a smooth field; the noise is normal, the same in every run.
"""

import argparse

import brindle
import numpy as np

DETAILS = [0.5, 1, 2]
STRIPES = 40


def turned(surface, field, radians):
    normals = np.asarray(surface.normals)
    return np.cos(radians)[:, None] * field + np.sin(radians)[:, None] * np.cross(normals, field)


def error(a, b):
    """Mean degrees between lines, where both are."""
    cosines = np.abs(np.sum(np.asarray(a) * np.asarray(b), axis=1))
    known = np.any(np.nan_to_num(np.asarray(a)) != 0, axis=1)
    return np.degrees(np.arccos(np.clip(cosines[known], 0, 1))).mean()


def row(surface, truth, name, degrees, holes=0.0, outliers=0.0):
    chance = np.random.default_rng(1)
    field = turned(surface, truth, np.radians(degrees) * chance.standard_normal(len(truth)))
    strays = chance.random(len(truth)) < outliers
    field[strays] = turned(surface, truth, np.pi * chance.random(len(truth)))[strays]
    field[chance.random(len(truth)) < holes] = np.nan
    known = ~np.isnan(field[:, 0])
    plain = brindle.stripes(surface, field, stripes=STRIPES)
    cells = [f"{error(field[known], truth[known]):.2f}° · {plain.report['branches']}"]
    for detail in DETAILS:
        seen = brindle.stripes(surface, field, stripes=STRIPES, measured=brindle.Measured(detail))
        cells.append(f"{error(seen.directions, truth):.2f}° · {seen.report['branches']}")
    print(f"| {name} | {' | '.join(cells)} |")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--shape", default="trefoil,resolution=100")
    surface = brindle.shape(parser.parse_args().shape)
    truth = np.array(surface.smooth_field())
    print("| noise | as given | " + " | ".join(f"P = {detail:g}" for detail in DETAILS) + " |")
    print("|---|" + "---|" * (1 + len(DETAILS)))
    row(surface, truth, "none", 0)
    for degrees in (10, 20, 40):
        row(surface, truth, f"{degrees} degrees", degrees)
    row(surface, truth, "20 degrees, 30 % holes", 20, holes=0.3)
    row(surface, truth, "20 degrees, 10 % outliers", 20, outliers=0.1)


if __name__ == "__main__":
    main()
