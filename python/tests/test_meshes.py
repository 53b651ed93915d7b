"""Objects of pyvista, trimesh, meshio and VTK, by what they look like."""

import importlib.util
import sys
import types

import numpy as np
import pytest

import brindle
from brindle import _core

meshio = pytest.importorskip("meshio")


@pytest.fixture
def data(square):
    vertices, triangles = square
    rng = np.random.default_rng(5)
    return {"points": {"velocity": rng.normal(size=(len(vertices), 3)) + [3, 0, 0],
                       "speed": 1 + rng.random(len(vertices))},
            "cells": {"number": np.arange(len(triangles), dtype=float)}}


def pyvista_like(square, data, padded=False):
    vertices, triangles = square
    mesh = types.SimpleNamespace(points=vertices, point_data=dict(data["points"]),
                                 cell_data=dict(data["cells"]), n_points=len(vertices))
    if padded:
        mesh.faces = np.insert(triangles, 0, 3, axis=1).ravel()
    else:
        mesh.regular_faces = triangles
    return mesh


def trimesh_like(square, data):
    return types.SimpleNamespace(vertices=square[0].astype("f8"), faces=square[1].astype("i8"),
                                 vertex_attributes=dict(data["points"]),
                                 face_attributes=dict(data["cells"]))


def meshio_of(square, data):
    vertices, triangles = square
    return meshio.Mesh(vertices, [("line", [[0, 1]]), ("triangle", triangles)],
                       point_data=dict(data["points"]),
                       cell_data={name: [np.zeros(1), array] for name, array in data["cells"].items()})


def vtk_of(square, data):
    vtk = pytest.importorskip("vtk")
    from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
    vertices, triangles = square
    points = vtk.vtkPoints()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(vertices), deep=1))
    cells = vtk.vtkCellArray()
    cells.SetCells(len(triangles), numpy_to_vtkIdTypeArray(
        np.insert(triangles.astype("i8"), 0, 3, axis=1).ravel(), deep=1))
    mesh = vtk.vtkPolyData()
    mesh.SetPoints(points)
    mesh.SetPolys(cells)
    for where, arrays in ((mesh.GetPointData(), data["points"]), (mesh.GetCellData(), data["cells"])):
        for name, array in arrays.items():
            made = numpy_to_vtk(np.ascontiguousarray(array), deep=1)
            made.SetName(name)
            where.AddArray(made)
    return mesh


MAKERS = {"pyvista": pyvista_like, "pyvista, padded": lambda *given: pyvista_like(*given, padded=True),
          "trimesh": trimesh_like, "meshio": meshio_of, "vtk": vtk_of}


@pytest.mark.parametrize("make", MAKERS.values(), ids=MAKERS)
def test_meshes_are_surfaces(make, square, data):
    mesh = make(square, data)
    expected = brindle.stripes(brindle.Surface(*square), data["points"]["velocity"], stripes=10)
    p = brindle.stripes(mesh, "velocity", stripes=10)
    np.testing.assert_array_equal(p.phases, expected.phases)
    np.testing.assert_array_equal(p.surface.faces, square[1])
    np.testing.assert_array_equal(p.surface.array("cells/number").shape, (len(square[0]),))
    by_name = brindle.stripes(mesh, "velocity", frequency="speed")
    np.testing.assert_array_equal(by_name.frequency, np.float32(data["points"]["speed"]))
    with pytest.raises(brindle.Error, match="velocity .3., speed|speed, velocity .3."):
        brindle.stripes(mesh, "temperature")


def arrays_on(mesh):
    if hasattr(mesh, "GetPointData"):
        from vtk.util.numpy_support import vtk_to_numpy
        return tuple({where.GetArrayName(i): vtk_to_numpy(where.GetArray(i))
                      for i in range(where.GetNumberOfArrays())}
                     for where in (mesh.GetPointData(), mesh.GetCellData()))
    if hasattr(mesh, "point_data"):
        return mesh.point_data, mesh.cell_data
    return mesh.vertex_attributes, mesh.face_attributes


