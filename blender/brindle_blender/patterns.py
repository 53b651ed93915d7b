"""Fields and patterns of an object, by its settings. Nothing here changes Blender's data."""
from functools import cached_property

import brindle
import numpy as np

from . import settings as rows
from .corners import stripe_corners, uv_corners, whole_triangles
from .evaluated import EvaluatedMesh, column, remembered
from .nodes import BRANCH, PHASE, UV

_CURVATURE_ANCHOR = brindle.Surface.curvature_field.__kwdefaults__["anchor"]


class Pattern:
    """What an object's settings make of its evaluated mesh. It stays near to `last`, the pattern of the
    frame before."""

    _smooth = {}

    def __init__(self, obj, depsgraph, last=None):
        self.settings = obj.brindle
        self.depsgraph = depsgraph
        self.last = last
        self.to_object = np.array(obj.matrix_world.inverted_safe())
        self.mesh = EvaluatedMesh(obj, depsgraph, rows.value_of(obj.brindle, "crease_angle"), last and last.mesh)

    def forget(self):
        """Lets go of the pattern before, which has let go of its own."""
        self.last = None

    def given(self, names):
        return rows.given(self.settings, names)

    # --- fields -------------------------------------------------------------------------------

    def field(self, symmetry=2):
        """(n, 3) directions; a smooth field goes on from that of the frame before."""
        settings, surface = self.settings, self.mesh.surface
        if settings.field == "VECTOR":
            return surface.projected_field(rows.value_of(settings, "vector"))
        if settings.field == "ATTRIBUTE":
            if not settings.attribute:
                raise brindle.Error("the field is an attribute: choose one")
            return surface.array_field(self.mesh.vectors(settings.attribute))
        given = self.given(rows.SMOOTH)
        previous = self.last and (self.last.mesh.surface, self.last.directions)
        if settings.field == "CURVATURE":
            given = {"curvature_anchor": _CURVATURE_ANCHOR, "curvature": settings.curvature_direction, **given}
        strokes = self._strokes()
        if strokes or previous:
            return surface.smooth_field(symmetry=symmetry, strokes=strokes, previous=previous, **given)
        return remembered(self._smooth, (surface, symmetry, given),
                          lambda: surface.smooth_field(symmetry=symmetry, **given))

    def _strokes(self):
        settings = self.settings
        lines = []
        if settings.use_marked_edges:
            lines += list(self.mesh.points[self.mesh.marked_edges])
        if settings.use_annotations:
            lines += [self.mesh.placed(line, self.to_object) for line in _annotations(self.depsgraph.scene)]
        if settings.stroke_object is not None:
            guide = settings.stroke_object.evaluated_get(self.depsgraph)
            matrix = self.to_object @ np.array(guide.matrix_world)
            lines += [self.mesh.placed(line, matrix) for line in _lines_of(guide)]
        radius, strength = (rows.value_of(settings, name) for name in ("stroke_radius", "stroke_strength"))
        return [brindle.Stroke(line, radius, strength) for line in lines]

    def turned(self, directions):
        degrees = rows.value_of(self.settings, "rotate")
        return self.mesh.surface.rotate_field(directions, degrees) if degrees else directions

    # --- patterns -----------------------------------------------------------------------------

    def options(self, names=()):
        """Arguments of all patterns."""
        measured = self.given(rows.MEASURED)
        given = self.given(rows.SOLVER)
        solver = brindle.Solver(given.pop("solver", None), **given) if given else "multilevel"
        spacing = {"frequency": self.frequency} if self.last else self.given(rows.SPACING)
        return {**spacing, **self.given(["slack", *names]), "solver": solver,
                "measured": brindle.Measured(**measured) if measured else None}

    @cached_property
    def frequency(self):
        """Stripes per unit length, the same in all frames."""
        if self.last:
            return self.last.frequency
        spacing = self.given(rows.SPACING)
        return (1 / spacing["spacing"] if "spacing" in spacing
                else self.mesh.surface.frequency_of(rows.value_of(self.settings, "stripes")))

    @property
    def layout(self):
        given = self.given(rows.LAYOUT)
        return {"layout": brindle.Layout(**given)} if given else {}

    @property
    def run(self):
        return "along" if self.settings.along else "across"

    @cached_property
    def directions(self):
        return self.field()

    @cached_property
    def stripes(self):
        last = self.last and brindle.Previous(self.last.stripes, stiffness=rows.value_of(self.settings, "lambda"))
        return brindle.stripes(self.mesh.surface, self.turned(self.directions), run=self.run, previous=last,
                               **self.options(), **self.layout)

    @cached_property
    def animator(self):
        """What makes textures of moving meshes; it keeps the last frame."""
        if self.last and self.mesh.is_moved:
            return self.last.animator
        if self.given([*rows.LAYOUT, *rows.MEASURED, *rows.SOLVER]):
            raise brindle.Error("textures that follow an animation take no options of layout, measured data and "
                                "solver; turn them or 'Follow animation' off")
        return brindle.TextureAnimator(self.mesh.surface, stiffness=rows.value_of(self.settings, "lambda"),
                                       **self.given(["oriented", "slack"]))

    @cached_property
    def corner_uv(self):
        surface, directions = self.mesh.surface, self.turned(self.directions)
        if self.settings.follow:
            directions = surface.rotate_field(directions, 90) if self.settings.along else directions
            return self.animator.frame(directions, self.frequency, surface.vertices)
        return brindle.texture(surface, directions, run=self.run, **self.options(["oriented"]),
                               **self.layout).corner_uv

    @cached_property
    def crosses(self):
        surface = self.mesh.surface
        made = brindle.crosses(surface, self.turned(self.field(symmetry=4)), **self.options(), **self.layout)
        return whole_triangles(made, surface.face_count, surface.faces)

    @cached_property
    def curves(self):
        return self.stripes.curves(**self.given(rows.CURVES))

    @cached_property
    def samples(self):
        return brindle.samples(self.mesh.surface, self.turned(self.directions), **self.options(["min_distance"]))

    def attributes(self, kinds):
        """Attributes of corners: (corners, 3) by name, or a UV map."""
        made = {}
        if "STRIPES" in kinds:
            made[PHASE], made[BRANCH] = stripe_corners(self.mesh, self.stripes)
        if "TEXTURE" in kinds:
            made[UV] = uv_corners(self.mesh, self.corner_uv)
        if "CROSSES" in kinds:
            made[UV] = uv_corners(self.mesh, self.crosses, quarter_turns=True)
        return made


def _annotations(scene):
    """The strokes on the current frame, in the world; Blender 5.0 has them under another name."""
    notes = scene.annotation if hasattr(scene, "annotation") else scene.grease_pencil
    frames = [layer.active_frame for layer in (notes.layers if notes else ()) if not layer.annotation_hide]
    lines = [column(stroke.points, "co", np.float32, 3) for frame in frames if frame for stroke in frame.strokes]
    return [line for line in lines if len(line) > 1]


def _lines_of(curve):
    """The edges of an evaluated curve object."""
    mesh = curve.to_mesh()
    try:
        return list(column(mesh.vertices, "co", np.float32, 3)[column(mesh.edges, "vertices", np.int32, 2)])
    finally:
        curve.to_mesh_clear()
