#!/usr/bin/env pvpython
"""Loads the plugin into ParaView, lets it make, follow and draw stripes, and looks at the pictures.

    xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" pvpython check_plugin.py Brindle.so
                                                     [--tool BRINDLE] [--keep FOLDER]

With --tool, the phases in ParaView must be those that `brindle stripe` writes for the same file, bit
for bit. Ends with 0 if all is well and 1 if not.
"""

import argparse
import json
import os
import subprocess
import sys
import tempfile

import numpy as np
from paraview import servermanager
from paraview import simple as pv
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkStringOutputWindow, vtkOutputWindow
from vtkmodules.vtkIOImage import vtkPNGReader

FILTERS = ("BrindleStripes", "BrindleCurves", "BrindleSamples")
SIZE = (800, 600)
failures = []


def check(holds, what):
    if not holds:
        failures.append(what)
    print(("ok      " if holds else "WRONG   ") + what, flush=True)


def array(data, name):
    return vtk_to_numpy(data.GetPointData().GetArray(name))


def information(proxy, name):
    proxy.UpdatePropertyInformation()
    return proxy.GetProperty(name)[0]


def swirl(turn=0.0):
    """A torus with vectors."""
    source = pv.Superquadric(Toroidal=1, ThetaResolution=256, PhiResolution=128)
    field = pv.Calculator(Input=source, ResultArrayName="v",
                          Function=f"(coordsY+{turn})*iHat-coordsX*jHat+0.4*kHat")
    field.UpdatePipeline()
    return field


def is_described(proxy):
    properties = proxy.SMProxy.NewPropertyIterator()
    properties.Begin()
    missing = []
    while not properties.IsAtEnd():
        one = properties.GetProperty()
        text = one.GetDocumentation()
        if properties.GetKey() != "Input" and not (text and text.GetDescription().strip()):
            missing.append(properties.GetKey())
        properties.Next()
    return missing


def loaded_libraries():
    with open("/proc/self/maps") as maps:
        return {os.path.basename(line.split()[-1]) for line in maps if ".so" in line}


def check_filters(plugin):
    before = loaded_libraries()
    pv.LoadPlugin(plugin, remote=False, ns=globals())
    brought = [name for name in loaded_libraries() - before if "Qt" in name or "Icons" in name]
    check("Brindle.so" in loaded_libraries() and not brought,
          f"where there are no windows the plugin loads no icons and no Qt {brought}")
    check(all(name in globals() for name in FILTERS), "the plugin brings its filters")
    field = swirl()
    for name in FILTERS:
        proxy = globals()[name](Input=field)
        check(not is_described(proxy), f"{name}: every property is described {is_described(proxy)}")
        check(list(proxy.Vectors) == ["POINTS", "v"] and proxy.Field == "Smooth",
              f"{name}: vectors are found")
        proxy.Field = "Array"
        proxy.UpdatePipeline()
        data = servermanager.Fetch(proxy)
        check(data.GetNumberOfCells() > 0, f"{name}: makes {data.GetNumberOfCells()} cells of an array")
        pv.Delete(proxy)


def check_tool(tool, folder):
    """The same file in ParaView and in the tool."""
    path = os.path.join(folder, "swirl.vtp")
    pv.SaveData(path, proxy=pv.Triangulate(Input=swirl()))
    report = os.path.join(folder, "tool.json")
    subprocess.run([tool, "stripe", path, "--field", "array:v", "--along", "--stripes", "30", "--uv",
                    "--quiet", "--output", os.path.join(folder, "tool.vtp"), "--report", report], check=True)
    theirs = servermanager.Fetch(pv.OpenDataFile(os.path.join(folder, "tool.vtp")))
    stripes = BrindleStripes(Input=pv.OpenDataFile(path), Field="Array", Stripes=30)
    stripes.Vectors = ["POINTS", "v"]
    stripes.StripesRun = "Along the Field"
    stripes.UpdatePipeline()
    ours = servermanager.Fetch(stripes)
    points = servermanager.Fetch(stripes.Input).GetNumberOfPoints()
    for name in ("phase", "sin_phase", "frequency", "direction", "branch", "valid"):
        check(np.array_equal(array(ours, name)[:points], array(theirs, name)[:points], equal_nan=True),
              f"'{name}' is that of brindle stripe")
    with open(report) as file:
        told = json.load(file)
    for name in ("edges_per_period_min", "edges_per_period_median"):
        metric = ours.GetFieldData().GetArray(name).GetValue(0)
        check(abs(metric - told[name]) <= 1e-5 * metric, f"{name} is {metric:.3g}, as in the tool's report")


