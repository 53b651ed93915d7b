"""Results are pickled and copied with every bit; what runs says what to pickle instead."""

import copy
import os
import pickle
import subprocess
import sys

import numpy as np
import pytest

import brindle
from brindle import _core


def sleeve():
    """A cylinder without caps, along z."""
    around, along = 48, 30
    angles = 2 * np.pi * np.arange(around) / around
    ring = np.c_[np.cos(angles), np.sin(angles)]
    vertices = np.concatenate([np.c_[ring, np.full(around, 2 * z / along)] for z in range(along + 1)])
    i = np.arange(around * along)
    after = i - i % around + (i + 1) % around
    return brindle.Surface(vertices, np.r_[np.c_[i, after, after + around], np.c_[i, after + around, i + around]])


@pytest.fixture(scope="module")
def things():
    plain = brindle.shape("molecule", resolution=14)
    far = plain.vertices.astype(float) + [5e6, 0, 0]
    s = brindle.Surface(far, plain.faces, crease_angle=40, repair=True,
                        point_data={"height": far[:, 1]}, cell_data={"number": np.arange(plain.face_count)})
    data = np.random.default_rng(0).normal(size=(s.vertex_count, 3)) + [0, 3, 0]
    data[:5] = np.nan
    torus, tube = brindle.shape("torus", resolution=20), sleeve()
    points = brindle.points(torus.vertices, torus.normals)
    first = brindle.stripes(torus, stripes=10)
    texture = brindle.texture(s, data, stripes=12, slack=0.2, measured=brindle.Measured(1))
    crosses = brindle.crosses(s, data, stripes=12, layout=brindle.Layout(cancel_branches=0.1))
    p = brindle.stripes(s, data, stripes=15, measured=brindle.Measured(1), slack=brindle.Slack(0.3, np.full(s.vertex_count, 0.5)))
    return {"surface": s, "points": points, "stripes": p, "of points": brindle.stripes(points, stripes=10),
            "followed": brindle.stripes(torus, stripes=10, previous=first, layout=brindle.Layout(cancel_branches=0.1)),
            "wound": brindle.stripes(tube, tube.projected_field((0, 0, 1)), stripes=9, layout=brindle.Layout(winding=1)),
            "texture": texture, "crosses": crosses, "mesh": texture.mesh(), "mesh of stripes": p.mesh(),
            "curves": p.curves(min_length=0.1, resample=0.05), "faired": p.curves(trim=0.6, fair=0.25),
            "samples": brindle.samples(torus, stripes=10)}


def values_of(thing):
    """All public properties that there are, and what they hold."""
    if isinstance(thing, np.ndarray):
        return (thing.dtype.str, thing.shape, thing.tobytes(), thing.flags.writeable)
    if isinstance(thing, dict):
        return {name: values_of(value) for name, value in thing.items()}
    if isinstance(thing, (list, tuple)):
        return [values_of(value) for value in thing]
    if type(thing).__module__.startswith("brindle"):
        names = [name for name in dir(type(thing)) if not name.startswith("_")
                 and not callable(getattr(type(thing), name))]
        return {name: values_of(getattr(thing, name, None)) for name in names}
    return thing


@pytest.fixture(scope="module")
def expected(things):
    return {name: values_of(thing) for name, thing in things.items()}


@pytest.mark.parametrize("again", [copy.copy, copy.deepcopy, lambda thing: pickle.loads(pickle.dumps(thing))],
                         ids=["copy", "deepcopy", "pickle"])
def test_every_value_comes_back(things, expected, again):
    for name, thing in things.items():
        got = again(thing)
        assert type(got) is type(thing) and got is not thing
        assert values_of(got) == expected[name], name


