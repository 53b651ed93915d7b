"""Results that follow their objects: when a setting changes, and frame by frame."""
import sys
import warnings

import bpy
import brindle
from bpy.app.handlers import persistent

from .patterns import Pattern
from .results import lay

FOLLOWING = ("STRIPES", "TEXTURE", "CURVES")
_last = {}  # by names of objects: the frame, and its pattern


def make(obj, depsgraph, kinds, last=None):
    """Makes these kinds of results; returns warnings. Errors change nothing."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always", brindle.PatternWarning)
        pattern = Pattern(obj, depsgraph, last)
        lay(obj, pattern, kinds)
    pattern.forget()
    _last[obj.name] = depsgraph.scene.frame_current, pattern
    return [str(warning.message) for warning in caught]


def on_change(settings, context):
    """Repeats what was made after a change of a setting."""
    if not (settings.live and settings.made):
        return
    settings.message = _errors_of(lambda: make(settings.id_data, context.evaluated_depsgraph_get(), settings.made))


def _errors_of(job):
    """The message of an error, for the panel; renders without a window have the console alone."""
    try:
        job()
    except (brindle.Error, TypeError) as error:
        print("Brindle:", error, file=sys.stderr)
        return str(error)
    return ""


@persistent
def on_frame(scene, depsgraph):
    """Goes on from the last frame, or starts again if time went back."""
    for obj in scene.objects:
        if obj.type != "MESH" or not obj.brindle.follow or obj.mode != "OBJECT":
            continue
        kinds = obj.brindle.made & set(FOLLOWING)
        frame, pattern = _last.get(obj.name, (scene.frame_current + 1, None))
        if not kinds or (pattern and frame == scene.frame_current):
            continue
        last = pattern if frame < scene.frame_current else None
        obj.brindle.message = _errors_of(lambda: make(obj, depsgraph, kinds, last))


@persistent
def on_load(*_):
    _last.clear()


def register():
    bpy.app.handlers.frame_change_post.append(on_frame)
    bpy.app.handlers.load_pre.append(on_load)


def unregister():
    bpy.app.handlers.frame_change_post.remove(on_frame)
    bpy.app.handlers.load_pre.remove(on_load)
    _last.clear()
