"""What is wrong is brindle.Error, or TypeError for wrong types, and says what is wrong."""

import warnings

import numpy as np
import pytest

import brindle
from conftest import grouped

V = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], float)
F = np.array([[0, 1, 2], [0, 2, 3]])


def nan_at(array, where):
    array = np.array(array, float)
    array[where] = np.nan
    return array


def test_error_is_a_value_error():
    assert issubclass(brindle.Error, ValueError) and issubclass(brindle.Cancelled, brindle.Error)
    with pytest.raises(ValueError, match="there is no shape|unknown|nothing"):
        brindle.shape("nothing")


@pytest.mark.parametrize("vertices, triangles, message", [
    (nan_at(V, (2, 1)), F, "vertex 2"),
    (V + np.inf, F, "vertex 0"),
    (V * 1e30, F, "vertex 1"),
    (V, [[0, 1, 4]], "corner 4"),
    (V, [[0, 1, -1]], "corner -1"),
    (V, [[0, 1, 2**40]], str(2**40)),
    (V, F.astype(float), "whole numbers"),
    (V[:, :2], F, "3 columns"),
    (V, [[0, 1]], "3 columns"),
    (V.ravel(), F, "3 columns"),
    (V.reshape(2, 2, 3), F, "3 dimensions"),
    (5, F, "column"),
    ([[0, 0, 0], [1, 0]], F, "numbers"),
])
def test_surfaces(vertices, triangles, message):
    with pytest.raises(brindle.Error, match=message):
        brindle.Surface(vertices, triangles)


@pytest.mark.parametrize("vertices, triangles", [
    (None, F), (V, None), ("vertices", F), (V, "faces"), (V.astype(complex), F),
    (V.astype(bool), F), (V.astype(str), F), (V.astype(object), F), ({}, F), (V, object()),
    (V, F.astype(bool)), (np.array(["2020-01-01"] * 3, "M8[D]"), F),
])
def test_wrong_types(vertices, triangles):
    with pytest.raises(TypeError):
        brindle.Surface(vertices, triangles)


def test_repair_takes_what_is_damaged():
    vertices = np.vstack([nan_at(V, (3, 0)), V[:1]])
    s = brindle.Surface(vertices, [[0, 1, 2], [0, 2, 3], [4, 1, 2], [0, 0, 1], [0, 1, 99]],
                        repair=True, cell_data={"number": np.arange(5)})
    assert s.face_count == 1 and s.vertex_count == 5
    assert s.repair["triangles_out_of_range"] == 1 and s.repair["vertices_not_finite"] == 1
    assert s.repair["triangles_duplicate"] == 1 and s.repair["vertices_joined"] == 1
    assert list(s.cell_data["number"]) == [0] and "dropped" in s.notes


def test_meshes_that_are_split_along_edges():
    box = brindle.shape("box,resolution=10")
    vertices = box.vertices[box.faces.reshape(-1)]
    triangles = np.arange(len(vertices)).reshape(-1, 3)
    with pytest.warns(brindle.PatternWarning, match="boundary edges stand exactly where.*repair=True"):
        split = brindle.Surface(vertices, triangles)
    assert len(split.joined) == 0
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        whole = brindle.Surface(vertices, triangles, repair=True)
        brindle.Surface(box.vertices, box.faces)
    np.testing.assert_array_equal(vertices[whole.joined], vertices)
    np.testing.assert_array_equal(whole.joined[triangles], whole.faces)
    assert len(np.unique(whole.joined)) == box.vertex_count
    curves = [brindle.stripes(s, stripes=10).curves().count for s in (box, whole, split)]
    assert curves[1] <= 1.2 * curves[0] < curves[2] / 5


@pytest.mark.parametrize("triangles", [[[0, 1, 2], [0, 2, 1]], [[0, 1, 1], [0, 1, 2]]])
def test_triangles_that_no_mesh_has(triangles):
    with pytest.raises(brindle.Error, match="triangle.*repair=True"):
        brindle.Surface(V, triangles)


