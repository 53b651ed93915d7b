#!/usr/bin/python3
"""Works with the window of brindle view as a user does, and looks at what happens.

    scripts/check_window.py build/release/apps/brindle/brindle [NAME...] [--keep FOLDER]
    scripts/check_window.py build/release/apps/brindle/brindle --measure MESH
    scripts/check_window.py build/release/apps/brindle/brindle --measure-gallery [ITEM...]

Starts a display of its own (Xvfb), moves the mouse and presses keys (xdotool), drops files
(python3-xlib) and reads the window's log (brindle view --log) for where widgets are and what has been
drawn. --measure drags a slider to and fro instead, in a window of 1280x720, and says how many frames a
second there were and what they and the window itself cost; --measure-gallery does so with every item of the
gallery. Of the checks, those are run whose names contain a NAME. Ends with 0 if all is well, 1 if not, and
77 where Xvfb or xdotool is missing.
"""

import argparse
import json
import os
import pathlib
import select
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import traceback

SKIPPED = 77
PATIENCE = float(os.environ.get("BRINDLE_PATIENCE", 240))  # seconds until what never comes is a failure
SIZE = (1000, 640)


class Failure(Exception):
    pass


def expect(condition, what):
    if not condition:
        raise Failure(what)


class Display:
    """A display that nobody sees."""

    def __init__(self):
        reading, writing = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(writing), "-screen", "0", "1280x800x24", "-noreset", "-nolisten", "tcp"],
            pass_fds=[writing], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(writing)
        with os.fdopen(reading) as line:
            number = line.readline().strip()
        expect(number, "Xvfb does not start")
        self.name = f":{number}"

    def close(self):
        self.server.terminate()
        self.server.wait()


