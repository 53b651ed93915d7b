"""Arrays of any type, order and stride come in; what goes out is safe."""

import gc
import os

import numpy as np
import pytest

import brindle
from brindle import _core

REAL = ["f2", "f4", "f8", "g", ">f4", ">f8"]
WHOLE = ["i1", "u1", "i2", "u2", "i4", "u4", "i8", "u8", ">i4", ">u2"]


def variants(array):
    """The same numbers in other orders and strides."""
    yield "c", np.ascontiguousarray(array)
    yield "fortran", np.asfortranarray(array)
    yield "backwards", np.ascontiguousarray(array[::-1])[::-1]
    wide = np.zeros((2 * len(array), *array.shape[1:]), array.dtype)
    wide[::2] = array
    yield "every other row", wide[::2]
    columns = np.zeros((len(array), 2 * array.shape[1]), array.dtype)
    columns[:, ::2] = array
    yield "every other column", columns[:, ::2]
    bytes_ = np.zeros(array.nbytes + 1, np.uint8)
    odd = bytes_[1:].view(array.dtype).reshape(array.shape)
    odd[...] = array
    yield "at an odd address", odd
    frozen = array.copy()
    frozen.flags.writeable = False
    yield "read-only", frozen


@pytest.fixture(scope="module")
def grid():
    """8 x 8 vertices at whole numbers below 64, so that every type holds them."""
    x, y = np.meshgrid(np.arange(8), np.arange(8))
    vertices = np.stack([x.ravel(), y.ravel(), (x * y % 3).ravel()], axis=1)
    corner = (8 * np.arange(7)[:, None] + np.arange(7)).ravel()
    triangles = np.concatenate([np.stack([corner, corner + 1, corner + 9], axis=1),
                                np.stack([corner, corner + 9, corner + 8], axis=1)])
    return vertices, triangles


def solved(vertices, triangles, field=None):
    surface = brindle.Surface(vertices, triangles)
    directions = surface.projected_field((1, 0.5, 0)) if field is None else field
    return brindle.stripes(surface, directions, frequency=0.25)


@pytest.mark.parametrize("real", REAL + WHOLE)
@pytest.mark.parametrize("whole", ["i1", "u2", "i4", "u4", "i8", "u8", ">i8"])
def test_types_make_no_difference(grid, real, whole):
    vertices, triangles = grid
    expected = solved(vertices.astype("f8"), triangles)
    got = solved(vertices.astype(real), triangles.astype(whole))
    np.testing.assert_array_equal(got.phases, expected.phases)


def test_orders_and_strides_make_no_difference(grid):
    vertices, triangles = grid[0].astype("f4"), grid[1].astype("i4")
    directions = np.tile(np.float32([0.6, 0.8, 0]), (len(vertices), 1))
    expected = solved(vertices, triangles, directions)
    for name, other in variants(vertices):
        np.testing.assert_array_equal(solved(other, triangles, directions).phases, expected.phases, name)
    for name, other in variants(triangles):
        np.testing.assert_array_equal(solved(vertices, other, directions).phases, expected.phases, name)
    for name, other in variants(directions):
        np.testing.assert_array_equal(solved(vertices, triangles, other).phases, expected.phases, name)


def test_lists_and_broadcast_rows(grid):
    vertices, triangles = grid
    directions = np.broadcast_to(np.array([1.0, 0, 0]), vertices.shape)
    expected = solved(vertices, triangles, np.array(directions))
    got = solved(vertices.tolist(), triangles.tolist(), directions)
    np.testing.assert_array_equal(got.phases, expected.phases)


def test_frequencies_of_any_type(torus):
    d = torus.smooth_field()
    expected = brindle.stripes(torus, d, frequency=4.0)
    for frequency in (4, np.float32(4), np.array(4), np.full(torus.vertex_count, 4, "u1"),
                      np.full((torus.vertex_count, 1), 4.0), [4] * torus.vertex_count):
        got = brindle.stripes(torus, d, frequency=frequency)
        np.testing.assert_array_equal(got.phases, expected.phases)