@pytest.mark.parametrize("arguments, message", [
    ({"directions": np.ones((3, 3))}, r"directions: expected a row for each of \d+ vertices, got the shape \(3, 3\)"),
    ({"directions": np.ones(7)}, r"directions: expected .* got the shape \(7,\)"),
    ({"directions": np.full((1, 3), np.nan)}, "for"),
    ({"frequency": 0}, "above zero"),
    ({"frequency": -1}, "above zero"),
    ({"frequency": np.nan}, "finite"),
    ({"frequency": np.inf}, "finite"),
    ({"frequency": [1, 2, 3]}, r"frequency: expected a row for each of \d+ vertices, got the shape \(3,\)"),
    ({"slack": [0.1, 0.2]}, r"slack: expected .* got the shape \(2,\)"),
    ({"slack": 0.1, "avoid_branches": np.ones(5)}, r"avoid_branches: expected .* got the shape \(5,\)"),
    ({"stripes": 0}, "above zero"),
    ({"stripes": [1, 2]}, "one number"),
    ({"stripes": 3, "frequency": 3}, "exclude"),
    ({"stripes": 3, "spacing": 3}, "exclude"),
    ({"spacing": 0}, "above zero"),
    ({"spacing": np.nan}, "finite"),
    ({"solver": "fast"}, "expected one of multilevel"),
    ({"phase_shift": "x"}, "expected one of aligned"),
    ({"weights": "x"}, "expected one of paper"),
    ({"epsilon": 0.1}, "no effect"),
    ({"global_iterations": 3}, "no effect"),
    ({"stiffness": 0.1}, "no effect"),
    ({"match": "number"}, "no effect"),
    ({"solver": "relaxation", "sweeps": 3}, "no effect"),
    ({"solver": "relaxation", "epsilon": -1}, "epsilon"),
    ({"sweeps": -1}, "sweeps: expected a number from 0 to 10000, got -1"),
    ({"sweeps": 2**40}, "sweeps: expected a number from 0"),
    ({"threads": -1}, "threads"),
    ({"threads": 1025}, "threads: expected a number from 0 to 1024"),
    ({"sweeps": 10001}, "sweeps: expected a number from 0 to 10000"),
    ({"global_iterations": 0, "solver": "global"}, "global_iterations: expected a number from 1"),
    ({"directions": "velocity"}, "no array 'velocity'"),
    ({"frequency": 1e9}, "fewer stripes"),
])
def test_stripes(torus, arguments, message):
    with pytest.raises(brindle.Error, match=message):
        brindle.stripes(torus, **grouped(**{"directions": None, **arguments}))


@pytest.mark.parametrize("arguments", [
    {"directions": 5j}, {"directions": {}}, {"directions": "abc".encode()}, {"frequency": "1".encode()},
    {"frequency": 1j}, {"stripes": "40"}, {"stripes": None, "frequency": True}, {"solver": 3},
    {"threads": "all"}, {"threads": 1.5}, {"progress": 7}, {"previous": 7}, {"run": 1},
    {"sweeps": 2.5}, {"nonsense": 1},
])
def test_wrong_types_of_stripes(torus, arguments):
    with pytest.raises(TypeError):
        brindle.stripes(torus, **grouped(**arguments))


def test_no_wave_at_all(torus):
    with pytest.raises(brindle.Error, match="no vertex has a wave"):
        brindle.stripes(torus, np.zeros((torus.vertex_count, 3)))
    with pytest.raises(brindle.Error, match="no vertex has a wave"):
        brindle.stripes(torus, torus.normals)


def test_fields(torus):
    for call in (lambda: torus.projected_field((0, 0, 0)), lambda: torus.projected_field((1, 2)),
                 lambda: torus.curvature_field("most"), lambda: torus.smooth_field(symmetry=0),
                 lambda: torus.tensor_field(np.ones((torus.vertex_count, 6)), "middle"),
                 lambda: torus.tensor_field(np.ones((torus.vertex_count, 5))),
                 lambda: torus.array_field(np.ones((torus.vertex_count, 4))),
                 lambda: torus.rotate_field(np.ones((5, 3))), lambda: torus.array("cells/x"),
                 lambda: torus.frequencies_by(np.ones(torus.vertex_count), range=(3, 1)),
                 lambda: torus.rotate_field(torus.smooth_field(), np.nan),
                 lambda: torus.rotate_field(torus.smooth_field(), np.inf),
                 lambda: torus.subdivide(-1), lambda: torus.subdivide(0, rounded=True),
                 lambda: brindle.shape("torus", rounded=True), lambda: torus.with_vertices(np.ones((3, 3)))):
        with pytest.raises(brindle.Error):
            call()
    for call in (lambda: torus.projected_field(3), lambda: torus.projected_field("xyz"),
                 lambda: torus.curvature_field(1), lambda: torus.smooth_field(symmetry="2"),
                 lambda: torus.array(3), lambda: torus.subdivide(1.5)):
        with pytest.raises(TypeError):
            call()


