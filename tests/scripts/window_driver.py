"""Works with the window of brindle view: a display that nobody sees (Xvfb), the mouse and keys (xdotool), and the
window's log (brindle view --log) for where widgets are and what has been drawn."""

import json
import os
import pathlib
import shutil
import signal
import subprocess
import time

PATIENCE = float(os.environ.get("BRINDLE_PATIENCE", 240))  # seconds until what never comes is a failure


def missing_programs():
    """The programs and modules that all of this needs and that are missing."""
    missing = [program for program in ("Xvfb", "xdotool") if shutil.which(program) is None]
    try:
        import Xlib  # noqa: F401
    except ImportError:
        missing.append("python3-xlib")
    return missing


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
            ["Xvfb", "-displayfd", str(writing), "-screen", "0", "1280x800x24", "-noreset", "-nolisten", "tcp",
             "-r"],  # where the machine is busy, keys would repeat themselves
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

    def __init__(self, tool, display, folder, arguments, size=(820, 640), environment=None):
        self.display = display
        self.log_path = folder / "log.jsonl"
        self.lines = []
        self.places = {}
        self.moved = {}  # at which mark a widget has come or moved
        self.marks = 0  # that were asked for
        self.seen_marks = 0
        self.size = size
        # Shaders that Mesa has compiled for others before are the one thing that windows share.
        shaders = os.environ.get("XDG_CACHE_HOME", str(pathlib.Path.home() / ".cache"))
        self.environment = {"MESA_SHADER_CACHE_DIR": shaders, **os.environ, "DISPLAY": display,
                            "XDG_CONFIG_HOME": str(folder / "config"), "XDG_CACHE_HOME": str(folder / "cache"),
                            **(environment or {})}
        self.log_path.unlink(missing_ok=True)  # of a window before
        self.errors = open(folder / "errors.txt", "w+")
        self.process = subprocess.Popen(
            [tool, "view", *arguments, "--log", str(self.log_path), "--window", "%dx%d" % size, "--scale", "1"],
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
            if entry["event"] == "mark":
                self.seen_marks = entry["number"]
            if entry["event"] == "widgets":
                for name, place in entry["places"].items():
                    self.moved[name] = self.seen_marks
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
            time.sleep(0.004)

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
            frames = [e for e in self.lines if e["event"] == "frame"]
            changes = [e for e in self.lines if "revision" in e and e["event"] != "frame"]
            if not frames or not frames[-1]["final"]:
                return None
            last, change = frames[-1], changes[-1] if changes else {"revision": 1}
            shown = last["revision"] == change["revision"] or change.get("frame") == last["number"]
            return last if shown else None
        return self.wait_until(find, "final frame of what was done")

    # The mouse and the keys. Nothing waits for a time to pass: F12 is pressed behind all that a hand does, and the
    # window writes a mark into its log once it has taken notice of what came before.

    def hand(self, *words):
        """What xdotool does, until the window has taken notice of it."""
        self.marks += 1
        self.xdotool(*words, "key", "F12")
        self.wait_until(lambda: self.seen_marks >= self.marks, f"mark {self.marks} after {words}")

    def place(self, name):
        self.wait_until(lambda: name in self.places, f"widget '{name}'")
        if self.moved[name] >= self.seen_marks - 1:
            self.hand()  # popups move while they open, and take the keyboard only then
            self.wait_until(lambda: name in self.places, f"widget '{name}'")
        return self.places[name]

    def point(self, name, across=0.5, down=0.5):
        x, y, width, height = self.place(name)
        return round(x + across * width), round(y + down * height)

    def move(self, x, y):
        self.hand("mousemove", "--window", self.id, x, y)

    def click(self, name, across=0.5, down=0.5, button=1):
        self.move(*self.point(name, across, down))
        self.hand("mousedown", button, "mouseup", button)

    def last_click(self, name):
        """Of what closes the window, so that no mark comes."""
        self.move(*self.point(name))
        self.xdotool("mousedown", 1, "sleep", 0.2, "mouseup", 1)

    def type_into_slider(self, name, text, end="Return"):
        """Ctrl and a click make a slider a field."""
        self.move(*self.point(name))
        self.hand("keydown", "ctrl", "mousedown", 1)
        self.hand("mouseup", 1, "keyup", "ctrl")
        self.key("ctrl+a")
        self.type(text)
        self.key(end)

    def drag(self, points, button=1):
        self.move(*points[0])
        self.hand("mousedown", button)
        for point in points[1:]:
            self.move(*point)
        self.hand("mouseup", button)

    def drag_slider(self, name, first, last, steps=8):
        self.drag([self.point(name, first + (last - first) * i / steps) for i in range(steps + 1)])

    def sweep(self, points, button=1, pause=0.012):
        """Drags as fast as a hand, whatever the window makes of it: all of it is one call of xdotool."""
        words = ["mousemove", "--window", self.id, *points[0], "sleep", 0.1]
        if button:
            words += ["mousedown", button, "sleep", 0.05]
        for point in points[1:]:
            words += ["mousemove", "--window", self.id, *point, "sleep", pause]
        self.xdotool(*words, *(["mouseup", button] if button else []))

    def key(self, *keys):
        for key in keys:
            self.hand("key", key)

    def type(self, text):
        self.hand("type", "--delay", "4", "--args", 1, "--", text)

    def menu(self, menu, *items):
        self.click(f"menu {menu}")
        for item in items:
            self.click(f"item {item}")

    def save_as(self, path, last=False):
        """Types a path into the dialogue of files that is open. `last`: then the window closes."""
        self.place("browser name")
        self.key("ctrl+a")
        self.type(str(path))
        self.xdotool("key", "Return") if last else self.key("Return")

    def quit(self):
        """Without saving, if it asks."""
        self.xdotool("key", "ctrl+q")  # not to a window, which may be gone before keys are let go
        self.wait_for_question()
        if "quit discard" in self.places and self.process.poll() is None:
            self.last_click("quit discard")
        expect(self.process.wait(PATIENCE) == 0, "quitting does not end with 0")

    def wait_for_question(self):
        """Until it asks whether to quit, or has quit."""
        end = time.monotonic() + PATIENCE
        while self.process.poll() is None and "quit discard" not in self.places and time.monotonic() < end:
            self.read()
            time.sleep(0.004)

    def wait_until_end(self):
        self.process.wait(PATIENCE)
        self.read()
        return self.lines[-1]

    def kill(self):
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGKILL)
            self.process.wait()
        self.errors.close()


def wait_for_file(path):
    end = time.monotonic() + PATIENCE
    while not path.exists():
        expect(time.monotonic() < end, f"no {path.name} is written")
        time.sleep(0.01)


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


def open_gallery(window, item, picture, discards=False):
    """`discards` what was edited before, which the window asks about."""
    window.click("menu Gallery")
    window.click(f"item {item}")
    since = window.now()
    window.click(f"item {item} {picture}")
    if discards:
        window.click("open discard")
    return window.settled(since)
