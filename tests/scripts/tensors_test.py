"""Compares waves along tensors with eigenvectors that numpy computes.

VTK (python3-vtk9) writes plates at any angle with random symmetric tensors: of 6 and of 9 numbers, per
point and per cell; among them tensors that are isotropic, not symmetric or not finite. At every vertex
Brindle's direction must be numpy's eigenvector, projected into the plate, up to sign; and there must be
no wave where that is within 15 degrees of the normal, where eigenvalues are equal, and where there is
no tensor; the report must count the same. Skipped without numpy and VTK.
"""

import json
import subprocess

import pytest

np = pytest.importorskip("numpy")
vtk = pytest.importorskip("vtk")
from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy  # noqa: E402

SIDE = 40  # vertices
LIMIT_DEG = 15
UNDECIDED_DEG = 1e-3  # so near to the limit both answers are right
WORST_DEG = 1e-3


def random_rotation(random):
    q, r = np.linalg.qr(random.normal(size=(3, 3)))
    q = q * np.sign(np.diag(r))
    return q if np.linalg.det(q) > 0 else -q


def plate(random):
    """Points, triangles and the normal of a plate at any angle, whose vertices do not lie in rows."""
    x, y = np.meshgrid(np.arange(SIDE), np.arange(SIDE))
    flat = np.stack([x, y, 0 * x], axis=-1).reshape(-1, 3).astype(float)
    flat[:, :2] += random.uniform(-0.2, 0.2, size=(len(flat), 2))  # folds no triangle
    corner = (np.arange(SIDE - 1) + SIDE * np.arange(SIDE - 1)[:, None]).ravel()
    triangles = np.concatenate([np.stack([corner, corner + 1, corner + SIDE + 1], axis=1),
                                np.stack([corner, corner + SIDE + 1, corner + SIDE], axis=1)])
    turn = random_rotation(random)
    return flat @ turn.T, triangles, turn[:, 2]


def random_tensors(random, count):
    tensors = random.normal(size=(count, 3, 3))
    tensors = tensors + tensors.transpose(0, 2, 1)
    for i in range(0, count, 50):  # two equal eigenvalues, or three
        q = random_rotation(random)
        tensors[i] = q @ np.diag([2, 2, i % 100 / 50]) @ q.T if i % 150 else 3 * np.eye(3)
    return tensors


def written(path, points, triangles, name, rows, per_cell):
    data = vtk.vtkPolyData()
    vertices = vtk.vtkPoints()
    vertices.SetData(numpy_to_vtk(points.astype(np.float32), deep=True))
    data.SetPoints(vertices)
    cells = vtk.vtkCellArray()
    with_counts = np.insert(triangles, 0, 3, axis=1).ravel().astype(np.int64)
    cells.SetCells(len(triangles), numpy_to_vtkIdTypeArray(with_counts, deep=True))
    data.SetPolys(cells)
    array = numpy_to_vtk(np.ascontiguousarray(rows), deep=True)
    array.SetName(name)
    (data.GetCellData() if per_cell else data.GetPointData()).AddArray(array)
    writer = vtk.vtkXMLPolyDataWriter()
    writer.SetFileName(path)
    writer.SetInputData(data)
    assert writer.Write() == 1


def directions_of(path):
    reader = vtk.vtkXMLPolyDataReader()
    reader.SetFileName(path)
    reader.Update()
    directions = vtk_to_numpy(reader.GetOutput().GetPointData().GetArray("direction")).astype(float)
    return np.where(np.isfinite(directions).all(axis=1, keepdims=True), directions, 0)


def means_by_area(points, triangles, tensors):
    a, b, c = (points[triangles[:, i]] for i in range(3))
    areas = np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2
    areas = np.where(np.isfinite(tensors).all(axis=(1, 2)), areas, 0)
    sums, total = np.zeros((len(points), 3, 3)), np.zeros(len(points))
    for i in range(3):
        np.add.at(sums, triangles[:, i], areas[:, None, None] * np.nan_to_num(tensors))
        np.add.at(total, triangles[:, i], areas)
    with np.errstate(invalid="ignore"):
        return sums / total[:, None, None]


