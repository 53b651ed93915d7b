"""Tool paths: the same as those of the tool; arrays; rejections."""
import json

import numpy as np
import pytest

import brindle
from conftest import run_tool


def curves_of(shape="torus,resolution=48", stripes=30):
    surface = brindle.shape(shape)
    return brindle.stripes(surface, surface.smooth_field(), stripes=stripes).curves()


def test_paths_are_those_of_the_tool(tmp_path):
    made = brindle.paths(curves_of())
    made.write(tmp_path / "python.gcode", scale=40, place=(10, 20, 0.2))
    run_tool("paths", "shape:torus,resolution=48", "--stripes", "30", "--scale", "40:1", "--place",
             "10,20,0.2", "--output", str(tmp_path / "tool.gcode"), "--report",
             str(tmp_path / "tool.json"), "--quiet")
    assert (tmp_path / "python.gcode").read_text() == (tmp_path / "tool.gcode").read_text()
    report = json.loads((tmp_path / "tool.json").read_text())["paths"]
    for key, value in made.report.items():
        assert report[key] == pytest.approx(value, rel=1e-6), key


def test_arrays_agree():
    made = brindle.paths(curves_of(), connect=0, cut_length=0.2)
    count = len(made.points)
    assert made.offsets[-1] == count == len(made.widths) == len(made.cuts)
    np.testing.assert_allclose(np.linalg.norm(made.directions, axis=1), 1, atol=1e-4)
    np.testing.assert_allclose(np.linalg.norm(made.poses, axis=1), 1, atol=1e-4)
    assert not made.joins.any() and made.cuts.any()
    assert made.report["travel"] <= made.report["travel_nearest"]
    assert "Paths" in repr(made)


def test_a_spiral_is_one_path():
    surface = brindle.shape("tube,bend=0,resolution=48")
    stripes = brindle.stripes(surface, surface.curvature_field("min"), stripes=30, layout=brindle.Layout(winding=1))
    made = brindle.paths(stripes.curves(), order="spiral")
    assert made.report["paths"] == 1 and made.report["travel"] == 0


def test_rejections(tmp_path):
    curves = curves_of()
    for arguments in ({"order": "zigzag"}, {"width": 0}, {"connect": -1}, {"order": "spiral"},
                      {"connect": 1, "least_radius": 1}):
        with pytest.raises(brindle.Error):
            brindle.paths(curves, **arguments)
    made = brindle.paths(curves)
    for arguments in ({"gcode": "fanuc"}, {"axes": 4}, {"speed": 0}):
        with pytest.raises(brindle.Error):
            made.write(tmp_path / "a.gcode", **arguments)
    with pytest.raises(TypeError):
        made.write(tmp_path / "a.gcode", colour=1)
    with pytest.raises(brindle.Error):
        made.write(tmp_path / "a.stl")
    assert list(tmp_path.iterdir()) == []