@pytest.mark.parametrize("range", [(1, 2, 3), (1,), 5, (), None])
def test_ranges(torus, range):
    with pytest.raises(brindle.Error, match="range: expected two factors"):
        torus.frequencies_by(np.ones(torus.vertex_count), range=range)


@pytest.mark.parametrize("neighbors", [-1, 0, 2, 101])
def test_neighbors(torus, neighbors, tmp_path):
    torus.write(tmp_path / "torus.ply")
    for call in (lambda: brindle.points(torus.vertices, neighbors=neighbors),
                 lambda: brindle.read(tmp_path / "torus.ply", points=True, neighbors=neighbors)):
        with pytest.raises(brindle.Error, match="neighbors: expected a number from 3 to 100"):
            call()


@pytest.mark.parametrize("distance", [-1, np.nan, -np.inf])
def test_distances(torus, distance):
    for call in (lambda: torus.nearest(torus.vertices[:3], distance),
                 lambda: torus.interpolate_to(torus, np.ones(torus.vertex_count), distance)):
        with pytest.raises(brindle.Error, match="max_distance: expected 0 or more"):
            call()
    for rows in (5, torus.face_count + 1):
        with pytest.raises(brindle.Error, match=f"it has {rows} rows for"):
            torus.interpolate_to(torus, np.ones(rows))


@pytest.mark.parametrize("make", [brindle.Animator, brindle.TextureAnimator, brindle.FieldAnimator])
def test_bounds_of_frames(torus, make):
    for options, message in (({"sweeps": 10**9}, "sweeps: expected a number from 0 to 10000"),
                             ({"sweeps": -1}, "sweeps: expected"), ({"stiffness": np.nan}, "stiffness: expected"),
                             ({"stiffness": 1e9}, "stiffness: expected a number from 0 to 1000000")):
        with pytest.raises(brindle.Error, match=message):
            make(torus, **options if "stiffness" in options or make is brindle.FieldAnimator else grouped(**options))
    with pytest.raises(brindle.Error, match="iterations: expected"):
        brindle.Animator(torus, solver=brindle.Solver("relaxation", iterations=0))


def test_windings_that_name_nothing(torus):
    with pytest.raises(brindle.Error, match="names no loop"):
        brindle.stripes(torus, layout=brindle.Layout(winding={}))


def test_animator(torus):
    d, n = torus.smooth_field(), torus.vertex_count
    animator = brindle.Animator(torus)
    with pytest.raises(brindle.Error):
        animator.energy
    expected = brindle.Animator(torus).frame(d, 4)
    for arguments, message in (((d[:5], 4), r"directions: expected .* got the shape \(5, 3\)"),
                               ((d, np.ones(3)), r"frequencies: expected .* got the shape \(3,\)"),
                               ((d, 0), "above zero"), ((d, np.nan), "above zero"),
                               ((d, 4, d[:2]), r"positions: expected .* got the shape \(2, 3\)"),
                               ((d, 4, nan_at(torus.vertices, 7)), "vertex 7")):
        with pytest.raises(brindle.Error, match=message) as error:
            animator.frame(*arguments)
        assert "tangent_directions" not in str(error.value), "a name of the C++ side"
    for out in (np.empty(n - 1, "c8"), torus.vertices[0], np.empty(n, "c16"), np.empty(2 * n, "c8")[::2]):
        with pytest.raises((brindle.Error, TypeError)):
            animator.frame(d, 4, out=out)
    np.testing.assert_array_equal(animator.frame(d, 4), expected)
    with pytest.raises(brindle.Error):
        animator.set_phases(np.full(n, 2, "c8"))
    with pytest.raises(brindle.Error, match=r"phases: expected .* got the shape \(7,\)"):
        animator.set_phases(np.full(7, 1, "c8"))
    with pytest.raises(brindle.Error, match=r"edge_weights: expected .* directed edges, got the shape \(3,\)"):
        brindle.Animator(torus, edge_weights=[1, 2, 3])
    with pytest.raises(TypeError):
        animator.set_phases(np.zeros(n))
    with pytest.raises(brindle.Error):
        brindle.Animator(torus, solver="global")
    with pytest.raises(brindle.Error):
        brindle.Animator(torus, stiffness=-1)


