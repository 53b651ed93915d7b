"""Other programs judge reliefs: admesh finds nothing to repair, and PrusaSlicer slices them.

Each judge is skipped where it is missing (packages admesh, prusa-slicer).
"""

import json
import pathlib
import re
import shutil
import subprocess

import pytest

from conftest import ROOT

BUNNY = ROOT.parent / "shared/models/stanford-bunny.obj"  # has holes
# The bracket stands on a plain face: a printer lays nothing on the tips of a knurl.
RELIEFS = {
    "knurl": ["shape:bracket", "--only", "z@100", "--texture", "knurl", "--height", "1%", "--spacing", "4%"],
    "fine knurl": ["shape:bracket", "--only", "z@100", "--texture", "knurl", "--height", "0.4%", "--spacing", "2%"],
    "bricks": ["shape:molecule", "--texture", "bricks", "--height", "0.6%", "--spacing", "4%"],
    "cut": ["shape:tube,bend=0", "--texture", "dots", "--height", "1%", "--spacing", "6%", "--cut"],
    "bunny": [str(BUNNY), "--texture", "bricks", "--height", "0.6%", "--spacing", "4%"],
}


@pytest.fixture(params=RELIEFS, scope="module")
def relief(request, tool, tmp_path_factory):
    """A relief as an STL file, and its report."""
    words = RELIEFS[request.param]
    if not words[0].startswith("shape:") and not pathlib.Path(words[0]).is_file():
        pytest.skip(f"{words[0]} is missing")
    folder = tmp_path_factory.mktemp("relief")
    subprocess.run([tool, "relief", *words, "-o", "a.stl", "--report", "a.json", "-q"], cwd=folder, check=True)
    report = json.loads((folder / "a.json").read_text())
    assert report["closed"] and report["intersecting_triangles"] == 0
    return folder / "a.stl", report


def said_by(program, *words):
    if not shutil.which(program):
        pytest.skip(f"{program} is missing")
    done = subprocess.run([program, *words], capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout + done.stderr


def number_after(label, text):
    found = re.search(rf"{re.escape(label)}\s*[:=]\s*(-?[\d.]+(?:e[-+]?\d+)?)", text)
    assert found, f"no {label} in {text}"
    return float(found.group(1))


def test_admesh_repairs_nothing(relief):
    path, report = relief
    text = said_by("admesh", str(path))
    assert number_after("Number of facets", text) == report["triangles"]
    assert number_after("Volume", text) == pytest.approx(report["volume"], rel=1e-3)
    for label in ("Total disconnected facets", "Degenerate facets", "Edges fixed", "Facets removed",
                  "Facets added", "Facets reversed", "Backwards edges"):
        assert number_after(label, text) == 0, label
    # It computes normals in single precision, which is not enough for a few thin triangles of the bunny.
    assert number_after("Normals fixed", text) <= 1e-5 * report["triangles"]


def test_prusa_slicer_slices_without_a_repair(relief, tmp_path):
    path, report = relief
    scale = 40 / max(report["volume"] ** (1 / 3), 1e-9)  # to some centimetres
    text = said_by("prusa-slicer", "--info", str(path))
    assert "manifold = yes" in text and "repair" not in text, text
    assert number_after("number_of_facets", text) == report["triangles"]
    assert number_after("volume", text) == pytest.approx(report["volume"], rel=1e-3)
    said_by("prusa-slicer", "--export-gcode", "--scale", str(scale), "--fill-density", "100%",
            "--fill-pattern", "rectilinear", "--skirts", "0", "--nozzle-diameter", "0.6",
            "--layer-height", "0.4", "--first-layer-height", "0.4",
            "--output", str(tmp_path / "a.gcode"), str(path))
    used = number_after("filament used [cm3]", (tmp_path / "a.gcode").read_text())
    assert used == pytest.approx(report["volume"] * (scale / 10) ** 3, rel=0.1)
