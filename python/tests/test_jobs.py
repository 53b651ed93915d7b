"""Long calls: threads, progress, Ctrl-C; frames."""

import functools
import os
import signal
import subprocess
import sys
import textwrap
import threading
import time

import numpy as np
import pytest

import brindle


def test_two_threads_at_once():
    surfaces = [brindle.shape("trefoil"), brindle.shape("vessels")]
    expected = [brindle.stripes(s, stripes=40).phases.copy() for s in surfaces]
    results = [None, None]

    def work(i):
        for _ in range(3):
            results[i] = brindle.stripes(surfaces[i], stripes=40).phases

    threads = [threading.Thread(target=work, args=(i,)) for i in range(2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for got, wanted in zip(results, expected):
        np.testing.assert_array_equal(got, wanted)


def test_one_surface_in_two_threads(torus):
    d = torus.smooth_field()
    expected = brindle.stripes(torus, d, stripes=20).phases
    results = []
    threads = [threading.Thread(target=lambda: results.append(brindle.stripes(torus, d, stripes=20)))
               for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for p in results:
        np.testing.assert_array_equal(p.phases, expected)


def test_other_threads_run_meanwhile():
    """A thread of Python counts on while another one solves."""
    surface = brindle.shape("torus")
    d = surface.smooth_field()
    stop, ticks, inside = threading.Event(), [0], []

    def count():
        while not stop.is_set():
            ticks[0] += 1
            time.sleep(0.001)

    counter = threading.Thread(target=count)
    counter.start()
    begin = ticks[0]
    brindle.stripes(surface, d, solver="averaged")
    inside.append(ticks[0] - begin)
    stop.set()
    counter.join()
    assert inside[0] > 0


def test_number_of_threads_makes_no_difference(torus):
    d = torus.smooth_field()
    one, all_ = brindle.stripes(torus, d, stripes=20, solver=brindle.Solver(threads=1)), brindle.stripes(torus, d, stripes=20)
    np.testing.assert_array_equal(one.phases, all_.phases)
    assert one.report["threads"] == 1


def test_progress_is_told(torus):
    heard = []
    brindle.stripes(torus, stripes=20, progress=lambda stage, share: heard.append((stage, share)))
    assert {"couple", "pattern"} <= {stage for stage, _ in heard}
    assert all(isinstance(stage, str) and 0 <= share <= 1 for stage, share in heard)


@pytest.mark.parametrize("solver", ["multilevel", "relaxation", "averaged"])
def test_progress_cancels(torus, solver):
    calls = []

    def progress(stage, share):
        calls.append(stage)
        return len(calls) < 2

    with pytest.raises(brindle.Cancelled):
        brindle.stripes(torus, stripes=20, solver=solver, progress=progress)
    assert len(calls) == 2


def test_what_progress_raises_is_raised(torus):
    def progress(stage, share):
        raise LookupError(stage)

    for call in (lambda: brindle.stripes(torus, stripes=20, progress=progress),
                 lambda: brindle.texture(torus, stripes=20, progress=progress),
                 lambda: brindle.crosses(torus, stripes=20, progress=progress),
                 lambda: brindle.samples(torus, stripes=20, progress=progress),
                 lambda: brindle.Animator(torus).frame(torus.smooth_field(), 4, progress=progress)):
        with pytest.raises(LookupError):
            call()


def test_reading_tells_and_cancels(tmp_path, torus):
    torus.write(tmp_path / "torus.obj")
    heard = []
    brindle.read(tmp_path / "torus.obj", progress=lambda *report: heard.append(report))
    assert heard
    with pytest.raises(brindle.Cancelled):
        brindle.read(tmp_path / "torus.obj", progress=lambda *report: False)


def test_ctrl_c_interrupts():
    """In a program of its own: the signal comes while it solves, and everything is usable after."""
    program = textwrap.dedent("""
        import os, signal, threading, brindle
        # Jobs in the background of a shell are started without it.
        signal.signal(signal.SIGINT, signal.default_int_handler)
        s = brindle.shape("torus", resolution=800)
        d = s.projected_field((0.31, 0.9, 0.27))
        a = brindle.Animator(s)
        first = a.frame(d, 5.0)
        started = threading.Event()
        def interrupt():
            started.wait()
            os.kill(os.getpid(), signal.SIGINT)
        threading.Thread(target=interrupt).start()
        try:
            brindle.stripes(s, d, solver=brindle.Solver("relaxation", epsilon=0), progress=lambda *_: started.set())
            print("not interrupted")
        except KeyboardInterrupt:
            print("interrupted")
        again = a.frame(d, 5.0)
        print((first == again).all(), brindle.stripes(s, d, frequency=5.0).report["energy"] < 1)
    """)
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True,
                          env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)})
    assert done.stdout.split() == ["interrupted", "True", "True"], done.stderr