def test_rows_of_triangles(torus):
    """The message names what moves them to the vertices."""
    vectors, numbers = np.ones((torus.face_count, 3)), np.ones(torus.face_count)
    d = torus.smooth_field()
    for call in (lambda: brindle.stripes(torus, vectors), lambda: torus.array_field(vectors),
                 lambda: torus.rotate_field(vectors), lambda: brindle.Animator(torus).frame(vectors, 4),
                 lambda: torus.smooth_field(previous=(torus, vectors))):
        with pytest.raises(brindle.Error, match=r"surface.cells_to_points\(\w+, axes=True\)"):
            call()
    for call in (lambda: brindle.stripes(torus, frequency=numbers), lambda: torus.frequencies_by(numbers),
                 lambda: brindle.Animator(torus).frame(d, numbers)):
        with pytest.raises(brindle.Error, match=r"surface.cells_to_points\(\w+\)"):
            call()
    assert brindle.stripes(torus, torus.cells_to_points(vectors, axes=True)).report["branches"] >= 0
    with pytest.raises(brindle.Error, match="field_weight: expected .* vertices, got 5"):
        brindle.stripes(torus, d, measured=brindle.Measured(1, field_weight=np.ones(5)))


def test_empty_arrays_are_not_left_out(torus):
    directions, f = torus.smooth_field(), torus.frequency_of(10)
    for nothing in ([], np.empty(0), np.empty((0, 3))):
        for given in ({"slack": nothing}, {"slack": 0.2, "avoid_branches": nothing},
                      {"field_smoothing": 1, "field_weight": nothing}):
            with pytest.raises(brindle.Error, match=f"{list(given)[-1]}: the array is empty"):
                brindle.stripes(torus, directions, stripes=10, **grouped(**given))
        for name in ("normals", "frequencies_v", "positions"):
            with pytest.raises(brindle.Error, match=f"{name}: the array is empty"):
                brindle.TextureAnimator(torus).frame(directions, f, **{name: nothing})
        for name in ("confidence", "previous"):
            with pytest.raises(brindle.Error, match=f"{name}: the array is empty"):
                brindle.advanced.FieldSmoothing(torus).frame(directions, f, **{name: nothing})
        with pytest.raises(brindle.Error, match="positions: the array is empty"):
            brindle.Animator(torus).frame(directions, f, nothing)


def test_angles_of_features(torus):
    with pytest.raises(brindle.Error, match="feature_angle: expected a finite number, zero or more"):
        torus.smooth_field(feature_anchor=1, feature_angle=-1)


def test_field_smoothing_keeps_its_last_frame(torus):
    f, vectors = torus.frequency_of(20), np.cross([0, 0, 1], torus.vertices)
    smoothing, undisturbed = brindle.advanced.FieldSmoothing(torus, 0.3), brindle.advanced.FieldSmoothing(torus, 0.3)
    for each in (smoothing, undisturbed):
        each.frame(vectors, f)
    metrics, other = smoothing.metrics, vectors[:, ::-1]
    with pytest.raises(brindle.Error, match="there is no datum"):
        smoothing.frame(np.full_like(vectors, np.nan), f)
    calls = []
    with pytest.raises(brindle.Cancelled):
        smoothing.frame(other, f, progress=lambda *report: calls.append(report) or len(calls) < 3)
    assert smoothing.metrics == metrics
    for seen, expected in zip(smoothing.frame(other, f), undisturbed.frame(other, f)):
        assert np.array_equal(seen, expected)


def test_field_animator(torus):
    animator = brindle.FieldAnimator(torus)
    for vertices, directions in (([torus.vertex_count], [[1, 0, 0]]), ([-1], [[1, 0, 0]]),
                                 ([0, 1], [[1, 0, 0]]), ([0], [[np.nan, 0, 0]])):
        with pytest.raises(brindle.Error):
            animator.frame(vertices, directions)
    with pytest.raises(brindle.Error, match=r"weights: expected .* each of 2 .* got the shape \(3,\)"):
        animator.frame([0, 1], [[1, 0, 0], [0, 1, 0]], [1, 2, 3])
    with pytest.raises(TypeError):
        animator.frame([0.5], [[1, 0, 0]])
    with pytest.raises(brindle.Error, match="2 dimensions"):
        brindle.FieldAnimator(torus).frame([[0, 1], [2, 3]], [[0, 0, 1], [0, 1, 0]])


