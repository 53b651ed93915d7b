#!/usr/bin/python3
"""Stripes every mesh in a folder and says what came of it: what was refused and why, what was slowest,
what came out worst. Anything but a pattern or a refusal is a defect of Brindle's: a crash, a run without
an end, a report without a number.

    scripts/zoo.py build/release/apps/brindle/brindle FOLDER [--seconds 60] [--csv ALL.csv] [-- OPTIONS]

OPTIONS go to `brindle stripe`: -- --points --stripes 60. Exits with 0 if all was well, 1 on a defect, 2 on
wrong usage, 130 where Ctrl-C ended it.
"""

import argparse
import csv
import json
import math
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor

SURFACES = (".ply", ".obj", ".stl", ".off", ".gltf", ".glb", ".vtp", ".vtu", ".vtk")
COLUMNS = ("file", "outcome", "seconds", "vertices", "triangles", "energy", "branches",
           "field_singularities", "branches_per_1000_squares", "angle_error_mean_deg", "why")


def files_in(folder):
    found = [path for path in folder.rglob("*")
             if path.suffix.lower() in SURFACES and path.is_file()]
    return sorted(found)


def plain(text):
    """One line that any terminal may show."""
    return "".join(c if c.isprintable() else "?" for c in text)


def reason(text, path):
    """The line that says why, without the tool's name and the file's."""
    lines = [line for line in text.splitlines() if line.startswith("brindle: ")]
    if not lines:
        return plain(text.strip().splitlines()[-1]) if text.strip() else "nothing was said"
    said = lines[0].removeprefix("brindle: ")
    return plain(said.removeprefix(str(path)).removeprefix(":").strip())


def run(words, seconds):
    """The exit code (None: it did not end), what was written, and how long it took."""
    began = time.monotonic()
    # A group of its own, so that Ctrl-C is heard here and nothing is left behind.
    process = subprocess.Popen(words, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                               stderr=subprocess.STDOUT, text=True, errors="replace",
                               start_new_session=True)
    try:
        out, _ = process.communicate(timeout=seconds)
        return process.returncode, out, time.monotonic() - began
    except subprocess.TimeoutExpired:
        return None, "", time.monotonic() - began
    finally:
        if process.poll() is None:
            os.killpg(process.pid, signal.SIGKILL)
            process.wait()


def number(report, key):
    value = report.get(key)
    return value if isinstance(value, (int, float)) and math.isfinite(value) else None


def area_of(tool, path, options, seconds):
    about = [word for word in options if word == "--points"]
    code, out, _ = run([tool, "info", str(path), *about], seconds)
    match = re.search(r"^area +(\S+)$", out, re.MULTILINE)
    return float(match.group(1)) if code == 0 and match else None


def judged(row, report, area):
    """The row of a pattern; a report that lacks what every report has is a defect."""
    missing = [key for key in ("energy", "vertices") if number(report, key) is None]
    if missing:
        return {**row, "outcome": "defect", "why": f"the report has no number for {missing[0]}"}
    row.update({key: report.get(key) for key in COLUMNS if key in report})
    energy = row["energy"]
    if not 0 <= energy <= 1:
        return {**row, "outcome": "defect", "why": f"the energy is {energy}"}
    frequency = number(report, "frequency_max")
    if area and frequency and "branches" in report:
        squares = area * frequency ** 2
        extra = report["branches"] - report.get("field_singularities", 0)
        row["branches_per_1000_squares"] = 1000 * extra / squares
    return {**row, "outcome": "striped"}


def visit(tool, folder, path, options, seconds):
    row = {"file": plain(str(path.relative_to(folder))), "why": ""}
    with tempfile.TemporaryDirectory() as beside:
        report = pathlib.Path(beside) / "report.json"
        code, out, row["seconds"] = run(
            [tool, "stripe", str(path), "--quiet", "--report", str(report), *options], seconds)
        if code is None:
            return {**row, "outcome": "defect", "why": f"no end within {seconds:g} s"}
        if code == 1 and not report.exists():
            return {**row, "outcome": "refused", "why": reason(out, path)}
        if code == 2:
            return {**row, "outcome": "usage", "why": reason(out, path)}
        if code != 0 or not report.exists():
            what = f"signal {signal.Signals(-code).name}" if code < 0 else f"exit code {code}"
            return {**row, "outcome": "defect", "why": f"{what}: {reason(out, path)}"}
        try:
            read = json.loads(report.read_text())
        except ValueError as error:
            return {**row, "outcome": "defect", "why": f"the report is no JSON: {error}"}
    return judged(row, read, area_of(tool, path, options, seconds))