def test_the_input_is_not_kept_and_not_changed(grid):
    vertices, triangles = grid[0].astype("f4"), grid[1].astype("u4")
    before = vertices.copy(), triangles.copy()
    surface = brindle.Surface(vertices, triangles)
    assert (vertices == before[0]).all() and (triangles == before[1]).all()
    vertices[:], triangles[:] = 0, 0
    np.testing.assert_array_equal(surface.vertices, before[0])
    np.testing.assert_array_equal(surface.faces, before[1])


def address(array):
    return array.__array_interface__["data"][0]


def test_results_share_memory(torus):
    p = brindle.stripes(torus, torus.smooth_field(), stripes=20)
    for owner, names in ((p, ["phases", "frequency", "directions", "corner_phases", "branches"]),
                         (torus, ["vertices", "faces", "normals"])):
        for name in names:
            first, second = getattr(owner, name), getattr(owner, name)
            assert address(first) == address(second), name
            assert first.flags.c_contiguous
    for array in (p.phases, p.frequency, p.directions, torus.vertices, torus.faces,
                  torus.normals, *torus.neighbors):
        with pytest.raises(ValueError):
            array.flags.writeable = True
        with pytest.raises(ValueError):
            array[0] = 0


def test_covers_of_crosses_are_surfaces(tmp_path):
    """With what came with the surface: two rows for each of its own."""
    plain = brindle.shape("molecule", resolution=24)
    n = plain.vertex_count
    far = np.array([5.8e6, 4e5, 1])
    surface = brindle.Surface(plain.vertices + far, plain.faces,
                              point_data={"id": np.arange(n)})
    field = np.random.default_rng(0).normal(size=(n, 3))
    crosses = brindle.crosses(surface, field, stripes=20, measured=brindle.Measured(1))
    cover = crosses.double_cover
    assert np.allclose(cover.surface.origin, surface.origin)
    assert np.array_equal(cover.point_data["original_id"], np.repeat(np.arange(n), 2))
    assert np.array_equal(cover.surface.point_data["id"], np.repeat(np.arange(n), 2))
    curves = cover.curves().points
    assert (abs(curves - far) <= abs(plain.vertices).max() + 1).all()
    cover.write(tmp_path / "cover.vtp")
    cover.write(tmp_path / "cover.glb", uv=True)
    assert len(cover.mesh().point_data["original_id"]) == len(cover.mesh().vertices)
    assert len(cover.point_data["coherence"]) == 2 * n
    mesh = crosses.mesh()
    coherence = mesh.point_data["coherence"]
    assert coherence.min() >= 0 and coherence.max() <= 1
    origins = mesh.vertex_origins
    split = (origins[:, 0] == origins[:, 1]) & (origins[:, 0] >= n)
    assert split.any()
    own = cover.point_data["coherence"][::2]
    base = surface.faces[crosses.singular_faces]
    expected = own[base].mean(axis=1)
    at = origins[split][:, 0] - n
    assert np.allclose(coherence[split], expected[at], atol=1e-6)


@pytest.mark.parametrize("solver", ["multilevel", "relaxation", "averaged", "global"])
def test_phases_without_a_wave(torus, solver):
    directions = np.array(torus.smooth_field())
    directions[:5] = 0
    phases = brindle.stripes(torus, directions, stripes=20, solver=solver).phases
    assert (phases[:5] == 1j).all()


def test_gaps_are_those_of_all_curves(torus):
    p = brindle.stripes(torus, torus.projected_field((0.31, 0.9, 0.27)), stripes=20)
    all_curves, shaped = p.curves(), p.curves(min_length=1, resample=0.05)
    assert shaped.count < all_curves.count
    assert shaped.measures()["gaps"] == all_curves.measures()["gaps"]
    assert shaped.measures()["lengths"] != all_curves.measures()["lengths"]
    width = 0.01
    left = p.curves(min_length=1)
    assert shaped.measures(width)["coverage"] == left.measures(width)["coverage"]