def test_every_frame_tells_and_cancels(torus):
    """What is cancelled leaves the animator as it was: the next frame is the one that was due."""
    d = torus.smooth_field()
    animator, twin = brindle.Animator(torus), brindle.Animator(torus)
    for number in range(3):
        heard = []
        z = animator.frame(d, 4 + 0.1 * number, progress=lambda *report: heard.append(report))
        assert heard and all(0 <= share <= 1 for _, share in heard)
        with pytest.raises(brindle.Cancelled):
            animator.frame(d, 5 + 0.1 * number, progress=lambda *report: False)
        with pytest.raises(LookupError):
            animator.frame(d, 5 + 0.1 * number, progress=lambda *report: {}["nothing"])
        np.testing.assert_array_equal(z, twin.frame(d, 4 + 0.1 * number))


def test_every_frame_of_a_texture_tells_and_cancels(torus):
    """As frames of stripes do."""
    d = torus.smooth_field()
    animator, twin = brindle.TextureAnimator(torus), brindle.TextureAnimator(torus)
    for number in range(3):
        heard = []
        uv = animator.frame(d, 4 + 0.1 * number, progress=lambda *report: heard.append(report))
        assert len(heard) > 2 and all(0 <= share <= 1 for _, share in heard)
        with pytest.raises(brindle.Cancelled):
            animator.frame(d, 5 + 0.1 * number, progress=lambda *report: False)
        with pytest.raises(LookupError):
            animator.frame(d, 5 + 0.1 * number, progress=lambda *report: {}["nothing"])
        np.testing.assert_array_equal(uv, twin.frame(d, 4 + 0.1 * number))


def test_every_frame_of_a_field_tells_and_cancels(torus):
    animator, twin = brindle.FieldAnimator(torus), brindle.FieldAnimator(torus)
    for number in range(3):
        heard = []
        drawn = ([number], torus.normals[[number]][:, [1, 2, 0]], 5.0)
        field = animator.frame(*drawn, progress=lambda *report: heard.append(report)).copy()
        assert heard and all(0 <= share <= 1 for _, share in heard)
        with pytest.raises(brindle.Cancelled):
            animator.frame([number + 50], drawn[1], progress=lambda *report: False)
        np.testing.assert_array_equal(field, twin.frame(*drawn))


def test_frames_are_those_of_stripes(torus):
    d = torus.smooth_field()
    p = brindle.stripes(torus, d, frequency=4)
    animator = brindle.Animator(torus, stiffness=0.025)
    z = animator.frame(d, 4)
    np.testing.assert_array_equal(z, p.phases)
    assert animator.phase_step == 0 and animator.energy == pytest.approx(p.report["energy"])
    np.testing.assert_array_equal(animator.frame(d, p.frequency), z)
    assert animator.unchanged


