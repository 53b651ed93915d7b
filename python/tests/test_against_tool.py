"""Results are those of the tool, bit for bit: reports, phases, files, pictures."""

import subprocess

import numpy as np
import pytest

import brindle
from conftest import MODELS, grouped, model, run_tool

SURFACES = ["shape:trefoil", "shape:vessels", "horse.ply", "nefertiti.obj", "spot.obj",
            "stanford-bunny.obj"]
# What the two were asked, and how long it took.
OWN_KEYS = {"command", "input", "options", "milliseconds"}


def opened(name):
    if name.startswith("shape:"):
        return name, brindle.shape(name.removeprefix("shape:"))
    return MODELS / name, model(name)


def check_report(got, expected):
    assert list(got) == list(expected)
    for key in expected.keys() - OWN_KEYS:
        assert got[key] == expected[key], key
    assert got["milliseconds"].keys() == expected["milliseconds"].keys() - {"draw"}


@pytest.mark.parametrize("name", SURFACES)
def test_stripes(name, tool, tmp_path):
    path, surface = opened(name)
    expected = tool("stripe", path, "--output", tmp_path / "tool.vtp")
    p = brindle.stripes(surface, surface.smooth_field(), stripes=40)
    check_report(p.report, expected)
    assert np.count_nonzero(p.branches) == p.report["branches"]
    assert np.count_nonzero(p.singularities) == p.report["field_singularities"]
    p.write(tmp_path / "python.vtp")
    assert (tmp_path / "python.vtp").read_bytes() == (tmp_path / "tool.vtp").read_bytes()
    written = brindle.read(tmp_path / "tool.vtp", crease_angle=180).point_data["phase"]
    there = ~np.isnan(written)
    np.testing.assert_allclose(np.angle(p.phases[there]), written[there], atol=1e-6)


OPTIONS = [
    (["--direction", "0.31,0.9,0.27"], lambda s: {"directions": s.projected_field((0.31, 0.9, 0.27))}),
    (["--field", "curvature"], lambda s: {"directions": s.curvature_field()}),
    (["--field", "curvature,min"],
     lambda s: {"directions": s.curvature_field("min")}),
    (["--field", "raw-curvature"], lambda s: {"directions": s.curvature_field("max", raw=True)}),
    (["--along", "--stripes", "25"], lambda s: {"along": True, "stripes": 25}),
    (["--frequency", "7.5"], lambda s: {"frequency": 7.5}),
    (["--feature-anchor", "1"], lambda s: {"directions": s.smooth_field(feature_anchor=1)}),
    (["--solver", "relaxation,seed=3,epsilon=0.1"],
     lambda s: {"solver": "relaxation", "seed": 3, "epsilon": 0.1}),
    (["--solver", "averaged"], lambda s: {"solver": "averaged"}),
    (["--solver", "multilevel,cycles=2,sweeps=3"], lambda s: {"cycles": 2, "sweeps": 3}),
    (["--solver", "multilevel,phase-shift=trapezoid,weights=cotangent"],
     lambda s: {"phase_shift": "trapezoid", "weights": "cotangent"}),
    (["--threads", "1"], lambda s: {"threads": 1}),
    (["--slack", "0.25"], lambda s: {"slack": 0.25}),
]


def test_turned_fields(tool, tmp_path):
    """Waves are those of --rotate; files of the tool say `turn_deg` besides, which it knows."""
    expected = tool("stripe", "shape:torus,resolution=100", "--rotate", "30", "--output", tmp_path / "tool.vtp")
    s = brindle.shape("torus", resolution=100)
    p = brindle.stripes(s, s.rotate_field(s.smooth_field(), 30))
    check_report(p.report, expected)
    p.write(tmp_path / "python.vtp")
    ours, theirs = (brindle.read(tmp_path / name).point_data for name in ("python.vtp", "tool.vtp"))
    assert set(theirs) - set(ours) == {"turn_deg"}
    for name, values in ours.items():
        np.testing.assert_array_equal(values, theirs[name])


@pytest.mark.parametrize("words, arguments", OPTIONS, ids=[" ".join(words) for words, _ in OPTIONS])
def test_options(words, arguments, tool, tmp_path):
    surface = brindle.shape("torus", resolution=100)
    expected = tool("stripe", "shape:torus,resolution=100", "--output", tmp_path / "tool.ply", *words)
    p = brindle.stripes(surface, **grouped(**arguments(surface)))
    check_report(p.report, expected)
    p.write(tmp_path / "python.ply")
    assert (tmp_path / "python.ply").read_bytes() == (tmp_path / "tool.ply").read_bytes()


