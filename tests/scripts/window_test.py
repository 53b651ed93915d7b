"""Works with the window of brindle view as a user does, and looks at what happens.

    BRINDLE_TOOL=build/release/apps/brindle/brindle /usr/bin/python3 -m pytest tests/scripts/window_test.py [-k NAME]

Starts a display of its own (Xvfb), moves the mouse and presses keys (xdotool), drops files
(python3-xlib) and reads the window's log (brindle view --log) for where widgets are and what has been
drawn. Tests may run at the same time, each on a display of its own. They are skipped where Xvfb or xdotool is
missing.
"""

import json
import math
import os
import select
import shutil
import subprocess
import time

import pytest

from conftest import ROOT
from window_driver import (PATIENCE, Display, Failure, Window, expect, missing_programs, open_gallery, save_picture,
                           save_session)


class Starter:
    def __init__(self, tool, display, folder):
        self.tool, self.display, self.folder = tool, display, folder
        self.windows = []

    def __call__(self, *arguments, environment=None):
        window = Window(self.tool, self.display, self.folder, arguments, environment=environment)
        self.windows.append(window)
        return window


@pytest.fixture
def folder(tmp_path):
    return tmp_path


@pytest.fixture
def start(tool, folder):
    """Opens windows, which end with the test."""
    if missing := missing_programs():
        pytest.skip(f"{' and '.join(missing)} missing")
    display = Display()
    starter = Starter(tool, display.name, folder)
    yield starter
    for window in starter.windows:
        window.kill()
    display.close()


def test_open_by_command_line_and_menu(start, folder):
    window = start("shape:torus,resolution=90", "--rotate", "40")
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


def test_slider_changes_branches(start, folder):
    window = start("shape:torus,resolution=90", "--rotate", "40")
    first = window.settled()
    since = window.now()
    window.drag_slider("option stripes", 0.5, 0.8)
    last = window.settled(since)
    frames = [e for e in window.lines[since:] if e["event"] == "frame"]
    expect(any(not frame["final"] for frame in frames), "nothing was drawn while the slider moved")
    expect(last["branches"] != first["branches"], f"still {first['branches']} branches")
    stripes = json.loads(save_session(window, folder / "dragged.json"))["options"]["stripes"]
    expect(float(stripes).is_integer(), f"a number of stripes is dragged to {stripes}")
    since = window.now()
    window.key("ctrl+z")
    window.settled(since)
    session = json.loads(save_session(window, folder / "session.json"))
    expect("stripes" not in session.get("options", {}), "one undo does not take the slider back")
    window.quit()


def write_noisy_flow(path, side=60):
    """A flow over a plane, with noise and a hole."""
    places = [(x, y) for y in range(side) for x in range(side)]
    noise = [math.modf(math.sin(12.9898 * k) * 43758.5453)[0] for k in range(2 * len(places))]
    hole = [math.dist(place, (side / 3, side / 3)) < side / 12 for place in places]
    flow = [(0, 0) if hole[k] else (1 + 1.6 * noise[2 * k], 0.5 + 1.6 * noise[2 * k + 1])
            for k in range(len(places))]
    squares = [(x + y * side) for x, y in places if x + 1 < side and y + 1 < side]
    path.write_text("\n".join(
        ["# vtk DataFile Version 3.0", "flow", "ASCII", "DATASET POLYDATA", f"POINTS {len(places)} float",
         *(f"{x} {y} 0" for x, y in places), f"POLYGONS {len(squares)} {5 * len(squares)}",
         *(f"4 {k} {k + 1} {k + side + 1} {k + side}" for k in squares),
         f"POINT_DATA {len(places)}", "VECTORS flow float", *(f"{u} {v} 0" for u, v in flow), ""]))


def test_measured_field_is_seen_at_its_scale(start, folder):
    write_noisy_flow(folder / "flow.vtk")
    window = start(str(folder / "flow.vtk"), "--field", "array:flow", "--stripes", "12")
    as_given = window.settled()
    window.click("group Field")
    window.move(*window.point("option direction"))
    for _ in range(40):
        if "option field-smoothing" in window.places:
            break
        window.hand("click", 5)
    since = window.now()
    window.drag_slider("option field-smoothing", 0.02, 0.5)
    seen = window.settled(since)
    expect(4 * seen["branches"] < as_given["branches"],
           f"of {as_given['branches']} branches {seen['branches']} are left")
    save_picture(window, folder / "seen.png")
    since = window.now()
    window.key("ctrl+z")
    expect(window.settled(since)["branches"] == as_given["branches"], "one undo does not take the slider back")
    window.quit()


def test_stroke_and_undo(start, folder):
    window = start("shape:sphere,resolution=40", "--stripes", "16")
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


def test_strokes_end_where_the_surface_does(start, folder):
    window = start("shape:torus,resolution=60", "--stripes", "16", "--camera", "0,90")
    window.settled()
    before = save_session(window, folder / "before.json")
    window.click("tool Comb")
    since = window.now()
    window.drag([window.point("picture", 0.02 + 0.06 * i, 0.5) for i in range(17)])
    window.settled(since)
    strokes = json.loads(save_session(window, folder / "across.json"))["strokes"]
    expect(len(strokes) == 2, f"{len(strokes)} strokes beside the hole")
    for stroke in strokes:
        sides = {math.copysign(1, x) for x, _, _ in stroke["points"]}
        expect(len(sides) == 1, f"a stroke runs through the air: {stroke['points']}")
    since = window.now()
    window.key("ctrl+z")
    window.settled(since)
    expect(save_session(window, folder / "after.json") == before, "both strokes are not one step")
    window.quit()


def test_files_are_those_that_can_be_read(start, folder):
    shutil.copy(ROOT / "docs" / "images" / "window.png", folder / "tile.png")
    (folder / "plate.obj").write_text("v 0 0 0\nv 2 0 0\nv 2 1 0\nf 1 2 3\n")
    window = start("shape:torus,resolution=20")
    window.settled()
    search_option(window, "texture")
    window.click("browse texture 0")
    window.place("browser item tile.png")
    expect("browser item plate.obj" not in window.places, "a mesh is offered as a tile")
    window.click("browser cancel")
    window.quit()


