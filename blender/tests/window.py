"""Runs in a window of Blender: panels are drawn, settings change results, undo takes them back."""
import os
import sys
import traceback

import addon_utils
import bpy
import numpy as np

addon_utils.enable("brindle_blender")
bpy.context.preferences.view.show_splash = False
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


def shot(name):
    with in_view():
        bpy.ops.screen.screenshot(filepath=os.path.join(os.environ["BRINDLE_PICTURES"], name))


def steps():
    """Each step ends where Blender may draw."""
    with in_view():
        space = bpy.context.space_data
        space.show_region_ui, space.shading.type = True, "MATERIAL"
        bpy.data.objects.remove(bpy.data.objects["Cube"])
        bpy.ops.mesh.primitive_torus_add(major_segments=96, minor_segments=32, minor_radius=0.5)
        bpy.ops.object.shade_smooth()
        bpy.ops.view3d.view_selected()
        bpy.ops.ed.undo_push(message="torus")
    yield
    # No call opens a tab of the sidebar, so the panels move to the tab that is open.
    from brindle_blender import panel
    for cls in panel.CLASSES[1:]:
        bpy.utils.unregister_class(cls)
    for cls in panel.CLASSES[1:]:
        cls.bl_category = "Item"
        cls.bl_options = set()
        bpy.utils.register_class(cls)
    with in_view():
        assert bpy.ops.brindle.make("EXEC_DEFAULT", True, kind="STRIPES") == {"FINISHED"}
    first = phases()
    assert first is not None
    yield
    with in_view():
        settings().stripes = 20
        bpy.ops.ed.undo_push(message="stripes")
    second = phases()
    assert not np.array_equal(first, second)
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
    assert settings().stripes == 20 and np.array_equal(phases(), second)
    yield
    shot("window.png")
    with in_view():
        checks.check_nodes_draw_what_corners_hold("BLENDER_EEVEE")


def run(todo=steps()):
    try:
        next(todo)
        return 0.7
    except StopIteration:
        print("window: all done", flush=True)
        os._exit(0)
    except BaseException:
        traceback.print_exc()
        sys.stderr.flush()
        os._exit(1)


bpy.app.timers.register(run, first_interval=2)