def test_what_objects_keep_is_read_only(torus):
    pattern = brindle.stripes(torus, stripes=10)
    texture, curves = brindle.texture(torus, stripes=10), pattern.curves()
    samples = brindle.samples(torus, stripes=10)
    kept = [pattern.branches, pattern.branch_indices, pattern.corner_phases, pattern.angle_errors,
            pattern.singularities, *pattern.point_data.values(), *pattern.cell_data.values(),
            texture.corner_uv, *texture.mesh().point_data.values(), texture.mesh().vertices,
            curves.points, curves.edges, curves.lengths, samples.points, *samples.directions,
            brindle.advanced.PatternFrames(torus).faces]
    assert len(kept) > 20 and not any(array.flags.writeable for array in kept)
    branches = pattern.branches.copy()
    branches[:] = 0  # a copy is the caller's


def test_results_outlive_their_owner():
    surface = brindle.shape("torus", resolution=30)
    p = brindle.stripes(surface, surface.smooth_field(), stripes=5)
    arrays = [p.phases, p.directions, p.frequency, surface.vertices, surface.faces,
              p.point_data["phase"], *p.curves(), p.curves().normals]
    copies = [array.copy() for array in arrays]
    del p, surface
    gc.collect()
    brindle.shape("torus", resolution=30)  # somebody else's memory
    for array, copy in zip(arrays, copies):
        np.testing.assert_array_equal(array, copy)


def test_fields_are_the_callers_own(torus):
    """They may be changed, and nobody else hears of it."""
    for make in (torus.smooth_field, lambda: torus.projected_field((1, 0.2, 0.3)),
                 lambda: torus.curvature_field(raw=True), lambda: torus.rotate_field(torus.smooth_field()),
                 lambda: brindle.Animator(torus).frame(torus.smooth_field(), 4)):
        made, kept = make(), make()
        made *= -1
        np.testing.assert_array_equal(made, -kept)
        np.testing.assert_array_equal(make(), kept)


def test_shapes_and_types(torus):
    p = brindle.stripes(torus, torus.smooth_field(), stripes=20)
    n, m = torus.vertex_count, torus.face_count
    assert p.phases.shape == (n,) and p.phases.dtype == np.complex64
    assert p.frequency.shape == (n,) and p.frequency.dtype == np.float32
    assert p.corner_phases.shape == (m, 3) and p.corner_phases.dtype == np.float32
    assert p.branches.shape == (m,) and p.branches.dtype.kind == "i"
    points, edges = p.curves()
    assert points.shape[1:] == (3,) and edges.shape[1:] == (2,)
    assert edges.min() >= 0 and edges.max() < len(points)
    t = brindle.texture(torus, torus.smooth_field(), stripes=20, oriented=False)
    assert t.corner_uv.shape == (m, 3, 2)
    points, normals = brindle.samples(torus, torus.smooth_field(), stripes=20)
    assert points.shape == normals.shape and points.shape[1] == 3


def test_packed_floats_are_read_where_they_are(torus):
    d = torus.smooth_field()
    f = np.full(torus.vertex_count, 4, np.float32)
    before = _core.converted_arrays()
    animator = brindle.Animator(torus)
    animator.frame(d, f, torus.vertices)
    brindle.stripes(torus, d, frequency=4)
    assert _core.converted_arrays() == before
    animator.frame(d.astype("f8"), f, torus.vertices)
    assert _core.converted_arrays() == before + 1
    animator.frame(np.asfortranarray(d), f.astype("f8"), torus.vertices)
    assert _core.converted_arrays() == before + 3