@pytest.mark.skipif(not brindle.advanced.has_solver("global"), reason="this build has no CHOLMOD")
def test_global_solver(tool):
    surface = brindle.shape("torus", resolution=60)
    expected = tool("stripe", "shape:torus,resolution=60", "--solver", "global", "--stripes", "15")
    check_report(brindle.stripes(surface, solver="global", stripes=15).report, expected)


def test_subdivision(tool):
    expected = tool("stripe", "shape:torus,resolution=30", "--subdivide", "2")
    check_report(brindle.stripes(brindle.shape("torus", resolution=30, subdivide=2)).report, expected)


def test_joined_vertices(tool, tmp_path):
    """Along a seam, vertices stand at one place twice: triangles use the first, both have its wave."""
    (tmp_path / "seam.obj").write_text(
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 1 0 0\nv 1 1 0\nv 2 0 0\nv 2 1 0\n"
        "f 1 2 3 4\nf 5 7 8 6\n")
    surface = brindle.read(tmp_path / "seam.obj")
    p = brindle.stripes(surface, surface.projected_field((1, 0.3, 0)), stripes=2)
    expected = tool("stripe", tmp_path / "seam.obj", "--direction", "1,0.3,0", "--stripes", "2",
                    "--output", tmp_path / "tool.vtp")
    assert expected["vertices_joined"] == 2
    check_report(p.report, expected)
    p.write(tmp_path / "python.vtp")
    assert (tmp_path / "python.vtp").read_bytes() == (tmp_path / "tool.vtp").read_bytes()
    np.testing.assert_array_equal(p.phases[[1, 2]], p.phases[[4, 5]])


def field_file(path):
    """A mesh with arrays of points and cells: vectors, tensors, numbers."""
    surface = brindle.shape("torus", resolution=100)
    x = np.array(surface.vertices, float)
    velocity = np.stack([-x[:, 1], x[:, 0], 0.3 + x[:, 2]], axis=1) * 5
    velocity[3] = np.nan
    stress = np.zeros((len(x), 6))
    stress[:, 0], stress[:, 1], stress[:, 3] = 1 + x[:, 0], 2, 0.4
    speed = np.linalg.norm(velocity, axis=1)
    surface.write(path, point_data={"velocity": velocity, "stress": stress, "speed": speed},
                  cell_data={"flow": velocity[surface.faces[:, 0]]})
    return brindle.read(path)


ARRAYS = [
    (["--field", "array:velocity"], lambda s: {"directions": "velocity"}),
    (["--field", "array:cells/flow"], lambda s: {"directions": "cells/flow"}),
    (["--field", "array:stress"], lambda s: {"directions": "stress"}),
    (["--field", "array:velocity", "--frequency", "array:speed"],
     lambda s: {"directions": "velocity", "frequency": "speed"}),
    (["--frequency-by", "array:speed@0.5..1.5,inverse", "--stripes", "15"],
     lambda s: {"frequency": s.frequencies_by("speed", stripes=15, range=(0.5, 1.5), inverse=True)}),
]


@pytest.mark.parametrize("words, arguments", ARRAYS, ids=[" ".join(words) for words, _ in ARRAYS])
def test_arrays(words, arguments, tool, tmp_path):
    surface = field_file(tmp_path / "field.vtp")
    expected = tool("stripe", tmp_path / "field.vtp", "--output", tmp_path / "tool.vtp", *words)
    p = brindle.stripes(surface, **arguments(surface))
    check_report(p.report, expected)
    p.write(tmp_path / "python.vtp")
    assert (tmp_path / "python.vtp").read_bytes() == (tmp_path / "tool.vtp").read_bytes()


def test_tensors_along_another_axis(tool, tmp_path):
    surface = field_file(tmp_path / "field.vtp")
    expected = tool("stripe", tmp_path / "field.vtp", "--field", "array:stress", "--tensor", "minor")
    p = brindle.stripes(surface, surface.tensor_field("stress", "minor"))
    for key in ("energy", "branches", "vertices_without_wave"):
        assert p.report[key] == expected[key]