def table(title, rows, columns):
    if not rows:
        return
    print(f"\n{title}\n")
    print("| " + " | ".join(columns) + " |")
    print("|" + "---|" * len(columns))
    for row in rows:
        cells = []
        for column in columns:
            value = row.get(column)
            cells.append("" if value is None else
                         f"{value:.4g}" if isinstance(value, float) else str(value))
        print("| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |")


def highest(rows, column, count=10):
    known = [row for row in rows if row.get(column) is not None]
    return sorted(known, key=lambda row: row[column], reverse=True)[:count]


def show(rows):
    of = {name: [row for row in rows if row["outcome"] == name]
          for name in ("striped", "refused", "usage", "defect")}
    print(f"{len(rows)} files: {len(of['striped'])} striped, "
          f"{len(of['refused']) + len(of['usage'])} refused, {len(of['defect'])} defects")
    size = ["file", "vertices", "triangles"]
    table("Defects: please report them, with the file", of["defect"], ["file", "why"])
    table("Refused", of["refused"] + of["usage"], ["file", "why"])
    table("Slowest", highest(rows, "seconds"), [*size, "seconds"])
    table("Highest energies", highest(of["striped"], "energy"), [*size, "energy"])
    table("Most branches beyond the field's singularities, over 1,000 squares of a period",
          highest(of["striped"], "branches_per_1000_squares"),
          [*size, "branches", "field_singularities", "branches_per_1000_squares"])
    return len(of["defect"])


def visit_all(arguments, files):
    rows, began = [], time.monotonic()
    with ThreadPoolExecutor(arguments.jobs) as pool:
        pending = [pool.submit(visit, arguments.tool, arguments.folder, path, arguments.options,
                               arguments.seconds) for path in files]
        try:
            for count, job in enumerate(pending, 1):
                rows.append(job.result())
                if time.monotonic() - began > 1:
                    began = time.monotonic()
                    print(f"zoo: {count} of {len(files)}", file=sys.stderr)
        except KeyboardInterrupt:
            for job in pending:
                job.cancel()
            raise
    return rows


def parsed(words):
    parser = argparse.ArgumentParser(
        prog="./dev zoo", usage="%(prog)s FOLDER [--seconds S] [--jobs N] [--csv FILE] [-- OPTIONS]",
        description="Stripes every mesh in a folder and prints what came of it.",
        epilog="example: ./dev zoo ~/meshes --csv all.csv -- --points --stripes 60")
    parser.add_argument("tool", help=argparse.SUPPRESS)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--seconds", type=float, default=60,
                        help="what takes longer has no end (default 60)")
    parser.add_argument("--jobs", type=int, default=1, help="files at a time (default 1: times count)")
    parser.add_argument("--csv", type=pathlib.Path, help="a row for every file")
    own, options = (words[:words.index("--")], words[words.index("--") + 1:]) \
        if "--" in words else (words, [])
    arguments = parser.parse_args(own)
    if not arguments.folder.is_dir():
        parser.error(f"'{arguments.folder}' is no folder")
    if not arguments.seconds > 0 or arguments.jobs < 1:
        parser.error("--seconds and --jobs must be above 0")
    arguments.options = options
    return parser, arguments


def main():
    parser, arguments = parsed(sys.argv[1:])
    files = files_in(arguments.folder)
    if not files:
        parser.error(f"no mesh in '{arguments.folder}': looked for {' '.join(SURFACES)}")
    rows = visit_all(arguments, files)
    if arguments.csv:
        with arguments.csv.open("w", newline="") as out:
            writer = csv.DictWriter(out, COLUMNS, extrasaction="ignore")
            writer.writeheader()
            writer.writerows(rows)
    if all(row["outcome"] == "usage" for row in rows):
        parser.error(rows[0]["why"])
    return 1 if show(rows) else 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except KeyboardInterrupt:
        sys.exit(130)