@pytest.mark.parametrize("make", MAKERS.values(), ids=MAKERS)
def test_results_are_put_back(make, square, data):
    mesh = make(square, data)
    p = brindle.stripes(mesh, "velocity", stripes=10)
    assert p.add_to(mesh) is mesh
    points, cells = arrays_on(mesh)
    np.testing.assert_array_equal(points["phase"], p.point_data["phase"])
    np.testing.assert_array_equal(points["direction"], p.directions)
    branch = cells["branch"]
    branch = branch[1] if isinstance(branch, list) else branch
    np.testing.assert_array_equal(branch, p.branches)
    assert "velocity" in points  # what was there stays
    t = brindle.texture(mesh, "velocity", stripes=10)
    t.add_to(mesh)
    uv = arrays_on(mesh)[1]["uv"]
    uv = uv[1] if isinstance(uv, list) else uv
    np.testing.assert_array_equal(uv, t.corner_uv.reshape(-1, 6))
    with pytest.raises(brindle.Error, match="arrays uv already.*prefix="):
        t.add_to(mesh)  # whoever's it is
    t.add_to(mesh, prefix="tile_")
    assert {"uv", "tile_uv"} <= set(arrays_on(mesh)[1])


@pytest.mark.parametrize("make", MAKERS.values(), ids=MAKERS)
def test_crosses_are_put_back(make, square, data):
    """Triangles that were split have no corners of their own: NaN, as parts of polygons."""
    angle = 2 * np.arctan2(square[0][:, 1] - 0.42, square[0][:, 0] - 0.37) / 4
    field = np.c_[np.cos(angle), np.sin(angle), 0 * angle]
    mesh = make(square, data)
    c = brindle.crosses(mesh, field, stripes=10)
    assert len(c.singular_faces) > 0 and c.surface.vertex_count > len(square[0])
    assert c.add_to(mesh) is mesh
    uv = arrays_on(mesh)[1]["uv"]
    uv = uv[1] if isinstance(uv, list) else uv
    whole = ~np.isin(c.face_origins, c.singular_faces)
    np.testing.assert_array_equal(uv[c.face_origins[whole]], c.corner_uv.reshape(-1, 6)[whole])
    assert np.isnan(uv[c.singular_faces]).all()
    other = make((square[0], square[1][1:]), {"points": {}, "cells": {}})
    with pytest.raises(brindle.Error, match="cells.*made for another"):
        c.add_to(other)


@pytest.mark.parametrize("make", MAKERS.values(), ids=MAKERS)
def test_arrays_of_the_mesh_are_not_replaced(make, square, data):
    named = {**data, "points": {**data["points"], "frequency": np.arange(len(square[0]), dtype=float)}}
    mesh = make(square, named)
    p = brindle.stripes(mesh, "velocity", stripes=10)
    with pytest.raises(brindle.Error, match='arrays frequency already.*prefix="stripes_"'):
        p.add_to(mesh)
    assert "phase" not in arrays_on(mesh)[0], "nothing is changed"
    for _ in range(2):  # those of an earlier pattern are replaced
        p.add_to(mesh, prefix="stripes_")
    points, _ = arrays_on(mesh)
    np.testing.assert_array_equal(points["frequency"], named["points"]["frequency"])
    np.testing.assert_array_equal(points["stripes_frequency"], p.frequency)


def test_files_keep_arrays_whose_names_are_taken(square, tmp_path):
    given = np.arange(len(square[0]), dtype=float)
    brindle.Surface(*square).write(tmp_path / "in.vtp", point_data={"frequency": given})
    s = brindle.read(tmp_path / "in.vtp")
    p = brindle.stripes(s, s.projected_field((1, 0, 0)), stripes=10)
    with pytest.warns(brindle.PatternWarning, match="'frequency' is kept as 'frequency_input'"):
        p.write(tmp_path / "a.vtp")
    again = brindle.read(tmp_path / "a.vtp")
    np.testing.assert_array_equal(again.point_data["frequency_input"], given)
    np.testing.assert_array_equal(again.point_data["frequency"], p.frequency)


