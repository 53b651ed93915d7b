"""Long calls: threads, progress, Ctrl-C; frames."""

import os
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
    one, all_ = brindle.stripes(torus, d, stripes=20, threads=1), brindle.stripes(torus, d, stripes=20)
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
            brindle.stripes(s, d, solver="relaxation", epsilon=0, progress=lambda *_: started.set())
            print("not interrupted")
        except KeyboardInterrupt:
            print("interrupted")
        again = a.frame(d, 5.0)
        print((first == again).all(), brindle.stripes(s, d, frequency=5.0).report["energy"] < 1)
    """)
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True,
                          env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)})
    assert done.stdout.split() == ["interrupted", "True", "True"], done.stderr


def test_frames_are_those_of_stripes(torus):
    d = torus.smooth_field()
    p = brindle.stripes(torus, d, frequency=4)
    animator = brindle.Animator(torus, lambda_=0.025)
    z = animator.frame(d, 4)
    np.testing.assert_array_equal(z, p.phases)
    assert animator.phase_step == 0 and animator.energy == pytest.approx(p.report["energy"])
    np.testing.assert_array_equal(animator.frame(d, p.frequency), z)
    assert animator.unchanged


def test_frames_follow(torus):
    d = torus.smooth_field()
    calm, loose = brindle.Animator(torus, lambda_=0.025), brindle.Animator(torus, lambda_=0)
    for number in range(3):
        moved = torus.vertices * np.float32(1 + 0.01 * number)
        turned = torus.turned_field(d, 2 * number)
        z = calm.frame(turned, 4 + 0.1 * number, moved)
        loose.frame(turned, 4 + 0.1 * number, moved)
    assert z.dtype == np.complex64 and 0 < calm.phase_step < loose.phase_step
    np.testing.assert_allclose(np.abs(z), 1, atol=1e-5)
    calm.restart()
    np.testing.assert_array_equal(calm.frame(turned, 4.2, moved), loose.frame(turned, 4.2, moved))


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
        a.frame(d * np.float32(3), 4.1)
    with pytest.raises(brindle.Error):
        a.frame(d, -1)
    np.testing.assert_array_equal(a.frame(d, 4.1), b.frame(d, 4.1))


def test_one_frame_at_a_time(torus):
    animator = brindle.Animator(torus)
    d = torus.smooth_field()

    def progress(stage, share):
        with pytest.raises(brindle.Error, match="at work already"):
            animator.frame(d, 4)

    animator.frame(d, 4, progress=progress)
    errors = []

    def work():
        for number in range(20):
            try:
                animator.frame(d, 4 + 0.01 * number)
            except brindle.Error as error:
                errors.append(str(error))

    threads = [threading.Thread(target=work) for _ in range(3)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert all("at work already" in error for error in errors)


def test_siblings_and_last_phases(torus):
    d = torus.smooth_field()
    animator = brindle.Animator(torus)
    z = animator.frame(d, 4)
    sibling = animator.sibling()
    across = torus.turned_field(d, 90)
    alone = brindle.Animator(torus)
    assert sibling.frame(across, 4).shape == alone.frame(across, 4).shape == z.shape
    assert sibling.energy == pytest.approx(alone.energy, rel=0.2)
    other = brindle.Animator(torus)
    other.set_last_phases(z.astype("c16"))
    other.frame(d, 4)
    assert other.phase_step < 0.1


def test_phases_of_frames_become_patterns(torus):
    d = torus.smooth_field()
    z = brindle.Animator(torus).frame(d, 4)
    p = brindle.stripes_from_phases(torus, z, d, frequency=4)
    q = brindle.stripes(torus, d, frequency=4)
    assert p.report["branches"] == q.report["branches"]
    np.testing.assert_array_equal(p.corner_phases, q.corner_phases)
    assert p.report["energy"] == pytest.approx(q.report["energy"], rel=1e-6)


def test_fields_follow_anchors(torus):
    animator = brindle.FieldAnimator(torus)
    np.testing.assert_allclose(np.linalg.norm(animator.frame(), axis=1), 1, atol=1e-5)
    vertex = 17
    wish = torus.turned_field(animator.frame(), 60)[vertex]
    got = animator.frame([vertex], [wish], 50)
    assert abs(got[vertex] @ wish) > 0.9