def test_results_work_on(things, tmp_path):
    p, curves, samples = (pickle.loads(pickle.dumps(things[name])) for name in ("stripes", "curves", "samples"))
    was = things["stripes"]
    np.testing.assert_array_equal(p.curves().points, was.curves().points)
    assert p.windings() == was.windings()
    assert curves.measures(0.01) == things["curves"].measures(0.01)
    args = dict(frequency=p.frequency_wanted, previous=p)  # and can be followed
    np.testing.assert_array_equal(brindle.stripes(p.surface, p.directions, **args).phases,
                                  brindle.stripes(was.surface, was.directions, **args).phases)
    again = brindle.advanced.samples_of(samples.u, samples.v)  # both still of one surface
    np.testing.assert_array_equal(again.points, samples.points)
    p.write(tmp_path / "a.vtp")
    was.write(tmp_path / "b.vtp")
    assert (tmp_path / "a.vtp").read_bytes() == (tmp_path / "b.vtp").read_bytes()


def test_results_share_their_surface(things):
    p, q, curves = pickle.loads(pickle.dumps([things["stripes"], things["stripes"].surface, things["curves"]]))
    assert p.surface is q and p._core.surface is q._core and curves.stripes is p


def test_another_process_goes_on(things, tmp_path):
    path = tmp_path / "pattern.pickle"
    path.write_bytes(pickle.dumps(things["stripes"]))
    program = ("import pickle, sys; p = pickle.load(open(sys.argv[1], 'rb')); "
               "pickle.dump(p.curves(), open(sys.argv[1], 'wb'))")
    subprocess.run([sys.executable, "-c", program, path], check=True,
                   env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)})
    curves = pickle.loads(path.read_bytes())
    np.testing.assert_array_equal(curves.points, things["stripes"].curves().points)


def test_cached_arrays_are_not_pickled(torus):
    p = brindle.stripes(torus, stripes=10)
    before = len(pickle.dumps(p))
    p.corner_phases, p.point_data, p.report
    assert len(pickle.dumps(p)) == before


def test_damaged_pickles(things):
    version, data, objects = things["stripes"]._core.__getstate__()
    for state, message in ((("0.1", data, objects), "pickled by brindle 0.1"), ((version, data[:-8], objects), "not whole"),
                           ((version, data + b"12345678", objects), "not whole"), ((version, data, []), "not whole"),
                           ((version, data[:40], objects), "not whole")):
        with pytest.raises(brindle.Error, match=message):
            _core.Stripes.__new__(_core.Stripes).__setstate__(state)


@pytest.mark.parametrize("make, instead", [
    (brindle.FieldAnimator, "its surface"), (brindle.advanced.FieldSmoothing, "previous="), (brindle.advanced.PatternFrames, "its surface")])
@pytest.mark.parametrize("again", [copy.copy, copy.deepcopy, pickle.dumps])
def test_what_runs_names_what_to_pickle(torus, make, instead, again):
    with pytest.raises(TypeError, match=f"brindle.{make.__name__} cannot be .*{instead}"):
        again(make(torus))


@pytest.mark.parametrize("again", [copy.copy, copy.deepcopy, lambda thing: pickle.loads(pickle.dumps(thing))],
                         ids=["copy", "deepcopy", "pickle"])
@pytest.mark.parametrize("options", [{}, {"slack": 0.2}, {"stiffness": 0}], ids=str)
@pytest.mark.parametrize("make", [brindle.Animator, brindle.TextureAnimator])
def test_animators_go_on(torus, again, options, make):
    one = make(torus, **options)
    fields = [torus.projected_field((0.3, 0.9, z)) for z in (0, 0.2, 0.4)]
    one.frame(fields[0], 5)
    one.frame(-fields[1], 5, 1.1 * torus.vertices)
    other = again(one)
    assert type(other) is make and other.surface.vertex_count == torus.vertex_count
    for name in {"phase_step", "unchanged", "energy", "metrics"}.intersection(dir(one)):
        assert values_of(getattr(other, name)) == values_of(getattr(one, name)), name
    for field in (fields[1], fields[2], fields[2]):
        np.testing.assert_array_equal(other.frame(field, 5), one.frame(field, 5))
        assert repr(getattr(other, "metrics", None)) == repr(getattr(one, "metrics", None))
