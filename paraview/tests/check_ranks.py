#!/usr/bin/env pvbatch
"""Stripes over the ranks of ParaView: one pattern, and pictures in which no border is seen.

    mpirun -n 2 pvbatch check_ranks.py Brindle.so --folder FOLDER
    mpirun -n 1 pvbatch check_ranks.py Brindle.so --folder FOLDER --against 2

Both under xvfb-run -a -s "-screen 0 1280x1024x24 -noreset". The second compares its pictures with
those of the first. Ends with 0 if all is well and 1 if not.
"""

import argparse
import os
import sys

import numpy as np
from paraview import servermanager
from paraview import simple as pv
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

SIZE = (800, 600)
failures = []


def check(holds, what):
    if not holds:
        failures.append(what)
    print(("ok      " if holds else "WRONG   ") + what, flush=True)


def rank_count():
    return servermanager.vtkProcessModule.GetProcessModule().GetNumberOfLocalPartitions()


def parts(source):
    """A distributed surface with the rank's number at its points."""
    pieces = pv.RedistributeDataSet(Input=pv.Triangulate(Input=source))
    pieces.GenerateGlobalCellIds = 0
    return pv.ProcessIdScalars(Input=pieces)


def array(data, name):
    return vtk_to_numpy(data.GetPointData().GetArray(name))


def check_shared_points(folder):
    """Points at one position have one phase on all ranks; also for partitioned files."""
    path = os.path.join(folder, f"pieces_{rank_count()}.pvtp")
    torus = parts(pv.Superquadric(Toroidal=1, ThetaResolution=256, PhiResolution=128))
    pv.SaveData(path, proxy=BrindleStripes(Input=torus, TextureCoordinates=0))
    torus = pv.ProcessIdScalars(Input=pv.OpenDataFile(path))
    field = pv.Calculator(Input=torus, ResultArrayName="v",
                          Function="coordsY*iHat-coordsX*jHat+0.4*kHat")
    stripes = BrindleStripes(Input=field, Field="Array", Stripes=40, TextureCoordinates=0)
    stripes.Vectors = ["POINTS", "v"]
    stripes.UpdatePipeline()
    data = servermanager.Fetch(stripes)
    points = vtk_to_numpy(data.GetPoints().GetData())
    ranks, phases = array(data, "ProcessId"), array(data, "phase")
    check(len(np.unique(ranks)) == rank_count(), f"{rank_count()} ranks have parts")
    _, place, count = np.unique(points, axis=0, return_inverse=True, return_counts=True)
    order = np.lexsort((ranks, place))
    same = place[order][1:] == place[order][:-1]
    across = same & (ranks[order][1:] != ranks[order][:-1])
    apart = np.abs(np.angle(np.exp(1j * (phases[order][1:] - phases[order][:-1]))))[same]
    check(across.sum() >= 50 * (rank_count() - 1), f"{across.sum()} points are shared by ranks")
    check(not np.nanmax(apart, initial=0) > 0, "and have the same phases, to the bit")


def check_curves():
    """Curves that need the whole surface are whole, longer than cut ones, and on one rank."""
    torus = parts(pv.Superquadric(Toroidal=1, ThetaResolution=128, PhiResolution=64))
    field = pv.Calculator(Input=torus, ResultArrayName="v",
                          Function="coordsY*iHat-coordsX*jHat+0.4*kHat")

    def lengths_and_ranks(**options):
        curves = BrindleCurves(Input=field, Field="Array", **options)
        curves.Vectors = ["POINTS", "v"]
        data = servermanager.Fetch(pv.ProcessIdScalars(Input=curves))
        pieces = np.unique(array(data, "ProcessId"))
        return vtk_to_numpy(data.GetCellData().GetArray("length")), list(pieces), data

    cut, everywhere, _ = lengths_and_ranks()
    whole, first, data = lengths_and_ranks(Join=1, MinimumLength=0.05)
    check(len(everywhere) == rank_count() and first == [0], f"whole curves are on one rank {first}")
    check(whole.min() >= 0.05 and whole.sum() > cut.sum(),
          f"{len(whole)} whole curves of {whole.sum():.2f}; {len(cut)} in parts of {cut.sum():.2f}")
    check(rank_count() == 1 or len(whole) < len(cut), "and fewer than in parts")
    check(data.GetPointData().HasArray("v") and data.GetPointData().HasArray("normal"),
          "with arrays")


def pixels(view, path):
    pv.SaveScreenshot(path, view, ImageResolution=SIZE)
    return read_pixels(path)


def read_pixels(path):
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars())[:, :3].reshape(height, width, 3)


def new_view(background):
    view = pv.CreateView("RenderView")
    view.ViewSize = SIZE
    view.UseColorPaletteForBackground = 0
    view.Background = background
    view.OrientationAxesVisibility = 0
    return view