class Window:
    """brindle view with its log."""

    def __init__(self, tool, display, folder, arguments):
        self.display = display
        self.log_path = folder / "log.jsonl"
        self.lines = []
        self.places = {}
        self.size = SIZE
        self.environment = dict(os.environ, DISPLAY=display, XDG_CONFIG_HOME=str(folder / "config"),
                                XDG_CACHE_HOME=str(folder / "cache"))
        self.log_path.unlink(missing_ok=True)  # of a window before
        self.errors = open(folder / "errors.txt", "w+")
        self.process = subprocess.Popen(
            [tool, "view", *arguments, "--log", str(self.log_path), "--window", "%dx%d" % SIZE, "--scale", "1"],
            cwd=folder, env=self.environment, stdout=subprocess.DEVNULL, stderr=self.errors)
        self.file = None
        self.wait_for("start")
        self.id = self.xdotool("search", "--sync", "--pid", str(self.process.pid)).split()[-1]

    def xdotool(self, *words):
        result = subprocess.run(["xdotool", *map(str, words)], env=self.environment, capture_output=True,
                                text=True, timeout=PATIENCE)
        expect(result.returncode == 0, f"xdotool {words}: {result.stderr}")
        return result.stdout

    # The log.

    def read(self):
        if self.file is None and self.log_path.exists():
            self.file = open(self.log_path)
        while self.file is not None:
            start = self.file.tell()
            line = self.file.readline()
            if not line.endswith("\n"):
                self.file.seek(start)
                return
            entry = json.loads(line)
            self.lines.append(entry)
            if entry["event"] == "widgets":
                for name, place in entry["places"].items():
                    if place is None:
                        self.places.pop(name, None)
                    else:
                        self.places[name] = place

    def wait_until(self, condition, what):
        """What `condition` gives, once that is anything."""
        end = time.monotonic() + PATIENCE
        while True:
            self.read()
            found = condition()
            if found:
                return found
            if self.process.poll() is not None:
                self.errors.seek(0)
                raise Failure(f"the window is gone ({self.process.returncode}) before {what}: {self.errors.read()}")
            if time.monotonic() > end:
                last = [line for line in self.lines if line["event"] != "widgets"][-6:]
                raise Failure(f"no {what}; the last events: {json.dumps(last)[:1500]}")
            time.sleep(0.02)

    def wait_for(self, event, since=0, **what):
        """The first entry of the log after number `since` with these values."""
        def find():
            for entry in self.lines[since:]:
                if entry["event"] == event and all(entry.get(key) == value for key, value in what.items()):
                    return entry
            return None
        return self.wait_until(find, f"{event} {what}")

    def now(self):
        self.read()
        return len(self.lines)

    def settled(self, since=None):
        """The final frame of all that has been done; of something done after entry `since`."""
        if since is not None:
            self.wait_for("command", since)

        def find():
            frames = [e for e in self.lines if e["event"] == "frame" and not e["variant"]]
            changes = [e for e in self.lines if "revision" in e and e["event"] != "frame"]
            if not frames or not frames[-1]["final"]:
                return None
            last, change = frames[-1], changes[-1] if changes else {"revision": 1}
            shown = last["revision"] == change["revision"] or change.get("frame") == last["number"]
            return last if shown else None
        return self.wait_until(find, "final frame of what was done")

    # The mouse and the keys.

    def place(self, name):
        self.wait_until(lambda: name in self.places, f"widget '{name}'")
        time.sleep(0.15)  # popups move while they open
        self.read()
        return self.places[name]

    def point(self, name, across=0.5, down=0.5):
        x, y, width, height = self.place(name)
        return round(x + across * width), round(y + down * height)

    def move(self, x, y):
        self.xdotool("mousemove", "--window", self.id, x, y)
        time.sleep(0.03)

    def click(self, name, across=0.5, down=0.5, button=1):
        self.move(*self.point(name, across, down))
        time.sleep(0.1)
        self.xdotool("mousedown", button)
        time.sleep(0.08)
        self.xdotool("mouseup", button)
        time.sleep(0.15)

    def drag(self, points, button=1, pause=0.06):
        self.move(*points[0])
        time.sleep(0.1)
        self.xdotool("mousedown", button)
        time.sleep(0.1)
        for point in points[1:]:
            self.move(*point)
            time.sleep(pause)
        self.xdotool("mouseup", button)
        time.sleep(0.1)

    def drag_slider(self, name, first, last, steps=8):
        self.drag([self.point(name, first + (last - first) * i / steps) for i in range(steps + 1)])

    def sweep(self, points, button=1, pause=0.012):
        """Drags as fast as a hand: all of it is one call of xdotool."""
        words = ["mousemove", "--window", self.id, *points[0], "sleep", 0.1]
        if button:
            words += ["mousedown", button, "sleep", 0.05]
        for point in points[1:]:
            words += ["mousemove", "--window", self.id, *point, "sleep", pause]
        self.xdotool(*words, *(["mouseup", button] if button else []))

    def key(self, *keys):
        for key in keys:
            self.xdotool("key", "--window", self.id, key)
            time.sleep(0.15)

    def type(self, text):
        self.xdotool("type", "--delay", "25", text)
        time.sleep(0.1)

    def menu(self, menu, *items):
        self.click(f"menu {menu}")
        for item in items:
            self.click(f"item {item}")

    def save_as(self, path):
        """Types a path into the dialogue of files that is open."""
        self.place("browser name")
        time.sleep(0.2)
        self.key("ctrl+a")
        self.type(str(path))
        self.key("Return")

    def quit(self):
        """Without saving, if it asks."""
        self.xdotool("key", "ctrl+q")  # not to a window, which may be gone before keys are let go
        self.wait_for_question()
        if "quit discard" in self.places and self.process.poll() is None:
            self.click("quit discard")
        expect(self.process.wait(PATIENCE) == 0, "quitting does not end with 0")

    def wait_for_question(self):
        """Until it asks whether to quit, or has quit."""
        end = time.monotonic() + PATIENCE
        while self.process.poll() is None and "quit discard" not in self.places and time.monotonic() < end:
            self.read()
            time.sleep(0.02)

    def wait_until_end(self):
        self.process.wait(PATIENCE)
        self.read()
        return self.lines[-1]

    def kill(self):
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGKILL)
            self.process.wait()
        self.errors.close()


# What is checked. Each is given the window's maker and a folder.


def wait_for_file(path):
    end = time.monotonic() + PATIENCE
    while not path.exists():
        expect(time.monotonic() < end, f"no {path.name} is written")
        time.sleep(0.05)


def save_picture(window, path):
    window.key("ctrl+p")
    window.save_as(path)
    window.wait_for("message", text=f"wrote {path}")
    return path.read_bytes()