def test_singularity_is_steered(start, folder):
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
    said = window.wait_for("steered", since)["text"]
    expect(said == "the singularity is where you dropped it", f"it says: {said}")
    window.settled(since)
    window.hand()
    window.place("status of steering")
    places = [window.point(name) for name in window.places if name.startswith("singularity ")]
    expect(any(abs(px - to[0]) + abs(py - to[1]) < 30 for px, py in places), f"no singularity at {to}: {places}")
    expect(all(abs(px - x) + abs(py - y) > 30 for px, py in places), f"one stays at {(x, y)}: {places}")
    steered = json.loads(save_session(window, folder / "steered.json"))
    expect(steered["steering"] and "strokes" not in steered, "what holds it is among the strokes that are shown")
    window.drag([to, window.point("picture", 0.01, 0.01)])
    said = window.wait_for("steered", window.now() - 6)["text"]
    expect("beside the surface; it is" in said, f"dropped beside the surface it says: {said}")
    since = window.now()
    window.key("ctrl+z")
    window.settled(since)
    expect(save_session(window, folder / "after.json") == before, "one undo does not bring it back")
    window.hand()
    expect("status of steering" not in window.places, "what is undone is still told")
    since = window.now()
    window.key("ctrl+shift+z")
    window.settled(since)
    since = window.now()
    window.click("let go")
    window.settled(since)
    expect("steering" not in json.loads(save_session(window, folder / "let_go.json")), "it is still held")
    window.quit()


def test_singularities_that_cannot_be_steered_say_why(start, folder):
    window = start("shape:vessels", "--field", "raw-curvature")
    window.settled()
    window.key("g")
    window.wait_until(lambda: any(name.startswith("singularity ") for name in window.places), "singularity")
    name = next(name for name in window.places if name.startswith("singularity "))
    x, y = window.point(name)
    since = window.now()
    window.drag([(x, y), (x + 20, y + 20), (x + 40, y + 40)])
    said = window.wait_for("steered", since)["text"]
    expect("stays: only 'direction field' smooth" in said, f"it says: {said}")
    window.quit()


def test_zoom_changes_frequency(start, folder):
    window = start("shape:torus,resolution=90", "--stripes", "20", "--rotate", "40")
    first = window.settled()
    since = window.now()
    window.drag_slider("frequency by zoom", 0.05, 0.98, 3)
    window.settled(since)
    since = window.now()
    window.move(*window.point("picture"))
    for _ in range(6):
        window.hand("click", 4)
    last = window.settled(since)
    session = json.loads(save_session(window, folder / "session.json"))
    expect(session["camera"]["zoom"] > 1.5, "the wheel does not zoom")
    expect(last["energy"] != first["energy"] and last["branches"] != first["branches"],
           "frequencies do not follow the zoom")
    window.quit()


def test_screenshot_is_rendered_picture(start, folder):
    window = start("shape:trefoil,resolution=40", "--stripes", "30")
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


def metrics_of(window, shown, since):
    window.click(f"show {shown}")
    return window.settled(since)["shown"]


def test_curves_and_samples_are_live(start, folder):
    window = start("shape:sphere,resolution=30")
    window.settled()
    curves = metrics_of(window, "curves", window.now())
    expect(curves["curves of u"] > 0, f"no curves are counted: {curves}")
    since = window.now()
    window.drag_slider("option min-length", 0.1, 0.9)
    longer = window.settled(since)["shown"]
    expect(longer["curves of u"] < curves["curves of u"], "short curves are not left out while a slider moves")
    samples = metrics_of(window, "samples", window.now())
    expect(samples["samples"] > 0, f"no samples are counted: {samples}")
    since = window.now()
    window.drag_slider("option min-distance", 0.2, 0.9)
    apart = window.settled(since)["shown"]
    expect(apart["too near to others"] > samples["too near to others"], "samples do not keep their distance")
    seen = save_picture(window, folder / "seen.png")
    session = json.loads(save_session(window, folder / "session.json"))
    expect(session["shown"] == "samples" and "min-length" in session["curves"] and
           "min-distance" in session["samples"], f"the session has other options: {session}")
    subprocess.run([start.tool, "render", "session.json", "--output", "rendered.png", "--output", "samples.csv"],
                   cwd=folder, check=True, stdout=subprocess.DEVNULL)
    expect((folder / "rendered.png").read_bytes() == seen, "brindle render draws other samples")
    rows = len((folder / "samples.csv").read_text().splitlines()) - 1
    expect(rows == apart["samples"], f"{rows} samples are written")
    since = window.now()
    window.key("ctrl+z")
    expect(window.settled(since)["shown"] == samples, "one undo does not take the slider back")
    window.quit()


def test_curves_are_exported(start, folder):
    words = ("shape:trefoil,resolution=60", "--stripes", "24")
    window = start(*words)
    window.settled()
    metrics = metrics_of(window, "curves", window.now())
    told = folder / "told.json"
    subprocess.run([start.tool, "curves", *words, "--report", told, "--output", "tool.obj", "--output", "tool.vtp",
                    "--output", "tool.csv", "--output", "tool.ply"], cwd=folder, check=True, stdout=subprocess.DEVNULL)
    u = json.loads(told.read_text())["u"]
    expect([metrics[name] for name in ("curves of u", "closed ones of u", "ends of u")] ==
           [u["curves"], u["closed"], u["ends"]["total"]], f"the panel has {metrics}, the report {u}")
    for name in ("shortest", "longest"):
        expect(math.isclose(metrics[f"  {name} (u)"], u["lengths"][name], rel_tol=1e-6), f"{name}: {metrics}, {u}")
    for name, value in (("gaps of u", u["gaps"]["mean"]), ("  least gap (u)", u["gaps"]["least"]),
                        ("  least, times f (u)", u["gaps"]["least_ratio"]),
                        ("spacing of u", u["spacing"]["mean"]),
                        *((f"winding {loop['name']} (u)", loop["winding"]) for loop in u["loops"])):
        expect(math.isclose(metrics[name], value, rel_tol=1e-5), f"{name}: {metrics}, {u}")
    expect(u["loops"], "the knot has no loops")
    expect(abs(metrics["length of u"] - u["length"]) < 1e-3 * u["length"], f"{metrics['length of u']} is no length")
    window.wait_until(lambda: "metric ends of u" in window.places, "ends in the panel")
    save_session(window, folder / "session.json")
    for kind in ("obj", "vtp", "csv", "ply", "svg"):
        window.menu("File", "Export curves...")
        window.save_as(folder / f"window.{kind}")
        window.wait_for("message", text=f"wrote {folder / f'window.{kind}'}")
    window.menu("File", "Export curves...")
    window.save_as(folder / "window.json")
    window.wait_for("message", text=f"wrote {folder / 'window.json'}")
    expect(json.loads((folder / "window.json").read_text())["u"] == u, "the window reports other curves")
    subprocess.run([start.tool, "render", "session.json", "--output", "tool.svg"], cwd=folder, check=True,
                   stdout=subprocess.DEVNULL)
    for kind in ("obj", "vtp", "csv", "ply", "svg"):
        seen, expected = (folder / f"{name}.{kind}" for name in ("window", "tool"))
        expect(seen.read_bytes() == expected.read_bytes(), f"the window writes another {kind}")
    window.quit()


