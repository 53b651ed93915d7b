#!/usr/bin/env pvpython
"""The same vectors as Brindle's stripes and as Surface LIC, and how long either takes to follow.

    xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" pvpython stripes_beside_lic.py
        [--plugin Brindle.so] [--surface FILE] [--stripes N] [--size 1200x900]
        [--output STRIPES.png --output LIC.png] [--session STRIPES.pvsm] [--show-ranks]

Or with `mpirun -n 2 pvbatch` instead of `pvpython`: the ranks then share the surface.

Vectors swirl over a surface, by default a torus, and turn with time. Stripes run along them and are
the denser the longer they are. Prints a table, the surface alone in its first row: milliseconds for a
first picture, and medians for one from another side and one of the next time, with all that ParaView
does for it. Pictures are half as large as what was measured. ParaView opens the session.
"""

import argparse
import math
import os
import statistics
import time

import numpy as np
from paraview import servermanager
from paraview import simple as pv
from vtkmodules.util.numpy_support import vtk_to_numpy

RANK_COLORS = [[0.93, 0.9, 0.83], [0.72, 0.83, 0.9], [0.93, 0.77, 0.72], [0.78, 0.88, 0.74]]

VECTORS = """
import numpy as np
from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.util.numpy_support import numpy_to_vtk
information = self.GetOutputInformation(0)
now = information.Get(vtkStreamingDemandDrivenPipeline.UPDATE_TIME_STEP()) \\
    if information.Has(vtkStreamingDemandDrivenPipeline.UPDATE_TIME_STEP()) else 0.0
surface = self.GetInputDataObject(0, 0)
output = self.GetOutputDataObject(0)
output.ShallowCopy(surface)
points = np.asarray(inputs[0].Points) if surface.GetNumberOfPoints() > 0 else np.zeros((0, 3))
points = (points - np.array(MIDDLE, dtype=points.dtype)) / points.dtype.type(SIZE)
angle = 0.05 * now
x, y, z = points.T
swirl = np.stack((np.cos(angle) - y + 0.4 * np.sin(4 * z), np.sin(angle) + x, 0.6 * np.cos(3 * x)), 1)
array = numpy_to_vtk(swirl.astype(np.float32), deep=True)
array.SetName("velocity")
output.GetPointData().AddArray(array)
output.GetInformation().Set(vtkDataObject.DATA_TIME_STEP(), now)
"""

TIMES = """
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
information = self.GetOutputInformation(0)
steps = [float(step) for step in range(100)]
information.Remove(vtkStreamingDemandDrivenPipeline.TIME_STEPS())
for step in steps:
    information.Append(vtkStreamingDemandDrivenPipeline.TIME_STEPS(), step)
information.Remove(vtkStreamingDemandDrivenPipeline.TIME_RANGE())
information.Append(vtkStreamingDemandDrivenPipeline.TIME_RANGE(), steps[0])
information.Append(vtkStreamingDemandDrivenPipeline.TIME_RANGE(), steps[-1])
"""


def rank_count():
    return servermanager.vtkProcessModule.GetProcessModule().GetNumberOfLocalPartitions()


def in_pieces(surface):
    """The surface in partitions, one per rank, with the rank's number at their points."""
    pieces = pv.RedistributeDataSet(Input=surface)
    pieces.GenerateGlobalCellIds = 0
    return pv.ProcessIdScalars(Input=pieces)


def moving_vectors(options):
    """A surface with the array velocity, vectors that change with time."""
    if options.surface:
        surface = pv.OpenDataFile(options.surface)
    else:
        surface = pv.Superquadric(Toroidal=1, ThetaResolution=400, PhiResolution=200)
    points = vtk_to_numpy(servermanager.Fetch(surface).GetPoints().GetData())
    middle = points.mean(axis=0)
    if rank_count() > 1 or options.show_ranks:
        surface = in_pieces(surface)
    return pv.ProgrammableFilter(
        Input=surface, RequestInformationScript=TIMES,
        Script="from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline\n"
        f"MIDDLE, SIZE = {[float(m) for m in middle]}, {float(np.abs(points - middle).max())}\n"
        + VECTORS)


def new_view(size):
    view = pv.CreateView("RenderView")
    view.ViewSize = size
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    view.OrientationAxesVisibility = 0
    return view


def color_ranks(shown, view):
    pv.ColorBy(shown, ("POINTS", "ProcessId"))
    colors = pv.GetColorTransferFunction("ProcessId")
    colors.ColorSpace = "RGB"
    colors.RGBPoints = [x for rank in range(rank_count() + 1)
                        for x in (rank, *RANK_COLORS[rank % len(RANK_COLORS)])]
    shown.SetScalarBarVisibility(view, False)