def save_session(window, path):
    window.menu("File", "Save session as...")
    window.save_as(path)
    window.wait_for("message", text=f"wrote {path}")
    return path.read_bytes()


def check_open_by_command_line_and_menu(start, folder):
    window = start("shape:torus,resolution=90")
    window.settled()
    expect(window.wait_for("frame")["branches"] > 0, "the first picture has no branches")
    (folder / "plate.obj").write_text("v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n")
    since = window.now()
    window.key("ctrl+o")
    window.save_as(folder / "plate.obj")
    window.settled(since)
    since = window.now()
    window.menu("Edit", "Undo")
    back = window.settled(since)
    session = json.loads(save_session(window, folder / "session.json"))
    expect(session["mesh"] == "shape:torus,resolution=90", "undo does not bring the torus back")
    expect(back["final"], "no final picture")
    window.quit()


def check_slider_changes_branches(start, folder):
    window = start("shape:torus,resolution=90")
    first = window.settled()
    since = window.now()
    window.drag_slider("option stripes", 0.5, 0.8)
    last = window.settled(since)
    frames = [e for e in window.lines[since:] if e["event"] == "frame"]
    expect(any(not frame["final"] for frame in frames), "nothing was drawn while the slider moved")
    expect(last["branches"] != first["branches"], f"still {first['branches']} branches")
    since = window.now()
    window.key("ctrl+z")
    window.settled(since)
    session = json.loads(save_session(window, folder / "session.json"))
    expect("stripes" not in session.get("options", {}), "one undo does not take the slider back")
    window.quit()


def check_stroke_and_undo(start, folder):
    window = start("shape:sphere", "--stripes", "16")
    window.settled()
    before = save_picture(window, folder / "before.png")
    session_before = save_session(window, folder / "before.json")
    window.click("tool Comb")
    since = window.now()
    window.drag([window.point("picture", 0.35 + 0.03 * i, 0.4 + 0.02 * i) for i in range(10)])
    window.settled(since)
    drawn = [e for e in window.lines[since:] if e["event"] == "frame" and not e["final"]]
    expect(drawn, "the field does not follow while the stroke is drawn")
    expect(save_picture(window, folder / "during.png") != before, "the stroke changes nothing")
    strokes = json.loads(save_session(window, folder / "during.json"))["strokes"]
    expect(len(strokes) == 1 and len(strokes[0]["points"]) > 4, "the session has no stroke")
    window.key("s")
    for place in ((0.4, 0.6), (0.5, 0.65), (0.6, 0.6)):
        since = window.now()
        window.click("picture", *place)
        if place != (0.4, 0.6):
            window.settled(since)
    window.key("Return")
    with_spline = json.loads(save_session(window, folder / "spline.json"))["strokes"]
    expect(len(with_spline) == 2 and with_spline[0] == strokes[0], "a spline does not come beside the stroke")
    for _ in range(3):
        since = window.now()
        window.key("ctrl+z")
        window.settled(since)
    expect(save_picture(window, folder / "after.png") == before, "undo does not restore the picture")
    expect(save_session(window, folder / "after.json") == session_before, "undo does not restore the session")
    window.quit()