def test_typed_values_count_as_a_whole(start, folder):
    window = start("shape:torus,resolution=40", "--stripes", "30")
    window.settled()

    def set_to(since):
        return [e["what"].get("values") for e in window.lines[since:]
                if e["event"] == "command" and e["what"]["command"] == "set_option" and e["done"]]

    since = window.now()
    window.type_into_slider("option stripes", "123.456")
    window.settled(since)
    expect(set_to(since) == [["123.456"]], f"typing is not one step: {set_to(since)}")
    since = window.now()
    window.type_into_slider("option stripes", "-3")
    message = window.wait_for("message", since, kind="error")
    expect("--stripes" in message["text"], f"it does not say what is wrong: {message['text']}")
    expect(not set_to(since), f"what is refused leaves other values: {set_to(since)}")
    since = window.now()
    window.type_into_slider("option stripes", "50", "Escape")
    window.type_into_slider("zoom", "2", "Tab")
    window.settled(since)
    expect(not set_to(since), "Escape does not leave the value as it was")
    session = json.loads(save_session(window, folder / "typed.json"))
    expect(session["options"]["stripes"] == "123.456" and session["camera"]["zoom"] == 2,
           f"the session has other values: {session}")
    for _ in range(2):
        since = window.now()
        window.key("ctrl+z")
        window.settled(since)
    session = json.loads(save_session(window, folder / "undone.json"))
    expect(session["options"]["stripes"] == "30", "two values are not two steps")
    window.quit()


def test_escape_closes_lists(start, folder):
    window = start("shape:torus,resolution=40", "--stripes", "20")
    window.settled()
    window.click("names frequency-by")
    window.place("choice frequency-by light")
    window.key("Escape")
    window.wait_until(lambda: "choice frequency-by light" not in window.places, "end of the list")
    since = window.now()
    window.drag([window.point("picture", 0.4), window.point("picture", 0.5)])
    window.settled(since)
    expect(any(e["event"] == "command" and e["what"]["command"] == "set_camera" for e in window.lines[since:]),
           "the picture is not there for the mouse")
    window.quit()


def test_options_are_searched(start, folder):
    window = start("shape:torus,resolution=40", "--stripes", "20")
    window.settled()
    window.click("search")
    window.type("avoid")
    # Of a group that is closed otherwise, and by its help.
    window.place("option avoid-branches")
    window.wait_until(lambda: "option stripes" not in window.places, "end of what is not meant")
    window.type(" nothing of that kind")
    window.wait_until(lambda: "option avoid-branches" not in window.places, "end of all options")
    window.key("Escape")
    window.place("option stripes")
    since = window.now()
    window.click("search")
    window.type("outlin")
    window.click("option outline")
    window.click("choice outline solid")
    window.settled(since)
    session = json.loads(save_session(window, folder / "searched.json"))
    expect(session["options"]["outline"] == "solid", f"what was found was not set: {session}")
    window.quit()


def test_stripes_run_across_or_along_strokes(start, folder):
    window = start("shape:plane,resolution=40", "--stripes", "20", "--camera", "0,89")
    window.settled()
    window.click("tool Comb")
    window.drag([window.point("picture", 0.4 + 0.05 * i, 0.5) for i in range(5)])
    since = window.now()
    window.click("stripes along strokes")
    window.settled(since)
    session = json.loads(save_session(window, folder / "along.json"))
    expect("along" in session["options"] and session["strokes"], f"stripes do not run along: {session}")
    since = window.now()
    window.click("stripes along strokes")
    window.settled(since)
    session = json.loads(save_session(window, folder / "across.json"))
    expect("along" not in session["options"], f"stripes still run along: {session}")
    window.quit()


def test_values_under_the_mouse(start, folder):
    window = start("shape:plane,resolution=40", "--stripes", "20", "--camera", "0,89")
    window.settled()
    window.move(*window.point("picture"))
    window.wait_until(lambda: any(name.startswith("value frequency ") for name in window.places),
                      "values of the middle")
    expect(any(name.startswith("value sine of the phase ") for name in window.places), "no phase there")
    window.move(*window.point("picture", 0.01, 0.01))
    window.wait_until(lambda: not any(name.startswith("value ") for name in window.places),
                      "end of values beside the surface")
    window.quit()


def test_warnings_are_shown(start, folder):
    fine = ("shape:sphere,resolution=8", "--stripes", "200")
    window = start(*fine)
    frame = window.settled()
    expect(any(note.startswith("warning: ") for note in frame["notes"]), f"no warning: {frame['notes']}")
    told = subprocess.run([start.tool, "stripe", *fine], cwd=folder, capture_output=True, text=True, check=True)
    expect(any("'number of stripes'" in note and "or 'split triangles' 4" in note for note in frame["notes"]),
           f"not in the window's words: {frame['notes']}")
    for note in frame["notes"]:
        for words, option in (("number of stripes", "stripes"), ("stripes per unit", "frequency"),
                              ("direction field", "field"), ("split triangles", "subdivide")):
            note = note.replace(f"'{words}'", f"--{option}")
        expect(note in told.stdout + told.stderr, f"the tool says something else than {note}")
    window.wait_until(lambda: "note 1" in window.places, "warning in the panel")
    since = window.now()
    window.type_into_slider("option stripes", "10")
    expect(not window.settled(since)["notes"], "a warning stays that is none any more")
    window.wait_until(lambda: "note 1" not in window.places, "end of the warning")
    window.quit()