def test_nothing_at_all():
    empty = brindle.Surface(np.empty((0, 3)), np.empty((0, 3), int))
    assert empty.vertex_count == 0 and empty.vertices.shape == (0, 3)
    with pytest.raises(brindle.Error):
        brindle.stripes(empty)
    assert empty.smooth_field().shape == (0, 3)
    alone = brindle.Surface([[0, 0, 0], [1, 0, 0], [0, 1, 0]], np.empty((0, 3), int))
    assert alone.faces.shape == (0, 3)


def test_large_coordinates_keep_their_shape(square):
    far = np.array([4e6, 5e6, 100.0])
    near, there = brindle.Surface(*square), brindle.Surface(square[0] + far, square[1])
    assert there.vertices.dtype == np.float64
    np.testing.assert_allclose(there.vertices, square[0] + far, atol=1e-6)
    p = brindle.stripes(there, there.projected_field((1, 0.2, 0)), stripes=20)
    q = brindle.stripes(near, near.projected_field((1, 0.2, 0)), stripes=20)
    assert p.report["branches"] == q.report["branches"] == 0
    points, _ = p.curves()
    assert points.dtype == np.float64 and (points.min(axis=0) > far - 1).all()


def test_masked_numbers_are_no_wave(torus):
    """A mask over nonsense says that there is nothing: as NaN does."""
    d, n = np.array(torus.smooth_field()), torus.vertex_count
    nothing = np.zeros(n, bool)
    nothing[5:40] = True
    for hidden in (1e20, np.nan, 0):
        directions, frequency = d.copy(), np.full(n, 4.0)
        directions[nothing], frequency[nothing] = hidden, hidden
        masked = np.ma.masked_array(directions, np.repeat(nothing[:, None], 3, axis=1))
        expected = brindle.stripes(torus, np.where(nothing[:, None], np.nan, d), frequency=4)
        got = brindle.stripes(torus, masked, frequency=4)
        np.testing.assert_array_equal(got.phases, expected.phases)
        assert np.isnan(got.point_data["phase"]).sum() == nothing.sum()
        by_frequency = brindle.stripes(torus, d, frequency=np.ma.masked_array(frequency, nothing))
        assert by_frequency.report["vertices_without_frequency"] == nothing.sum()
        animator = brindle.Animator(torus)
        z = animator.frame(d, np.ma.masked_array(frequency, nothing))
        np.testing.assert_array_equal(z[nothing], np.full(nothing.sum(), 1j, "c8"))
    # Nothing is masked: the same as without.
    np.testing.assert_array_equal(brindle.stripes(torus, np.ma.masked_array(d), frequency=4).phases,
                                  brindle.stripes(torus, d, frequency=4).phases)


@pytest.mark.parametrize("moves", [False, True])
def test_frames_take_what_patterns_take(torus, moves):
    """Vectors of any length, in and out of the surface; zero, NaN or masked for no wave; frequencies
    that are vectors."""
    n = torus.vertex_count
    positions = np.float32(torus.vertices * (1 + 0.2 * np.sin(3 * torus.vertices[:, :1]))) if moves else None
    there = torus.with_vertices(positions) if moves else torus
    chance = np.random.default_rng(2)
    vectors = np.array(there.projected_field((0.3, 1, 0.2)), float)
    vectors[::3] = 5 * vectors[::3] + chance.normal(size=vectors[::3].shape)
    vectors[4:9], vectors[20:25] = np.nan, 0
    frequency = chance.uniform(3, 5, (n, 3))
    frequency[40:44] = np.nan
    hidden = np.arange(n) // 6 == 9
    masked = np.ma.masked_array(vectors, np.repeat(hidden[:, None], 3, axis=1))
    for directions in (vectors, masked):
        p = brindle.stripes(there, directions, frequency=frequency)
        z = brindle.Animator(torus).frame(directions, frequency, positions)
        np.testing.assert_array_equal(z, p.phases)
        uv = brindle.TextureAnimator(torus).frame(directions, frequency, positions)
        same = brindle.TextureAnimator(torus).frame(p.directions, p.frequency, positions, normals=there.normals)
        np.testing.assert_array_equal(uv, same)
        drawn = brindle.advanced.PatternFrames(torus)
        corners = drawn.corner_phases(z, directions, frequency, positions)
        np.testing.assert_array_equal(corners, p.corner_phases)


