"""Requests that the tool and Python are asked alike: the same metrics, bit for bit, or refusals in the
same words. What a row of the tables asks of Python is a function of the surface; what it asks of the
tool are words after the mesh."""

import json
import subprocess
import warnings

import numpy as np
import pytest

import brindle
from brindle import _core
from conftest import TOOL, run_tool, with_names_of_parts

# What the two were asked, where from, and how long it took.
OWN_KEYS = {"command", "input", "options", "milliseconds"}

TORUS = "shape:torus,resolution=40"
TREFOIL = "shape:trefoil,resolution=24"


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """Meshes, points and fields that both read."""
    folder = tmp_path_factory.mktemp("agreement")
    surface = brindle.shape("torus", resolution=40)
    x = np.array(surface.vertices, float)
    velocity = np.stack([-x[:, 1], x[:, 0], 0.3 + x[:, 2]], axis=1) * 5
    velocity[3] = np.nan
    stress = np.zeros((len(x), 6))
    stress[:, 0], stress[:, 1], stress[:, 3] = 1 + x[:, 0], 2, 0.4
    speed = 1 + x[:, 0] ** 2
    surface.write(folder / "field.vtp",
                  point_data={"velocity": velocity, "stress": stress, "speed": speed,
                              "stress9": np.stack([stress[:, [0, 3, 5]], stress[:, [3, 1, 4]],
                                                   stress[:, [5, 4, 2]]], axis=1)},
                  cell_data={"flow": velocity[surface.faces[:, 0]]})
    np.savetxt(folder / "points.csv", np.concatenate([x, surface.normals], axis=1), delimiter=",",
               fmt="%.9g")
    np.savetxt(folder / "avoid.csv", (x[:, 0] > 0).astype(float), fmt="%g")
    write_sleeve(folder / "sleeve.ply")
    run_tool("stripe", folder / "sleeve.ply", "--direction", "0,0,1", "--stripes", "9", "--quiet",
             "--output", folder / "last.vtp")
    return folder


def write_sleeve(path):
    """An open cylinder."""
    angles, heights = np.meshgrid(np.linspace(0, 2 * np.pi, 40, endpoint=False), np.linspace(0, 2, 21))
    vertices = np.stack([np.cos(angles), np.sin(angles), heights], axis=-1).reshape(-1, 3)
    i = np.arange(20 * 40)
    right = i - i % 40 + (i + 1) % 40
    triangles = np.concatenate([np.stack([i, right, right + 40], axis=1),
                                np.stack([i, right + 40, i + 40], axis=1)])
    brindle.Surface(vertices, triangles).write(path)


def opened(name, folder):
    if name.startswith("shape:"):
        return name, brindle.shape(name.removeprefix("shape:"))
    return folder / name, brindle.read(folder / name)


def up(s):
    return s.projected_field((0, 0, 1))


def avoid_branches(s):
    return (np.array(s.vertices)[:, 0] > 0).astype(float)


def stripes(**options):
    return lambda s: brindle.stripes(s, **options)


def with_field(field, **options):
    return lambda s: brindle.stripes(s, field(s), **options)