def test_pictures_are_what_they_are_called(start, folder):
    window = start("shape:torus,resolution=40")
    window.settled()
    window.key("ctrl+p")
    for name in ("picture.svg", "picture.jpg"):
        window.save_as(folder / name)
        window.place("browser problem")
        expect("browser name" in window.places, "the dialogue has gone")
    window.save_as(folder / "picture.png")
    window.wait_for("message", text=f"wrote {folder / 'picture.png'}")
    expect((folder / "picture.png").read_bytes()[:4] == b"\x89PNG", "what is called .png is something else")
    window.quit()
    for name in ("picture.svg", "picture.jpg"):
        result = subprocess.run([start.tool, "view", "shape:torus", "-o", name], cwd=folder, capture_output=True,
                                text=True, env=dict(os.environ, DISPLAY=start.display))
        expect(result.returncode == 2 and "write .png" in result.stderr, f"{name}: {result.stderr}")
        expect(not (folder / name).exists(), f"{name} is written")


def type_into(window, name, text):
    window.click(name)
    window.key("ctrl+a")
    window.type(text)


def exported(window, path):
    window.click("export done")
    window.wait_for("message", text=f"wrote {path}")
    return path.read_bytes()


def rendered(start, folder, session, name, *more):
    subprocess.run([start.tool, "render", session, "--quiet", "--output", name, *more], cwd=folder, check=True,
                   stdout=subprocess.DEVNULL)
    return (folder / name).read_bytes()


def test_picture_is_exported(start, folder):
    window = start("shape:trefoil,resolution=40", "--stripes", "30", "--stripe-width", "3px")
    window.settled()
    since = window.now()
    window.drag_slider("option stripes", 0.6, 0.63)
    window.settled(since)
    save_session(window, folder / "session.json")
    window.menu("File", "Export picture...")
    window.click("export proportions of the window")
    type_into(window, "export width", "400")
    type_into(window, "export height", "300")
    window.click("export transparent background")
    type_into(window, "export name", "picture.png")
    expect(exported(window, folder / "picture.png") ==
           rendered(start, folder, "session.json", "rendered.png", "--size", "400x300", "--transparent",
                    "--scale-widths"), "brindle render draws another picture")
    window.key("ctrl+shift+p")
    type_into(window, "export name", "picture.svg")
    expect(exported(window, folder / "picture.svg") ==
           rendered(start, folder, "session.json", "rendered.svg", "--size", "400x300", "--scale-widths"),
           "brindle render makes another drawing")
    window.key("ctrl+shift+p")
    window.click("export unit")
    window.click("export millimetres")
    type_into(window, "export width", "50.8")
    type_into(window, "export height", "25.4")
    type_into(window, "export dpi", "200")
    window.place("export result 400 x 200 pixels, 50.8 x 25.4 mm at 200 pixels an inch")
    for width, name in (("5e4", "picture.png"), ("50", "picture.jpg"), ("50", "nowhere/picture.png")):
        type_into(window, "export width", width)
        type_into(window, "export name", name)
        window.place("export problem")
        window.click("export done")
        window.place("export done")
    type_into(window, "export name", "picture.png")
    before = (folder / "picture.png").read_bytes()
    window.wait_until(lambda: "export problem" not in window.places, "end of the problem")
    since = window.now()
    window.key("Return")
    window.place("export replace")
    window.key("Return")
    window.wait_for("message", since, text=f"wrote {folder / 'picture.png'}")
    expect((folder / "picture.png").read_bytes() != before, "the file is not replaced")
    window.quit()


def test_export_is_cancelled(start, folder):
    window = start("shape:torus,resolution=200", "--occlusion", "1")
    window.settled()
    window.key("ctrl+shift+p")
    type_into(window, "export width", "9000")
    type_into(window, "export name", "large.png")
    window.click("export done")
    window.click("cancel writing large.png")
    window.wait_for("message", text=f"cancelled: {folder / 'large.png'} is not written")
    expect(not list(folder.glob("*large*")), "something is left of it")
    window.key("ctrl+shift+p")
    type_into(window, "export name", "again.png")
    window.click("export done")
    window.place("cancel writing again.png")
    window.key("ctrl+q")
    window.wait_for("message", text="the window closes once again.png is written; cancel that to close it at once")
    window.last_click("cancel writing again.png")
    expect(window.process.wait(PATIENCE) == 0, "it does not quit once nothing is written any more")
    expect(not list(folder.glob("*again*")), "something is left of what was being written")


def test_coloured_views_have_legends(start, folder):
    window = start("shape:sphere,resolution=30", "--stripes", "20")
    window.settled()
    before = save_picture(window, folder / "stripes.png")
    for words in ("a stripe begins or ends", "angle between stripes and field"):
        expect(f"legend {words}" not in window.places, f"stripes have the legend '{words}'")
        since = window.now()
        window.key("b")
        window.settled(since)
        window.wait_until(lambda: f"legend {words}" in window.places, f"the legend '{words}'")
    since = window.now()
    window.menu("View", "stripes")
    window.settled(since)
    window.wait_until(lambda: not any(name.startswith("legend ") for name in window.places), "end of the legend")
    expect(save_picture(window, folder / "again.png") == before, "stripes are another picture now")
    window.quit()


def camera_of(window, path):
    return json.loads(save_session(window, path))["camera"]


def test_undo_leaves_the_camera(start, folder):
    window = start("shape:torus,resolution=40", "--stripes", "20")
    window.settled()
    first = camera_of(window, folder / "first.json")
    since = window.now()
    window.drag_slider("option stripes", 0.5, 0.7, 3)
    window.settled(since)
    since = window.now()
    window.drag([window.point("picture", 0.4), window.point("picture", 0.5), window.point("picture", 0.6)])
    window.settled(since)
    turned = camera_of(window, folder / "turned.json")
    expect(turned != first, "the picture does not turn")
    since = window.now()
    window.key("ctrl+z")
    window.settled(since)
    session = json.loads(save_session(window, folder / "undone.json"))
    expect(session["options"]["stripes"] == "20", "undo takes no edit back")
    expect(session["camera"] == turned, "undo turns the camera")
    for key, camera in (("alt+Left", first), ("alt+Right", turned)):
        since = window.now()
        window.key(key)
        window.settled(since)
        expect(camera_of(window, folder / f"{key}.json") == camera, f"{key} shows another view")
    since = window.now()
    window.menu("View", "Previous view")
    window.settled(since)
    expect(camera_of(window, folder / "menu.json") == first, "the menu shows another view")
    since = window.now()
    window.key("ctrl+y")
    window.settled(since)
    session = json.loads(save_session(window, folder / "redone.json"))
    expect(session["options"]["stripes"] != "20" and session["camera"] == first, "redo brings something else back")
    window.quit()


