#!/usr/bin/env pvpython
"""Lets ParaView and Brindle read each other's files.

    xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" \\
        pvpython paraview/tests/check_files.py build/release/apps/brindle/brindle [--keep FOLDER]

ParaView writes a surface with arrays in all its formats and encodings; Brindle reads each and writes
it as .vtp, where ParaView must find every array as it was, bit for bit. A CSV file of ParaView's
spreadsheet must give the same field as the array itself. ParaView then opens a series that Brindle
made (.pvd) and draws it as docs/paraview.md says; stripes must cover about half of the surface.

Needs ParaView's Python (Debian: paraview, python3-paraview, which takes the place of python3-vtk9).
Exits with 0 if all agree, 1 if not.
"""

import argparse
import json
import os
import subprocess
import sys
import tempfile

import numpy as np
from paraview import simple as pv
from paraview import servermanager
from vtkmodules.util.numpy_support import vtk_to_numpy

FRAMES = 3


def made_surface():
    """Triangles with arrays of several types, per point and per cell."""
    sphere = pv.Triangulate(pv.Sphere(ThetaResolution=48, PhiResolution=40))
    flow = pv.Calculator(Input=sphere, ResultArrayName="velocity",
                         Function="coordsY*iHat-coordsX*jHat+0.3*kHat")
    speed = pv.Calculator(Input=flow, ResultArrayName="speed of flow", Function="mag(velocity)")
    ids = pv.GenerateIds(Input=speed)
    return pv.GenerateSurfaceNormals(Input=ids, ComputeCellNormals=1)


def writes(surface):
    """(name, source, options of SaveData)"""
    files = [("plain.ply", surface, {}), ("binary.vtk", surface, {"FileType": "Binary"}),
             ("text.vtk", surface, {"FileType": "Ascii"})]
    grid = pv.AppendDatasets(Input=surface)
    for kind, source in (("vtp", surface), ("vtu", grid)):
        for mode in ("Ascii", "Binary", "Appended"):
            for compressor in ("None", "ZLib"):
                for encoded in (0, 1) if mode == "Appended" else (0,):
                    files.append((f"{mode}_{compressor}_{encoded}.{kind}", source,
                                  {"DataMode": mode, "CompressorType": compressor,
                                   "EncodeAppendedData": encoded}))
    return files


def arrays_of(data):
    found = {}
    for place, arrays in (("point", data.GetPointData()), ("cell", data.GetCellData())):
        for i in range(arrays.GetNumberOfArrays()):
            array = arrays.GetArray(i)
            found[place, array.GetName()] = vtk_to_numpy(array)
    return found


def fetched(path):
    reader = pv.OpenDataFile(path)
    data = servermanager.Fetch(reader)
    arrays = arrays_of(data)
    pv.Delete(reader)
    return arrays


def run(brindle, folder, *arguments):
    subprocess.run([brindle, *arguments, "--quiet"], cwd=folder, check=True,
                   stdout=subprocess.DEVNULL)


def kept(wanted, found):
    """The arrays that are not as they were."""
    wrong = []
    for (place, name), values in wanted.items():
        other = found.get((place, name))
        if other is None or other.dtype != values.dtype or not np.array_equal(other, values):
            wrong.append(f"{place} {name}")
    return wrong


def check_formats(brindle, folder, surface):
    failures = 0
    for name, source, options in writes(surface):
        pv.SaveData(os.path.join(folder, name), proxy=source, **options)
        wanted = fetched(os.path.join(folder, name))  # text of legacy files is rounded
        if name.endswith(".ply"):
            wanted.pop(("point", "Normals"), None)  # nx, ny, nz: Brindle's own take their place
        ply = name.endswith(".ply")
        field = ("--direction", "0,0,1") if ply else ("--field", "array:velocity")
        run(brindle, folder, "stripe", name, *field, "--stripes", "20", "--output", "out.vtp")
        found = fetched(os.path.join(folder, "out.vtp"))
        wrong = kept(wanted, found)
        missing = [key for key in ("sin_phase", "valid", "direction") if ("point", key) not in found]
        failures += bool(wrong or missing)
        print(f"{name:28} {len(wanted)} arrays {'agree' if not wrong else 'WRONG: ' + ', '.join(wrong)}"
              + (f" MISSING: {missing}" if missing else ""))
    return failures