def test_equal_input(torus):
    """Animators keep their phases; following a pattern solves again."""
    d = torus.projected_field((0.31, 0.9, 0.27))
    p = brindle.stripes(torus, d, frequency=4)
    q = brindle.stripes(torus, d, frequency=4, previous=p)
    assert 0 < np.abs(q.phases - p.phases).max() and q.report["phase_step"] > 0
    animator = brindle.Animator(torus)
    z = animator.frame(d, 4)
    np.testing.assert_array_equal(animator.frame(d, 4), z)
    assert animator.phase_step == 0 and "previous" in brindle.Animator.__doc__
    assert "Animator" in brindle.stripes.__doc__


def test_frames_follow(torus):
    d = torus.smooth_field()
    calm, loose = brindle.Animator(torus, stiffness=0.025), brindle.Animator(torus, stiffness=0)
    for number in range(3):
        moved = torus.vertices * np.float32(1 + 0.01 * number)
        turned = torus.rotate_field(d, 2 * number)
        z = calm.frame(turned, 4 + 0.1 * number, moved)
        loose.frame(turned, 4 + 0.1 * number, moved)
    assert z.dtype == np.complex64 and 0 < calm.phase_step < loose.phase_step
    np.testing.assert_allclose(np.abs(z), 1, atol=1e-5)
    calm.restart()
    np.testing.assert_array_equal(calm.frame(turned, 4.2, moved), loose.frame(turned, 4.2, moved))


@pytest.mark.parametrize("slack", [None, 0.3])
def test_frames_are_drawn_as_fresh_patterns_are(torus, slack):
    """Bit for bit, where vertices move and where they do not."""
    animator, drawn = brindle.Animator(torus, slack=slack), brindle.advanced.PatternFrames(torus)
    n, m = torus.vertex_count, len(torus.faces)
    np.testing.assert_array_equal(drawn.faces, np.c_[torus.faces, np.zeros(m, int)])
    buffer, corners = np.empty((n, 12), np.float32), np.empty((m, 3), np.float32)
    for number in (0, 1, 1, 2, 0):
        wave = 1 + 0.05 * np.sin(4 * torus.vertices[:, :1] + number)
        moved = (torus.vertices * wave).astype(np.float32)
        there = torus.with_vertices(moved)
        d = there.projected_field((0.31, 0.9, 0.27))
        z = animator.frame(d, 4, moved)
        f = np.full(n, 4, np.float32) if slack is None else animator.frequencies
        assert drawn.vertices(z, d, f, moved, out=buffer) is buffer
        np.testing.assert_array_equal(drawn.normals(moved), there.normals)
        fresh = np.c_[moved, f, d, z.real, there.normals, z.imag]
        np.testing.assert_array_equal(buffer, fresh)
        p = brindle.advanced.stripes_from_phases(there, z, d, frequency=f)
        assert drawn.corner_phases(z, d, f, moved, out=corners) is corners
        np.testing.assert_array_equal(corners, p.corner_phases)
    np.testing.assert_array_equal(drawn.vertices(z, d, 4), drawn.vertices(z, d, np.full(n, 4.0), torus.vertices))
    given = drawn.vertices(z, d, 4, normals=torus.normals[:, [1, 2, 0]])
    np.testing.assert_array_equal(given[:, 8:11], torus.normals[:, [1, 2, 0]])


def test_frames_that_do_not_fit_are_not_drawn(torus):
    d = torus.smooth_field()
    drawn, z = brindle.advanced.PatternFrames(torus), brindle.Animator(torus).frame(d, 4)
    n = torus.vertex_count
    for arguments, name in (((z[1:], d, 4), "phases"), ((z, d[1:], 4), "directions"),
                            ((z, d, 4, torus.vertices[1:]), "positions"),
                            ((z, d, np.full(n - 1, 4)), "frequencies")):
        with pytest.raises(brindle.Error, match=rf"{name}: expected .* {n} .* the shape \({n - 1},"):
            drawn.vertices(*arguments)
    for out, error in ((np.empty((n, 11), "f4"), brindle.Error), (np.empty(12 * n, "f4"), brindle.Error),
                       (np.empty((n, 12)), TypeError), (np.empty((n, 24), "f4")[:, ::2], TypeError)):
        with pytest.raises(error, match="out: expected"):
            drawn.vertices(z, d, 4, out=out)
    with pytest.raises(brindle.Error, match="no triangles"):
        brindle.advanced.PatternFrames(brindle.points(torus.vertices, torus.normals))
    with pytest.raises(brindle.Error, match="phase_shift"):
        drawn.corner_phases(z, d, 4, phase_shift="none")