def test_solve_again(start, folder):
    window = start("shape:torus,resolution=60")
    window.settled()
    since = window.now()
    window.drag_slider("option stripes", 0.75, 0.76, 3)
    followed = window.settled(since)
    expect(followed["followed"], "the pattern does not follow")
    picture = save_picture(window, folder / "followed.png")
    since = window.now()
    window.key("n")
    anew = window.settled(since)
    expect(not anew["followed"] and anew["energy"] != followed["energy"], "it is not solved again")
    session = json.loads(save_session(window, folder / "anew.json"))
    expect("phases" not in session, "phases that were let go are saved")
    expect(save_picture(window, folder / "anew.png") != picture, "the picture is the same")
    since = window.now()
    window.key("ctrl+z")
    window.settled(since)
    expect(save_picture(window, folder / "back.png") == picture, "undo does not bring what followed back")
    since = window.now()
    window.click("solve again")
    expect(not window.settled(since)["followed"], "the button does nothing")
    window.quit()


def test_what_follows_the_light_fits_at_rest(start, folder):
    window = start("shape:torus,resolution=60", "--frequency-by", "light", "--stripes", "24")
    window.settled()
    since = window.now()
    window.drag([window.point("picture", 0.2 + 0.06 * i) for i in range(11)])
    rest = window.settled(since)
    seen = save_picture(window, folder / "seen.png")
    session = json.loads(save_session(window, folder / "session.json"))
    expect(("phases" in session) == rest["followed"], "phases are kept of what has not followed, or the reverse")
    subprocess.run([start.tool, "render", "session.json", "--output", "rendered.png"], cwd=folder, check=True,
                   stdout=subprocess.DEVNULL)
    expect((folder / "rendered.png").read_bytes() == seen, "brindle render draws another picture")
    session.pop("phases", None)
    (folder / "alone.json").write_text(json.dumps(session))
    subprocess.run([start.tool, "render", "alone.json", "--output", "alone.json.json"], cwd=folder, check=True,
                   stdout=subprocess.DEVNULL)
    alone = json.loads((folder / "alone.json.json").read_text())
    expect(rest["spacing_error"] <= alone["spacing_error_mean"] + 0.03, f"{rest} fits no more: {alone}")
    window.quit()


def search_option(window, text):
    window.click("search")
    window.key("ctrl+a")
    window.type(text)


def test_light_is_moved(start, folder):
    window = start("shape:torus,resolution=40", "--stripes", "20", "--width-by", "light")
    window.settled()
    before = save_picture(window, folder / "before.png")
    camera = camera_of(window, folder / "camera.json")
    window.key("i")
    at = window.point("light")
    since = window.now()
    window.drag([window.point("picture", 0.3 + 0.05 * i, 0.5 + 0.03 * i) for i in range(6)])
    window.settled(since)
    frames = [e for e in window.lines[since:] if e["event"] == "frame"]
    expect(any(not frame["final"] for frame in frames), "nothing was drawn while the light moved")
    now = window.point("light")
    expect(now[0] > at[0] + 5 and now[1] > at[1] + 5, f"the ball's light goes from {at} to {now}")
    seen = save_picture(window, folder / "seen.png")
    session = json.loads(save_session(window, folder / "session.json"))
    azimuth, elevation = map(float, session["options"]["light-from"].split(","))
    expect(-31 < azimuth < 90 and -60 < elevation < 39, f"the light comes from {azimuth}, {elevation}")
    expect(session["camera"] == camera, "the camera moves with the light")
    expect(seen != before, "another light shows the same")
    subprocess.run([start.tool, "render", "session.json", "--output", "rendered.png"], cwd=folder, check=True,
                   stdout=subprocess.DEVNULL)
    expect((folder / "rendered.png").read_bytes() == seen, "brindle render draws another picture")
    search_option(window, "light from")
    window.place("option light-from")
    since = window.now()
    window.drag([window.point("picture", 0.5), window.point("picture", 0.6)], button=3)
    window.settled(since)
    expect(camera_of(window, folder / "turned.json") != camera, "the right button does not turn the surface")
    since = window.now()
    window.key("Escape", "ctrl+z")
    window.settled(since)
    expect("light-from" not in options_of(window, folder / "undone.json"), "a drag is not one step to undo")
    window.quit()


def place_under_mouse(window):
    def find():
        for name in window.places:
            if name.startswith("value place "):
                return [float(number) for number in name.removeprefix("value place ").split(",")]
        return None
    window.move(*window.point("picture", 0.5, 0.51))
    window.move(*window.point("picture"))
    return window.wait_until(find, "place under the mouse")


def expect_word_of_empty_slices(window, folder):
    since = window.now()
    window.drag_slider("option slice", 0.65, 0.9)  # to the end, where the front is: something is left
    frame = window.settled(since)
    expect(frame["nothing_left"] == "", "something is left where the plane is behind all")
    since = window.now()
    window.drag_slider("option slice", 0.65, 0.0)
    frame = window.settled(since)
    expect("leaves nothing" in frame["nothing_left"], "an empty picture says nothing")
    window.place("why empty")
    path = folder / "empty.png"
    window.key("ctrl+p")
    since = window.now()
    window.save_as(path)
    window.wait_for("message", since, kind="error", text=frame["nothing_left"])
    expect(not path.exists(), "an empty picture is saved")
    window.key("ctrl+shift+p")
    window.place("export problem")
    window.key("Escape")
    for _ in range(2):
        since = window.now()
        window.key("ctrl+z")
        frame = window.settled(since)
    expect(frame["nothing_left"] == "" and "why empty" not in window.places, "undo does not bring it back")