def expected_axes(tensors, axis):
    """Per tensor the axis, and whether it is the only one with its eigenvalue."""
    symmetric = (tensors + tensors.transpose(0, 2, 1)) / 2
    finite = np.isfinite(symmetric).all(axis=(1, 2))
    values, vectors = np.linalg.eigh(np.where(finite[:, None, None], symmetric, np.eye(3)))
    chosen = {"major": np.full(len(values), 2), "minor": np.zeros(len(values), int),
              "max-abs": np.where(-values[:, 0] > values[:, 2], 0, 2)}[axis]
    rows = np.arange(len(values))
    gap = np.abs(values[rows, chosen] - values[:, 1])
    single = gap > 1e-6 * np.abs(values).max(axis=1)
    return vectors[rows, :, chosen], single, finite


def compare(directions, tensors, normal, axis, report):
    axes, single, finite = expected_axes(tensors, axis)
    angles = np.degrees(np.arccos(np.clip(np.abs(axes @ normal), 0, 1)))
    decided = np.abs(angles - LIMIT_DEG) > UNDECIDED_DEG
    near = finite & single & (angles < LIMIT_DEG)
    wanted = finite & single & ~near
    waves = np.abs(directions).sum(axis=1) > 0
    projected = axes - np.outer(axes @ normal, normal)
    projected /= np.linalg.norm(projected, axis=1)[:, None]
    sines = np.linalg.norm(np.cross(projected, directions), axis=1)[wanted & waves]
    off = np.degrees(np.arcsin(np.clip(sines, 0, 1)))
    failures = []
    if (waves != wanted)[decided].any():
        failures.append(f"{(waves != wanted)[decided].sum()} vertices with and without wave")
    if off.max() > WORST_DEG:
        failures.append(f"{(off > WORST_DEG).sum()} axes are others")
    if abs(report["tensor_vertices_near_normal"] - near.sum()) > (~decided).sum():
        failures.append(f"near the normal: {near.sum()} wanted")
    if report["tensor_vertices_isotropic"] != (finite & ~single).sum():
        failures.append(f"isotropic: {(finite & ~single).sum()} wanted")
    assert not failures, f"{axis}: {waves.sum()} axes, off by at most {off.max():.1e} degrees; {'; '.join(failures)}"


@pytest.mark.parametrize("axis", ("major", "minor", "max-abs"))
@pytest.mark.parametrize("per_cell", (False, True))
@pytest.mark.parametrize("components", (6, 9))
def test_axes_are_those_of_numpy(tool, tmp_path, components, per_cell, axis):
    random = np.random.default_rng(components + per_cell)
    points, triangles, normal = plate(random)
    points = points.astype(np.float32).astype(float)
    tensors = random_tensors(random, len(triangles) if per_cell else len(points))
    if components == 9:
        tensors[7::20] += 0.5 * random.normal(size=tensors[7::20].shape)  # not symmetric
    tensors[5::40] = np.nan
    rows = tensors.reshape(-1, 9) if components == 9 else np.stack(
        [tensors[:, i, j] for i, j in ((0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (0, 2))], axis=1)
    written(str(tmp_path / "tensors.vtp"), points, triangles, "stress", rows, per_cell)
    at_points = means_by_area(points, triangles, tensors) if per_cell else tensors
    subprocess.run([tool, "stripe", "tensors.vtp", "--field", "array:stress", "--tensor", axis, "--stripes", "10",
                    "--output", "waves.vtp", "--report", "report.json", "-q"], cwd=tmp_path, check=True)
    report = json.loads((tmp_path / "report.json").read_text())
    compare(directions_of(str(tmp_path / "waves.vtp")), at_points, normal, axis, report)
