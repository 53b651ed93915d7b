#!/usr/bin/python3
"""Frames a second in the window of brindle view.

    tests/scripts/measure_window.py build/release/apps/brindle/brindle MESH
    tests/scripts/measure_window.py build/release/apps/brindle/brindle --gallery [ITEM...]

Drags a slider to and fro, in a window of 1280x720 on a display of its own, and says how many frames a second
there were and what they and the window itself cost; --gallery does so with every item of the gallery.
"""

import argparse
import os
import pathlib
import shutil
import sys
import tempfile
import time

from window_driver import Display, Window, missing_programs, open_gallery

SIZE = (1280, 720)


def median(values):
    return sorted(values)[len(values) // 2] if values else float("nan")


def processor_seconds(process):
    fields = pathlib.Path(f"/proc/{process.pid}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def measure(tool, mesh, display, folder):
    """Frames a second while a slider moves, and the processor's time for them and for the window."""
    folder.mkdir(parents=True)
    window = Window(tool, display, folder, [str(pathlib.Path(mesh).resolve()) if os.path.exists(mesh) else mesh],
                    SIZE)
    try:
        window.settled()
        since = window.now()
        window.click("option stripes")
        window.settled(since)
        since, before, start = window.now(), processor_seconds(window.process), time.monotonic()
        left, right = window.point("option stripes", 0.3), window.point("option stripes", 0.8)
        there = [(x, left[1]) for x in range(left[0], right[0])]
        window.sweep(4 * (there + there[::-1]))
        window.read()
        used, took = processor_seconds(window.process) - before, time.monotonic() - start
        frames = [e for e in window.lines[since:] if e["event"] == "frame" and not e["final"]]
        gaps = [b["time"] - a["time"] for a, b in zip(frames, frames[1:])]
        size = f"{frames[0]['width']}x{frames[0]['height']}"
        print(f"picture {size}, {len(frames)} frames in {took:.1f} s, median {1 / median(gaps):.1f} a second")
        print(f"a frame: {median([e['milliseconds'] for e in frames]):.1f} ms, of which drawing "
              f"{median([e['draw_milliseconds'] for e in frames]):.1f} ms; processor, with the window, "
              f"{1000 * used / len(frames):.1f} ms")
        window.settled(since)
        before = processor_seconds(window.process)
        x, y = window.point("group Solver")
        for i in range(150):
            window.move(x + i % 40, y)
        used = processor_seconds(window.process) - before
        window.quit()
        end = window.wait_until_end()
        print(f"the window's thread: {1000 * end['thread_seconds'] / end['drawn']:.1f} ms of the processor for each of "
              f"{end['drawn']} times that it was drawn; all threads while nothing is solved: "
              f"{1000 * used / 150:.1f} ms for each motion of the mouse")
    finally:
        window.kill()
    return 0


def frames_a_second(window, points):
    """While the mouse is dragged along these points, at least five times as long as a frame takes."""
    since = window.now()
    for _ in range(6):
        window.sweep(points + points[::-1])
        window.read()
        frames = [e for e in window.lines[since:] if e["event"] == "frame" and not e["final"]]
        if len(frames) > 5:
            break
    window.settled(since)
    return 1 / median([b["time"] - a["time"] for a, b in zip(frames, frames[1:])]), frames[-1]["vertices"]


# What is moved live of an item: its place, or the slider of an option.
GALLERY = {"liver": ("near", "place 1"), "nested": ("focus", "place 1"), "vortices": ("still", "option stripes"),
           "aneurysm": ("stress", "option stripes"), "molecule": ("signs", "option stripes"),
           "hatching": ("pen", "option stripes"), "glyphs": ("decals", "option stripes"),
           "crosses": ("tiles", "option stripes"), "rough": ("all", "option stripes"),
           "giant": ("stripes", "option stripes")}


def measure_gallery(tool, names, display, folder):
    """A table of frames a second: what a user sees who turns an item, or moves what is live in it."""
    folder.mkdir(parents=True)
    print("| item | vertices | turned | | moved |\n|---|---|---|---|---|")
    edited = False
    window = Window(tool, display, folder, ["shape:torus,resolution=20"], SIZE)
    try:
        window.settled()
        for item, (picture, control) in GALLERY.items():
            if names and item not in names:
                continue
            open_gallery(window, item, picture, discards=edited)
            edited = True
            x, y = window.point("picture", 0.75, 0.85)
            turned, vertices = frames_a_second(window, [(x + i, y) for i in range(90)])
            x, y = window.point(control)
            moved, _ = frames_a_second(window, [(x + i, y) for i in range(-40, 41)]
                                       if control.startswith("option") else [(x + i, y) for i in range(90)])
            what = {"liver": "needle", "nested": "focus"}.get(item, "stripes")
            print(f"| {item} | {vertices:,} | {turned:.1f} | {what} | {moved:.1f} |", flush=True)
        window.quit()
    finally:
        window.kill()
    return 0


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("tool")
    parser.add_argument("names", nargs="*", metavar="MESH|ITEM")
    parser.add_argument("--gallery", action="store_true")
    arguments = parser.parse_intermixed_args()
    if not arguments.gallery and len(arguments.names) != 1:
        parser.error("name one mesh, or give --gallery")
    if missing := missing_programs():
        sys.exit(f"{' and '.join(missing)} missing")
    tool = str(pathlib.Path(arguments.tool).resolve())
    folder = pathlib.Path(tempfile.mkdtemp(prefix="brindle_window_"))
    display = Display()
    try:
        if arguments.gallery:
            return measure_gallery(tool, arguments.names, display.name, folder / "gallery")
        return measure(tool, arguments.names[0], display.name, folder / "measure")
    finally:
        display.close()
        shutil.rmtree(folder, ignore_errors=True)


if __name__ == "__main__":
    sys.exit(main())