def test_frames_own_their_phases(torus):
    d = torus.smooth_field()
    animator = brindle.Animator(torus)
    first = animator.frame(d, 4)
    kept = first.copy()
    out = np.empty_like(first)
    assert animator.frame(d, 4.4, out=out) is out
    np.testing.assert_array_equal(first, kept)
    assert (out != first).any()


def test_failed_frames_leave_all_as_it_was(torus):
    d = torus.smooth_field()
    a, b = brindle.Animator(torus), brindle.Animator(torus)
    for animator in (a, b):
        animator.frame(d, 4)
    with pytest.raises(brindle.Error):
        a.frame(d, 4.1, torus.vertices * np.nan)
    with pytest.raises(brindle.Error):
        a.frame(d, -1)
    np.testing.assert_array_equal(a.frame(d, 4.1), b.frame(d, 4.1))


def test_one_frame_at_a_time(torus):
    animator = brindle.Animator(torus)
    d = torus.smooth_field()

    refused = []

    def progress(stage, share):
        with pytest.raises(brindle.Error, match="at work already"):
            animator.frame(d, 4)
        refused.append(stage)

    animator.frame(d, 4, progress=progress)
    assert refused
    errors, frames = [], []

    def work():
        for number in range(20):
            try:
                frames.append(animator.frame(d, 4 + 0.01 * number))
            except brindle.Error as error:
                errors.append(str(error))

    threads = [threading.Thread(target=work) for _ in range(3)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert all("at work already" in error for error in errors)
    assert frames and len(frames) + len(errors) == 60
    for z in frames:
        np.testing.assert_allclose(np.abs(z), 1, atol=1e-5)


def test_siblings_and_last_phases(torus):
    d = torus.smooth_field()
    animator = brindle.Animator(torus)
    z = animator.frame(d, 4)
    sibling = animator.sibling()
    across = torus.rotate_field(d, 90)
    alone = brindle.Animator(torus)
    assert sibling.frame(across, 4).shape == alone.frame(across, 4).shape == z.shape
    assert sibling.energy == pytest.approx(alone.energy, rel=0.2)
    other = brindle.Animator(torus)
    other.set_phases(z.astype("c16"))
    other.frame(d, 4)
    assert other.phase_step < 0.1


def test_phases_of_frames_become_patterns(torus):
    d = torus.smooth_field()
    z = brindle.Animator(torus).frame(d, 4)
    p = brindle.advanced.stripes_from_phases(torus, z, d, frequency=4)
    q = brindle.stripes(torus, d, frequency=4)
    assert p.report["branches"] == q.report["branches"]
    np.testing.assert_array_equal(p.corner_phases, q.corner_phases)
    assert p.report["energy"] == pytest.approx(q.report["energy"], rel=1e-6)


def test_fields_follow_anchors(torus):
    animator = brindle.FieldAnimator(torus)
    np.testing.assert_allclose(np.linalg.norm(animator.frame(), axis=1), 1, atol=1e-5)
    vertex = 17
    wish = torus.rotate_field(animator.frame(), 60)[vertex]
    got = animator.frame([vertex], [wish], 50)
    assert abs(got[vertex] @ wish) > 0.9


def test_measured_fields_frame_by_frame(torus):
    truth = torus.smooth_field()
    across = np.cross(torus.normals, truth)
    frequency = torus.frequency_of(12)
    chance = np.random.default_rng(1)

    def noisy():
        angle = chance.normal(0, 0.5, torus.vertex_count)[:, None]
        vectors = (np.cos(angle) * truth + np.sin(angle) * across).astype(np.float32)
        vectors[::9] = np.nan
        return vectors

    def angle_between(a, b):
        return np.degrees(np.arccos(np.clip(np.abs((a * b).sum(1)), 0, 1))).mean()

    smoothing, remembers = brindle.advanced.FieldSmoothing(torus, 0.7), brindle.advanced.FieldSmoothing(torus, 0.7, temporal_smoothing=3)
    with pytest.raises(brindle.Error):
        smoothing.metrics
    steps = []
    for animator in (smoothing, remembers):
        fields = [animator.frame(noisy(), frequency)[0] for _ in range(5)]
        steps.append(angle_between(fields[-1], fields[-2]))
        assert angle_between(fields[-1], truth) < 12  # of 23 in the data
    assert steps[1] < 0.7 * steps[0]
    assert smoothing.metrics["vertices_filled"] == len(truth[::9])
    # One frame is what stripes see.
    data = noisy()
    p = brindle.stripes(torus, data, stripes=12, measured=brindle.Measured(0.7))
    field, coherence = brindle.advanced.FieldSmoothing(torus, 0.7).frame(data, frequency)
    np.testing.assert_array_equal(p.directions, field)
    np.testing.assert_array_equal(p.point_data["coherence"], coherence)
    # Filled holes are marked, and a check of the scale leaves the pattern.
    holes = np.arange(len(truth)) % 9 == 0
    np.testing.assert_array_equal(p.point_data["filled"], holes)
    checked = brindle.stripes(torus, data, stripes=12, measured=brindle.Measured(0.7, hold_out=0.1))
    np.testing.assert_array_equal(checked.directions, field)
    assert 0 < checked.report["held_out"] < 0.2 * len(truth)
    assert 10 < checked.report["held_out_turned_mean_deg"] < 35
    assert "held_out" not in p.report and 0 < p.report["coherence_filled_mean"] < 1
    with pytest.raises(brindle.Error, match="field_smoothing"):
        brindle.stripes(torus, data, stripes=12, measured=brindle.Measured(hold_out=0.1))
    # What counts nothing is no datum, whatever it is; so are triangles' vectors taken.
    wrong = np.where(np.arange(len(truth))[:, None] % 9 == 0, np.float32(7), data)
    weights = (np.arange(len(truth)) % 9 != 0).astype(float)
    again, _ = brindle.advanced.FieldSmoothing(torus, 0.7).frame(wrong, frequency, confidence=weights)
    np.testing.assert_allclose(again, field, atol=1e-5)
    of_triangles, _ = smoothing.frame(truth[np.array(torus.faces)[:, 0]], frequency)
    assert of_triangles.shape == truth.shape
    for wishes in ({"periods": 0}, {"fill": -1}, {"singularities": -1}, {"temporal_smoothing": -1}):
        with pytest.raises(brindle.Error):
            brindle.advanced.FieldSmoothing(torus, **wishes)
    with pytest.raises(brindle.Error, match=r"vectors: expected .* got the shape \(5, 3\)"):
        smoothing.frame(truth[:5], frequency)


def test_vectors_on_a_globe():
    globe = brindle.shape("sphere")
    places = np.array(globe.vertices)
    vectors = globe.globe_vectors(np.tile([3.0, 4.0], (globe.vertex_count, 1)))
    known = np.isfinite(vectors[:, 0])
    np.testing.assert_allclose(np.linalg.norm(vectors[known], axis=1), 5, rtol=1e-5)
    np.testing.assert_allclose((vectors * places)[known].sum(1), 0, atol=1e-4)
    assert (vectors[known, 2] > 0).all()  # the north is up
    with pytest.raises(brindle.Error, match="globe"):
        brindle.shape("torus").globe_vectors(np.zeros((brindle.shape("torus").vertex_count, 2)))


def run_program(program):
    return subprocess.run([sys.executable, "-c", textwrap.dedent(program)], capture_output=True, text=True,
                          env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)})