def test_slice_opens_the_surface(start, folder):
    window = start("shape:sphere,resolution=40", "--stripes", "20", "--camera", "0,0", "--up", "y")
    window.settled()
    expect(place_under_mouse(window)[2] > 0.9, "the front is not seen")
    search_option(window, "cut open")
    window.click("slice axis")
    since = window.now()
    window.click("choice slice z")
    window.settled(since)
    expect(options_of(window, folder / "half.json").get("slice") == "z=50%", "no slice through the middle")
    expect(place_under_mouse(window)[2] < -0.9, "the mouse does not reach what is seen within")
    since = window.now()
    window.drag_slider("option slice", 0.5, 0.65)
    window.settled(since)
    frames = [e for e in window.lines[since:] if e["event"] == "frame"]
    expect(any(not frame["final"] for frame in frames), "nothing was drawn while the plane moved")
    expect(not any("solve" in str(frame["stages"]) for frame in frames), "a slice is solved for")
    seen = save_picture(window, folder / "seen.png")
    session = json.loads(save_session(window, folder / "session.json"))
    percent = float(session["options"]["slice"].removeprefix("z=").removesuffix("%"))
    expect(5 < percent < 95 and percent != 50, f"the slider says {percent}")
    subprocess.run([start.tool, "render", "session.json", "--output", "rendered.png"], cwd=folder, check=True,
                   stdout=subprocess.DEVNULL)
    expect((folder / "rendered.png").read_bytes() == seen, "brindle render draws another picture")
    since = window.now()
    window.key("Escape", "ctrl+z")
    window.settled(since)
    expect(options_of(window, folder / "undone.json").get("slice") == "z=50%", "a drag is not one step to undo")
    expect_word_of_empty_slices(window, folder)
    window.click("slice axis")
    since = window.now()
    window.click("choice slice not")
    window.settled(since)
    expect("slice" not in options_of(window, folder / "whole.json"), "the slice stays")
    window.quit()


def test_bad_file_dropped(start, folder):
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


def test_video_is_recorded_or_refused(start, folder):
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


def test_video_without_or_with_a_broken_ffmpeg(start, folder):
    programs = folder / "bin"
    programs.mkdir()
    (programs / "xdotool").symlink_to(shutil.which("xdotool"))
    window = start("shape:trefoil,resolution=30", environment={"PATH": str(programs)})
    window.settled()
    since = window.now()
    window.key("r")
    message = window.wait_for("message", since, kind="error")["text"]
    expect("ffmpeg is not installed" in message and "install the package" in message, f"it says: {message}")
    expect("browser name" not in window.places, "it asks for a file though there is nothing to write it with")
    (programs / "ffmpeg").write_text("#!/bin/sh\nexit 3\n")
    (programs / "ffmpeg").chmod(0o755)
    video = folder / "turn.mp4"
    window.key("r")
    since = window.now()
    window.save_as(video)
    window.drag([window.point("picture", 0.3 + 0.05 * i) for i in range(6)])
    message = window.wait_for("message", since, kind="error")["text"]
    expect("turn.mp4" in message and "ffmpeg" in message, f"it says: {message}")
    expect(not video.exists(), "a broken video is there")
    window.quit()


def close_by_window_manager(window):
    """As the button of a window's frame does."""
    from Xlib import X, display
    from Xlib.protocol import event

    connection = display.Display(window.display)
    target = connection.create_resource_object("window", int(window.id))
    data = [connection.intern_atom("WM_DELETE_WINDOW"), X.CurrentTime, 0, 0, 0]
    target.send_event(event.ClientMessage(window=target, client_type=connection.intern_atom("WM_PROTOCOLS"),
                                          data=(32, data)))
    connection.sync()
    connection.close()


def test_window_manager_closes_it(start, folder):
    window = start("shape:torus,resolution=40")
    window.settled()
    close_by_window_manager(window)
    expect(window.process.wait(PATIENCE) == 0, "it does not close, or not with 0")
    window = start("shape:torus,resolution=40")
    window.settled()
    since = window.now()
    window.drag_slider("option stripes", 0.5, 0.7, 3)
    changed = window.settled(since)
    close_by_window_manager(window)
    window.click("quit cancel")
    expect(window.process.poll() is None, "it closes though it was told not to")
    since = window.now()
    window.key("ctrl+z")
    expect(window.settled(since)["energy"] != changed["energy"], "the window does not go on")
    window.key("ctrl+shift+z")
    close_by_window_manager(window)
    window.place("quit discard")
    close_by_window_manager(window)  # impatient: the question stays
    window.last_click("quit discard")
    expect(window.process.wait(PATIENCE) == 0, "it does not close once that is answered")


def test_lost_context_keeps_the_work(start, folder):
    if shutil.which("cc") is None:
        pytest.skip("without a C compiler no context is lost")
    source = ROOT / "tests/window/lost_context.c"
    library = folder / "lost_context.so"
    subprocess.run(["cc", "-shared", "-fPIC", "-o", library, source], check=True)
    sign = folder / "sign"
    for number, name in ((1, "rescued.json"), (2, "rescued-2.json"), (3, None)):
        window = start("shape:torus,resolution=40",
                       environment={"LD_PRELOAD": str(library), "LOST_CONTEXT_SIGN": str(sign)})
        window.settled()
        since = window.now()
        if name is not None:
            window.type_into_slider("option stripes", str(20 + number))
            window.settled(since)
        sign.write_text("")
        expect(window.process.wait(PATIENCE) == 1, "it does not end with 1")
        window.errors.seek(0)
        said = window.errors.read()
        expect("OpenGL was lost" in said and "start brindle view again" in said, f"it says: {said}")
        sign.unlink()
        kept = folder / "config" / "brindle"
        if name is None:
            expect("not saved" not in said and not (kept / "rescued-3.json").exists(), "nothing is kept")
            continue
        expect(str(kept / name) in said, f"it does not say where the work is: {said}")
        session = json.loads((kept / name).read_text())
        expect(session["options"]["stripes"] == str(20 + number), f"kept is {session}")
    window = start(str(kept / "rescued.json"))
    window.settled()
    window.quit()


def test_quit_while_solving(start, folder):
    window = start("shape:sphere,resolution=400")
    window.wait_for("widgets")
    window.hand()
    window.quit()
    expect(window.wait_until_end()["busy"], "it was not solving any more")


