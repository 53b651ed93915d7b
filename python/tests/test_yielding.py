"""Frequencies that yield, strokes, boundaries, windings, measures, textures from frame to frame."""

import numpy as np
import pytest

import brindle
from conftest import run_tool


def crossed(surface):
    """A field whose lines converge: stripes must branch."""
    return surface.projected_field((0.31, 0.9, 0.27))


@pytest.fixture(scope="module")
def trefoil():
    return brindle.shape("trefoil")


def test_slack_leaves_fewer_branches_within_bounds(trefoil):
    d = crossed(trefoil)
    rigid = brindle.stripes(trefoil, d, stripes=40)
    p = brindle.stripes(trefoil, d, stripes=40, slack=0.25)
    assert p.report["branches"] < 0.7 * rigid.report["branches"]
    ratio = p.frequency / p.frequency_wanted
    assert ratio.min() >= 1 / 1.2501 and ratio.max() <= 1.2501 and ratio.std() > 0
    np.testing.assert_array_equal(p.frequency_wanted, rigid.frequency)
    assert p.frequency_change["ratio_max"] == pytest.approx(ratio.max(), abs=1e-3)
    assert rigid.frequency_change is None
    np.testing.assert_array_equal(brindle.stripes(trefoil, d, stripes=40, slack=0).phases, rigid.phases)


def test_slack_and_avoid_branches_per_vertex(trefoil):
    d, n = crossed(trefoil), trefoil.vertex_count
    same = brindle.stripes(trefoil, d, slack=np.full(n, 0.25))
    np.testing.assert_array_equal(same.phases, brindle.stripes(trefoil, d, slack=0.25).phases)
    avoid_branches = (trefoil.vertices[:, 2] > 0).astype("f8")
    avoided = brindle.stripes(trefoil, d, slack=brindle.Slack(0.25, avoid_branches))
    assert "branches_in_avoided_area" in avoided.frequency_change
    for slack, avoid_branches in ((-1, None), (np.nan, None), (np.ones(3), None), (None, avoid_branches), (0.1, avoid_branches[:5]),
                        (0.1, 2 * np.ones(n))):
        with pytest.raises(brindle.Error):
            brindle.stripes(trefoil, d, slack=brindle.Slack(slack, avoid_branches))
    for slack in ("much", True, 1j):
        with pytest.raises(TypeError):
            brindle.stripes(trefoil, d, slack=slack)


def test_slack_of_textures_samples_and_frames(trefoil):
    d = crossed(trefoil)
    for make in (brindle.texture, brindle.crosses):
        rigid, relaxed = make(trefoil, d, stripes=20), make(trefoil, d, stripes=20, slack=0.25)
        assert relaxed.report["branches"] < rigid.report["branches"]
        assert relaxed.report["frequency_change"]["ratio_max"] > 1.01
        assert np.isfinite(relaxed.corner_uv).any()
    samples = brindle.samples(trefoil, d, stripes=20, slack=0.25)
    assert samples.u.frequency_change["ratio_max"] > 1.01 and samples.count > 0
    animator = brindle.Animator(trefoil, slack=0.25)
    f = trefoil.frequency_of(40)
    z = animator.frame(d, f)
    np.testing.assert_array_equal(z, brindle.stripes(trefoil, d, stripes=40, slack=0.25).phases)
    assert animator.frequencies.min() >= f / 1.2501
    assert len(brindle.Animator(trefoil).frequencies) == 0
    rigid, relaxed = brindle.TextureAnimator(trefoil), brindle.TextureAnimator(trefoil, slack=0.25)
    rigid.frame(d, f)
    relaxed.frame(d, f)
    assert relaxed.metrics["branches_u"] < rigid.metrics["branches_u"]
    texture = brindle.texture(trefoil, d, stripes=40, slack=0.25)
    assert relaxed.metrics["branches_u"] == texture.u.report["branches"]
    np.testing.assert_array_equal(relaxed.frame(d, f).shape, texture.corner_uv.shape)