def test_unit_vectors_stay_where_vertices_move(torus):
    """Row by row, whatever the others are; these are projected there."""
    moved = np.float32(torus.vertices * (1 + 0.2 * np.sin(3 * torus.vertices[:, :1])))
    d, there = torus.projected_field((0.3, 1, 0.2)), torus.with_vertices(moved)
    z = brindle.Animator(torus).frame(d, 4, moved)
    mixed = d.copy()
    mixed[::7] *= 3
    mixed[1::7] = np.nan
    for given in (d, mixed):
        shown = brindle.advanced.PatternFrames(torus).vertices(z, given, 4, moved)[:, 4:7]
        units = np.isclose(np.linalg.norm(given, axis=1), 1)
        np.testing.assert_array_equal(shown[units], given[units])
        np.testing.assert_array_equal(shown[~units], there.array_field(given)[~units])


def test_masked_arrays_elsewhere(torus, tmp_path):
    n = torus.vertex_count
    hidden = np.arange(n) < 7
    whole = np.ma.masked_array(np.arange(n), hidden)
    s = brindle.Surface(torus.vertices, torus.faces, point_data={"whole": whole})
    np.testing.assert_array_equal(np.isnan(s.point_data["whole"]), hidden)
    s.write(tmp_path / "masked.vtp", point_data={"half": np.ma.masked_array(np.ones(n, "f2"), hidden)})
    again = brindle.read(tmp_path / "masked.vtp").point_data
    np.testing.assert_array_equal(np.isnan(again["half"]), hidden)
    np.testing.assert_array_equal(again["whole"][~hidden], np.arange(n)[~hidden])
    triangles = np.ma.masked_array(torus.faces, False)
    brindle.Surface(torus.vertices, triangles)
    triangles[3] = np.ma.masked
    with pytest.raises(brindle.Error, match="faces: some are masked"):
        brindle.Surface(torus.vertices, triangles)
    vertices = np.ma.masked_array(torus.vertices, False)
    vertices[2] = np.ma.masked
    with pytest.raises(brindle.Error, match="vertex 2"):
        brindle.Surface(vertices, torus.faces)


def test_truth_and_tensors_as_data(torus, tmp_path):
    n = torus.vertex_count
    truth, tensors = np.arange(n) % 2 == 0, np.arange(9.0 * n).reshape(n, 3, 3)
    s = brindle.Surface(torus.vertices, torus.faces, point_data={"truth": truth, "tensors": tensors},
                        cell_data={"cells": np.ones((torus.face_count, 3, 3))})
    np.testing.assert_array_equal(s.point_data["truth"], truth)
    np.testing.assert_array_equal(s.point_data["tensors"], tensors.reshape(n, 9))
    s.write(tmp_path / "data.vtp", point_data={"other": ~truth})
    again = brindle.read(tmp_path / "data.vtp")
    np.testing.assert_array_equal(again.point_data["other"], ~truth)
    np.testing.assert_array_equal(again.point_data["tensors"], tensors.reshape(n, 9))
    assert again.cell_data["cells"].shape == (torus.face_count, 9)
    for odd in (np.ones((n, 2, 2)), np.ones((n, 3, 3, 3))):
        with pytest.raises(brindle.Error, match="tensors"):
            brindle.Surface(torus.vertices, torus.faces, point_data={"odd": odd})