def check_series(folder):
    """A series of files, each read again: constant cells, turning vectors."""
    with open(os.path.join(folder, "run.pvd"), "w") as index:
        index.write('<VTKFile type="Collection" version="0.1"><Collection>\n')
        for step in range(4):
            name = f"step_{step}.vtp"
            pv.SaveData(os.path.join(folder, name), proxy=pv.Triangulate(Input=swirl(0.05 * step)))
            index.write(f'<DataSet timestep="{step}" file="{name}"/>\n')
        index.write("</Collection></VTKFile>\n")
    series = pv.OpenDataFile(os.path.join(folder, "run.pvd"))
    stripes = BrindleStripes(Input=series, Field="Array")
    stripes.Vectors = ["POINTS", "v"]
    phases, milliseconds = [], []
    for time in series.TimestepValues:
        stripes.UpdatePipeline(time)
        milliseconds.append(information(stripes, "SolveMilliseconds"))
        phases.append(array(servermanager.Fetch(stripes), "phase"))
    made = [information(stripes, name) for name in ("SurfacesMade", "SolversMade", "PatternsFollowed")]
    check(made == [1, 1, 3], f"a series builds once and follows: surfaces, solvers, followed {made}")
    count = min(len(p) for p in phases)
    turned = [np.nanmean(np.abs(np.angle(np.exp(1j * (b[:count] - a[:count])))))
              for a, b in zip(phases, phases[1:])]
    print("        milliseconds", [round(m, 1) for m in milliseconds], "mean phase steps",
          [round(float(t), 3) for t in turned])
    stripes.UpdatePipeline(0)
    check(information(stripes, "SolversMade") == 2, "going back starts afresh")
    check(np.array_equal(array(servermanager.Fetch(stripes), "phase"), phases[0], equal_nan=True),
          "and shows what was shown there")


def pixels(view, folder, name):
    path = os.path.join(folder, name)
    pv.SaveScreenshot(path, view, ImageResolution=SIZE)
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars())[:, :3].reshape(height, width, 3)[..., 0]


def flat_view(stripes, height):
    """Looks at a plane at right angles, with a visible height of `height`."""
    view = pv.CreateView("RenderView")
    view.ViewSize = SIZE
    view.Background = [0.5, 0, 0]
    view.UseColorPaletteForBackground = 0
    view.OrientationAxesVisibility = 0
    view.CameraParallelProjection = 1
    view.CameraPosition = [0.013, 0.007, 3]
    view.CameraFocalPoint = [0.013, 0.007, 0]
    view.CameraViewUp = [0, 1, 0]
    view.CameraParallelScale = height / 2
    shown = pv.Show(stripes, view)
    pv.ColorBy(shown, ("POINTS", None))
    shown.Representation = "Brindle Stripes"
    shown.DiffuseColor = [1, 1, 1]
    shown.StripeColor = [0, 0, 0]
    shown.Ambient, shown.Diffuse = 1, 0
    shown.AmbientColor = [1, 1, 1]
    return view, shown


def bars(row):
    """Sub-pixel positions of changes between light and dark along a row."""
    level = row.astype(float) / 255 - 0.5
    places = np.nonzero(np.sign(level[:-1]) != np.sign(level[1:]))[0]
    return places + level[places] / (level[places] - level[places + 1])