def test_strokes(torus, tmp_path):
    ring = np.array([[np.cos(a), np.sin(a), 0.0] for a in np.linspace(0, 2 * np.pi, 60)])
    outer = ring * np.abs(np.linalg.norm(torus.vertices[:, :2], axis=1)).max()
    stroke = brindle.Stroke(outer, radius=0.2, strength=50)
    d = torus.smooth_field(strokes=[stroke])
    near = np.linalg.norm(torus.vertices[:, None] - outer[None], axis=2).min(axis=1) < 0.05
    along = np.cross([0, 0, 1], torus.vertices[near])
    along /= np.linalg.norm(along, axis=1)[:, None]
    assert np.abs((d[near] * along).sum(axis=1)).min() > 0.9
    brindle.advanced.write_strokes(tmp_path / "strokes.json", [stroke])
    (again,) = brindle.advanced.read_strokes(tmp_path / "strokes.json")
    np.testing.assert_array_equal(again.points, outer)
    np.testing.assert_array_equal(torus.smooth_field(strokes=again), d)
    run_tool("stripe", "shape:torus,resolution=100", "--strokes", tmp_path / "strokes.json",
             "--output", tmp_path / "tool.ply", "--quiet")
    brindle.stripes(torus, d).write(tmp_path / "python.ply")
    assert (tmp_path / "tool.ply").read_bytes() == (tmp_path / "python.ply").read_bytes()
    vertices, directions, weights = torus.stroke_anchors([stroke])
    assert len(vertices) == len(directions) == len(weights) > 0
    brindle.FieldAnimator(torus).frame(vertices, directions, weights)
    for bad in (brindle.Stroke(outer, -1), brindle.Stroke(outer[:1], 1), brindle.Stroke(outer * 50, 0.1),
                brindle.Stroke(outer * np.nan, 1), brindle.Stroke(outer[:, :2], 1)):
        with pytest.raises(brindle.Error):
            torus.smooth_field(strokes=[bad])
    for bad in ([outer], [brindle.Stroke(outer, "wide")], 5):
        with pytest.raises(TypeError):
            torus.smooth_field(strokes=bad)


@pytest.fixture(scope="module")
def sleeve():
    """An open cylinder."""
    angles, heights = np.meshgrid(np.linspace(0, 2 * np.pi, 60, endpoint=False), np.linspace(0, 2, 41))
    vertices = np.stack([np.cos(angles), np.sin(angles), heights], axis=-1).reshape(-1, 3)
    i = np.arange(40 * 60)
    right = i - i % 60 + (i + 1) % 60
    triangles = np.concatenate([np.stack([i, right, right + 60], axis=1),
                                np.stack([i, right + 60, i + 60], axis=1)])
    return brindle.Surface(vertices, triangles)


def test_windings(sleeve):
    loops = sleeve.loops()
    assert [loop.name for loop in loops] == ["boundary-1", "boundary-2"]
    assert all(loop.boundary and loop.length == pytest.approx(2 * np.pi, rel=0.01) for loop in loops)
    up = sleeve.projected_field((0, 0, 1))
    rings = brindle.stripes(sleeve, up, frequency=5, layout=brindle.Layout(winding=0))
    spiral = brindle.stripes(sleeve, up, frequency=5, layout=brindle.Layout(winding=1))
    left = brindle.stripes(sleeve, up, frequency=5, layout=brindle.Layout(winding={"boundary-1": -2}))
    assert set(rings.windings().values()) == {0} and set(spiral.windings().values()) == {1}
    assert set(left.windings().values()) == {-2}
    assert rings.curves().closed.all() and spiral.curves().count == 1
    assert 0 < spiral.field_rotation["mean_deg"] < 5 and brindle.stripes(sleeve, up, frequency=5).field_rotation is None
    with pytest.raises(brindle.Error):
        brindle.stripes(sleeve, up, frequency=5, layout=brindle.Layout(winding={"loop-9": 1}))
    with pytest.raises(TypeError):
        brindle.stripes(sleeve, up, frequency=5, layout=brindle.Layout(winding=1.5))


def test_boundaries(sleeve):
    up = sleeve.projected_field((0, 0, 1))
    p = brindle.stripes(sleeve, up, frequency=5, layout=brindle.Layout(anchor_boundary=0.5))
    rim = sleeve.vertices[:, 2] == 0
    np.testing.assert_allclose(np.sin(np.angle(p.phases[rim])), -1, atol=1e-3)
    with pytest.raises(brindle.Error, match="nowhere"):
        brindle.stripes(sleeve, sleeve.rotate_field(up, 90), frequency=5, layout=brindle.Layout(anchor_boundary=0))