def test_previous(tool, tmp_path):
    first = tmp_path / "first.vtp"
    run_tool("stripe", "shape:torus,resolution=100", "--output", first, "--stripes", "20")
    expected = tool("stripe", "shape:torus,resolution=100", "--stripes", "20.5", "--previous", first)
    surface = brindle.shape("torus", resolution=100)
    d = surface.smooth_field()
    q = brindle.stripes(surface, d, stripes=20)
    p = brindle.stripes(surface, stripes=20.5, previous=q)
    assert list(p.report) == list(expected)
    assert p.report["field_turned_deg"] == pytest.approx(expected["field_turned_deg"], abs=1e-3)
    given = brindle.stripes(surface, d, stripes=20.5, previous=q)
    assert "field_turned_deg" not in given.report
    anew = brindle.stripes(surface, stripes=20.5, previous=brindle.Previous(q, stiffness=0))
    assert "field_turned_deg" not in anew.report
    assert p.report["matched_by"] == expected["matched_by"] == "number"
    assert p.report["lambda"] == expected["lambda"]
    # The file has the directions as floats, with which the field goes on.
    assert p.report["phase_step"] == pytest.approx(expected["phase_step"], abs=1e-3)
    other = brindle.shape("torus", resolution=90)
    assert brindle.stripes(other, stripes=20, previous=q).report["matched_by"] == "position"


def beating(step):
    """A knot that moves, with noise of its own at every step."""
    rest = brindle.shape("trefoil", resolution=48)
    v = np.array(rest.vertices)
    v *= 1 + 0.004 * np.sin(2 * v[:, :1] + 0.3 * step)
    v += 5e-4 * np.ptp(v, axis=0).max() * np.random.default_rng(step).normal(size=v.shape)
    return brindle.Surface(v, rest.faces)


@pytest.mark.parametrize("along", [False, True])
def test_smooth_fields_of_moving_surfaces_follow(along):
    options = {"frequency": 4, "run": "along" if along else "across"}
    p = last = brindle.stripes(beating(0), **options)
    steps, anew = [], []
    for step in range(1, 8):
        surface = beating(step)
        p = brindle.stripes(surface, previous=p, **options)
        steps.append(p.report["phase_step"])
        last = brindle.stripes(surface, surface.smooth_field(), previous=brindle.Previous(last, stiffness=0), **options)
        anew.append(last.report["phase_step"])
        assert p.report["field_turned_deg"] < 8
    assert np.mean(steps) <= 0.25 * np.mean(anew)


def test_fields_go_on_from_patterns_that_were_turned():
    before, surface = beating(0), beating(1)
    d = before.smooth_field()
    plain = brindle.stripes(before, d, frequency=4)
    turned = brindle.stripes(before, d, frequency=4, run="along")
    a, b, c = (brindle.stripes(surface, previous=q, frequency=4, run="along" if along else "across").directions
               for q, along in ((plain, False), (turned, False), (plain, True)))
    assert np.abs(np.sum(a * b, axis=1)).mean() > 0.9999
    assert np.abs(np.sum(a * c, axis=1)).mean() < 1e-3


def test_files_say_how_waves_are_turned(tool, tmp_path):
    tool("stripe", "shape:torus", "--along", "--output", tmp_path / "tool.vtp")
    turned = brindle.stripes(brindle.shape("torus"), run="along")
    assert set(turned.point_data["turn_deg"]) == {90}
    turned.write(tmp_path / "python.vtp")
    assert (tmp_path / "python.vtp").read_bytes() == (tmp_path / "tool.vtp").read_bytes()
    # What an input says of other waves does not go along.
    again = brindle.stripes(brindle.read(tmp_path / "python.vtp"))
    for uv in False, True:
        again.write(tmp_path / "again.vtp", uv=uv)
        assert "turn_deg" not in brindle.read(tmp_path / "again.vtp").point_data


def test_last_field():
    before, surface = beating(0), beating(1)
    d = before.smooth_field()
    followed = surface.smooth_field(previous=(before, d))
    assert np.abs(np.sum(followed * d, axis=1)).mean() > 0.99
    p = brindle.stripes(before, d, frequency=4)
    assert np.array_equal(surface.smooth_field(previous=p), followed)
    near = surface.smooth_field(previous=brindle.Previous((before, d), match="position", max_distance=0.5))
    assert np.abs(np.sum(followed * near, axis=1)).mean() > 0.98
    crosses = surface.smooth_field(symmetry=4, previous=(before, before.smooth_field(symmetry=4)))
    assert np.allclose(np.linalg.norm(crosses, axis=1), 1, atol=1e-4)
    with pytest.raises(brindle.Error, match="previous"):
        surface.smooth_field(previous=(before, d[:5]))
    with pytest.raises(brindle.Error, match="match"):
        surface.smooth_field(previous=brindle.Previous(None, match="number"))
    with pytest.raises(brindle.Error, match="neither"):
        surface.smooth_field(previous=brindle.Previous((before, d), match="colour"))
    with pytest.raises(TypeError, match="previous"):
        surface.smooth_field(previous=d)