def check_picture(folder):
    """A plane has known stripes: bars of half a period each."""
    plane = pv.Plane(XResolution=200, YResolution=200, Origin=[-2, -2, 0], Point1=[2, -2, 0],
                     Point2=[-2, 2, 0])
    stripes = BrindleStripes(Input=plane, Field="Direction", Direction=[1, 0, 0], Frequency=8)
    stripes.SpacingBy = "Frequency"
    for name, height in (("near", 0.05), ("middle", 0.8), ("far", 300.0)):
        view, shown = flat_view(stripes, height)
        image = pixels(view, folder, f"plane_{name}.png")
        per_pixel = height / SIZE[1]
        if name == "far":
            middle = image[SIZE[1] // 2 - 3:SIZE[1] // 2 + 3, SIZE[0] // 2 - 3:SIZE[0] // 2 + 3]
            check(np.all(np.abs(middle.astype(int) - 128) < 26), f"from afar the mean: {middle.mean():.0f}")
        elif name == "near":
            mixed = np.mean((image > 20) & (image < 235))
            check(mixed < 0.01, f"from near borders are sharp: {100 * mixed:.2f} % of the pixels between")
        else:
            places = bars(image[SIZE[1] // 2])
            inner = np.diff(places)[1:-1]
            wanted = 1 / 16 / per_pixel
            check(len(inner) > 8 and np.all(np.abs(inner - wanted) < 1.5),
                  f"bars are half a period wide: {inner.min():.1f} to {inner.max():.1f} of {wanted:.1f} pixels")
            pv.ColorBy(shown, ("POINTS", "frequency"))
            pv.GetColorTransferFunction("frequency").RGBPoints = [0, 1, 1, 1, 100, 1, 1, 1]
            shown.SetScalarBarVisibility(view, False)
            same = bars(pixels(view, folder, "plane_colored.png")[SIZE[1] // 2])
            check(len(same) == len(places) and np.all(np.abs(same - places) < 1),
                  "stripes stay where they are over colours by an array")
            pv.ColorBy(shown, ("POINTS", None))
            shown.StripeWidth = 0.25
            image = pixels(view, folder, "plane_thin.png")
            seen = (image[SIZE[1] // 2, 100:-100] < 128).mean()
            check(abs(seen - 0.25) < 0.05, f"thin stripes cover a quarter: {seen:.3f}")
        pv.Delete(view)


def complaints(work):
    """ParaView's output during `work`, and that of its Python."""
    said = vtkStringOutputWindow()
    before = vtkOutputWindow.GetInstance()
    vtkOutputWindow.SetInstance(said)
    result = work()
    vtkOutputWindow.SetInstance(before)
    return said.GetOutput(), result


def check_without_coordinates(folder):
    """The representation on surfaces without stripes."""
    plane = pv.Plane()
    plain = BrindleStripes(Input=plane, TextureCoordinates=0)
    for source, what in ((plain, "without coordinates"), (plane, "of another source")):
        view, _ = flat_view(source, 0.5)
        said, image = complaints(lambda: pixels(view, folder, "plain.png"))
        check(not said, f"a surface {what} is drawn without complaint {said[:300]}")
        if source is plain:
            check((image[250:350, 350:450] > 200).all(), "and without stripes")
        pv.Delete(view)


def check_errors():
    """An error message, an empty output and no crash."""
    stripes = BrindleStripes(Input=pv.Sphere(), Field="Direction", Direction=[0, 0, 0])
    said, _ = complaints(stripes.UpdatePipeline)
    check("0,0,0" in said, "a direction of no length is refused: " + said.strip().splitlines()[-1][-80:])
    check(servermanager.Fetch(stripes).GetNumberOfPoints() == 0, "and nothing is shown")
    stripes.Direction = [0, 0, 1]
    stripes.UpdatePipeline()
    check(servermanager.Fetch(stripes).GetNumberOfPoints() > 0, "until it is put right")


def check_state(folder):
    """A session is restored from a file."""
    plane = pv.Plane(XResolution=60, YResolution=60)
    stripes = BrindleStripes(Input=plane, Field="Direction", Direction=[1, 0, 0], Stripes=12)
    view, shown = flat_view(stripes, 1.5)
    shown.StripeWidth = 0.3
    image = pixels(view, folder, "before.png")
    path = os.path.join(folder, "session.pvsm")
    pv.SaveState(path)
    pv.ResetSession()
    pv.LoadState(path)
    again = pixels(pv.GetRenderViews()[-1], folder, "after.png")
    check(np.array_equal(image, again), "a saved session draws the same picture")


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("plugin")
    parser.add_argument("--tool", help="compare with this brindle")
    parser.add_argument("--keep", help="leave the files here")
    options = parser.parse_args()
    folder = os.path.abspath(options.keep) if options.keep else tempfile.mkdtemp(prefix="brindle_")
    os.makedirs(folder, exist_ok=True)
    check_filters(os.path.abspath(options.plugin))
    if options.tool:
        check_tool(os.path.abspath(options.tool), folder)
    check_series(folder)
    check_picture(folder)
    check_without_coordinates(folder)
    check_errors()
    check_state(folder)
    for view in pv.GetRenderViews():
        pv.Delete(view)  # while its display is there
    print(f"{len(failures)} wrong" if failures else "all is well")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
