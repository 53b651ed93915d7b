"""Reads Brindle's curves and samples back with VTK and compares them with the surface and the picture.

VTK (python3-vtk9) reads .vtp and .obj lines and .vtp and .ply samples. Numbers must be those of the
report, all points on the surface, and the strokes of the .svg drawing on the stripes of the .png
picture that is taken from the same side. Skipped without numpy and VTK.
"""

import json
import re
import subprocess

import pytest

np = pytest.importorskip("numpy")
vtk = pytest.importorskip("vtk")
from vtk.util.numpy_support import vtk_to_numpy  # noqa: E402

WANTED_ON_STRIPES = 0.97


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
    assert len(lengths) == report["curves"], f".vtp has {report['curves']} curves"
    assert vtp.GetNumberOfPoints() == report["points"], f".vtp has {report['points']} points"
    assert abs(lengths.sum() - report["length"]) < 1e-4 * report["length"], ".vtp length"
    stored = vtk_to_numpy(vtp.GetCellData().GetArray("length"))
    assert np.allclose(stored, lengths, rtol=1e-4, atol=1e-6 * size), ".vtp lengths per curve"
    obj = read(vtk.vtkOBJReader(), "curves.obj")
    assert np.allclose(np.sort(line_lengths(obj)), np.sort(lengths), rtol=1e-3, atol=1e-5 * size)
    assert farthest_from(surface, points_of(vtp)) < 2e-6 * size, "curves lie on the surface"


def check_samples(report, surface, size):
    vtp = read(vtk.vtkXMLPolyDataReader(), "samples.vtp")
    ply = read(vtk.vtkPLYReader(), "samples.ply")
    assert vtp.GetNumberOfVerts() == report["samples"], f".vtp has {report['samples']} samples"
    assert np.array_equal(points_of(vtp), points_of(ply)), ".ply has the same samples"
    assert farthest_from(surface, points_of(vtp)) < 2e-6 * size, "samples lie on the surface"
    triangles = vtk_to_numpy(vtp.GetPointData().GetArray("triangle")).astype(int)
    weights = vtk_to_numpy(vtp.GetPointData().GetArray("barycentric"))
    corners = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)[triangles]
    places = np.einsum("ij,ijk->ik", weights, points_of(surface)[corners])
    assert np.abs(places - points_of(vtp)).max() < 2e-6 * size, "triangles and weights give points"


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
    assert total > 0 and on >= WANTED_ON_STRIPES * total, f"{on} of {total} strokes on stripes"


def test_files_agree(tool, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)

    def run(command, *options):
        subprocess.run([tool, command, "shape:trefoil", "--stripes", "30", "-q", *options], check=True)

    run("stripe", "-o", "surface.vtp", "-o", "stripes.png")
    run("curves", "-o", "curves.vtp", "-o", "curves.obj", "-o", "curves.svg", "--report", "c.json")
    run("sample", "-o", "samples.vtp", "-o", "samples.ply", "--report", "s.json")
    surface = read(vtk.vtkXMLPolyDataReader(), "surface.vtp")
    size = surface.GetLength()
    check_lines(json.load(open("c.json"))["u"], surface, size)
    check_samples(json.load(open("s.json")), surface, size)
    check_drawing()
