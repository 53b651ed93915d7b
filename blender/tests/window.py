"""Runs in a window of Blender: panels are drawn, settings change results, undo takes them back.

    blender --factory-startup --window-geometry 0 0 1280 900 --python window.py -- --output FILE.jpg
"""
import os
import subprocess
import sys
import traceback

import addon_utils
import bpy
import numpy as np

addon_utils.enable("brindle_blender")
bpy.context.preferences.view.show_splash = False
bpy.context.preferences.system.use_region_overlap = False
sys.path.append(os.path.dirname(__file__))

import checks  # noqa: E402
from brindle_blender import evaluated, nodes  # noqa: E402


def phases():
    mesh = bpy.context.window_manager.windows[0].view_layer.objects.active.data
    if nodes.PHASE not in mesh.attributes:
        return None
    return evaluated.column(mesh.attributes[nodes.PHASE].data, "vector", np.float32, 3)


def in_view():
    """The context of the 3D view, where operators run."""
    window = bpy.context.window_manager.windows[0]
    area = next(area for area in window.screen.areas if area.type == "VIEW_3D")
    region = next(region for region in area.regions if region.type == "WINDOW")
    return bpy.context.temp_override(window=window, area=area, region=region)


def settings():
    return bpy.context.window_manager.windows[0].view_layer.objects.active.brindle


def mouse(*words):
    subprocess.run(["xdotool", *map(str, words)], check=True)


def drag(start, end):
    """Drags in steps, between which Blender runs."""
    mouse("mousemove", *start)
    yield
    mouse("mousedown", 1)
    for share in (0.1, 0.3, 0.5, 0.7, 0.9, 1):
        yield
        mouse("mousemove", *(round(a + share * (b - a)) for a, b in zip(start, end)))
    yield
    mouse("mouseup", 1)
    yield


def shot(path):
    """A picture of the 3D view."""
    with in_view():
        bpy.ops.screen.screenshot_area(filepath=path)
    scene = bpy.context.scene  # whose settings the file has
    scene.view_settings.view_transform = "Standard"
    scene.render.image_settings.file_format, scene.render.image_settings.quality = "JPEG", 88
    bpy.data.images.load(path).save_render(path, scene=scene)
    scene.render.image_settings.file_format = "PNG"


def steps():
    """Each step ends where Blender may draw."""
    with in_view():
        space = bpy.context.space_data
        space.show_region_ui, space.shading.type = True, "MATERIAL"
        bpy.data.objects.remove(bpy.data.objects["Cube"])
        bpy.ops.mesh.primitive_torus_add(major_segments=96, minor_segments=32, minor_radius=0.5)
        bpy.ops.object.shade_smooth()
        bpy.ops.ed.undo_push(message="torus")
    yield
    # No call opens a tab of the sidebar or widens it.
    mouse("mousemove", 1044, 248, "click", 1)
    yield
    yield from drag((829, 760), (690, 760))
    with in_view():
        bpy.ops.view3d.view_selected()
        assert bpy.ops.brindle.make("EXEC_DEFAULT", True, kind="STRIPES") == {"FINISHED"}
    first = phases()
    assert first is not None
    yield
    steps = []
    for _ in drag((960, 585), (936, 585)):
        steps.append(settings().stripes)
        yield
    print("stripes while the slider was dragged:", steps)
    assert len({*steps}) > 2 and not np.array_equal(first, phases())
    second, stripes = phases(), settings().stripes
    yield
    with in_view():
        bpy.ops.ed.undo()
    assert settings().stripes == 40 and np.array_equal(phases(), first)
    yield
    with in_view():
        bpy.ops.ed.undo()
    assert phases() is None and not settings().made
    yield
    with in_view():
        bpy.ops.ed.redo()
        bpy.ops.ed.redo()
    assert settings().stripes == stripes and np.array_equal(phases(), second)
    yield
    shot(os.path.abspath(sys.argv[-1]))
    with in_view():
        checks.check_nodes_draw_what_corners_hold("BLENDER_EEVEE")


def run(waiting=steps()):
    try:
        next(waiting)
        return 0.7
    except StopIteration:
        print("window: all done", flush=True)
        os._exit(0)
    except BaseException:
        traceback.print_exc()
        sys.stderr.flush()
        os._exit(1)


bpy.app.timers.register(run, first_interval=2)
