"""Settings of an object. Properties are made from the rows of Brindle's table of options."""
import dataclasses

import bpy
import brindle
import numpy as np
from bpy.props import (BoolProperty, EnumProperty, FloatProperty, FloatVectorProperty, IntProperty,
                       PointerProperty, StringProperty)

ROWS = brindle.advanced.option_rows()
_SHOWN = ("flag", "choice", "whole", "number", "length")
_LARGEST = 1e9
_SOME_LENGTH = 0.1  # where an option has no default


def _rows_of(names):
    return [name for name in names if ROWS.get(name, {}).get("kind") in _SHOWN]


def _fields_of(group):
    names = [field.name for field in dataclasses.fields(group)]
    return _rows_of("solver" if name == "name" else name for name in names)


# The options that the add-on shows, by the functions that take them.
SURFACE = ["crease_angle"]
SMOOTH = _rows_of(brindle.Surface.smooth_field.__kwdefaults__)
TURN = ["rotate", "along"]
SPACING = ["stripes", "spacing"]
LAYOUT = _fields_of(brindle.Layout)
MEASURED = _fields_of(brindle.Measured)
SOLVER = _fields_of(brindle.Solver)
CURVES = _rows_of(brindle.Stripes.curves.__kwdefaults__)
FRAMES = ["lambda"]
OPTIONS = [*SURFACE, "curvature_direction", *SMOOTH, *TURN, *SPACING, "slack", "oriented", *LAYOUT, *MEASURED,
           *SOLVER, *CURVES, "tube_radius", "min_distance", *FRAMES]


def is_optional(name):
    """Whether the option has no default, so that a switch is before its value."""
    return ROWS[name]["kind"] != "flag" and not ROWS[name]["standard"]


def _numbers(row, kind):
    (least, most), (lowest, highest) = row["range"], row["slider"]
    limits = {"min": max(least, -_LARGEST), "max": min(most, _LARGEST)}
    if row["kind"] == "length":
        return {**limits, "soft_min": limits["min"], "soft_max": _LARGEST, "default": _SOME_LENGTH}
    first = kind(float(row["standard"] or max(lowest, least)))
    return {"min": kind(limits["min"]), "max": kind(limits["max"]), "soft_min": kind(lowest),
            "soft_max": kind(highest), "default": first}


def _property_of(name, update):
    row = ROWS[name]
    label = (row["words"] or name.replace("_", " ")).capitalize()
    common = {"name": label, "description": row["help"][0].upper() + row["help"][1:], "update": update}
    if row["kind"] == "flag":
        return BoolProperty(**common)
    if row["kind"] == "choice":
        words = row["form"].split("|")
        return EnumProperty(items=[(word, word.replace("_", " ").capitalize(), "") for word in words],
                            default=row["standard"] or words[0], **common)
    if row["kind"] == "whole":
        return IntProperty(**_numbers(row, int), **common)
    subtype = "DISTANCE" if row["kind"] == "length" else "NONE"
    lowest, highest = row["slider"]
    step = min(max(round(highest - lowest), 1), 100)  # hundredths per pixel of a drag
    return FloatProperty(subtype=subtype, precision=3, step=step, **_numbers(row, float), **common)


def _of_rows(update):
    properties = {}
    for name in OPTIONS:
        properties[name] = _property_of(name, update)
        if is_optional(name):
            label = (ROWS[name]["words"] or name.replace("_", " ")).capitalize()
            properties["use_" + name] = BoolProperty(name=label, description="Use this option", update=update)
    return properties


FIELDS = [("SMOOTH", "Smooth", "The smoothest field, and lines that guide it"),
          ("CURVATURE", "Curvature", "Principal curvature, smoothed, and lines that guide it"),
          ("VECTOR", "Vector", "One vector in the axes of the object"),
          ("ATTRIBUTE", "Attribute", "A vector attribute of points or faces")]