def test_results_are_not_put_on_other_meshes(square, data):
    p = brindle.stripes(brindle.shape("torus", resolution=60), stripes=10)
    with pytest.raises(brindle.Error, match="another"):
        p.add_to(meshio_of(square, data))


def test_polygons_are_cut(square):
    vertices = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [2, 0, 0], [2, 1, 0.0], [3, 0.5, 0]])
    mixed = types.SimpleNamespace(points=vertices, faces=np.array([4, 0, 1, 2, 3, 4, 1, 4, 5, 2, 3, 4, 6, 5]),
                                  point_data={}, cell_data={"part": np.array([7.0, 8, 9])})
    s = brindle.as_surface(mixed)
    assert s.face_count == 5
    np.testing.assert_array_equal(s.cell_data["part"], [7, 7, 8, 8, 9])
    p = brindle.stripes(s, s.projected_field((1, 0, 0)), stripes=2)
    p.add_to(mixed)
    assert mixed.cell_data["branch"].shape == (3,)
    assert mixed.cell_data["corner_phase"].shape == (3, 3)
    blocks = meshio.Mesh(vertices, [("triangle", [[4, 6, 5]]), ("quad", [[0, 1, 2, 3], [1, 4, 5, 2]])],
                         cell_data={"part": [[9.0], [7.0, 8.0]]})
    s = brindle.as_surface(blocks)
    np.testing.assert_array_equal(s.cell_data["part"], [9, 7, 7, 8, 8])
    brindle.stripes(s, s.projected_field((1, 0, 0)), stripes=2).add_to(blocks)
    assert [len(block) for block in blocks.cell_data["branch"]] == [1, 2]


def test_damaged_polygons():
    vertices = np.zeros((3, 3))
    for faces in ([3, 0, 1], [-1, 0], [3, 0, 1, 7]):
        mesh = types.SimpleNamespace(points=vertices, faces=np.array(faces))
        with pytest.raises(brindle.Error):
            brindle.as_surface(mesh)
    with pytest.raises(brindle.Error, match="1 volume cells.*types whose faces"):
        of_types([42])
    with pytest.raises(brindle.Error, match="types that|Tessellate"):
        of_types([99])
    with pytest.raises(brindle.Error, match="no triangles"):
        brindle.as_surface(meshio.Mesh(np.eye(4, 3), [("line", [[0, 1]])]))
    for corners in ([0, 1, 4], [0, 1, -1], [0, 1, 2**40]):
        with pytest.raises(brindle.Error, match="points that do not exist: there are 4"):
            brindle.as_surface(meshio.Mesh(np.eye(4, 3), [("triangle", [corners])]))
    with pytest.raises(brindle.Error, match="cell of 0 points.*asks for 4"):
        of_types([8])
    with pytest.raises(brindle.Error):
        brindle.as_surface(types.SimpleNamespace(vertices=np.zeros((3, 3)), faces=[[0, 1]]))


def of_types(types):
    """Cells of VTK's types without corners."""
    return _core.surface_of_cells(np.eye(4, 3), np.zeros(0, int), np.zeros(len(types), int), types, {}, {})


