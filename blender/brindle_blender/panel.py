"""The operator and the panels in the sidebar of the 3D view."""
import bpy
import brindle
from bpy.props import EnumProperty

from . import frames
from . import settings as rows
from .results import put_material


class BRINDLE_OT_make(bpy.types.Operator):
    """Lay a pattern over the active mesh, with its settings in the sidebar"""

    bl_idname = "brindle.make"
    bl_label = "Lay pattern"
    bl_options = {"REGISTER", "UNDO"}
    kind: EnumProperty(name="Result", items=rows.KINDS)

    @classmethod
    def poll(cls, context):
        obj = context.object
        if obj is None or obj.type != "MESH" or obj.mode != "OBJECT":
            cls.poll_message_set("Select a mesh in object mode")
            return False
        return True

    @classmethod
    def description(cls, _, properties):
        return next(text for kind, _, text in rows.KINDS if kind == properties.kind)

    def execute(self, context):
        obj = context.object
        try:
            notes = frames.make(obj, context.evaluated_depsgraph_get(), {self.kind})
        except (brindle.Error, TypeError) as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        notes += put_material(obj, self.kind)
        rivals = {"TEXTURE", "CROSSES"} if self.kind in ("TEXTURE", "CROSSES") else set()
        obj.brindle.made = (obj.brindle.made - rivals) | {self.kind}
        obj.brindle.message = ""
        if obj.brindle.follow and self.kind not in frames.FOLLOWING:
            notes.append(f"{self.kind.lower()} do not follow animations")
        for note in notes:
            self.report({"WARNING"}, note)
        return {"FINISHED"}


class _InSidebar:
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Brindle"

    @classmethod
    def poll(cls, context):
        return context.object is not None and context.object.type == "MESH"


class BRINDLE_PT_make(_InSidebar, bpy.types.Panel):
    bl_label = "Brindle"

    def draw(self, context):
        settings, layout = context.object.brindle, self.layout
        grid = layout.grid_flow(row_major=True, columns=2, even_columns=True, align=True)
        for kind, name, _ in rows.KINDS:
            grid.operator("brindle.make", text=name, depress=kind in settings.made).kind = kind
        layout.prop(settings, "live")
        layout.prop(settings, "follow")
        if settings.message:
            layout.label(text=settings.message, icon="ERROR")


class _Section(_InSidebar):
    bl_parent_id = "BRINDLE_PT_make"
    options = ()

    def draw(self, context):
        self.layout.use_property_split = True
        self.layout.use_property_decorate = False
        self.draw_options(context.object.brindle, self.options)

    def draw_options(self, settings, names):
        for name in names:
            if rows.has_effect(settings, name):
                self._draw_option(settings, name)

    def _draw_option(self, settings, name):
        if not rows.is_optional(name):
            self.layout.prop(settings, name)
            return
        row = self.layout.row(heading=settings.bl_rna.properties["use_" + name].name)
        row.prop(settings, "use_" + name, text="")
        value = row.row()
        value.active = rows.is_on(settings, name)
        value.prop(settings, name, text="")


class BRINDLE_PT_field(_Section, bpy.types.Panel):
    bl_label = "Field"

    def draw_options(self, settings, _):
        layout = self.layout
        layout.prop(settings, "field")
        if settings.field == "VECTOR":
            layout.prop(settings, "vector")
        elif settings.field == "ATTRIBUTE":
            layout.prop_search(settings, "attribute", settings.id_data.data, "attributes")
        else:
            if settings.field == "CURVATURE":
                layout.prop(settings, "curvature_direction")
            for name in ("stroke_object", "use_annotations", "use_marked_edges"):
                layout.prop(settings, name)
            if settings.stroke_object or settings.use_annotations or settings.use_marked_edges:
                layout.prop(settings, "stroke_radius")
                layout.prop(settings, "stroke_strength")
            super().draw_options(settings, rows.SMOOTH)
        super().draw_options(settings, [*rows.TURN, *rows.SURFACE])


def _section(name, options, is_open=False):
    """A panel of options alone."""
    return type("BRINDLE_PT_" + name.split()[0].lower(), (_Section, bpy.types.Panel),
                {"bl_label": name, "options": options, "bl_options": set() if is_open else {"DEFAULT_CLOSED"}})


class BRINDLE_PT_samples(_Section, bpy.types.Panel):
    bl_label = "Samples"
    bl_options = {"DEFAULT_CLOSED"}
    options = ("min_distance",)

    def draw_options(self, settings, names):
        self.layout.prop(settings, "instance")
        super().draw_options(settings, names)


CLASSES = (BRINDLE_OT_make, BRINDLE_PT_make, BRINDLE_PT_field,
           _section("Spacing", (*rows.SPACING, "slack"), is_open=True),
           _section("Layout", (*rows.LAYOUT, "oriented")),
           _section("Curves", (*rows.CURVES, "tube_radius")), BRINDLE_PT_samples,
           _section("Measured data", rows.MEASURED), _section("Solver", (*rows.SOLVER, *rows.FRAMES)))