def test_wales(sleeve):
    round_ = sleeve.rotate_field(sleeve.projected_field((0, 0, 1)), 90)
    directions, frequency = sleeve.waves_around(round_, 30)
    p = brindle.stripes(sleeve, directions, frequency=frequency)
    assert p.report["branches"] == 0 and p.curves().count == 30
    with pytest.raises(brindle.Error):
        sleeve.waves_around(round_, 0)


def test_measures(sleeve):
    up = sleeve.projected_field((0, 0, 1))
    curves = brindle.stripes(sleeve, up, frequency=5, layout=brindle.Layout(winding=0)).curves()
    measures = curves.measures(path_width=0.1)
    assert measures["lengths"]["longest"] == pytest.approx(2 * np.pi, rel=0.01)
    assert measures["gaps"]["mean"] == pytest.approx(0.2, rel=0.05)
    assert measures["coverage"] == pytest.approx(0.5, abs=0.06)
    assert "coverage" not in curves.measures()
    with pytest.raises(brindle.Error):
        curves.measures(path_width=-1)


def test_measures_are_the_tools(tool):
    expected = tool("curves", "shape:trefoil", "--stripes", "30", "--path-width", "0.05")["u"]
    measures = brindle.stripes(brindle.shape("trefoil"), stripes=30).curves().measures(0.05)
    for key, value in measures.items():
        assert value == expected[key], key


def test_textures_from_frame_to_frame(torus):
    animator = brindle.TextureAnimator(torus)
    d = torus.smooth_field()
    first = animator.frame(d, 4)
    assert first.shape == (torus.face_count, 3, 2) and animator.metrics["orientation"] == "afresh"
    t = brindle.texture(torus, d, frequency=4)
    np.testing.assert_array_equal(first[..., 0], t.corner_uv[..., 0])  # V shares U's aggregates
    kept = first.copy()
    animator.frame(torus.rotate_field(d, 1), 4.05)
    assert animator.metrics["orientation"] in ("kept", "continued")
    np.testing.assert_array_equal(first, kept)
    with pytest.raises(brindle.Error):
        animator.frame(d[:5], 4)
    with pytest.raises(brindle.Error):
        brindle.TextureAnimator(brindle.points(torus.vertices, torus.normals))
    animator.restart()
    np.testing.assert_array_equal(animator.frame(d, 4), first)


def test_merged_branches():
    trefoil = brindle.shape("trefoil", resolution=30)
    d = trefoil.projected_field((0.31, 0.9, 0.27))
    before = brindle.stripes(trefoil, d, stripes=40)
    assert before.cancelled_branches is None
    after = brindle.stripes(trefoil, d, stripes=40, layout=brindle.Layout(cancel_branches=0))
    said = after.cancelled_branches
    assert said["pairs"] > 0 and said["energy_after"] <= said["energy_before"]
    assert said["branches_before"] == np.count_nonzero(before.branches)
    assert said["branches_after"] == np.count_nonzero(after.branches)
    assert said["branches_after"] <= said["branches_before"] - 2 * said["pairs"]
    for share in (-1, float("nan")):
        with pytest.raises(brindle.Error):
            brindle.stripes(trefoil, d, layout=brindle.Layout(cancel_branches=share))
    with pytest.raises(TypeError):
        brindle.stripes(trefoil, d, layout=brindle.Layout(cancel_branches="many"))


def test_merged_branches_of_textures_and_crosses():
    molecule = brindle.shape("molecule", resolution=20)
    d = molecule.projected_field((0.31, 0.9, 0.27))
    texture = brindle.texture(molecule, d, stripes=25, layout=brindle.Layout(cancel_branches=0))
    said = texture.cancelled_branches
    assert said["pairs"] > 0 and said["energy_after"] <= said["energy_before"]
    assert said["branches_after"] == sum(np.count_nonzero(p.branches) for p in (texture.u, texture.v))
    before, after = (brindle.crosses(molecule, stripes=25, **merging) for merging in ({}, {"layout": brindle.Layout(cancel_branches=0)}))
    assert before.cancelled_branches is None
    assert after.cancelled_branches["pairs"] > 0
    assert after.report["branches"] <= before.report["branches"] - 2 * after.cancelled_branches["pairs"]
    assert after.report["field_singularities"] == before.report["field_singularities"]