def show_stripes(vectors, options, view):
    pattern = BrindleStripes(Input=vectors, Field="Array", Stripes=options.stripes)
    pattern.Vectors = ["POINTS", "velocity"]
    pattern.StripesRun = "Along the Field"
    pattern.SpacingBy = "Stripes Times Factor by Array"
    pattern.FrequencyArray = ["POINTS", "velocity"]
    pattern.FrequencyRange = [0.7, 1.5]
    shown = pv.Show(pattern, view)
    shown.Representation = "Brindle Stripes"
    pv.ColorBy(shown, ("POINTS", None))
    shown.DiffuseColor = shown.AmbientColor = [0.93, 0.9, 0.83]
    shown.StripeColor = [0.11, 0.2, 0.35]
    if options.show_ranks:
        color_ranks(shown, view)
    return pattern


def show_plain(vectors, view):
    shown = pv.Show(vectors, view)
    pv.ColorBy(shown, ("POINTS", None))
    shown.DiffuseColor = shown.AmbientColor = [0.93, 0.9, 0.83]
    return shown


def show_lic(vectors, view):
    shown = show_plain(vectors, view)
    shown.SelectInputVectors = ["POINTS", "velocity"]
    shown.Representation = "Surface LIC"
    return shown


def milliseconds(work):
    begin = time.perf_counter()
    work()
    return 1000 * (time.perf_counter() - begin)


def measure(view, repeats):
    """The time of a first picture, then medians for another view and for another time."""
    camera = view.GetActiveCamera()

    def turned():
        camera.Azimuth(4)
        view.StillRender()

    def later():
        view.ViewTime += 1
        view.StillRender()

    first = milliseconds(lambda: view.StillRender())
    turned()
    sides = [milliseconds(turned) for _ in range(repeats)]
    later()
    times = [milliseconds(later) for _ in range(repeats)]
    camera.Azimuth(-4 * (repeats + 1))
    return first, statistics.median(sides), statistics.median(times)


def aim(view, bounds, options):
    """A view direction, at a distance at which the surface fills the picture."""
    middle = [(low + high) / 2 for low, high in zip(bounds[::2], bounds[1::2])]
    away = [float(c) for c in options.look_from.split(",")]
    size = math.dist(bounds[::2], bounds[1::2])
    length = math.hypot(*away)
    view.CameraFocalPoint = middle
    view.CameraPosition = [m + 1.4 * size * a / length for m, a in zip(middle, away)]
    view.CameraViewUp = [float(c) for c in options.up.split(",")]


def arguments():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--plugin", help="load this; otherwise PV_PLUGIN_PATH has been told of it")
    parser.add_argument("--surface", help="a file that ParaView reads")
    parser.add_argument("--stripes", type=float, default=60)
    parser.add_argument("--size", default="1200x900")
    parser.add_argument("--repeats", type=int, default=5)
    parser.add_argument("--look-from", default="1,-2,1.5", help="a direction, x,y,z")
    parser.add_argument("--up", default="0,0,1", help="what is above in pictures, x,y,z")
    parser.add_argument("--output", action="append", default=[],
                        help="a picture of the stripes, and again, one of the LIC")
    parser.add_argument("--show-ranks", action="store_true",
                        help="colour stripes' surface by the rank that has it")
    parser.add_argument("--session", help="ParaView's session with the stripes")
    return parser.parse_args()


def main():
    options = arguments()
    if options.plugin:
        pv.LoadPlugin(os.path.abspath(options.plugin), remote=False, ns=globals())
    size = [int(side) for side in options.size.split("x")]
    vectors = moving_vectors(options)
    vectors.UpdatePipeline()
    print(f"{vectors.GetDataInformation().GetNumberOfPoints()} points, {rank_count()} ranks, "
          f"{options.size}; milliseconds")
    print(f"{'':16}{'first':>8}{'view':>8}{'vectors':>8}")
    ways = (("surface", lambda view: show_plain(vectors, view)),
            ("stripes", lambda view: show_stripes(vectors, options, view)),
            ("Surface LIC", lambda view: show_lic(vectors, view)))
    pictures = dict(zip(("stripes", "Surface LIC"), options.output))
    for name, show in ways:
        view = new_view(size)
        show(view)
        view.ViewTime = 0
        aim(view, vectors.GetDataInformation().GetBounds(), options)
        first, side, later = measure(view, options.repeats)
        print(f"{name:16}{first:8.0f}{side:8.0f}{later:8.0f}", flush=True)
        view.ViewTime = 0
        if name in pictures:
            pv.SaveScreenshot(pictures[name], view, ImageResolution=[side // 2 for side in size])
        if options.session and name == "stripes":
            pv.SaveState(options.session)
        pv.Delete(view)  # while its display is there


if __name__ == "__main__":
    main()