# The command, the mesh, words after it, and what Python is asked for.
REQUESTS = [
    # fields
    ("stripe", TORUS, "", stripes()),
    ("stripe", TREFOIL, "--direction 0.31,0.9,0.27", with_field(lambda s: s.projected_field((0.31, 0.9, 0.27)))),
    ("stripe", TREFOIL, "--field curvature", with_field(lambda s: s.curvature_field())),
    ("stripe", TREFOIL, "--field curvature,min",
     with_field(lambda s: s.curvature_field("min"))),
    ("stripe", TREFOIL, "--field curvature --curvature-anchor 0.5",
     with_field(lambda s: s.curvature_field(anchor=0.5))),
    ("stripe", TREFOIL, "--curvature-anchor 0.3 --field smooth,min",
     with_field(lambda s: s.smooth_field(curvature_anchor=0.3, curvature="min"))),
    ("stripe", TREFOIL, "--field raw-curvature", with_field(lambda s: s.curvature_field(raw=True))),
    ("stripe", "shape:box", "--feature-anchor 2,angle=30",
     with_field(lambda s: s.smooth_field(feature_anchor=2, feature_angle=30))),
    ("stripe", "shape:molecule,resolution=24", "--normal-radius 0.2",
     with_field(lambda s: s.smooth_field(normal_radius=0.2))),
    ("stripe", "shape:box", "--feature-anchor 1,radius=0.2",
     with_field(lambda s: s.smooth_field(feature_anchor=1, feature_radius=0.2))),
    ("stripe", TORUS, "--rotate 35", with_field(lambda s: s.rotate_field(s.smooth_field(), 35))),
    ("stripe", TORUS, "--along", stripes(run="along")),
    ("stripe", "field.vtp", "--field array:velocity", stripes(directions="velocity")),
    ("stripe", "field.vtp", "--field array:cells/flow", stripes(directions="cells/flow")),
    ("stripe", "field.vtp", "--field array:stress", stripes(directions="stress")),
    ("stripe", "field.vtp", "--field array:stress9", stripes(directions="stress9")),
    ("stripe", "shape:trefoil,resolution=12", "--subdivide 2,rounded",
     lambda s: brindle.stripes(s.subdivide(2, rounded=True))),
    # measured fields
    ("stripe", "field.vtp", "--field array:velocity --field-smoothing 1.5",
     stripes(directions="velocity", measured=brindle.Measured(1.5))),
    ("stripe", "field.vtp", "--field array:velocity --field-smoothing 1,weight=length,arrows",
     stripes(directions="velocity", measured=brindle.Measured(1, field_weight="length", field_arrows=True))),
    ("stripe", "field.vtp", "--field array:cells/flow --field-smoothing 0.5,fill=1",
     stripes(directions="cells/flow", measured=brindle.Measured(0.5, fill=1))),
    ("stripe", "field.vtp", "--field array:cells/flow --field-smoothing 2,weight=array:speed",
     stripes(directions="cells/flow", measured=brindle.Measured(2, field_weight="speed"))),
    ("stripe", "field.vtp", "--field array:stress --field-smoothing 1 --along",
     stripes(directions="stress", measured=brindle.Measured(1), run="along")),
    ("stripe", "field.vtp", "--field array:velocity --field-smoothing 1 --frequency array:speed",
     stripes(directions="velocity", frequency="speed", measured=brindle.Measured(1))),
    ("stripe", "field.vtp", "--field array:velocity --frequency array:speed --frequency-smoothing 1,fill=1",
     stripes(directions="velocity", frequency="speed", measured=brindle.Measured(frequency_smoothing=1, fill=1))),
    ("stripe", "field.vtp", "--field array:velocity --field-smoothing 1 --frequency-by array:speed "
     "--frequency-smoothing 0.5 --texture dots",
     lambda s: brindle.texture(s, "velocity", frequency=s.frequencies_by("speed"), measured=brindle.Measured(1, frequency_smoothing=0.5))),
    ("stripe", "field.vtp", "--field array:velocity --cross --field-smoothing 1",
     lambda s: brindle.crosses(s, "velocity", measured=brindle.Measured(1))),
    ("stripe", "field.vtp", "--field array:velocity --texture dots --field-smoothing 1",
     lambda s: brindle.texture(s, "velocity", measured=brindle.Measured(1))),
    # frequencies
    ("stripe", TORUS, "--stripes 12.5", stripes(stripes=12.5)),
    ("stripe", TORUS, "--frequency 3", stripes(frequency=3)),
    ("stripe", TORUS, "--spacing 0.3", stripes(spacing=0.3)),
    ("stripe", "field.vtp", "--frequency array:speed", stripes(frequency="speed")),
    ("stripe", "field.vtp", "--frequency-by array:speed",
     lambda s: brindle.stripes(s, frequency=s.frequencies_by("speed"))),
    ("stripe", "field.vtp", "--frequency-by array:velocity@0.5..1.5,inverse --stripes 15",
     lambda s: brindle.stripes(s, frequency=s.frequencies_by("velocity", stripes=15, range=(0.5, 1.5),
                                                             inverse=True))),
    # solvers
    ("stripe", TORUS, "--solver relaxation,seed=3,epsilon=0.1,momentum=0.3",
     stripes(solver=brindle.Solver("relaxation", seed=3, epsilon=0.1, momentum=0.3))),
    ("stripe", TORUS, "--solver averaged", stripes(solver="averaged")),
    ("stripe", TORUS, "--solver relaxation,cycles=2,sweeps=3",
     stripes(solver=brindle.Solver("relaxation", cycles=2, sweeps=3))),
    ("stripe", TORUS, "--solver multilevel,cycles=3", stripes(solver=brindle.Solver(cycles=3))),
    ("stripe", TORUS, "--solver multilevel,sweeps=7", stripes(solver=brindle.Solver(sweeps=7))),
    ("stripe", TORUS, "--solver multilevel,phase-shift=trapezoid", stripes(solver=brindle.Solver(phase_shift="trapezoid"))),
    ("stripe", TORUS, "--solver multilevel,phase-shift=common_source", stripes(solver=brindle.Solver(phase_shift="common_source"))),
    ("stripe", TORUS, "--solver multilevel,weights=cotangent", stripes(solver=brindle.Solver(weights="cotangent"))),
    ("stripe", TORUS, "--threads 1", stripes(solver=brindle.Solver(threads=1))),
    # slack
    ("stripe", TREFOIL, "--slack 0.25", stripes(slack=0.25)),
    ("stripe", TORUS, "--slack 0.25 --solver multilevel,weights=cotangent --stripes 20",
     stripes(slack=0.25, stripes=20, solver=brindle.Solver(weights="cotangent"))),
    ("stripe", TORUS, "--slack 0.2 --avoid-branches {folder}/avoid.csv", lambda s: brindle.stripes(s, slack=brindle.Slack(0.2, avoid_branches(s)))),
    ("stripe", TORUS, "--slack 0", stripes(slack=0)),
    # what a maker asks for
    ("stripe", "sleeve.ply", "--direction 0,0,1 --stripes 9 --winding 1", with_field(up, stripes=9, layout=brindle.Layout(winding=1))),
    ("stripe", "sleeve.ply", "--direction 0,0,1 --stripes 9 --winding boundary-1:-2",
     with_field(up, stripes=9, layout=brindle.Layout(winding={"boundary-1": -2}))),
    ("stripe", "sleeve.ply", "--direction 0,0,1 --stripes 9 --anchor-boundary 0.5",
     with_field(up, stripes=9, layout=brindle.Layout(anchor_boundary=0.5))),
    ("stripe", "sleeve.ply", "--direction 0,0,1 --stripes 9 --anchor-boundary 0 --winding 0",
     with_field(up, stripes=9, layout=brindle.Layout(anchor_boundary=0, winding=0))),
    ("stripe", TREFOIL, "--direction 0.31,0.9,0.27 --cancel-branches 0.05",
     with_field(lambda s: s.projected_field((0.31, 0.9, 0.27)), layout=brindle.Layout(cancel_branches=0.05))),
    ("stripe", TREFOIL, "--slack 0.1 --cancel-branches 0", stripes(slack=0.1, layout=brindle.Layout(cancel_branches=0))),
    ("stripe", "sleeve.ply", "--direction 0,0,1 --stripes 9 --winding 2 --cancel-branches 0.1 --slack 0.1",
     with_field(up, stripes=9, slack=0.1, layout=brindle.Layout(winding=2, cancel_branches=0.1))),
    # textures
    ("stripe", TORUS, "--texture dots --stripes 12", lambda s: brindle.texture(s, stripes=12)),
    ("stripe", TORUS, "--texture arrows --oriented --direction 0,0,1 --stripes 12",
     lambda s: brindle.texture(s, up(s), oriented=True, stripes=12)),
    ("stripe", TORUS, "--texture dots --stripes 12 --stripes-v 20",
     lambda s: brindle.texture(s, stripes=(12, 20))),
    ("stripe", TORUS, "--texture dots --frequency 3 --frequency-v 2 --along",
     lambda s: brindle.texture(s, run="along", frequency=(3, 2))),
    ("stripe", TORUS, "--texture dots --stripes 12 --slack 0.2 --solver multilevel,weights=cotangent",
     lambda s: brindle.texture(s, stripes=12, slack=0.2, solver=brindle.Solver(weights="cotangent"))),
    ("stripe", TORUS, "--texture dots --stripes 12 --solver averaged",
     lambda s: brindle.texture(s, stripes=12, solver="averaged")),
    ("stripe", TREFOIL, "--direction 0.31,0.9,0.27 --texture dots --cancel-branches 0.05,distance=12",
     lambda s: brindle.texture(s, s.projected_field((0.31, 0.9, 0.27)), layout=brindle.Layout(cancel_branches=0.05, cancel_distance=12))),
    # crosses
    ("stripe", "shape:molecule,resolution=20", "--cross --stripes 25 --slack 0.1 --cancel-branches 0.1",
     lambda s: brindle.crosses(s, stripes=25, slack=0.1, layout=brindle.Layout(cancel_branches=0.1))),
    ("stripe", "shape:box", "--cross --stripes 20", lambda s: brindle.crosses(s, stripes=20)),
    ("stripe", TORUS, "--cross --frequency 3 --slack 0.2",
     lambda s: brindle.crosses(s, frequency=3, slack=0.2)),
    ("stripe", TORUS, "--cross --direction 0,0,1 --stripes 12",
     lambda s: brindle.crosses(s, up(s), stripes=12)),
    # points
    ("stripe", "points.csv", "", stripes()),
    ("stripe", "points.csv", "--direction 0,0,1 --stripes 9", with_field(up, stripes=9)),
    ("stripe", "points.csv", "--solver averaged --stripes 9", stripes(solver="averaged", stripes=9)),
    # curves
    ("curves", TREFOIL, "--stripes 20", lambda s: brindle.stripes(s, stripes=20).curves()),
    ("curves", TREFOIL, "--stripes 20 --join", lambda s: brindle.stripes(s, stripes=20).curves(join=True)),
    ("curves", TREFOIL, "--stripes 20 --trim 0", lambda s: brindle.stripes(s, stripes=20).curves(trim=0)),
    ("curves", TREFOIL, "--stripes 20 --fair 0.25", lambda s: brindle.stripes(s, stripes=20).curves(fair=0.25)),
    ("curves", TREFOIL, "--stripes 20 --offset 0.5 --min-length 0.3",
     lambda s: brindle.stripes(s, stripes=20).curves(offset=0.5, min_length=0.3)),
    ("curves", TREFOIL, "--stripes 20 --resample 0.05 --simplify 0.001 --output {folder}/lines.obj",
     lambda s: brindle.stripes(s, stripes=20).curves(resample=0.05, simplify=0.001)),
    ("curves", "sleeve.ply", "--direction 0,0,1 --stripes 9 --winding 1 --slack 0.1",
     lambda s: brindle.stripes(s, up(s), stripes=9, slack=0.1, layout=brindle.Layout(winding=1)).curves()),
    # samples
    ("sample", TORUS, "--stripes 12", lambda s: brindle.samples(s, stripes=12)),
    ("sample", TORUS, "--stripes 12 --stripes-v 20 --min-distance 0.5",
     lambda s: brindle.samples(s, min_distance=0.5, stripes=(12, 20))),
    ("sample", "points.csv", "--stripes 9", lambda s: brindle.samples(s, stripes=9)),
]