def test_files(tmp_path, torus):
    for path in ("missing.ply", tmp_path / "missing.vtp", tmp_path):
        with pytest.raises(brindle.Error):
            brindle.read(path)
    damaged = tmp_path / "damaged.ply"
    damaged.write_bytes(b"ply\nformat ascii 1.0\nelement vertex 3\n")
    with pytest.raises(brindle.Error, match="damaged.ply"):
        brindle.read(damaged)
    with open(damaged) as file:
        pass
    for path in (file, None, 3):
        with pytest.raises(TypeError):
            brindle.read(path)
    for path in ("a\0b.ply", ""):
        with pytest.raises((brindle.Error, TypeError)):
            brindle.read(path)
    for path in (tmp_path / "x.xyz", tmp_path / "no" / "x.ply"):
        with pytest.raises(brindle.Error):
            torus.write(path)
    with pytest.raises(brindle.Error, match="rows"):
        torus.write(tmp_path / "x.ply", point_data={"short": np.ones(3)})
    with pytest.raises(TypeError):
        torus.write(tmp_path / "x.ply", point_data={3: np.ones(torus.vertex_count)})
    assert not (tmp_path / "x.ply").exists()


def test_objects_that_are_no_surfaces():
    for thing in (None, 3, "torus", object(), [1, 2, 3], {}, np.ones((4, 3))):
        with pytest.raises((TypeError, brindle.Error)):
            brindle.stripes(thing)


def test_curves_and_samples(torus):
    p = brindle.stripes(torus, torus.smooth_field(), stripes=20)
    for options in ({"resample": 0}, {"simplify": -1}, {"min_length": -1}, {"offset": np.inf},
                    {"trim": 1.5}, {"trim": -0.1}, {"trim": np.nan}, {"fair": 1.5}, {"fair": np.nan}, {"trim": 0.6, "join": True}):
        with pytest.raises(brindle.Error):
            p.curves(**options)
    with pytest.warns(brindle.PatternWarning, match="u: no curves left: all .* shorter than min_length"):
        assert p.curves(min_length=1e6).count == 0
    for options in ({"join": 1}, {"resample": "fine"}, {"trim": "much"}):
        with pytest.raises(TypeError):
            p.curves(**options)
    with pytest.raises(brindle.Error):
        p.curves().tubes(-1)
    with pytest.raises(brindle.Error):
        brindle.samples(torus, stripes=20, min_distance=-1)
    other = brindle.shape("sphere", resolution=20)
    with pytest.raises(brindle.Error, match="one surface"):
        brindle.advanced.samples_of(p, brindle.stripes(other))


def test_phases_of_others(torus):
    d, n = torus.smooth_field(), torus.vertex_count
    for phases in (np.ones(3, "c8"), np.full(n, 2, "c8"), np.full(n, np.nan, "c8"), np.ones((n, 2), "c8")):
        with pytest.raises(brindle.Error):
            brindle.advanced.stripes_from_phases(torus, phases, d, stripes=20)
    with pytest.raises(TypeError):
        brindle.advanced.stripes_from_phases(torus, np.ones(n), d, stripes=20)


@pytest.mark.skipif(not brindle.has_opengl, reason="this build draws no pictures")
def test_what_points_and_crosses_do_not_show(torus, tmp_path):
    c = brindle.crosses(torus, stripes=10)
    cloud = brindle.points(torus.vertices, torus.normals)
    on_points = brindle.stripes(cloud, stripes=10)
    for view in ("branches", "angle_error"):
        with pytest.raises(brindle.Error, match="of a cross field, branches and angle errors are not"):
            brindle.render(torus, c, view=view, size=(20, 20))
        with pytest.raises(brindle.Error, match="points have no triangles: branches"):
            brindle.render(cloud, on_points, view=view, size=(20, 20))
    for call in (lambda: brindle.render(torus, c, tile="arrows", size=(20, 20)),
                 lambda: c.write(tmp_path / "c.glb", tile="arrows"),
                 lambda: c.mesh().write(tmp_path / "c.glb", tile="bricks")):
        with pytest.raises(brindle.Error, match="does not look the same turned by 90 degrees"):
            call()
    assert not (tmp_path / "c.glb").exists()
    with pytest.raises(brindle.Error, match=r"tiles: expected one of whole\|cut"):
        brindle.render(torus, c, tile="plus", size=(20, 20), look=brindle.Look(tiles="some"))
    with pytest.raises(brindle.Error, match="tiles has no effect here"):
        brindle.render(torus, size=(20, 20), look=brindle.Look(tiles="whole"))
    with pytest.raises(brindle.Error, match="tiles has no effect here.*holds no values of triangles"):
        c.write(tmp_path / "c.glb", tile="plus", tiles="whole")
    with pytest.raises(brindle.Error, match="tiles has no effect here: there is no tile"):
        c.mesh().write(tmp_path / "c.ply", tiles="whole")
    brindle.render(torus, c, tile="plus", size=(20, 20))
    brindle.render(cloud, on_points, view="stripes", size=(20, 20))