def test_what_is_refused(start, folder):
    for arguments, code in ((["no_such_mesh.ply", "--stripes", "-3"], 2),
                            (["shape:torus", "--field-mesh", "none.vtp,within=3"], 2)):
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
    end = time.monotonic() + PATIENCE
    while time.monotonic() < end:
        if not select.select([connection.fileno()], [], [], 0.2)[0] and not connection.pending_events():
            continue
        received = connection.next_event()
        if received.type == X.ClientMessage and received.client_type == atom("XdndStatus"):
            send("XdndDrop", 0, X.CurrentTime)
        elif received.type == X.SelectionRequest:
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


def options_of(window, path):
    return json.loads(save_session(window, path))["options"]


def test_gallery_needle_is_dragged(start, folder):
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


def test_place_follows_mouse(start, folder):
    window = start("shape:sphere,resolution=40", "--width-by", "distance:1,0,0")
    window.settled()
    window.click("place at mouse")
    since = window.now()
    x, y = window.point("picture", 0.4)
    window.sweep([(x + 4 * i, y) for i in range(20)], button=0)
    window.settled(since)
    frames = [e for e in window.lines[since:] if e["event"] == "frame" and not e["final"]]
    expect(frames and "solve" not in frames[-1]["stages"], "widths do not follow, or all is solved again")
    window.wait_until(lambda: any(e["event"] == "command" and e["what"]["command"] == "end_drag"
                                  for e in window.lines[since:]), "end of the motion")
    expect(options_of(window, folder / "moved.json")["width-by"] != "distance:1,0,0", "the place stays")
    window.key("ctrl+z")
    expect(options_of(window, folder / "undone.json")["width-by"] == "distance:1,0,0", "no single undo")
    window.quit()


PLATE = "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n"


def test_opening_asks_for_what_is_not_saved(start, folder):
    (folder / "plate.obj").write_text(PLATE)
    window = start("shape:sphere,resolution=40", "--stripes", "16")
    window.settled()
    save_session(window, folder / "other.json")
    since = window.now()
    window.drag_slider("option stripes", 0.5, 0.7, 3)
    window.settled(since)
    drop(window, folder / "other.json")
    window.click("open cancel")
    stripes = options_of(window, folder / "kept.json")["stripes"]  # which saves, so that nothing is asked
    expect(stripes != "16", "the session is opened though it was told not to")
    since = window.now()
    drop(window, folder / "other.json")
    window.settled(since)
    expect("open cancel" not in window.places, "it asks though all is saved")
    window.click("tool Comb")
    window.drag([window.point("picture", 0.35 + 0.05 * i, 0.4 + 0.03 * i) for i in range(6)])
    since = window.now()
    drop(window, folder / "plate.obj")
    window.click("open discard")
    window.settled(since)
    session = json.loads(save_session(window, folder / "plate.json"))
    expect(session["mesh"] == str(folder / "plate.obj") and "strokes" not in session, f"it is not opened: {session}")
    since = window.now()
    window.key("ctrl+z")
    window.settled(since)
    window.menu("File", "Shape", "torus")
    since = window.now()
    window.click("open save")  # into the file of the session
    window.wait_for("message", since, text=f"wrote {folder / 'plate.json'}")
    window.settled(since)
    session = json.loads((folder / "plate.json").read_text())
    expect(len(session["strokes"]) == 1, "the stroke is not saved first")
    expect(json.loads(save_session(window, folder / "torus.json"))["mesh"] == "shape:torus", "no torus is opened")
    window.quit()


def test_shapes_keep_strokes_or_say_why_not(start, folder):
    window = start("shape:sphere,resolution=40", "--stripes", "16")
    window.settled()
    window.click("tool Comb")
    since = window.now()
    window.drag([window.point("picture", 0.35 + 0.03 * i, 0.62) for i in range(6)])
    window.settled(since)
    before = save_session(window, folder / "before.json")
    strokes = json.loads(before)["strokes"]
    expect(strokes, "no stroke is drawn")
    window.key("v")
    window.menu("File", "Shape", "Parameters...")
    since = window.now()
    window.type_into_slider("shape resolution", "50")
    window.settled(since)
    finer = json.loads(save_session(window, folder / "finer.json"))
    expect("resolution=50" in finer["mesh"] and finer["strokes"] == strokes, "another resolution takes strokes away")
    since = window.now()
    window.type_into_slider("shape radius", "3")
    window.wait_for("message", since, kind="error")
    failure = window.wait_for("failure", since)
    expect(failure["taken_back"], "what does not work stays")
    said = [e["text"] for e in window.lines[since:] if e["event"] == "message"][-1]
    expect("stroke" in said and "from the surface" in said, f"it says {said}")
    window.settled()
    expect(json.loads(save_session(window, folder / "back.json")) == finer, "the shape before is not back")
    since = window.now()
    window.key("ctrl+z")
    window.settled(since)
    expect(save_session(window, folder / "undone.json") == before, "undo does not bring the first shape back")
    window.quit()


def test_what_takes_long_is_cancelled(start, folder):
    window = start("shape:sphere,resolution=20")
    window.settled()
    before = save_session(window, folder / "before.json")
    window.menu("File", "Shape", "Parameters...")
    since = window.now()
    window.type_into_slider("shape resolution", "1500")
    window.wait_until(lambda: "cancel working" in window.places, "bar that cancels")
    window.click("cancel working")
    window.wait_for("message", since, kind="error", text="cancelled: all is as it was before")
    expect(window.wait_for("failure", since)["taken_back"], "what was cancelled stays")
    window.hand()
    window.wait_until(lambda: "cancel working" not in window.places, "end of the bar")
    expect(save_session(window, folder / "after.json") == before, "the shape before is not back")
    picture = folder / "window.png"
    window.key("Escape")
    window.menu("File", "Save picture of the window...")
    window.save_as(picture)
    window.wait_for("message", text=f"wrote {picture}")
    expect(window.places.get("browser name") is None, "the dialogue is still there")
    window.quit()