def solids():
    """A row of bricks, some cut into other solids; the last one bends."""
    x, y, z = np.meshgrid(np.arange(7.0), [0.0, 1], [0.0, 1], indexing="ij")
    points = np.c_[x.ravel(), y.ravel(), z.ravel()]
    brick = np.array([0, 4, 6, 2, 1, 5, 7, 3])
    tetra, wedge, pyramid = brick + 4, brick + 8, brick + 12
    tip = len(points)
    points = np.r_[points, [[3.5, 0.5, 0.5]]]
    faces = [(0, 1, 2, 3), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]
    cells = [("hexahedron", [brick, brick + 16]),
             ("tetra", tetra[[(0, 1, 3, 4), (1, 2, 3, 6), (1, 4, 5, 6), (3, 4, 6, 7), (1, 3, 4, 6)]]),
             ("wedge", wedge[[(0, 1, 3, 4, 5, 7), (1, 2, 3, 5, 6, 7)]]),
             ("pyramid", [[*pyramid[list(face)], tip] for face in faces])]
    middles = [(a, b) for a, b in ((0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5),
                                   (2, 6), (3, 7))]
    bent = brick + 20
    added = np.array([points[bent[list(pair)]].mean(axis=0) + [0, 0, 0.1] for pair in middles])
    cells.append(("hexahedron20", [[*bent, *range(tip + 1, tip + 13)]]))
    points = np.r_[points, added]
    count = sum(len(block) for _, block in cells)
    return meshio.Mesh(points, cells, point_data={"flow": np.cross(points, [0, 1, 0.3])},
                       cell_data={"number": np.split(np.arange(count), np.cumsum([len(b) for _, b in cells])[:-1])})


def surfaces():
    """Curved faces, and a cell of each kind that is none."""
    points = np.array([[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0], [1, 0, 0.1], [2, 1, 0.1], [1, 2, 0.1], [0, 1, 0.1],
                       [4, 0, 0], [4, 2, 0], [3, 1, 0.2], [3, 0, 0.1], [4, 1, 0.1]], float)
    return meshio.Mesh(points, [("vertex", [[0]]), ("quad8", [[0, 1, 2, 3, 4, 5, 6, 7]]), ("line", [[0, 1], [1, 2]]),
                                ("triangle6", [[1, 8, 9, 11, 12, 10]]), ("triangle", [[1, 9, 2]]),
                                ("tetra", [[0, 1, 2, 4]])],
                       point_data={"flow": np.cross(points, [0, 1, 0.3])},
                       cell_data={"number": [[0], [1], [2, 3], [4], [5], [6]],
                                  "row": [[7], [7], [7, 7], [7], [7], [7]]})


def as_grid(mesh, path):
    """The same as a vtkUnstructuredGrid."""
    vtk = pytest.importorskip("vtk")
    mesh.write(path)
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


@pytest.mark.parametrize("make", [solids, surfaces])
@pytest.mark.parametrize("package", ["meshio", "vtk"])
def test_cells_are_those_of_files(make, package, tmp_path):
    """Volumes give their boundary, curved cells their middle points, as the reader of .vtu has it."""
    mesh = make()
    mesh.write(tmp_path / "cells.vtu")
    expected = brindle.read(tmp_path / "cells.vtu", crease_angle=180)
    if package == "vtk":
        mesh = as_grid(mesh, tmp_path / "cells.vtu")
    s = brindle.as_surface(mesh)
    np.testing.assert_array_equal(s.vertices, expected.vertices)
    np.testing.assert_array_equal(s.faces, expected.faces)
    assert s.notes == expected.notes and s.face_count > 0
    for own, read in ((s.point_data, expected.point_data), (s.cell_data, expected.cell_data)):
        assert list(own) == list(read)
        for name in own:
            np.testing.assert_array_equal(own[name], read[name])
    p = brindle.stripes(mesh, "flow", stripes=5)
    np.testing.assert_array_equal(p.point_data["original_id"], np.arange(s.vertex_count))
    p.add_to(mesh)
    points, cells = arrays_on(mesh)
    np.testing.assert_array_equal(points["phase"], p.point_data["phase"])
    branch = cells["branch"]
    branch = np.concatenate(branch) if isinstance(branch, list) else branch
    number = s.cell_data["number"]
    assert set(np.flatnonzero(branch)) == set(number[p.branches == 1])


def test_points_of_a_plane(square):
    mesh = meshio.Mesh(square[0][:, :2], [("triangle", square[1])])
    np.testing.assert_array_equal(brindle.as_surface(mesh).vertices, square[0])