@pytest.mark.parametrize("oriented", [False, True])
def test_textures(oriented, tool):
    surface = brindle.shape("torus", resolution=100)
    words = ["--oriented"] if oriented else []
    expected = tool("stripe", "shape:torus,resolution=100", "--texture", "dots", "--stripes", "20",
                    "--stripes-v", "10", *words)
    t = brindle.texture(surface, surface.smooth_field(), oriented=oriented, stripes=(20, 10))
    check_report(t.report, expected)


def test_crosses(tool):
    expected = tool("stripe", "shape:box", "--cross", "--stripes", "20")
    c = brindle.crosses(brindle.shape("box"), stripes=20, slack=0, solver=brindle.Solver("multilevel", threads=1))
    check_report({**c.report, "threads": expected["threads"]}, expected)
    assert c.report["options"] == {"stripes": 20, "threads": 1, "slack": 0}
    assert len(c.singular_faces) == c.report["field_singularities"]


@pytest.mark.parametrize("kind", ["vtp", "ply", "glb", "obj"])
@pytest.mark.parametrize("words, make", [
    (["--uv", "--slack", "0.2"], lambda s: brindle.stripes(s, stripes=20, slack=0.2)),
    (["--texture", "dots", "--slack", "0.2"], lambda s: brindle.texture(s, stripes=20, slack=0.2)),
    (["--cross", "--texture", "plus"], lambda s: brindle.crosses(s, stripes=20)),
], ids=["uv", "texture", "cross"])
def test_meshes_with_coordinates(kind, words, make, tmp_path):
    """All arrays of the tool's file, frequency_wanted among them."""
    run_tool("stripe", "shape:box", "--stripes", "20", *words, "--output", tmp_path / f"tool.{kind}")
    pattern = make(brindle.shape("box"))
    if words[0] == "--uv":
        pattern.write(tmp_path / f"python.{kind}", uv=True)
        assert "frequency_wanted" in pattern.mesh().point_data
    else:
        if not brindle.has_opengl:
            pytest.skip("this build draws no pictures")
        pattern.write(tmp_path / f"python.{kind}", tile=words[1] if words[1] != "--texture" else "plus")
    written, expected = ((tmp_path / f"{who}.{kind}").read_bytes() for who in ("python", "tool"))
    assert written.replace(b"python", b"tool") == expected


def test_curves(tool, tmp_path):
    expected = tool("curves", "shape:trefoil", "--stripes", "30", "--join", "--output",
                    tmp_path / "tool.obj")["u"]
    surface = brindle.shape("trefoil")
    curves = brindle.stripes(surface, stripes=30).curves(join=True)
    assert curves.report.keys() <= expected.keys()
    for key, value in curves.report.items():
        assert value == (pytest.approx(expected[key]) if key == "length" else expected[key]), key
    curves.write(tmp_path / "python.obj")
    assert (tmp_path / "python.obj").read_bytes() == (tmp_path / "tool.obj").read_bytes()


def test_shaped_curves(tool, tmp_path):
    expected = tool("curves", "shape:trefoil", "--stripes", "30", "--offset", "0.25", "--min-length",
                    "0.2", "--resample", "0.05", "--simplify", "0.001", "--output", tmp_path / "tool.obj")
    curves = brindle.stripes(brindle.shape("trefoil"), stripes=30).curves(
        offset=0.25, min_length=0.2, resample=0.05, simplify=0.001)
    curves.write(tmp_path / "python.obj")
    assert curves.report["points"] == expected["u"]["points"]
    assert (tmp_path / "python.obj").read_bytes() == (tmp_path / "tool.obj").read_bytes()


def test_samples(tool):
    expected = tool("sample", "shape:torus,resolution=100", "--stripes", "20", "--stripes-v", "10")
    samples = brindle.samples(brindle.shape("torus", resolution=100), stripes=(20, 10))
    for key, value in samples.report.items():
        assert value == expected[key], key