@pytest.mark.parametrize("call", [
    "brindle.stripes(s, d, stripes=40)",
    "brindle.stripes(s, d, stripes=40, progress=lambda *report: time.sleep(0.0005))",
    "s.smooth_field()",
    "a.frame(s.rotate_field(d, next(degrees)), 5.0)",
    "brindle.stripes(s, d, stripes=40, progress=lambda *report: started.set() or threading.Event().wait())",
])
def test_leaving_while_a_thread_is_at_work(call):
    """A thread that nobody waits for stands still; the process ends well."""
    program = f"""
        import itertools, threading, time, brindle
        s = brindle.shape("torus", resolution=100)
        d = s.smooth_field()
        a = brindle.Animator(s)
        degrees = itertools.count()
        started = threading.Event()
        def work():
            while True:
                {call}
                started.set()
        threading.Thread(target=work, daemon=True).start()
        started.wait()
        print("left")
    """
    for _ in range(4):
        done = run_program(program)
        assert (done.returncode, done.stdout, done.stderr) == (0, "left\n", "")


def test_functions_at_exit_may_work():
    done = run_program("""
        import atexit
        atexit.register(lambda: print(brindle.stripes(brindle.shape("torus", resolution=60), stripes=9)))
        import brindle
    """)
    assert done.returncode == 0 and "Stripes" in done.stdout, done.stderr