def asked(words, folder):
    return words.format(folder=folder).split()


def named(rows):
    return [f"{row[0]} {row[1]} {row[2]}" for row in rows]


def check_same(got, expected):
    """All that Python says the tool says alike."""
    for key in got.keys() - OWN_KEYS:
        assert got[key] == expected[key], key


def said_of_lines(text):
    """What the tool says of a surface and its waves, without what it says of files."""
    lines = (line.removeprefix("brindle: ").removeprefix("warning: ")
             for line in with_names_of_parts(text).splitlines())
    return {_core.in_pythons_words(line) for line in lines}


@pytest.mark.parametrize("command, mesh, words, ask", REQUESTS, ids=named(REQUESTS))
def test_requests(command, mesh, words, ask, folder, tmp_path):
    path, surface = opened(mesh, folder)
    if not TOOL.exists():
        pytest.skip("the tool is not built; BRINDLE_TOOL names it")
    done = subprocess.run([TOOL, command, path, *asked(words, folder), "--report", tmp_path / "report.json"],
                          capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    expected = json.loads((tmp_path / "report.json").read_text())
    with warnings.catch_warnings(record=True) as heard:
        warnings.simplefilter("always")
        report = ask(surface).report
    if command == "stripe":
        assert list(report) == list(expected)
        assert report["milliseconds"].keys() == expected["milliseconds"].keys()
        assert report["milliseconds"]["field"] > 0
    check_same(report, expected["u"] if command == "curves" else expected)
    # Whatever Python warns of, the tool says in the same words.
    assert {str(warning.message) for warning in heard} <= said_of_lines(done.stderr)
    assert all(warning.category is brindle.PatternWarning for warning in heard)
    # Whatever the tool warns of, Python warns of.
    warned = {line for line in done.stderr.splitlines() if "warning: " in line}
    assert said_of_lines("\n".join(warned)) <= {str(warning.message) for warning in heard}


# Refused in the same words.
REFUSALS = [
    ("stripe", TORUS, "--solver relaxation,sweeps=3", stripes(solver=brindle.Solver("relaxation", sweeps=3))),
    ("stripe", TORUS, "--solver multilevel,epsilon=0.1", stripes(solver=brindle.Solver(epsilon=0.1))),
    ("stripe", TORUS, "--solver multilevel,momentum=0.1", stripes(solver=brindle.Solver(momentum=0.1))),
    ("stripe", TORUS, "--solver global,seed=1", stripes(solver=brindle.Solver("global", seed=1))),
    ("stripe", TORUS, "--solver multilevel,iterations=3", stripes(solver=brindle.Solver(global_iterations=3))),
    ("stripe", TORUS, "--avoid-branches {folder}/avoid.csv", lambda s: brindle.stripes(s, slack=brindle.Slack(None, avoid_branches(s)))),
    ("stripe", TORUS, "--avoid-branches {folder}/avoid.csv --slack 0", lambda s: brindle.stripes(s, slack=brindle.Slack(0, avoid_branches(s)))),
    ("stripe", TORUS, "--texture dots --avoid-branches {folder}/avoid.csv", lambda s: brindle.texture(s, slack=brindle.Slack(None, avoid_branches(s)))),
    ("stripe", TORUS, "--cross --avoid-branches {folder}/avoid.csv", lambda s: brindle.crosses(s, slack=brindle.Slack(None, avoid_branches(s)))),
    ("stripe", "sleeve.ply", "--previous {folder}/last.vtp --solver averaged",
     lambda s: brindle.stripes(s, previous=brindle.stripes(s), solver="averaged")),
    ("stripe", "sleeve.ply", "--anchor-boundary 0 --winding 5", stripes(layout=brindle.Layout(anchor_boundary=0, winding=5))),
    ("stripe", "sleeve.ply", "--anchor-boundary 0 --winding boundary-2:1",
     stripes(layout=brindle.Layout(anchor_boundary=0, winding={"boundary-2": 1}))),
    ("stripe", "sleeve.ply", "--anchor-boundary 0 --solver averaged", stripes(solver="averaged", layout=brindle.Layout(anchor_boundary=0))),
    ("stripe", "sleeve.ply", "--direction 0,0,1 --along --anchor-boundary 0 --stripes 9",
     with_field(up, stripes=9, layout=brindle.Layout(anchor_boundary=0), run="along")),
    ("stripe", "sleeve.ply", "--direction 0,0,1 --winding loop-9:1", with_field(up, layout=brindle.Layout(winding={"loop-9": 1}))),
    ("stripe", "sleeve.ply", "--direction 0,0,1 --winding 400 --stripes 9", with_field(up, stripes=9, layout=brindle.Layout(winding=400))),
    ("stripe", "shape:sphere,resolution=20", "--winding 1", stripes(layout=brindle.Layout(winding=1))),
    ("stripe", TORUS, "--field smooth,min", lambda s: s.smooth_field(curvature="min")),
    ("stripe", TORUS, "--feature-anchor 0,angle=20", lambda s: s.smooth_field(feature_angle=20)),
    ("stripe", TORUS, "--feature-anchor 0,radius=2", lambda s: s.smooth_field(feature_radius=2)),
    ("stripe", "points.csv", "--feature-anchor 1", lambda s: s.smooth_field(feature_anchor=1)),
    ("stripe", "points.csv", "--solver multilevel,weights=cotangent", stripes(solver=brindle.Solver(weights="cotangent"))),
    ("sample", "points.csv", "--solver multilevel,weights=cotangent", lambda s: brindle.samples(s, solver=brindle.Solver(weights="cotangent"))),
    ("sample", "points.csv", "--min-distance 0.1", lambda s: brindle.samples(s, min_distance=0.1)),
    ("stripe", "points.csv", "--winding 1", stripes(layout=brindle.Layout(winding=1))),
    ("stripe", "points.csv", "--anchor-boundary 0", stripes(layout=brindle.Layout(anchor_boundary=0))),
    ("stripe", "points.csv", "--cancel-branches 0", stripes(layout=brindle.Layout(cancel_branches=0))),
    ("stripe", TORUS, "--frequency 1e9", stripes(frequency=1e9)),
    ("stripe", "field.vtp", "--field array:nothing", stripes(directions="nothing")),
]


@pytest.mark.parametrize("command, mesh, words, ask", REFUSALS, ids=named(REFUSALS))
def test_refusals(command, mesh, words, ask, folder):
    path, surface = opened(mesh, folder)
    if not TOOL.exists():
        pytest.skip("the tool is not built; BRINDLE_TOOL names it")
    done = subprocess.run([TOOL, command, path, *asked(words, folder), "--quiet"], capture_output=True, text=True)
    assert done.returncode in (1, 2), done.stderr
    with pytest.raises(brindle.Error) as refused:
        ask(surface)
    expected = with_names_of_parts(done.stderr.strip().splitlines()[-1].removeprefix("brindle: "))
    assert str(refused.value) == _core.in_pythons_words(expected)


# Arguments whose options the tool has in the values of others, without these: sessions have them, too.
PARTS_ALONE = [
    ({"cross": True, "cancel-distance": "5"}, lambda s: brindle.crosses(s, layout=brindle.Layout(cancel_distance=5))),
    ({"lambda": "0.1"}, stripes(previous=brindle.Previous(None, stiffness=0.1))),
    ({"match": "number"}, stripes(previous=brindle.Previous(None, match="number"))),
    ({"feature-angle": "20"}, lambda s: s.smooth_field(feature_angle=20)),
]


@pytest.mark.parametrize("options, ask", PARTS_ALONE, ids=["_".join(options) for options, _ in PARTS_ALONE])
def test_refusals_of_sessions(options, ask, tmp_path):
    if not TOOL.exists():
        pytest.skip("the tool is not built; BRINDLE_TOOL names it")
    session = tmp_path / "session.json"
    session.write_text(json.dumps({"brindle_session": 1, "mesh": TORUS, "options": options}))
    done = subprocess.run([TOOL, "render", session, "--quiet", "--output", tmp_path / "report.json"],
                          capture_output=True, text=True)
    with pytest.raises(brindle.Error) as refused:
        ask(brindle.shape(TORUS.removeprefix("shape:")))
    assert _core.in_pythons_words(done.stderr.strip().splitlines()[-1]).endswith(str(refused.value))