def check_csv(brindle, folder, surface):
    """The spreadsheet's columns are the same field as the array."""
    pv.SaveData(os.path.join(folder, "table.csv"), proxy=surface, FieldAssociation="Point Data",
                Precision=17)
    reports = []
    for number, field in enumerate(("array:velocity", "table.csv:velocity")):
        run(brindle, folder, "stripe", "Appended_ZLib_0.vtp", "--field", field, "--stripes", "20",
            "--report", f"csv{number}.json")
        with open(os.path.join(folder, f"csv{number}.json")) as report:
            reports.append(json.load(report))
    same = all(reports[0][key] == reports[1][key] for key in ("energy", "branches"))
    print(f"{'table.csv':28} {'the same field' if same else 'ANOTHER FIELD'}")
    return not same


def check_series(brindle, folder):
    """Drawn by the lines of docs/paraview.md."""
    for step in range(FRAMES):
        run(brindle, folder, "stripe", "shape:torus,resolution=96", "--stripes", "12", "--rotate",
            str(3 * step), "--output", f"step_{step}.vtp")
    run(brindle, folder, "animate", "--series", "step_%d.vtp", "--field", "array:direction",
        "--stripes", "12", "--output", "run_%d.vtp")
    view = pv.CreateView("RenderView")
    view.ViewSize = [800, 600]
    view.UseLight = 0
    view.Background = [0, 0, 0]
    view.UseColorPaletteForBackground = 0
    series = pv.OpenDataFile(os.path.join(folder, "run.pvd"))
    times = list(series.TimestepValues)
    steps = pv.Show(series, view)
    pv.ColorBy(steps, ("POINTS", "sin_phase"))
    steps.SetScalarBarVisibility(view, False)
    table = pv.GetColorTransferFunction("sin_phase")
    table.RescaleTransferFunction(-1, 1)
    table.NumberOfTableValues = 2
    view.ResetCamera()
    shares = []
    for number, time in enumerate(times):
        view.ViewTime = time
        pv.Render(view)
        image = os.path.join(folder, f"series_{number}.png")
        pv.SaveScreenshot(image, view)
        shares.append(share_of_stripes(image))
    pv.Delete(view)  # while its display is there
    good = len(times) == FRAMES and all(0.35 < share < 0.65 for share in shares)
    print(f"{'run.pvd':28} times {times}, stripes on "
          + ", ".join(f"{100 * share:.0f} %" for share in shares) + ("" if good else "  WRONG"))
    return not good


def share_of_stripes(image):
    """Warm pixels among all that show the surface: two colours of the map, red and blue."""
    from vtkmodules.vtkIOImage import vtkPNGReader
    reader = vtkPNGReader()
    reader.SetFileName(image)
    reader.Update()
    pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())[:, :3].astype(int)
    surface = pixels.sum(axis=1) > 60
    return (pixels[surface][:, 0] > pixels[surface][:, 2]).mean()


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("brindle")
    parser.add_argument("--keep", help="leave the files here")
    options = parser.parse_args()
    brindle = os.path.abspath(options.brindle)
    folder = os.path.abspath(options.keep) if options.keep else tempfile.mkdtemp(prefix="brindle_")
    os.makedirs(folder, exist_ok=True)
    surface = made_surface()
    failures = check_formats(brindle, folder, surface)
    failures += check_csv(brindle, folder, surface)
    failures += check_series(brindle, folder)
    print("ParaView", pv.GetParaViewVersion(), "and Brindle agree" if not failures else "DISAGREE")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