FORKED = """
    import os, sys, brindle
    s = brindle.shape("torus", resolution=60)
    d = s.smooth_field()
    {before}
    read, write = os.pipe()
    child = os.fork()
    if child == 0:
        try:
            said = str({after})
        except BaseException as error:
            said = type(error).__name__ + ": " + str(error)
        os.write(write, said.encode())
        os._exit(0)
    os.close(write)
    print(open(read).read())
    os.waitpid(child, 0)
"""


@pytest.mark.parametrize("work", [
    pytest.param("brindle.render(s, size=(20, 20)).shape", marks=pytest.mark.skipif(
        not brindle.has_opengl, reason="this build draws no pictures")),
    pytest.param("brindle.stripes(s, d, stripes=9, solver='global').report['vertices']",
                 marks=pytest.mark.skipif(not brindle.advanced.has_solver("global"), reason="no CHOLMOD")),
])
def test_forked_processes_are_told(work):
    """What would wait for ever for threads that a forked process does not have says so."""
    done = run_program(FORKED.format(before=work, after=work))
    assert done.stdout.startswith("RuntimeError: ") and "'spawn'" in done.stdout, done.stderr
    # Nothing was used before: it works. And all else does in any case.
    done = run_program(FORKED.format(before="", after=work))
    assert done.returncode == 0 and "Error" not in done.stdout, done.stdout
    stripes = "brindle.stripes(s, d, stripes=9).phases.sum()"
    done = run_program(FORKED.format(before=f"{work}; print({stripes})", after=stripes))
    here, there = done.stdout.split()
    assert here == there


def test_forks_amid_a_call_are_told():
    done = run_program(FORKED.format(
        before="""import threading
    started, go_on = threading.Event(), threading.Event()
    thread = threading.Thread(target=lambda: brindle.stripes(
        s, d, stripes=9, progress=lambda *report: started.set() or go_on.wait()))
    thread.start()
    started.wait()""", after="brindle.stripes(s, d, stripes=9), go_on.set()").replace(
            "    print(open", "    go_on.set()\n    print(open"))
    assert done.stdout.startswith("RuntimeError: ") and "'spawn'" in done.stdout, done.stderr


@pytest.mark.parametrize("no", [False, np.bool_(False), np.float32(2) < 1])
def test_progress_cancels_by_any_false(torus, no):
    with pytest.raises(brindle.Cancelled):
        brindle.stripes(torus, stripes=20, progress=lambda *report: no)


@pytest.mark.parametrize("yes", [True, np.bool_(True), None, 0, "", np.zeros(3)])
def test_progress_goes_on_by_all_else(torus, yes):
    assert brindle.stripes(torus, stripes=20, progress=lambda *report: yes).phases.size