@pytest.mark.parametrize("extension", ["vtu", "ply", "vtk", "obj"])
def test_through_files_of_meshio(extension, square, data, tmp_path):
    path = tmp_path / f"mesh.{extension}"
    mesh = meshio_of(square, data)
    del mesh.cells[0]
    for arrays in mesh.cell_data.values():
        del arrays[0]
    if extension in ("ply", "obj"):
        mesh.point_data, mesh.cell_data = {}, {}
    mesh.write(path)
    s = brindle.read(path)
    np.testing.assert_allclose(s.vertices, square[0], atol=1e-6)
    np.testing.assert_array_equal(s.faces, square[1])
    if mesh.point_data:
        np.testing.assert_array_equal(s.point_data["velocity"], data["points"]["velocity"])


def test_meshio_reads_what_brindle_writes(square, tmp_path):
    """meshio 5 reads no properties of faces: arrays of points alone."""
    s = brindle.Surface(*square)
    p = brindle.stripes(s, s.projected_field((1, 0.4, 0)), stripes=10)
    s.write(tmp_path / "stripes.ply", point_data=p.point_data)
    mesh = meshio.read(tmp_path / "stripes.ply")
    np.testing.assert_array_equal(mesh.points, s.vertices)
    np.testing.assert_array_equal(mesh.cells[0].data, s.faces)
    np.testing.assert_array_equal(np.float32(mesh.point_data["phase"]), p.point_data["phase"])


def test_vtk_reads_what_brindle_writes(square, tmp_path):
    vtk = pytest.importorskip("vtk")
    s = brindle.Surface(*square)
    p = brindle.stripes(s, s.projected_field((1, 0.4, 0)), stripes=10)
    p.write(tmp_path / "stripes.vtp")
    reader = vtk.vtkXMLPolyDataReader()
    reader.SetFileName(str(tmp_path / "stripes.vtp"))
    reader.Update()
    mesh = reader.GetOutput()
    points, cells = arrays_on(mesh)
    np.testing.assert_array_equal(points["phase"], p.point_data["phase"])
    np.testing.assert_array_equal(cells["corner_phase"], p.corner_phases)
    again = brindle.as_surface(mesh)
    np.testing.assert_array_equal(again.faces, s.faces)


def test_meshio_from_brindle(square):
    """Results as a mesh of meshio, in its own words."""
    s = brindle.Surface(*square)
    p = brindle.stripes(s, s.projected_field((1, 0.4, 0)), stripes=10)
    points, edges = p.curves()
    lines = meshio.Mesh(points, [("line", edges)])
    assert len(lines.cells[0].data) == len(edges)
    mesh = meshio.Mesh(s.vertices, [("triangle", s.faces)])
    p.add_to(mesh)
    np.testing.assert_array_equal(mesh.cell_data["branch"][0], p.branches)


class StandIn(types.ModuleType):
    """Takes what the package takes, and checks it as the package's own classes do."""


def pyvista_stand_in():
    class PolyData:
        def __init__(self, points, faces=None, lines=None, verts=None):
            given = [cells for cells in (faces, lines, verts) if cells is not None]
            assert points.ndim == 2 and points.shape[1] == 3 and len(given) == 1
            size = given[0][0]
            assert (given[0].reshape(-1, size + 1)[:, 0] == size).all()
            self.points, self.lines, self.verts = points, lines, verts
            self.faces = np.zeros(0, int) if faces is None else faces
            self.n_cells = len(given[0]) // (size + 1)
            self.point_data, self.cell_data = {}, {}

    module = StandIn("pyvista")
    module.PolyData = PolyData
    return module


def trimesh_stand_in():
    class Trimesh:
        def __init__(self, vertices, faces, process=True, vertex_attributes=None, face_attributes=None):
            assert process is False and faces.shape[1] == 3 and faces.max() < len(vertices)
            self.vertices, self.faces, self.visual = vertices, faces, None
            self.vertex_attributes, self.face_attributes = dict(vertex_attributes), dict(face_attributes)
            assert all(len(array) == len(vertices) for array in self.vertex_attributes.values())
            assert all(len(array) == len(faces) for array in self.face_attributes.values())

    module = StandIn("trimesh")
    module.Trimesh = Trimesh
    module.visual = types.SimpleNamespace(TextureVisuals=lambda uv: types.SimpleNamespace(uv=uv))
    return module