def test_surfaces_have_their_styles(start, folder):
    window = start("shape:torus,resolution=40", "--stripes", "16")
    window.settled()

    def others(name):
        values = options_of(window, folder / name).get("with", [])
        return [values] if isinstance(values, str) else values

    search_option(window, "other surfaces")
    window.click("other surfaces")
    since = window.now()
    window.click("add surface shape")
    window.settled(since)
    window.click("surface looks")
    since = window.now()
    window.click("surface looks striped")
    window.settled(since)
    expect(others("striped.json") == ["shape:sphere@striped"], "the sphere is not striped")
    since = window.now()
    window.type_into_slider("surface stripes", "12")
    window.settled(since)
    since = window.now()
    window.drag_slider("surface width", 0.5, 0.25)
    frame = window.settled(since)
    expect(frame["final"], "no final picture")
    since = window.now()
    window.type_into_slider("surface place z", "1.5")
    window.settled(since)
    seen = save_picture(window, folder / "seen.png")
    (text,) = others("styled.json")
    expect(text.startswith("shape:sphere@striped@stripes=12@stripe-width=0.") and text.endswith("@0,0,1.5"),
           f"the style is {text}")
    subprocess.run([start.tool, "render", "styled.json", "--output", "rendered.png"], cwd=folder, check=True,
                   stdout=subprocess.DEVNULL)
    expect((folder / "rendered.png").read_bytes() == seen, "brindle render draws another picture")
    window.click("other surfaces")
    since = window.now()
    window.click("add surface shape")
    window.settled(since)
    expect(others("two.json") == [text, "shape:sphere"], "a second surface changes the first")
    window.click("other surfaces")
    window.click("other surface 1")
    since = window.now()
    window.click("remove surface")
    window.settled(since)
    expect(others("one.json") == ["shape:sphere"], "another one than the chosen is left out")
    since = window.now()
    window.key("ctrl+z")
    window.settled(since)
    expect(others("back.json") == [text, "shape:sphere"], "undo does not bring it back")
    window.quit()


MEASURED_SQUARE = """ply
format ascii 1.0
element vertex 4
property float x
property float y
property float z
property float speed
element face 2
property list uchar int vertex_indices
end_header
-1 -1 0 1
1 -1 0 2
1 1 0 4
-1 1 0 8
3 0 1 2
3 0 2 3
"""


def test_surfaces_have_values_and_tiles(start, folder):
    square = folder / "square.ply"
    square.write_text(MEASURED_SQUARE)
    window = start("shape:torus,resolution=40", "--stripes", "16", "--with", f"{square}@0,0,1")
    window.settled()

    def style(name):
        text = options_of(window, folder / name)["with"]
        return text.removeprefix(str(square))

    def change(*widgets):
        *steps, last = widgets
        for step in steps:
            window.click(step)
        since = window.now()
        window.click(last)
        window.settled(since)

    search_option(window, "other surfaces")
    change("surface values", "surface values array:speed")
    expect(style("array.json") == "@color-by=array:speed@0,0,1", "the array is not in the list")
    change("surface outlined")
    change("surface looks", "surface looks tiles")
    tiled = style("tiles.json")
    expect(tiled == "@texture=dots@color-by=array:speed@outlined@0,0,1", f"the style is {tiled}")
    change("surface tile", "surface tile plus")
    since = window.now()
    window.type_into_slider("surface stripes", "6")
    window.settled(since)
    change("surface looks", "surface looks tiles alone")
    wanted = "@discarded@texture=plus@stripes=6@color-by=array:speed@outlined@0,0,1"
    alone = style("alone.json")
    expect(alone == wanted, f"the style is {alone}")
    seen = save_picture(window, folder / "seen.png")
    subprocess.run([start.tool, "render", "alone.json", "--output", "rendered.png"], cwd=folder, check=True,
                   stdout=subprocess.DEVNULL)
    expect((folder / "rendered.png").read_bytes() == seen, "brindle render draws another picture")
    window.click("surface value")
    window.key("ctrl+a")
    window.type("light")
    since = window.now()
    window.key("Return")
    said = window.wait_for("message", since)["text"]
    expect("first surface alone" in said, f"what is not for other surfaces says: {said}")
    expect(style("same.json") == wanted, "what is refused has changed the style")
    window.quit()


def test_recent_files_can_be_read(start, folder):
    for name in ("good.obj", "gone.obj", "bad.obj"):
        (folder / name).write_text(PLATE)
    window = start("shape:torus,resolution=40")
    window.settled()
    for name in ("gone.obj", "bad.obj", "good.obj"):
        since = window.now()
        window.key("ctrl+o")
        window.save_as(folder / name)
        window.settled(since)
    (folder / "gone.obj").unlink()
    (folder / "bad.obj").write_text("v 0 0 zero\n")
    for name in ("gone.obj", "bad.obj"):
        since = window.now()
        window.menu("File", "Open recent", str(folder / name))
        message = window.wait_for("message", since, kind="error")["text"]
        expect(name in message and "no longer among the recent files" in message, f"it says: {message}")
    window.click("menu File")
    window.click("item Open recent")
    window.place(f"item {folder / 'good.obj'}")
    expect(not {f"item {folder / name}" for name in ("gone.obj", "bad.obj")} & set(window.places),
           "what cannot be read stays in the list")
    window.quit()
    recent = json.loads((folder / "config" / "brindle" / "window.json").read_text())["recent"]
    expect(str(folder / "good.obj") in recent and str(folder / "bad.obj") not in recent, f"kept are {recent}")


def test_quit_asks_for_what_is_not_saved(start, folder):
    window = start("shape:torus,resolution=40")
    window.settled()
    since = window.now()
    window.drag([window.point("picture", 0.4), window.point("picture", 0.5)])  # a view alone is nothing to lose
    window.settled(since)
    since = window.now()
    window.drag_slider("option stripes", 0.5, 0.7, 3)
    window.settled(since)
    window.key("ctrl+q")
    window.click("quit cancel")
    expect(window.process.poll() is None, "it quits though it was told not to")
    window.key("ctrl+q")
    window.click("quit save")
    window.save_as(folder / "kept.json", last=True)
    expect(window.process.wait(PATIENCE) == 0, "it does not quit once all is saved")
    options = json.loads((folder / "kept.json").read_text())["options"]
    expect("stripes" in options, "what was saved is not what was shown")
    window = start("kept.json")
    window.settled()
    window.xdotool("key", "ctrl+q")
    expect(window.process.wait(PATIENCE) == 0, "it asks though nothing has changed")