def draw_striped(source, view):
    shown = pv.Show(source, view, "GeometryRepresentation")
    pv.ColorBy(shown, ("POINTS", None))
    shown.Representation = "Brindle Stripes"
    shown.DiffuseColor = shown.AmbientColor = [1, 1, 1]
    shown.StripeColor = [0, 0, 0]
    return shown


def bars(row):
    """Sub-pixel positions of changes between light and dark along a row."""
    level = row.astype(float) / 255 - 0.5
    places = np.nonzero(np.sign(level[:-1]) != np.sign(level[1:]))[0]
    return places + level[places] / (level[places] - level[places + 1])


def rows_of_bars(image):
    """Edges of bars in some rows of a picture, without those at its sides."""
    return [bars(image[y])[1:-1] for y in range(0, SIZE[1], 40)]


def farthest_from_one_shift(rows, others, width):
    """The largest distance, in bars, between the edges in two pictures, up to a common shift."""
    moves = np.concatenate([(a[:8] - b[:8]) / width for a, b in zip(rows, others)])
    turns = np.exp(2j * np.pi * moves)
    return np.abs(np.angle(turns / turns.mean())).max() / (2 * np.pi)


def check_plane(options):
    """Straight bars of known width continue across borders, as on one rank."""
    plane = parts(pv.Plane(XResolution=120, YResolution=90, Origin=[-2, -1.5, 0],
                           Point1=[2, -1.5, 0], Point2=[-2, 1.5, 0]))
    stripes = BrindleStripes(Input=plane, Field="Direction", Direction=[3, 1, 0], Frequency=8)
    stripes.SpacingBy = "Frequency"
    view = new_view([0.5, 0, 0])
    view.CameraParallelProjection = 1
    view.CameraPosition = [0.013, 0.007, 3]
    view.CameraFocalPoint = [0.013, 0.007, 0]
    view.CameraParallelScale = 0.4
    shown = draw_striped(stripes, view)
    shown.Ambient, shown.Diffuse = 1, 0
    picture = os.path.join(options.folder, "plane_{}.png")
    rows = rows_of_bars(pixels(view, picture.format(rank_count()))[..., 0])
    wanted = SIZE[1] / 0.8 / 16 * np.sqrt(10) / 3
    worst = max(np.abs(np.diff(row) - wanted).max() for row in rows)
    check(min(len(row) for row in rows) > 10 and worst < 1.5,
          f"bars are {wanted:.1f} pixels wide everywhere, but for {worst:.2f}")
    if options.against:
        others = rows_of_bars(read_pixels(picture.format(options.against))[..., 0])
        apart = farthest_from_one_shift(rows, others, wanted)
        check(apart < 0.05, f"and those of {options.against} ranks but for a shift: {apart:.3f}")
    pv.Delete(view)


def check_picture(options):
    """Several ranks draw their partitions as one rank draws the same pieces of a file."""
    path = os.path.join(options.folder, "torus.pvtp")
    if options.against:
        stripes = pv.OpenDataFile(path)
    else:
        torus = parts(pv.Superquadric(Toroidal=1, ThetaResolution=256, PhiResolution=128))
        stripes = BrindleStripes(Input=torus, Field="Curvature", Stripes=30)
        pv.SaveData(path, proxy=stripes)
    view = new_view([1, 1, 1])
    view.CameraPosition = [0.8, -1.2, 1.8]
    view.CameraFocalPoint = [0, 0, 0]
    view.CameraViewAngle = 32
    draw_striped(stripes, view)
    image = pixels(view, os.path.join(options.folder, f"torus_{rank_count()}.png"))
    dark = (image.min(axis=2) < 60).mean()
    check(0.05 < dark < 0.6, f"stripes cover {100 * dark:.0f} % of the picture")
    if options.against:
        other = read_pixels(os.path.join(options.folder, f"torus_{options.against}.png"))
        apart = np.abs(image.astype(int) - other.astype(int)).max(axis=2) > 40
        check(apart.mean() < 1e-3, f"{100 * apart.mean():.3f} % of the pixels are others with "
                                   f"{options.against} ranks")
    pv.Delete(view)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("plugin")
    parser.add_argument("--folder", required=True, help="for pictures and data")
    parser.add_argument("--against", type=int,
                        help="compare with what so many ranks have left there")
    options = parser.parse_args()
    os.makedirs(options.folder, exist_ok=True)
    pv.LoadPlugin(os.path.abspath(options.plugin), remote=False, ns=globals())
    check_shared_points(options.folder)
    check_curves()
    check_plane(options)
    check_picture(options)
    print(f"{len(failures)} wrong" if failures else "all is well", flush=True)
    if failures:
        sys.exit(1)  # without ending MPI, which mpirun takes for a failure whatever the code


if __name__ == "__main__":
    main()