@pytest.fixture
def converters(monkeypatch):
    """Those of packages that are here, or stand-ins."""
    for name, make in (("pyvista", pyvista_stand_in), ("trimesh", trimesh_stand_in)):
        if importlib.util.find_spec(name) is None:
            monkeypatch.setitem(sys.modules, name, make())
    return {"meshio": brindle.to_meshio, "pyvista": brindle.to_pyvista, "trimesh": brindle.to_trimesh}


@pytest.mark.parametrize("name", ["meshio", "pyvista", "trimesh"])
def test_results_as_meshes_of_packages(name, converters, square, data):
    """What is converted and read again gives the same pattern."""
    s = brindle.Surface(*square, point_data=data["points"], cell_data=data["cells"])
    p = brindle.stripes(s, "velocity", stripes=10)
    for thing in (s, p):
        mesh = converters[name](thing)
        again = brindle.as_surface(mesh)
        np.testing.assert_array_equal(again.faces, s.faces)
        np.testing.assert_array_equal(again.point_data["velocity"], s.point_data["velocity"])
        np.testing.assert_array_equal(again.cell_data["number"], s.cell_data["number"])
        np.testing.assert_array_equal(brindle.stripes(mesh, "velocity", stripes=10).phases, p.phases)
    np.testing.assert_array_equal(brindle.as_surface(mesh).point_data["frequency"], p.frequency)
    t = brindle.texture(s, "velocity", stripes=10)
    textured = converters[name](t)
    assert brindle.as_surface(textured).face_count == len(t.mesh().faces)
    uv = {"meshio": lambda: textured.point_data["uv"], "trimesh": lambda: textured.visual.uv,
          "pyvista": lambda: textured.active_texture_coordinates}[name]()
    np.testing.assert_array_equal(uv, t.mesh().uv)


@pytest.mark.parametrize("name", ["meshio", "pyvista"])
def test_lines_and_points_as_meshes(name, converters, square):
    s = brindle.Surface(*square)
    d = s.projected_field((1, 0.4, 0))
    curves, samples = brindle.stripes(s, d, stripes=10).curves(), brindle.samples(s, d, stripes=10)
    lines, points = converters[name](curves), converters[name](samples)
    np.testing.assert_array_equal(lines.points, curves.points)
    np.testing.assert_array_equal(points.points, samples.points)
    if name == "meshio":
        np.testing.assert_array_equal(lines.cells_dict["line"], curves.edges)
        assert len(points.cells_dict["vertex"]) == samples.count
    else:
        assert (lines.n_cells, points.n_cells) == (len(curves.edges), samples.count)
    np.testing.assert_array_equal(points.point_data["direction_u"], samples.directions[0])
    cloud = converters[name](brindle.points(s.vertices))
    assert brindle.as_surface(cloud).is_points


def test_what_is_no_result_or_has_no_triangles(converters, square):
    s = brindle.Surface(*square)
    curves = brindle.stripes(s, s.projected_field((1, 0, 0)), stripes=10).curves()
    with pytest.raises(brindle.Error, match="Curves has no triangles"):
        brindle.to_trimesh(curves)
    for convert in converters.values():
        with pytest.raises(TypeError, match="expected a Surface"):
            convert(square)


@pytest.mark.parametrize("name", ["meshio", "pyvista", "trimesh"])
def test_missing_packages_are_named(name, square, monkeypatch):
    monkeypatch.setitem(sys.modules, name, None)
    with pytest.raises(ImportError, match=f"{name} is not installed here; install it"):
        getattr(brindle, f"to_{name}")(brindle.Surface(*square))