def test_phases_where_there_is_no_wave(torus):
    """1j in `phases`, NaN in `point_data`; both come back as they were."""
    d = np.array(torus.smooth_field())
    d[:9] = 0
    p = brindle.stripes(torus, d, frequency=4)
    np.testing.assert_array_equal(p.phases[:9], np.full(9, 1j, "c8"))
    assert np.isnan(p.point_data["phase"][:9]).all() and not p.point_data["valid"][:9].any()
    for nothing in (np.nan, 0):
        z = p.phases.copy()
        z[:9] = nothing
        for given in (z, np.ma.masked_array(z, z != z)):
            q = brindle.advanced.stripes_from_phases(torus, given, torus.smooth_field(), frequency=4)
            np.testing.assert_array_equal(q.phases, p.phases)
            np.testing.assert_array_equal(q.corner_phases, p.corner_phases)
            assert q.report["vertices_without_wave"] == 9
    q = brindle.advanced.stripes_from_phases(torus, np.exp(1j * p.point_data["phase"]), d, frequency=4)
    np.testing.assert_allclose(q.corner_phases, p.corner_phases, atol=1e-5)
    with pytest.raises(brindle.Error, match="none at any vertex"):
        brindle.advanced.stripes_from_phases(torus, np.full(torus.vertex_count, np.nan, "c8"), d, frequency=4)


def test_frequencies_of_frames_that_are_nan(torus):
    """As in patterns: no wave there."""
    d, f = np.array(torus.smooth_field()), np.full(torus.vertex_count, 4, "f4")
    f[:9] = np.nan
    without = d.copy()
    without[:9] = 0
    for make in (brindle.Animator, brindle.TextureAnimator):
        expected = make(torus).frame(without, np.full(torus.vertex_count, 4, "f4"))
        np.testing.assert_array_equal(make(torus).frame(d, f), expected)
        for nothing in (np.full_like(f, np.nan), np.nan, np.full_like(f, np.inf)):
            with pytest.raises(brindle.Error):
                make(torus).frame(d, nothing)


def test_paths_of_any_kind(torus, tmp_path):
    path = tmp_path / "torus.ply"
    for kind in (path, str(path), os.fsencode(path)):
        torus.write(kind)
        assert brindle.read(kind).vertex_count == torus.vertex_count


def test_signs_of_axes_do_not_count():
    """Fibres run both ways: in cells, on finer meshes and on other surfaces."""
    torus = brindle.shape("torus", resolution=24)
    fibers = torus.projected_field((0.2, 1, 0.3))
    signs = np.where(np.random.default_rng(3).random(torus.vertex_count) < 0.5, -1, 1)
    of_cells = fibers[torus.faces[:, 0]] * signs[torus.faces[:, 1]][:, None]
    surface = brindle.Surface(torus.vertices, torus.faces,
                              point_data={"fiber": fibers * signs[:, None], "even": fibers},
                              cell_data={"of cells": of_cells,
                                         "even cells": fibers[torus.faces[:, 0]]})

    def angles(a, b):
        a, b = (v / np.linalg.norm(v, axis=1)[:, None] for v in (a, b))
        return np.degrees(np.arccos(np.clip(np.abs((a * b).sum(axis=1)), 0, 1)))

    finer = surface.subdivide(1)
    assert angles(finer.axes("fiber"), finer.axes("even")).max() < 0.1
    assert angles(surface.axes("of cells"), surface.axes("even cells")).max() < 0.1
    assert angles(surface.cells_to_points(of_cells, axes=True), surface.axes("of cells")).max() < 0.1
    assert angles(surface.interpolate_to(finer, "fiber", axes=True), finer.axes("even")).max() < 0.1
    assert np.linalg.norm(finer.array("fiber"), axis=1).min() < 0.1, "numbers cancel"
    for name, even in (("fiber", "even"), ("of cells", "even cells")):
        for s in (surface, finer):
            branches = [brindle.stripes(s, field, stripes=12).report["branches"]
                        for field in (name, even)]
            assert branches[0] == branches[1], (name, s)
    lines, arrows = (brindle.texture(finer, "fiber", stripes=12, oriented=oriented).report["branches"]
                     for oriented in (False, True))
    assert arrows > 2 * lines + 100, "signs that are meant cancel"
