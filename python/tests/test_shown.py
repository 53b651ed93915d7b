"""Results in notebooks and editors: texts with metrics, pictures, types."""

import re
import typing

import numpy as np
import pytest

import brindle
from brindle import _arguments, _core


@pytest.fixture(scope="module")
def results(torus):
    p = brindle.stripes(torus, stripes=10)
    return {"surface": torus, "stripes": p, "texture": brindle.texture(torus, stripes=10),
            "crosses": brindle.crosses(torus, stripes=10), "curves": p.curves(),
            "samples": brindle.samples(torus, stripes=10)}


def test_texts_have_metrics(torus, results):
    n, m = torus.vertex_count, torus.face_count
    assert repr(torus) == f"<brindle.Surface {torus.name}: {n} vertices, {m} triangles, diagonal {torus.diagonal:.4g}>"
    p, curves, samples = results["stripes"], results["curves"], results["samples"]
    assert f"{p.report['branches']} branches, spacing {torus.diagonal / 10:.4g}, on {torus!r}" in repr(p)
    for name in ("texture", "crosses"):
        assert f"{results[name].report['branches']} branches, on" in repr(results[name])
    assert f"{curves.count} curves of {len(curves.points)} points, length {curves.lengths.sum():.4g}" in repr(curves)
    assert f"{samples.count} samples, spacing" in repr(samples)
    assert f"{len(p.mesh().uv)} vertices" in repr(p.mesh())
    for make in (brindle.Animator, brindle.TextureAnimator, brindle.FieldAnimator, brindle.advanced.FieldSmoothing,
                 brindle.advanced.PatternFrames):
        assert repr(make(torus)) == f"<brindle.{make.__name__} on {torus!r}>"
    points = brindle.points(torus.vertices, torus.normals)
    assert repr(brindle.stripes(points, stripes=10)).startswith("<brindle.Stripes: spacing 0.2")


@pytest.mark.skipif(not brindle.has_opengl, reason="this build draws no pictures")
def test_notebooks_draw(results, tmp_path):
    for name, thing in results.items():
        (tmp_path / "a.png").write_bytes(thing._repr_png_())
        image = brindle.read_png(tmp_path / "a.png")
        surface = thing.stripes.surface if name == "curves" else getattr(thing, "surface", thing)
        expected = brindle.render(surface, None if name == "surface" else thing, size=image.shape[1::-1])
        np.testing.assert_array_equal(image, expected)
        assert image.size < 10**6, "small"


def test_notebooks_show_the_text_without_pictures(results, monkeypatch):
    def refuse(*_, **__):
        raise brindle.Error("no display")

    monkeypatch.setattr(_core, "render", refuse)
    assert results["stripes"]._repr_png_() is None
    monkeypatch.setattr(_core, "has_opengl", False)
    assert results["surface"]._repr_png_() is None


def test_types_name_the_choices(torus):
    """The words of each type are those that its argument takes."""
    p = brindle.stripes(torus, stripes=10)

    def named_by(call):
        with pytest.raises(brindle.Error) as error:
            call()
        words = re.sub(r".*expected one of|.*? is (none of|neither)|, got .*", "", str(error.value))
        return set(re.findall(r"-?[a-z][\w-]*", words)) - {"nor"}

    tensors = np.ones((torus.vertex_count, 6))
    for kind, call in (
            ("SolverName", lambda: brindle.stripes(torus, solver="x")),
            ("FrameSolver", lambda: brindle.Animator(torus, solver="global")),
            ("PhaseShift", lambda: brindle.stripes(torus, solver=brindle.Solver(phase_shift="x"))),
            ("Run", lambda: brindle.stripes(torus, run="x")),
            ("Match", lambda: brindle.stripes(torus, previous=brindle.Previous(p, match="x"))),
            ("Curvature", lambda: torus.curvature_field("x")),
            ("TensorAxis", lambda: torus.tensor_field(tensors, "x")),
            ("TensorOrder", lambda: torus.tensor_field(tensors, order="x")),
            ("View", lambda: brindle.render(torus, p, view="x")),
            ("Projection", lambda: brindle.render(torus, p, projection="x")),
            ("Up", lambda: brindle.render(torus, p, up="w")),
            ("Tiles", lambda: brindle.render(torus, brindle.texture(torus, stripes=5), look=brindle.Look(tiles="x")))):
        assert set(typing.get_args(getattr(_arguments, kind))) == named_by(call), kind


def test_types_of_arguments_are_the_choices():
    """No argument that has choices is any text."""
    choices = {"solver", "phase_shift", "weights", "match", "curvature", "axis", "view", "projection", "up", "tiles"}
    functions = [getattr(brindle, name) for name in brindle.__all__]
    for owner in [thing for thing in functions if isinstance(thing, type)]:
        functions += [value for value in vars(owner).values() if hasattr(value, "__annotations__")]
    said = [(function, name) for function in functions for name, kind in
            getattr(function, "__annotations__", {}).items() if name in choices and re.search(r"\bstr\b", str(kind))]
    assert not said


def test_parts_of_textures_and_crosses(results):
    """Each has its own; others say where to look."""
    texture, crosses = results["texture"], results["crosses"]
    for part in (texture.u, texture.v, crosses.double_cover):
        assert isinstance(part, brindle.Stripes)
    for name in ("u", "v"):
        assert getattr(brindle.Texture, name).func.__annotations__["return"] == "Stripes"
        with pytest.raises(AttributeError, match="cover"):
            getattr(crosses, name)
    with pytest.raises(AttributeError, match="u and v"):
        texture.double_cover
