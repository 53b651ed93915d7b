#!/usr/bin/python3
"""Branches, angle errors and energies by spacing tolerance (--slack).

    scripts/slack_table.py build/release/apps/brindle/brindle [--models FOLDER] [--only TEXT]

Prints rows in Markdown. Without --models, built-in shapes alone.
"""

import argparse
import json
import pathlib
import subprocess
import tempfile

DIRECTION = ["--direction", "0.31,0.9,0.27"]
CASES = [
    ("shape:trefoil", DIRECTION, "`shape:trefoil`, one direction"),
    ("shape:trefoil", ["--field", "curvature", "--rotate", "35"], "`shape:trefoil`, turned curvature"),
    ("shape:vessels", [], "`shape:vessels`"),
    ("shape:box", [], "`shape:box`"),
]
MODELS = ["horse.ply", "nefertiti.obj", "spot.obj", "stanford-bunny.obj"]
SLACKS = ["0", "0.05", "0.1", "0.25", "0.5"]


def report(tool, mesh, options):
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "report.json"
        subprocess.run([tool, "stripe", mesh, "-q", "--report", path, *options], check=True)
        return json.loads(path.read_text())


def cell(metrics):
    return (f"{metrics['branches']} · {metrics['angle_error_mean_deg']:.2f}° · "
            f"{1000 * metrics['energy']:.2f}")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("tool")
    parser.add_argument("--models", type=pathlib.Path)
    parser.add_argument("--only", default="")
    arguments = parser.parse_args()
    cases = list(CASES)
    if arguments.models:
        cases += [(str(arguments.models / name), ["--crease-angle", "180"], name) for name in MODELS]
    print("| | stripes | singular | `global` | " + " | ".join(f"S = {s}" for s in SLACKS) + " | rest at 0.25 |")
    print("|---|---|---|---|" + "---|" * len(SLACKS) + "---|")
    for mesh, field, name in cases:
        if arguments.only not in name:
            continue
        for stripes in ("40", "100"):
            asked = [*field, "--stripes", stripes]
            global_ = report(arguments.tool, mesh, [*asked, "--solver", "global"])
            slack = [report(arguments.tool, mesh, [*asked, "--slack", s]) for s in SLACKS]
            spare = [f["branches"] - f["field_singularities"] for f in slack]
            share = spare[3] / spare[0] if spare[0] else 0
            print(f"| {name} | {stripes} | {slack[0]['field_singularities']} | {cell(global_)} | "
                  + " | ".join(cell(f) for f in slack) + f" | {share:.2f} |", flush=True)


if __name__ == "__main__":
    main()
