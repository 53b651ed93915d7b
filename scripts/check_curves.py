#!/usr/bin/python3
"""Reads Brindle's curves and samples back with VTK and compares them with the surface and the picture.

    scripts/check_curves.py build/release/apps/brindle/brindle [--mesh MESH] [--stripes N]

VTK (python3-vtk9) reads .vtp and .obj lines and .vtp and .ply samples. Numbers must be those of the
report, all points on the surface, and the strokes of the .svg drawing on the stripes of the .png
picture that is taken from the same side. Exits with 0 if all agree, 1 if not, 77 if VTK is missing.
"""

import argparse
import json
import os
import re
import subprocess
import sys
import tempfile

SKIPPED = 77
WANTED_ON_STRIPES = 0.97

try:
    import numpy as np
    import vtk
    from vtk.util.numpy_support import vtk_to_numpy
except ImportError as missing:
    print(f"skipped: {missing}; install python3-vtk9 and python3-numpy")
    sys.exit(SKIPPED)

failures = []


def expect(holds, what):
    print(("ok    " if holds else "WRONG ") + what)
    if not holds:
        failures.append(what)


def read(reader, path):
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def points_of(data):
    return vtk_to_numpy(data.GetPoints().GetData()).astype(float)


def line_lengths(data):
    points, lengths = points_of(data), []
    lines, ids = data.GetLines(), vtk.vtkIdList()
    lines.InitTraversal()
    while lines.GetNextCell(ids):
        along = points[[ids.GetId(i) for i in range(ids.GetNumberOfIds())]]
        lengths.append(np.linalg.norm(np.diff(along, axis=0), axis=1).sum())
    return np.array(lengths)


def farthest_from(surface, points):
    locator = vtk.vtkCellLocator()
    locator.SetDataSet(surface)
    locator.BuildLocator()
    nearest, cell, sub, square = [0, 0, 0], vtk.reference(0), vtk.reference(0), vtk.reference(0.0)
    most = 0
    for point in points:
        locator.FindClosestPoint(point, nearest, cell, sub, square)
        most = max(most, float(square) ** 0.5)
    return most


def check_lines(report, surface, size):
    vtp = read(vtk.vtkXMLPolyDataReader(), "curves.vtp")
    lengths = line_lengths(vtp)
    expect(len(lengths) == report["curves"], f".vtp has {report['curves']} curves")
    expect(vtp.GetNumberOfPoints() == report["points"], f".vtp has {report['points']} points")
    expect(abs(lengths.sum() - report["length"]) < 1e-4 * report["length"], ".vtp length")
    stored = vtk_to_numpy(vtp.GetCellData().GetArray("length"))
    expect(np.allclose(stored, lengths, rtol=1e-4, atol=1e-6 * size), ".vtp lengths per curve")
    obj = read(vtk.vtkOBJReader(), "curves.obj")
    expect(np.allclose(np.sort(line_lengths(obj)), np.sort(lengths), rtol=1e-3, atol=1e-5 * size),
           ".obj has the same curves")
    expect(farthest_from(surface, points_of(vtp)) < 2e-6 * size, "curves lie on the surface")


def check_samples(report, surface, size):
    vtp = read(vtk.vtkXMLPolyDataReader(), "samples.vtp")
    ply = read(vtk.vtkPLYReader(), "samples.ply")
    expect(vtp.GetNumberOfVerts() == report["samples"], f".vtp has {report['samples']} samples")
    expect(np.array_equal(points_of(vtp), points_of(ply)), ".ply has the same samples")
    expect(farthest_from(surface, points_of(vtp)) < 2e-6 * size, "samples lie on the surface")
    triangles = vtk_to_numpy(vtp.GetPointData().GetArray("triangle")).astype(int)
    weights = vtk_to_numpy(vtp.GetPointData().GetArray("barycentric"))
    corners = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)[triangles]
    places = np.einsum("ij,ijk->ik", weights, points_of(surface)[corners])
    expect(np.abs(places - points_of(vtp)).max() < 2e-6 * size, "triangles and weights give points")


def check_drawing():
    image = read(vtk.vtkPNGReader(), "stripes.png")
    width, height, _ = image.GetDimensions()
    pixels = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)[::-1]
    group = re.search(r'<g id="u".*?</g>', open("curves.svg").read(), re.S).group(0)
    on = total = 0
    for path in re.findall(r'd="M([^"]*)"', group):
        points = np.array([float(n) for n in path.replace("L", " ").split()]).reshape(-1, 2)
        for x, y in (points[1:] + points[:-1]) / 2:
            row, column = min(int(y), height - 1), min(int(x), width - 1)
            near = pixels[max(row - 1, 0):row + 2, max(column - 1, 0):column + 2].astype(int)
            on += (near[..., 2] > near[..., 0]).any()  # blue stripes on sand, in light and shade
            total += 1
    expect(total > 0 and on >= WANTED_ON_STRIPES * total, f"{on} of {total} strokes on stripes")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("brindle")
    parser.add_argument("--mesh", default="shape:trefoil")
    parser.add_argument("--stripes", default="30")
    arguments = parser.parse_args()
    brindle = os.path.abspath(arguments.brindle)
    mesh = arguments.mesh if arguments.mesh.startswith("shape:") else os.path.abspath(arguments.mesh)

    def run(command, *options):
        subprocess.run([brindle, command, mesh, "--stripes", arguments.stripes, "-q", *options],
                       check=True)

    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        run("stripe", "-o", "surface.vtp", "-o", "stripes.png")
        run("curves", "-o", "curves.vtp", "-o", "curves.obj", "-o", "curves.svg", "--report", "c.json")
        run("sample", "-o", "samples.vtp", "-o", "samples.ply", "--report", "s.json")
        surface = read(vtk.vtkXMLPolyDataReader(), "surface.vtp")
        size = surface.GetLength()
        check_lines(json.load(open("c.json"))["u"], surface, size)
        check_samples(json.load(open("s.json")), surface, size)
        check_drawing()
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