KINDS = [("STRIPES", "Stripes", "A material with stripes that are sharp at any zoom"),
         ("TEXTURE", "Texture", "A UV map along and across the field, and a material that shows it"),
         ("CROSSES", "Crosses", "A UV map of square tiles along a cross field, and a material that shows it"),
         ("CURVES", "Curves", "Centre lines of the stripes as a curve object"),
         ("SAMPLES", "Samples", "Evenly spaced points with normals, ready for instances")]


def _own(update):
    """Properties of Blender's side, which the table of options does not have."""
    def is_curve(_, other):
        return other.type == "CURVE"

    return {
        "field": EnumProperty(name="Field", items=FIELDS, description="Direction across which stripes run",
                              update=update),
        "vector": FloatVectorProperty(name="Vector", subtype="XYZ", default=(1, 0, 0), update=update),
        "attribute": StringProperty(name="Attribute", description="Name of a vector attribute", update=update),
        "stroke_object": PointerProperty(name="Curves", type=bpy.types.Object, poll=is_curve, update=update,
                                         description="Curve object that the smooth field follows"),
        "use_annotations": BoolProperty(name="Annotations", update=update,
                                        description="The smooth field follows annotations on the surface"),
        "use_marked_edges": BoolProperty(name="Marked edges", update=update,
                                         description="The smooth field follows edges marked sharp or as creases"),
        "stroke_radius": FloatProperty(name="Radius", subtype="DISTANCE", default=0.1, min=1e-6, update=update,
                                       description="Distance over which lines guide the field"),
        "stroke_strength": FloatProperty(name="Strength", default=1, min=0, soft_max=10, update=update,
                                         description="Attraction to lines, relative to the neighbours"),
        "instance": PointerProperty(name="Instance", type=bpy.types.Object, update=update,
                                    description="Object to place at every sample"),
        "live": BoolProperty(name="Live", default=True,
                             description="Repeat what was made whenever a setting changes"),
        "follow": BoolProperty(name="Follow animation", update=update,
                               description="Repeat stripes, curves and texture at every frame, near to the "
                                           "last frame's"),
        "made": EnumProperty(items=KINDS, options={"ENUM_FLAG"}),
        "message": StringProperty(),
        "curves_object": PointerProperty(type=bpy.types.Object),
        "samples_object": PointerProperty(type=bpy.types.Object),
        "data_object": PointerProperty(type=bpy.types.Object),
    }


def settings_class(update):
    """The class of `object.brindle`; `update` is called when one of its properties changes."""
    return type("BrindleSettings", (bpy.types.PropertyGroup,),
                {"__annotations__": {**_of_rows(update), **_own(update)}})


def value_of(settings, name):
    """The value as it is shown: Blender's numbers are floats, which have 0.05000000074505806 for 0.05."""
    def shown(number):
        return float(str(np.float32(number))) if isinstance(number, float) else number

    value = getattr(settings, name)
    return tuple(map(shown, value)) if name == "vector" else shown(value)


def is_on(settings, name):
    """Whether an option differs from its default."""
    if is_optional(name):
        return getattr(settings, "use_" + name)
    return getattr(settings, name) != settings.bl_rna.properties[name].default


def has_effect(settings, name):
    """Whether a part's owner is on, and no option that excludes this one."""
    row = ROWS[name]
    owners = [owner.replace("-", "_") for owner in row["part_of"].split()]
    owners = [owner for owner in owners if owner in OPTIONS and ROWS[owner]["kind"] != "choice"]
    rivals = [other.replace("-", "_") for other in row["excludes"].split()]
    return ((not owners or any(is_on(settings, owner) for owner in owners))
            and not any(other in OPTIONS and is_optional(other) and is_on(settings, other) for other in rivals))


def given(settings, names):
    """The arguments of Brindle's functions that differ from the defaults."""
    return {name: value_of(settings, name) for name in names if is_on(settings, name) and has_effect(settings, name)}