def arrays_of_places(tmp_path):
    """A file whose arrays have all that is told apart: numbers, labels, vectors, a row per triangle."""
    s = brindle.shape("torus", resolution=40)
    n, m = s.vertex_count, s.face_count
    s.write(tmp_path / "in.vtp", point_data={"height": s.vertices[:, 2], "label": np.arange(n) // 7,
                                             "flow": np.cross([0, 0, 1], s.vertices)},
            cell_data={"number": np.arange(m)})
    return brindle.read(tmp_path / "in.vtp", crease_angle=180)


def test_arrays_at_curves_and_samples(tmp_path):
    """As the tool's files of curves and samples have them, of meshes and of points."""
    s = arrays_of_places(tmp_path)
    points = brindle.points(s.vertices, s.normals, point_data=s.point_data)
    s.write(tmp_path / "points.vtp")
    p = brindle.stripes(s, stripes=12)
    for shaped in ({}, {"resample": 0.05}, {"trim": 0.6, "fair": 0.25},
                   {"resample": 0.05, "simplify": 0.01}):
        words = [word for name, value in shaped.items() for word in (f"--{name}", str(value))]
        run_tool("curves", tmp_path / "in.vtp", "--stripes", "12", *words, "--output", tmp_path / "c.ply")
        written = read_vertices(tmp_path / "c.ply")
        curves = p.curves(**shaped)
        for name in ("height", "label", "number"):
            np.testing.assert_array_equal(curves.interpolate(name), written[name], name)
        np.testing.assert_array_equal(curves.interpolate("flow"), written["flow"])
    run_tool("sample", tmp_path / "in.vtp", "--stripes", "12", "--output", tmp_path / "s.ply")
    written, samples = read_vertices(tmp_path / "s.ply"), brindle.samples(s, stripes=12)
    for name in ("height", "label", "number", "flow"):
        np.testing.assert_array_equal(samples.interpolate(name), written[name], name)
    np.testing.assert_array_equal(samples.interpolate(s.point_data["height"]), samples.interpolate("height"))
    of_points = brindle.samples(points, stripes=12)
    assert set(of_points.interpolate("label")) <= set(points.point_data["label"])
    with pytest.raises(brindle.Error, match="5 rows for"):
        samples.interpolate(np.ones(5))
    assert np.ptp(p.curves().interpolate(s.vertices[:, 2]) - p.curves().points[:, 2]) < 1e-6


def read_vertices(path):
    """The arrays of a .ply of lines or samples."""
    return brindle.read(path, points=True).point_data


def test_points(tool, tmp_path):
    torus = brindle.shape("torus", resolution=100)
    rows = np.concatenate([torus.vertices, torus.normals], axis=1)
    np.savetxt(tmp_path / "points.csv", rows, delimiter=",", fmt="%.9g")
    expected = tool("stripe", tmp_path / "points.csv", "--output", tmp_path / "tool.ply")
    surface = brindle.read(tmp_path / "points.csv")
    p = brindle.stripes(surface, surface.smooth_field(), stripes=40)
    check_report(p.report, expected)
    p.write(tmp_path / "python.ply")
    assert (tmp_path / "python.ply").read_bytes() == (tmp_path / "tool.ply").read_bytes()
    same = brindle.points(torus.vertices, torus.normals)
    np.testing.assert_array_equal(brindle.stripes(same, stripes=40).phases, p.phases)


@pytest.mark.skipif(not brindle.has_opengl, reason="this build draws no pictures")
@pytest.mark.parametrize("words, options", [
    ([], {}),
    (["--camera", "60,-10,1.5", "--up", "y", "--colors", "#ff0000,#00ff00,#0000ff"],
     {"camera": (60, -10, 1.5), "up": "y", "colors": ("#ff0000", "#00ff00", "#0000ff")}),
    (["--up", "-x"], {"up": "-x"}),
    (["--camera", "top,orthographic"], {"camera": "top", "projection": "orthographic"}),
    (["--camera", "left,2"], {"camera": "left,2", "projection": "perspective"}),
    (["--light-from", "70,-15.5"], {"light_from": (70, -15.5)}),
    (["--slice", "z=40%"], {"slice": "z=40%"}),
    (["--slice=-x=0.1", "--view", "branches"], {"slice": "-x=0.1", "view": "branches"}),
    (["--slice", "0,0,0.1,1,2,3"], {"slice": "0,0,0.1,1,2,3"}),
    (["--view", "branches"], {"view": "branches"}),
    (["--view", "angle_error"], {"view": "angle_error"}),
    (["--stripe-width", "0.2"], {"stripe_width": 0.2}),
])
def test_pictures(words, options, tmp_path):
    run_tool("stripe", "shape:torus,resolution=100", "--stripes", "20", "--size", "120x90",
             "--output", tmp_path / "tool.png", *words)
    surface = brindle.shape("torus", resolution=100)
    image = brindle.render(surface, brindle.stripes(surface, stripes=20), size=(120, 90), **grouped(**options))
    np.testing.assert_array_equal(image, brindle.read_png(tmp_path / "tool.png"))