@pytest.mark.skipif(not brindle.has_opengl, reason="this build draws no pictures")
def test_pictures(torus, tmp_path):
    p = brindle.stripes(torus, torus.smooth_field(), stripes=20)
    for options in ({"size": (0, 5)}, {"size": (10**6, 10**6)}, {"size": 5}, {"camera": (1,)},
                    {"camera": (0, 100)}, {"camera": "nowhere"}, {"projection": "flat"}, {"up": "w"}, {"colors": ("reddish", "blue")},
                    {"colors": ("#fff",)}, {"view": "nothing"}, {"stripe_width": 2},
                    {"tile": "dots"}, {"tube_radius": 1}, {"light_from": 5}, {"slice": "50%"}, {"slice": "0,0,0,0,0,0"}, {"light_from": (0, 95)},
                    {"light_from": (float("nan"), 0)},
                    {"light_from": (0, 0), "shading": False}):
        with pytest.raises(brindle.Error):
            brindle.render(torus, p, **grouped(**options))
    for options in ({"size": (10.5, 3)}, {"transparent": "yes"}, {"colors": (1, 2)}, {"slice": 0.5}):
        with pytest.raises(TypeError):
            brindle.render(torus, p, **grouped(**options))
    with pytest.raises(TypeError):
        brindle.render(torus, "stripes")
    c = brindle.crosses(torus, stripes=10)
    for pattern in (p, p.curves(), brindle.texture(torus, stripes=20), brindle.samples(torus, stripes=20),
                    c, c.double_cover.curves()):
        with pytest.raises(brindle.Error, match="not made for"):
            brindle.render(brindle.shape("sphere"), pattern)
    for surface in (torus, c.surface):
        for pattern in (c, c.double_cover.curves()):
            assert brindle.render(surface, pattern, size=(20, 20)).any()
    with pytest.raises(brindle.Error):
        brindle.write_png(tmp_path / "x.png", np.zeros((4, 4), "u1"))
    with pytest.raises(TypeError):
        brindle.write_png(tmp_path / "x.png", np.zeros((4, 4, 4)))


@pytest.mark.skipif(not brindle.has_opengl, reason="this build draws no pictures")
def test_slices_leave_something(torus):
    """Of everything that is drawn; where the plane only touches, nothing is left."""
    cloud = brindle.points(torus.vertices, torus.normals)
    low, high = torus.vertices[:, 2].min(), torus.vertices[:, 2].max()
    p = brindle.stripes(torus, torus.smooth_field(), stripes=10)
    drawn = [(torus, None), (torus, p), (torus, p.curves()), (torus, brindle.crosses(torus, stripes=10)),
             (torus, brindle.texture(torus, stripes=10)), (torus, brindle.samples(torus, stripes=10)),
             (cloud, None), (cloud, brindle.stripes(cloud, stripes=10))]
    for surface, pattern in drawn:
        for nothing in (f"z={low - 0.5}", f"-z={high + 0.5}", "x=-20%", "0,0,-9,1,2,30"):
            with pytest.raises(brindle.Error, match="^slice leaves nothing of the surface, which has x from"):
                brindle.render(surface, pattern, slice=nothing, size=(20, 20))
        assert brindle.render(surface, pattern, slice="z=50%", size=(20, 20)).any()
    for touching in ("z=0%", "-z=100%"):
        with pytest.raises(brindle.Error, match="slice leaves nothing"):
            brindle.render(torus, slice=touching, size=(20, 20))


def test_slices_leave_something_of_drawings(torus, tmp_path):
    curves = brindle.stripes(torus, torus.smooth_field(), stripes=10).curves()
    with pytest.raises(brindle.Error, match="^slice leaves nothing of the surface"):
        curves.draw(tmp_path / "c.svg", slice="z=-20%")
    assert not (tmp_path / "c.svg").exists()
    curves.draw(tmp_path / "c.svg", slice="z=50%")
    assert (tmp_path / "c.svg").exists()


def test_build_without_pictures_says_so(torus):
    if brindle.has_opengl:
        pytest.skip("this build draws pictures")
    with pytest.raises(brindle.Error, match="BRINDLE_GL"):
        brindle.render(torus)
