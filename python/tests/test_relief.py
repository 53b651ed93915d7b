"""Reliefs: the same as those of the tool; arguments; rejections."""
import json
import pickle

import numpy as np
import pytest

import brindle
from conftest import run_tool


@pytest.fixture(scope="module")
def texture():
    if not brindle.has_opengl:
        pytest.skip("tiles need a build with OpenGL")
    surface = brindle.shape("bracket")
    return brindle.texture(surface, surface.smooth_field(), spacing=0.4)


@pytest.mark.parametrize("words, named", [
    ([], {}), (["--keep-flat"], {"keep_flat": True}), (["--only", "z@30"], {"only": (0, 0, 1, 30)}),
    (["--inlay", "0.1"], {"inlay": 0.1}), (["--cut", "--tolerance", "0.016"], {"cut": True, "tolerance": 0.016})])
def test_reliefs_are_those_of_the_tool(texture, tmp_path, words, named):
    made = brindle.relief(texture, "dots", 0.08, **named)
    made.write(tmp_path / "python.stl")
    run_tool("relief", "shape:bracket", "--spacing", "0.4", "--texture", "dots", "--height", "0.08", *words,
             "--output", str(tmp_path / "tool.stl"), "--report", str(tmp_path / "tool.json"), "--quiet")
    assert (tmp_path / "python.stl").read_bytes() == (tmp_path / "tool.stl").read_bytes()
    report = json.loads((tmp_path / "tool.json").read_text())
    assert all(report[key] == pytest.approx(value, rel=1e-6) for key, value in made.report.items())
    assert made.report["closed"] and made.report["intersecting_triangles"] == 0


def test_arrays_are_a_closed_mesh(texture):
    made = brindle.relief(texture, "bricks", 0.08, tiles="whole")
    corners = made.vertices[made.faces].astype(float)
    volume = np.einsum("ij,ij->", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])) / 6
    assert volume == pytest.approx(made.report["volume"], rel=1e-4)
    edges = np.concatenate([made.faces[:, [0, 1]], made.faces[:, [1, 2]], made.faces[:, [2, 0]]])
    assert len(np.unique(edges, axis=0)) == len(edges)
    assert {tuple(edge) for edge in edges} == {tuple(edge[::-1]) for edge in edges}
    assert "closed" in repr(made)
    np.testing.assert_array_equal(pickle.loads(pickle.dumps(made)).vertices, made.vertices)


def test_arrays_choose_faces(texture):
    surface = texture.surface
    upper = (surface.vertices[:, 2] > surface.vertices[:, 2].mean()).astype(float)
    made = brindle.relief(texture, "knurl", 0.04, only=upper)
    assert 0 < made.report["area"] < 0.9 * brindle.relief(texture, "knurl", 0.04).report["area"]


def test_holes_are_filled():
    if not brindle.has_opengl:
        pytest.skip("tiles need a build with OpenGL")
    ball = brindle.shape("sphere", resolution=12)
    open_ball = brindle.Surface(ball.vertices, ball.faces[1:])
    texture = brindle.texture(open_ball, stripes=12)
    assert brindle.relief(texture, "dots", 0.02).report["filled_holes"] == 1
    assert not brindle.relief(texture, "dots", 0.02, fill_holes=0).report["closed"]


def test_rejections(texture, tmp_path):
    for named in ({"height": 0}, {"tolerance": -1}, {"inlay": -1}, {"inlay": 1, "cut": True}, {"only": (0, 0, 0)},
                  {"only": (0, 0, 1, 200)}, {"only": [1, 2]}, {"only": "missing"}, {"cut": True, "fill_holes": 1},
                  {"tile": "waffle"}):
        with pytest.raises(brindle.Error):
            brindle.relief(texture, **{"tile": "dots", "height": 0.01, **named})
    with pytest.raises(TypeError):
        brindle.relief(texture.surface, "dots", 0.01)
    with pytest.raises(brindle.Cancelled):
        brindle.relief(texture, "dots", 0.01, progress=lambda stage, done: False)
    with pytest.raises(brindle.Error):
        brindle.relief(texture, "dots", 0.01).write(tmp_path / "a.off")
    assert list(tmp_path.iterdir()) == []