def check_singularity_is_steered(start, folder):
    window = start("shape:sphere,resolution=50", "--stripes", "20")
    window.settled()
    before = save_session(window, folder / "before.json")
    window.key("g")
    window.wait_until(lambda: any(name.startswith("singularity ") for name in window.places), "singularity")
    name = next(name for name in window.places if name.startswith("singularity "))
    x, y = window.point(name)
    middle = window.point("picture")
    to = (round(0.45 * x + 0.55 * middle[0]), round(0.45 * y + 0.55 * middle[1]))
    since = window.now()
    window.drag([(x + (to[0] - x) * i // 8, y + (to[1] - y) * i // 8) for i in range(9)])
    window.settled(since)
    time.sleep(0.3)
    window.read()
    places = [window.point(name) for name in window.places if name.startswith("singularity ")]
    expect(any(abs(px - to[0]) + abs(py - to[1]) < 30 for px, py in places), f"no singularity at {to}: {places}")
    expect(all(abs(px - x) + abs(py - y) > 30 for px, py in places), f"one stays at {(x, y)}: {places}")
    since = window.now()
    window.key("ctrl+z")
    window.settled(since)
    expect(save_session(window, folder / "after.json") == before, "one undo does not bring it back")
    window.quit()


def check_zoom_changes_frequency(start, folder):
    window = start("shape:torus,resolution=90", "--stripes", "20")
    first = window.settled()
    since = window.now()
    window.drag_slider("frequency by zoom", 0.05, 0.98, 3)
    window.settled(since)
    since = window.now()
    window.move(*window.point("picture"))
    for _ in range(6):
        window.xdotool("click", 4)
        time.sleep(0.1)
    last = window.settled(since)
    session = json.loads(save_session(window, folder / "session.json"))
    expect(session["camera"]["zoom"] > 1.5, "the wheel does not zoom")
    expect(last["energy"] != first["energy"] and last["branches"] != first["branches"],
           "frequencies do not follow the zoom")
    window.quit()


def check_screenshot_is_rendered_picture(start, folder):
    window = start("shape:trefoil", "--stripes", "30")
    window.settled()
    since = window.now()
    window.drag([window.point("picture", 0.4, 0.4), window.point("picture", 0.5, 0.45),
                 window.point("picture", 0.6, 0.5)])
    window.settled(since)
    since = window.now()
    window.drag_slider("option stripes", 0.6, 0.65)
    window.settled(since)
    seen = save_picture(window, folder / "seen.png")
    save_session(window, folder / "session.json")
    window.quit()
    subprocess.run([start.tool, "render", "session.json", "--output", "rendered.png"], cwd=folder, check=True,
                   stdout=subprocess.DEVNULL)
    expect((folder / "rendered.png").read_bytes() == seen, "brindle render draws another picture")


def check_bad_file_dropped(start, folder):
    window = start("shape:torus,resolution=90")
    window.settled()
    before = save_picture(window, folder / "before.png")
    bad = folder / "bad.ply"
    bad.write_text("ply\nformat ascii 1.0\nelement vertex many\nend_header\n")
    since = window.now()
    drop(window, bad)
    message = window.wait_for("message", since, kind="error")
    expect("bad.ply" in message["text"], f"the message does not name the file: {message['text']}")
    expect(save_picture(window, folder / "after.png") == before, "a bad file changes the picture")
    good = folder / "good.obj"
    good.write_text("v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n")
    since = window.now()
    drop(window, good)
    window.settled(since)
    expect(json.loads(save_session(window, folder / "session.json"))["mesh"] == str(good),
           "a good file is not opened")
    window.quit()


def check_video_is_recorded_or_refused(start, folder):
    window = start("shape:trefoil,resolution=30", "--stripes", "20")
    window.settled()
    since = window.now()
    window.key("r")
    if shutil.which("ffmpeg") is None:
        message = window.wait_for("message", since, kind="error")
        expect("ffmpeg" in message["text"], f"the message does not say what is missing: {message['text']}")
        return window.quit()
    window.save_as(folder / "turn.mp4")
    window.drag([window.point("picture", 0.3 + 0.03 * i) for i in range(12)])
    expect(not (folder / "turn.mp4").exists(), "half a video is there")
    window.key("r")
    window.wait_for("message", since, text=f"wrote {folder / 'turn.mp4'}")
    seen = subprocess.run(["ffmpeg", "-v", "error", "-i", folder / "turn.mp4", "-f", "framemd5", "-"], text=True,
                          capture_output=True, check=True).stdout
    frames = {line.split(",")[-1] for line in seen.splitlines() if not line.startswith("#")}
    expect(len(frames) > 3, f"the video has {len(frames)} different pictures")
    window.quit()


def check_quit_while_solving(start, folder):
    window = start("shape:sphere,resolution=400")
    window.wait_for("widgets")
    time.sleep(1)
    window.quit()
    expect(window.wait_until_end()["busy"], "it was not solving any more")


def check_what_is_refused(start, folder):
    for arguments, code in ((["no_such_mesh.ply", "--stripes", "-3"], 2),
                            (["shape:torus", "--max-distance", "3"], 2)):
        result = subprocess.run([start.tool, "view", *arguments], cwd=folder, capture_output=True, text=True,
                                env=dict(os.environ, DISPLAY=start.display))
        expect(result.returncode == code, f"{arguments}: ends with {result.returncode}: {result.stderr}")
    environment = {key: value for key, value in os.environ.items() if key not in ("DISPLAY", "WAYLAND_DISPLAY")}
    result = subprocess.run([start.tool, "view"], cwd=folder, capture_output=True, text=True, env=environment)
    expect(result.returncode == 1 and "brindle render" in result.stderr,
           f"without a display: {result.returncode}, {result.stderr}")
    result = subprocess.run([start.tool, "view"], cwd=folder, capture_output=True, text=True,
                            env=dict(os.environ, DISPLAY=start.display, MESA_GL_VERSION_OVERRIDE="2.1"))
    expect(result.returncode == 1 and "OpenGL 3.2" in result.stderr,
           f"without OpenGL: {result.returncode}, {result.stderr}")


def drop(window, path):
    """Plays the part of a file manager from which a file is dragged onto the window (XDND)."""
    from Xlib import X, Xatom, display
    from Xlib.protocol import event

    connection = display.Display(window.display)
    root = connection.screen().root
    source = root.create_window(0, 0, 10, 10, 0, X.CopyFromParent)
    target = connection.create_resource_object("window", int(window.id))
    atom = connection.intern_atom
    uris = atom("text/uri-list")
    x, y = window.point("picture")

    def send(name, *data):
        data = list(data) + [0] * (4 - len(data))
        target.send_event(event.ClientMessage(window=target, client_type=atom(name),
                                              data=(32, [source.id, *data])))
        connection.flush()

    source.set_selection_owner(atom("XdndSelection"), X.CurrentTime)
    send("XdndEnter", 5 << 24, uris, 0, 0)
    send("XdndPosition", 0, (x << 16) | y, X.CurrentTime, atom("XdndActionCopy"))
    time.sleep(0.3)
    send("XdndDrop", 0, X.CurrentTime)
    end = time.monotonic() + PATIENCE
    while time.monotonic() < end:
        if not select.select([connection.fileno()], [], [], 0.2)[0] and not connection.pending_events():
            continue
        received = connection.next_event()
        if received.type == X.SelectionRequest:
            requestor = received.requestor
            requestor.change_property(received.property, received.target, 8, f"file://{path}\r\n".encode())
            requestor.send_event(event.SelectionNotify(
                time=received.time, requestor=requestor, selection=received.selection,
                target=received.target, property=received.property))
            connection.flush()
        elif received.type == X.ClientMessage and received.client_type == atom("XdndFinished"):
            break
    else:
        raise Failure("the window does not take what is dropped")
    connection.close()


def open_gallery(window, item, picture):
    window.click("menu Gallery")
    window.click(f"item {item}")
    since = window.now()
    window.click(f"item {item} {picture}")
    return window.settled(since)


def options_of(window, path):
    return json.loads(save_session(window, path))["options"]


def check_gallery_needle_is_dragged(start, folder):
    window = start("shape:torus,resolution=40")
    window.settled()
    open_gallery(window, "liver", "near")
    before = options_of(window, folder / "before.json")
    since = window.now()
    x, y = window.point("place 1")
    window.drag([(x + 12 * i, y - 4 * i) for i in range(8)])
    window.settled(since)
    frames = [e for e in window.lines[since:] if e["event"] == "frame" and not e["final"]]
    expect(len(frames) > 1 and frames[-1]["followed"], "the hatching does not follow the needle")
    after = options_of(window, folder / "after.json")
    place = after["width-by"].removeprefix("distance:")
    expect(before["width-by"] != after["width-by"] and after["frequency-by"] == f"distance:{place}" and
           after["with"][1].endswith(f"@{place}"), f"the needle is not moved as a whole: {after}")
    seen = save_picture(window, folder / "seen.png")
    subprocess.run([start.tool, "render", "after.json", "--output", "rendered.png"], cwd=folder, check=True,
                   stdout=subprocess.DEVNULL)
    expect((folder / "rendered.png").read_bytes() == seen, "brindle render draws another needle")
    since = window.now()
    window.key("ctrl+z")
    window.settled(since)
    expect(options_of(window, folder / "undone.json") == before, "one undo does not take the needle back")
    window.quit()


def check_place_follows_mouse(start, folder):
    window = start("shape:sphere,resolution=40", "--width-by", "distance:1,0,0")
    window.settled()
    window.click("place at mouse")
    since = window.now()
    x, y = window.point("picture", 0.4)
    window.sweep([(x + 4 * i, y) for i in range(20)], button=0)
    window.settled(since)
    frames = [e for e in window.lines[since:] if e["event"] == "frame" and not e["final"]]
    expect(frames and "solve" not in frames[-1]["stages"], "widths do not follow, or all is solved again")
    time.sleep(0.6)  # a rest ends the motion
    expect(options_of(window, folder / "moved.json")["width-by"] != "distance:1,0,0", "the place stays")
    window.key("ctrl+z")
    expect(options_of(window, folder / "undone.json")["width-by"] == "distance:1,0,0", "no single undo")
    window.quit()


def check_quit_asks_for_what_is_not_saved(start, folder):
    window = start("shape:torus,resolution=40")
    window.settled()
    since = window.now()
    window.drag([window.point("picture", 0.4), window.point("picture", 0.5)])  # a view alone is nothing to lose
    window.settled(since)
    since = window.now()
    window.drag_slider("option stripes", 0.5, 0.7, 3)
    window.settled(since)
    window.xdotool("key", "ctrl+q")
    window.click("quit cancel")
    expect(window.process.poll() is None, "it quits though it was told not to")
    window.xdotool("key", "ctrl+q")
    window.click("quit save")
    window.save_as(folder / "kept.json")
    expect(window.process.wait(PATIENCE) == 0, "it does not quit once all is saved")
    options = json.loads((folder / "kept.json").read_text())["options"]
    expect("stripes" in options, "what was saved is not what was shown")
    window = start("kept.json")
    window.settled()
    window.xdotool("key", "ctrl+q")
    expect(window.process.wait(PATIENCE) == 0, "it asks though nothing has changed")


class Starter:
    def __init__(self, tool, display, folder):
        self.tool, self.display, self.folder = tool, display, folder
        self.windows = []

    def __call__(self, *arguments):
        window = Window(self.tool, self.display, self.folder, arguments)
        self.windows.append(window)
        return window


def run(name, check, tool, display, folder):
    folder.mkdir(parents=True)
    start = Starter(tool, display, folder)
    try:
        check(start, folder)
        print(f"{name}: ok", flush=True)
        return True
    except (Failure, subprocess.SubprocessError, OSError, KeyError, ValueError) as failure:
        print(f"{name}: {failure}", flush=True)
        if not isinstance(failure, Failure):
            traceback.print_exc()
        return False
    finally:
        for window in start.windows:
            window.kill()


def median(values):
    return sorted(values)[len(values) // 2] if values else float("nan")


def processor_seconds(process):
    fields = pathlib.Path(f"/proc/{process.pid}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def measure(tool, mesh, display, folder):
    """Frames a second while a slider moves, and the processor's time for them and for the window."""
    global SIZE
    SIZE = (1280, 720)
    folder.mkdir(parents=True)
    window = Window(tool, display, folder, [str(pathlib.Path(mesh).resolve()) if os.path.exists(mesh) else mesh])
    try:
        window.settled()
        since = window.now()
        window.click("option stripes")
        window.settled(since)
        since, before, start = window.now(), processor_seconds(window.process), time.monotonic()
        left, right = window.point("option stripes", 0.3), window.point("option stripes", 0.8)
        there = [(x, left[1]) for x in range(left[0], right[0])]
        window.sweep(4 * (there + there[::-1]))
        window.read()
        used, took = processor_seconds(window.process) - before, time.monotonic() - start
        frames = [e for e in window.lines[since:] if e["event"] == "frame" and not e["final"]]
        gaps = [b["time"] - a["time"] for a, b in zip(frames, frames[1:])]
        size = f"{frames[0]['width']}x{frames[0]['height']}"
        print(f"picture {size}, {len(frames)} frames in {took:.1f} s, median {1 / median(gaps):.1f} a second")
        print(f"a frame: {median([e['milliseconds'] for e in frames]):.1f} ms, of which drawing "
              f"{median([e['draw_milliseconds'] for e in frames]):.1f} ms; processor, with the window, "
              f"{1000 * used / len(frames):.1f} ms")
        window.settled(since)
        before = processor_seconds(window.process)
        x, y = window.point("group Solver")
        for i in range(150):
            window.move(x + i % 40, y)
        used = processor_seconds(window.process) - before
        window.quit()
        end = window.wait_until_end()
        print(f"the window's thread: {1000 * end['thread_seconds'] / end['drawn']:.1f} ms of the processor for each of "
              f"{end['drawn']} times that it was drawn; all threads while nothing is solved: "
              f"{1000 * used / 150:.1f} ms for each motion of the mouse")
    finally:
        window.kill()
    return 0


def frames_a_second(window, points):
    """While the mouse is dragged along these points, at least five times as long as a frame takes."""
    since = window.now()
    for _ in range(6):
        window.sweep(points + points[::-1])
        window.read()
        frames = [e for e in window.lines[since:] if e["event"] == "frame" and not e["final"]]
        if len(frames) > 5:
            break
    window.settled(since)
    return 1 / median([b["time"] - a["time"] for a, b in zip(frames, frames[1:])]), frames[-1]["vertices"]


# What is moved live of an item: its place, or the slider of an option.
GALLERY = {"liver": ("near", "place 1"), "nested": ("focus", "place 1"), "vortices": ("still", "option stripes"),
           "aneurysm": ("stress", "option stripes"), "molecule": ("signs", "option stripes"),
           "hatching": ("pen", "option stripes"), "glyphs": ("decals", "option stripes"),
           "crosses": ("tiles", "option stripes"), "rough": ("all", "option stripes"),
           "giant": ("stripes", "option stripes")}


def measure_gallery(tool, names, display, folder):
    """A table of frames a second: what a user sees who turns an item, or moves what is live in it."""
    global SIZE
    SIZE = (1280, 720)
    folder.mkdir(parents=True)
    print("| item | vertices | turned | | moved |\n|---|---|---|---|---|")
    window = Window(tool, display, folder, ["shape:torus,resolution=20"])
    try:
        window.settled()
        for item, (picture, control) in GALLERY.items():
            if names and item not in names:
                continue
            open_gallery(window, item, picture)
            x, y = window.point("picture", 0.75, 0.85)
            turned, vertices = frames_a_second(window, [(x + i, y) for i in range(90)])
            x, y = window.point(control)
            moved, _ = frames_a_second(window, [(x + i, y) for i in range(-40, 41)]
                                       if control.startswith("option") else [(x + i, y) for i in range(90)])
            what = {"liver": "needle", "nested": "focus"}.get(item, "stripes")
            print(f"| {item} | {vertices:,} | {turned:.1f} | {what} | {moved:.1f} |", flush=True)
        window.quit()
    finally:
        window.kill()
    return 0


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("tool")
    parser.add_argument("names", nargs="*")
    parser.add_argument("--keep", type=pathlib.Path)
    parser.add_argument("--measure", metavar="MESH")
    parser.add_argument("--measure-gallery", action="store_true")
    arguments = parser.parse_args()
    missing = [program for program in ("Xvfb", "xdotool") if shutil.which(program) is None]
    try:
        import Xlib  # noqa: F401
    except ImportError:
        missing.append("python3-xlib")
    if missing:
        print(f"skipped: {' and '.join(missing)} missing", file=sys.stderr)
        return SKIPPED
    checks = {name.removeprefix("check_"): check for name, check in globals().items()
              if name.startswith("check_") and (not arguments.names or any(n in name for n in arguments.names))}
    expect(checks or arguments.measure_gallery, "no check has such a name")
    tool = str(pathlib.Path(arguments.tool).resolve())
    folder = (arguments.keep or pathlib.Path(tempfile.mkdtemp(prefix="brindle_window_"))).resolve()
    display = Display()
    try:
        if arguments.measure:
            return measure(tool, arguments.measure, display.name, folder / "measure")
        if arguments.measure_gallery:
            return measure_gallery(tool, arguments.names, display.name, folder / "gallery")
        passed = [run(name, check, tool, display.name, folder / name) for name, check in checks.items()]
    finally:
        display.close()
        if not arguments.keep:
            shutil.rmtree(folder, ignore_errors=True)
    print(f"{sum(passed)} passed, {len(passed) - sum(passed)} failed")
    return 0 if all(passed) else 1


if __name__ == "__main__":
    sys.exit(main())