@pytest.mark.skipif(not brindle.has_opengl, reason="this build draws no pictures")
def test_pictures_of_stl_stand_on_z(tmp_path):
    corners = [(0, 0, 0), (2, 0, 0), (2, 1, 1)], [(0, 0, 0), (2, 1, 1), (0, 1, 1)]
    facets = ("facet normal 0 0 0\nouter loop\n" + "".join("vertex %g %g %g\n" % place for place in triangle)
              + "endloop\nendfacet\n" for triangle in corners)
    (tmp_path / "plate.stl").write_text(f"solid plate\n{''.join(facets)}endsolid plate\n")
    run_tool("stripe", tmp_path / "plate.stl", "--stripes", "8", "--size", "120x90", "--output", tmp_path / "tool.png")
    surface = brindle.read(tmp_path / "plate.stl")
    pattern = brindle.stripes(surface, stripes=8)
    image = brindle.render(surface, pattern, size=(120, 90))
    np.testing.assert_array_equal(image, brindle.read_png(tmp_path / "tool.png"))
    np.testing.assert_array_equal(image, brindle.render(surface, pattern, size=(120, 90), up="z"))
    assert (image != brindle.render(surface, pattern, size=(120, 90), up="y")).any()


@pytest.mark.skipif(not brindle.has_opengl, reason="this build draws no pictures")
def test_refused_slices(tmp_path):
    """In the tool's words, with the argument's name in place of the option's."""
    words = ["stripe", "shape:torus,resolution=100", "--stripes", "20", "--slice", "-y=3", "--output",
             tmp_path / "tool.png"]
    with pytest.raises(subprocess.CalledProcessError) as refused:
        run_tool(*words)
    surface = brindle.shape("torus", resolution=100)
    with pytest.raises(brindle.Error) as error:
        brindle.render(surface, brindle.stripes(surface, stripes=20), slice="-y=3")
    assert f"--{error.value}\n" in refused.value.stderr.decode()


@pytest.mark.skipif(not brindle.has_opengl, reason="this build draws no pictures")
@pytest.mark.parametrize("tile", ["dots", "hatch"])
def test_whole_tiles(tile, tmp_path):
    surface = brindle.shape("trefoil", resolution=100)
    pattern = brindle.texture(surface, stripes=20)
    pictures = {}
    for tiles in (None, "whole", "cut"):
        run_tool("stripe", "shape:trefoil,resolution=100", "--stripes", "20", "--size", "240x180",
                 "--texture", f"{tile},{tiles}" if tiles else tile,
                 "--output", tmp_path / "tool.png", "--output", tmp_path / "tool.ply")
        pictures[tiles] = brindle.render(surface, pattern, size=(240, 180), tile=tile, look=brindle.Look(tiles=tiles))
        np.testing.assert_array_equal(pictures[tiles], brindle.read_png(tmp_path / "tool.png"))
        pattern.write(tmp_path / "python.ply", tile=tile, tiles=tiles)
        assert ((tmp_path / "python.ply").read_bytes().replace(b"python", b"tool")
                == (tmp_path / "tool.ply").read_bytes())
        assert (b"tile_broken" in (tmp_path / "tool.ply").read_bytes()) == (
            tiles == "whole" or (tiles is None and tile == "dots"))
    assert (pictures["whole"] != pictures["cut"]).any()
    np.testing.assert_array_equal(pictures[None], pictures["whole" if tile == "dots" else "cut"])


@pytest.mark.skipif(not brindle.has_opengl, reason="this build draws no pictures")
def test_pictures_of_textures(tmp_path):
    run_tool("stripe", "shape:torus,resolution=100", "--stripes", "20", "--size", "120x90",
             "--texture", "bricks", "--output", tmp_path / "tool.png")
    surface = brindle.shape("torus", resolution=100)
    image = brindle.render(surface, brindle.texture(surface, stripes=20), size=(120, 90), tile="bricks")
    np.testing.assert_array_equal(image, brindle.read_png(tmp_path / "tool.png"))