def test_nearest_hears_ctrl_c():
    """From its own callback-free loop: the signal comes while it searches."""
    done = run_program("""
        import os, signal, threading, time, numpy as np, brindle
        signal.signal(signal.SIGINT, signal.default_int_handler)
        s = brindle.shape("torus", resolution=100)
        far = np.random.default_rng(1).normal(size=(3_000_000, 3))
        searching = threading.Event()
        def interrupt():
            searching.wait()
            time.sleep(0.3)
            os.kill(os.getpid(), signal.SIGINT)
        threading.Thread(target=interrupt).start()
        try:
            searching.set()
            s.nearest(far)
            print("not interrupted")
        except KeyboardInterrupt:
            print("interrupted")
        print(s.nearest(far[:5])[0].shape)
    """)
    assert done.stdout.split("\n")[:2] == ["interrupted", "(5,)"], done.stderr


def test_nearest_of_any_number_of_threads(torus):
    points = np.random.default_rng(2).normal(size=(20_000, 3))
    triangles, weights, distances = torus.nearest(points)
    for part in (slice(0, 1), slice(8190, 8195), slice(19_990, None)):
        some = torus.nearest(points[part])
        for got, expected in zip(some, (triangles, weights, distances)):
            np.testing.assert_array_equal(got, expected[part])
    found = (weights[:, :, None] * torus.vertices[torus.faces[triangles]]).sum(axis=1)
    np.testing.assert_allclose(np.linalg.norm(found - points, axis=1), distances, atol=1e-5)


def signals_heard(call):
    """How often a handler of signals runs while a signal comes every few milliseconds. Signals that
    nobody looks for until a call is over are one."""
    heard = []
    before = signal.signal(signal.SIGALRM, lambda *_: heard.append(1))
    signal.setitimer(signal.ITIMER_REAL, 0.002, 0.002)
    try:
        call()
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
    return len(heard)


def moving(s):
    fine = s.subdivide(2)
    return lambda: fine.with_vertices(fine.vertices)


def searching_points(s):
    points = np.random.default_rng(1).normal(size=(20_000, 3))
    return lambda: s.nearest(points)


def making_points(s):
    points = np.random.default_rng(1).normal(size=(200_000, 3))
    points /= np.linalg.norm(points, axis=1)[:, None]
    return lambda: brindle.points(points)


LONG_CALLS = {
    "nearest": searching_points,
    "interpolate_to": lambda s: functools.partial(s.interpolate_to, s.subdivide(1), np.ones(s.vertex_count)),
    "subdivided": lambda s: functools.partial(s.subdivide, 3),
    "moved": moving,
    "shape": lambda s: lambda: brindle.shape("torus", resolution=100, subdivide=4),
    "points": making_points,
    "smooth_field": lambda s: functools.partial(s.subdivide(1).smooth_field, curvature_anchor=0.1),
    "curves": lambda s: brindle.stripes(s.subdivide(2), stripes=300).curves,
    "resampled": lambda s: functools.partial(brindle.stripes(s, stripes=60).curves, resample=1e-4),
    "render": lambda s: functools.partial(brindle.render, s.subdivide(1), size=(9000, 2000)),
    "mesh": lambda s: brindle.texture(s.subdivide(1), stripes=40).mesh,
}


@pytest.mark.parametrize("make", LONG_CALLS.values(), ids=LONG_CALLS)
def test_long_calls_hear_signals(make):
    if make is LONG_CALLS["render"] and not brindle.has_opengl:
        pytest.skip("this build draws no pictures")
    call = make(brindle.shape("torus", resolution=300))
    assert signals_heard(call) >= 3


def test_results_that_no_memory_holds(torus):
    """Refused, by name, before memory is asked for."""
    p = brindle.stripes(torus, stripes=20)
    with pytest.raises(brindle.Error, match="points"):
        p.curves(resample=1e-9)
    assert p.curves(resample=1e-2).count > 0
