"""Puts patterns into Blender's data: attributes, materials, curves and points."""
import bpy
import brindle
import numpy as np

from . import settings as rows
from .nodes import CORNERS, STRIPES, TILES, UV, material, place_instances, shows, take_attributes

_TUBE = 1 / 12  # of the spacing, as in Brindle's pictures


def lay(obj, pattern, kinds):
    """Makes these kinds of results. All is computed before anything changes."""
    attributes = pattern.attributes(kinds)
    curves = pattern.curves if "CURVES" in kinds else None
    samples = pattern.samples if "SAMPLES" in kinds else None
    if attributes:
        _put_attributes(obj, pattern, attributes)
    if curves is not None:
        _put_curves(obj, pattern, curves)
    if samples is not None:
        _put_samples(obj, pattern, samples)


def _put_attributes(obj, pattern, attributes):
    """On the mesh itself, or by a modifier where other modifiers have changed its corners."""
    mesh = pattern.mesh
    target = obj.data if mesh.is_own else bpy.data.meshes.new_from_object(obj.evaluated_get(pattern.depsgraph))
    for name, values in attributes.items():
        _put_attribute(target, name, values, is_uv=mesh.is_own and name == UV)
    target.update()
    if not mesh.is_own:
        old = obj.brindle.data_object
        is_like_old = old is not None and len(old.data.loops) == len(target.loops)
        names = [name for name in CORNERS if name in attributes or is_like_old and name in old.data.attributes]
        take_attributes(obj, _child(obj, "data_object", f"{obj.name} Brindle data", target, is_linked=False), names)


def _put_attribute(mesh, name, values, is_uv):
    if is_uv:
        layer = mesh.uv_layers.get(name) or mesh.uv_layers.new(name=name, do_init=False)
        if layer is None:
            raise brindle.Error("the mesh has as many UV maps as it can have; remove one")
        layer.data.foreach_set("uv", values.ravel())
        return
    if values.shape[1] == 2:
        values = np.pad(values, ((0, 0), (0, 1)))
    found = mesh.attributes.get(name)
    if found is not None and (found.domain, found.data_type) != ("CORNER", "FLOAT_VECTOR"):
        mesh.attributes.remove(found)
        found = None
    attribute = found or mesh.attributes.new(name, "FLOAT_VECTOR", "CORNER")
    attribute.data.foreach_set("vector", np.ascontiguousarray(values, np.float32).ravel())


def put_material(obj, kind):
    """Shows the result, unless one of the object's materials does; returns notes to the user."""
    name = STRIPES if kind == "STRIPES" else TILES
    if kind not in ("STRIPES", "TEXTURE", "CROSSES") or any(shows(slot.material, name) for slot in obj.material_slots):
        return []
    old = obj.active_material
    obj.active_material = material(name)
    if old is None or old.name in (STRIPES, TILES):
        return []
    old.use_fake_user = True
    return [f"'{name}' replaces the material '{old.name}', which stays in the file"]


def _child(obj, pointer, name, data, is_linked=True):
    """The object of a result, whose coordinates are those of the surface."""
    child = getattr(obj.brindle, pointer)
    if child is None or child.parent != obj:  # copies of an object get results of their own
        child = bpy.data.objects.new(name, data)
        child.parent = obj
        setattr(obj.brindle, pointer, child)
    old, child.data = child.data, data
    if old != data and old.users == 0:
        (bpy.data.meshes if isinstance(old, bpy.types.Mesh) else bpy.data.curves).remove(old)
    if is_linked and not child.users_collection:
        for collection in obj.users_collection:
            collection.objects.link(child)
    return child


def _put_curves(obj, pattern, curves):
    data = bpy.data.curves.new(f"{obj.name} curves", "CURVE")
    data.dimensions = "3D"
    radius = (rows.value_of(obj.brindle, "tube_radius") if rows.is_on(obj.brindle, "tube_radius")
              else _TUBE / float(pattern.stripes.frequency.mean()))
    data.bevel_depth, data.use_fill_caps = radius, True
    points = np.pad(curves.points, ((0, 0), (0, 1)), constant_values=1).astype(np.float32)
    for first, last, is_closed in zip(curves.offsets[:-1], curves.offsets[1:], curves.closed):
        spline = data.splines.new("POLY")
        spline.points.add(last - first - 1)
        spline.points.foreach_set("co", points[first:last].ravel())
        spline.use_cyclic_u = bool(is_closed)
    old = obj.brindle.curves_object
    for slot in old.data.materials if old else ():
        data.materials.append(slot)
    child = _child(obj, "curves_object", data.name, data)
    child.matrix_parent_inverse = pattern.mesh.from_surface


def _put_samples(obj, pattern, samples):
    data = bpy.data.meshes.new(f"{obj.name} samples")
    data.vertices.add(samples.count)
    data.vertices.foreach_set("co", samples.points.astype(np.float32).ravel())
    direction, spacing = samples.directions[0], np.minimum(*samples.spacings)
    for name, values in (("surface_normal", samples.normals), ("direction", direction),
                         ("rotation", _angles(direction, samples.normals)), ("spacing", spacing)):
        is_vector = values.ndim == 2
        attribute = data.attributes.new(name, "FLOAT_VECTOR" if is_vector else "FLOAT", "POINT")
        attribute.data.foreach_set("vector" if is_vector else "value", np.ascontiguousarray(values, np.float32).ravel())
    child = _child(obj, "samples_object", data.name, data)
    child.matrix_parent_inverse = pattern.mesh.from_surface
    if obj.brindle.instance is not None:
        place_instances(child, obj.brindle.instance)


def _angles(x, z):
    """(k, 3) Euler angles XYZ of frames with these axes."""
    y = np.cross(z, x)
    return np.stack([np.arctan2(y[:, 2], z[:, 2]), -np.arcsin(np.clip(x[:, 2], -1, 1)),
                     np.arctan2(x[:, 1], x[:, 0])], axis=1)
