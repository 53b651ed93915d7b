"""Checks that run in Blender: `blender --background --python checks.py -- NAME` runs check_NAME's function."""
import os
import pathlib
import re
import sys

import addon_utils
import bpy
import numpy as np

addon_utils.enable("brindle_blender")

import brindle  # noqa: E402  the add-on brings it
from brindle_blender import evaluated, frames, nodes, patterns  # noqa: E402
from brindle_blender import settings as rows  # noqa: E402


def fresh(add, **arguments):
    """An empty scene with one mesh, which is active."""
    for obj in list(bpy.data.objects):
        bpy.data.objects.remove(obj)
    add(**arguments)
    return bpy.context.object


def torus(**arguments):
    return fresh(bpy.ops.mesh.primitive_torus_add, **{"major_segments": 64, "minor_segments": 24, **arguments})


def ball(subdivisions=4):
    return fresh(bpy.ops.mesh.primitive_ico_sphere_add, subdivisions=subdivisions)


def monkey():
    return fresh(bpy.ops.mesh.primitive_monkey_add)


def monkey_of_quads():
    """A subdivided mesh, without modifiers."""
    obj = monkey()
    obj.modifiers.new("Subdivision", "SUBSURF").levels = 2
    bpy.ops.object.modifier_apply(modifier="Subdivision")
    return obj


def make(kind, obj=None):
    if obj is not None:
        bpy.context.view_layer.objects.active = obj
    assert bpy.ops.brindle.make(kind=kind) == {"FINISHED"}


def error_of(kind):
    try:
        bpy.ops.brindle.make(kind=kind)
    except RuntimeError as error:
        return str(error)
    raise AssertionError("it did not fail")


def arrays(mesh):
    """(V, F), read apart from the add-on."""
    mesh.calc_loop_triangles()
    return (np.array([vertex.co for vertex in mesh.vertices], np.float32),
            np.array([triangle.vertices for triangle in mesh.loop_triangles], np.int32))


def attribute(mesh, name):
    return evaluated.column(mesh.attributes[name].data, "vector", np.float32, 3)


def last(obj):
    return frames._last[obj.name][1]


def turns(mesh, loops, weights):
    """What the node group computes, at barycentric `weights` (k, 3) of triangles with corners `loops` (k, 3)."""
    value, branch = (np.einsum("ki,kij->kj", weights, attribute(mesh, name)[loops].astype(float))
                     for name in (nodes.PHASE, nodes.BRANCH))
    is_b = value[:, 2] < 0
    t = np.stack([abs(value[:, 2]), branch[:, 2], 1 - abs(value[:, 2]) - branch[:, 2]])
    at = np.argmin(t, axis=0)  # the edge opposite is the nearest
    start, a, b = np.choose(at, [3, 5, 1]), np.choose(at, [t[2], t[0], t[1]]), np.choose(at, [t[1], t[2], t[0]])
    gained = (start + (a - b) / np.maximum(1 - 3 * t.min(0), 1e-9)) / 6
    return np.where(is_b, value[:, 1], value[:, 0]) + np.where(is_b, branch[:, 1], branch[:, 0]) * gained


def triangle_pairs(mesh):
    """Edges between triangles: (k, 2, 2) loops: of the one and of the other, at the same two vertices; and
    (k, 2) triangles."""
    mesh.calc_loop_triangles()
    edges = {}
    for triangle in mesh.loop_triangles:
        for corner in range(3):
            a, b = triangle.loops[corner], triangle.loops[(corner + 1) % 3]
            ends = sorted((a, b), key=lambda loop: mesh.loops[loop].vertex_index)
            edges.setdefault(tuple(mesh.loops[loop].vertex_index for loop in ends), []).append((triangle.index, ends))
    pairs = [pair for pair in edges.values() if len(pair) == 2]
    return (np.array([[ends for _, ends in pair] for pair in pairs]),
            np.array([[triangle for triangle, _ in pair] for pair in pairs]))


def check_same_as_python():
    for add, changes in ((ball, {}), (torus, {"slack": 0.2, "rotate": 30}),
                         (ball, {"use_spacing": True, "spacing": 0.07})):
        obj = add()
        for name, value in changes.items():
            setattr(obj.brindle, name, value)
        for kind in ("CURVES", "SAMPLES", "STRIPES"):
            make(kind)
        surface = brindle.Surface(*arrays(obj.data), crease_angle=40)
        field = surface.smooth_field()
        if "rotate" in changes:
            field = surface.rotate_field(field, 30)
        arguments = {name: changes[name] for name in ("slack", "spacing") if name in changes}
        pattern = brindle.stripes(surface, field, **arguments)
        assert np.array_equal(last(obj).stripes.phases, pattern.phases)
        points = np.concatenate([evaluated.column(spline.points, "co", np.float32, 4)[:, :3]
                                 for spline in obj.brindle.curves_object.data.splines])
        assert np.array_equal(points, pattern.curves().points)
        samples = brindle.samples(surface, field, **arguments)
        data = obj.brindle.samples_object.data
        assert np.array_equal(evaluated.column(data.vertices, "co", np.float32, 3), samples.points)
        assert np.array_equal(attribute(data, "surface_normal"), samples.normals)


def check_stripes_continue_across_edges():
    for add in (torus, ball, monkey):
        obj = add()
        obj.brindle.crease_angle = 180
        obj.brindle.stripes, obj.brindle.rotate = 25, 35
        make("STRIPES")
        pattern = last(obj).stripes
        loops, triangles = triangle_pairs(obj.data)
        regular = ~pattern.singularities[triangles].any(1)
        assert pattern.report["branches"] > pattern.singularities.sum(), "no branch is tested"
        of_triangle = evaluated.column(obj.data.loop_triangles, "loops", np.int32, 3)
        for share in (0.02, 0.3, 0.5, 0.77):
            sides = []
            for side in (0, 1):
                corners = of_triangle[triangles[:, side]]
                weights = (corners == loops[:, side, :1]) * (1 - share) + (corners == loops[:, side, 1:]) * share
                # A little inside, so that a quad's diagonal is on this side of it.
                weights = weights * (1 - 3e-5) + 1e-5
                sides.append(np.cos(2 * np.pi * turns(obj.data, corners, weights)))
            jump = abs(sides[0] - sides[1])
            assert jump[regular].max() < 0.01, (obj.name, jump[regular].max())


def check_nodes_draw_what_corners_hold(engine="CYCLES"):
    """A picture of the mask beside the same computed at the middle of every pixel."""
    obj = torus(major_segments=24, minor_segments=12)
    obj.brindle.stripes, obj.brindle.field, obj.brindle.vector = 20, "VECTOR", (1, 0.3, 0.2)
    make("STRIPES")
    assert last(obj).stripes.report["branches"] > 10
    scene, size = bpy.context.scene, 160
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    scene.collection.objects.link(camera)
    scene.camera, camera.location.z = camera, 3
    camera.data.type, camera.data.ortho_scale = "ORTHO", 2.6
    tree = obj.active_material.node_tree
    group = next(node for node in tree.nodes if node.type == "GROUP")
    light = tree.nodes.new("ShaderNodeEmission")
    tree.links.new(group.outputs["Mask"], light.inputs["Color"])
    out = next(node for node in tree.nodes if node.type == "OUTPUT_MATERIAL")
    tree.links.new(light.outputs[0], out.inputs["Surface"])
    scene.world.node_tree.nodes["Background"].inputs["Strength"].default_value = 0
    image = picture(scene, f"mask_{engine.lower()}.png", size, 4, engine)
    expected = np.full((size, size), np.nan)
    mesh = obj.data
    mesh.calc_loop_triangles()
    of_polygon = {}
    for triangle in mesh.loop_triangles:
        of_polygon.setdefault(triangle.polygon_index, []).append(triangle)
    for y, x in np.ndindex(size, size):
        place = ((x + 0.5) / size - 0.5) * 2.6, ((y + 0.5) / size - 0.5) * 2.6
        hit, where, _, polygon = obj.ray_cast((*place, 3), (0, 0, -1))
        for triangle in of_polygon[polygon] if hit else ():
            corners = np.array([mesh.vertices[vertex].co[:2] for vertex in triangle.vertices])
            weights = np.linalg.solve(np.vstack([corners.T, np.ones(3)]), [*where[:2], 1])
            if weights.min() >= -1e-4:
                apart = turns(mesh, np.array([triangle.loops]), weights[None])[0]
                expected[y, x] = abs(apart - round(apart))
    # Pixels whose neighbours are on the same side of the stripes' borders: others are mixed.
    shifted = [np.roll(expected, (y, x), (0, 1)) for y in (-1, 0, 1) for x in (-1, 0, 1)]
    inside = np.isfinite(shifted).all(0) & np.isin((np.array(shifted) < 0.25).sum(0), (0, 9))
    wrong = (image[..., 0] > 0.5) != (expected < 0.25)
    assert inside.sum() > 4000 and not wrong[inside].any(), (inside.sum(), wrong[inside].sum())


def picture(scene, name, size, samples, engine):
    """Renders a square without changing colours, and returns its pixels, the lowest row first."""
    scene.render.engine, scene.view_settings.view_transform = engine, "Raw"
    scene.cycles.samples = scene.eevee.taa_render_samples = samples
    scene.cycles.use_denoising = False
    scene.render.resolution_x, scene.render.resolution_y, scene.render.resolution_percentage = size, size, 100
    scene.render.filepath = os.path.join(os.environ["BRINDLE_PICTURES"], name)
    bpy.ops.render.render(write_still=True)
    image = bpy.data.images.load(scene.render.filepath)
    return np.array(image.pixels[:]).reshape(size, size, 4)


def uv_jumps(obj, turns_of):
    """For edges between polygons, how far coordinates are from whole tiles after the best turn."""
    mesh = obj.data
    uv = evaluated.column(mesh.uv_layers[nodes.UV].data, "uv", np.float32, 2) @ (1, 1j)
    loops, triangles = triangle_pairs(mesh)
    polygons = evaluated.column(mesh.loop_triangles, "polygon_index", np.int32)[triangles]
    between = polygons[:, 0] != polygons[:, 1]
    a, b = uv[loops[between, 0]], uv[loops[between, 1]]
    jumps = []
    for rotation in turns_of:
        apart = a - rotation * b
        jumps.append(abs(apart - np.round(apart)).max(1))
    return np.min(jumps, axis=0)


def check_texture_continues_across_edges():
    for add in (torus, ball):
        obj = add()
        obj.brindle.stripes = 25
        make("TEXTURE")
        jumps = uv_jumps(obj, (1, -1))
        surface = last(obj).mesh.surface
        report = brindle.texture(surface, surface.smooth_field(), stripes=25).report
        broken = report["branches"]
        assert (jumps > 0.01).sum() <= 6 * broken, ((jumps > 0.01).sum(), broken)
        assert (jumps < 0.01).mean() > 0.99


def check_crosses_continue_across_edges():
    for add in (monkey_of_quads, ball):
        obj = add()
        obj.brindle.stripes = 15
        make("CROSSES")
        jumps = uv_jumps(obj, (1, 1j, -1, -1j))
        assert (jumps < 0.01).mean() > 0.99, (jumps < 0.01).mean()


def waving(obj):
    """A mesh that moves by a modifier, for 20 frames."""
    modifier = obj.modifiers.new("Bend", "SIMPLE_DEFORM")
    modifier.deform_method = "TWIST"
    for frame, angle in ((1, 0.0), (20, 1.2)):
        modifier.angle = angle
        modifier.keyframe_insert("angle", frame=frame)


def check_phases_follow_for_20_frames():
    obj, scene = torus(), bpy.context.scene
    waving(obj)
    scene.frame_set(1)
    obj.brindle.stripes = 30
    obj.brindle.follow = True
    for kind in ("STRIPES", "CURVES", "TEXTURE"):
        make(kind)

    def wave(mesh):
        return np.cos(2 * np.pi * attribute(mesh, nodes.PHASE)[:, 0])

    waves, texture = [wave(obj.data)], []
    for frame in range(2, 21):
        scene.frame_set(frame)
        assert not obj.brindle.message, obj.brindle.message
        waves.append(wave(obj.data))
        texture.append(evaluated.column(obj.data.uv_layers[nodes.UV].data, "uv", np.float32, 2))
    steps = [abs(b - a).mean() for a, b in zip(waves, waves[1:])]
    obj.brindle.follow = False
    make("STRIPES")
    from_scratch = abs(wave(obj.data) - waves[-2]).mean()
    print("steps", max(steps), "from scratch", from_scratch)
    assert 0 < max(steps) < 0.5 * from_scratch
    assert all(np.isfinite(uv).all() for uv in texture)
    assert not np.array_equal(texture[0], texture[-1])
    # Back to the start: the same bits as at first.
    obj.brindle.follow = True
    scene.frame_set(1)
    assert np.array_equal(wave(obj.data), waves[0])


def check_phases_follow_in_renders():
    """Frames of an animation that is rendered have their own phases, not those of the frame before."""
    obj, scene = torus(), bpy.context.scene
    waving(obj)
    scene.frame_set(1)
    obj.brindle.follow = True
    make("STRIPES")
    seen = []
    bpy.app.handlers.render_post.append(lambda *_: seen.append(attribute(obj.data, nodes.PHASE).copy()))
    scene.camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    scene.frame_start, scene.frame_end, scene.cycles.samples = 1, 3, 1
    scene.render.engine, scene.render.resolution_percentage, scene.cycles.use_denoising = "CYCLES", 2, False
    scene.render.filepath = bpy.app.tempdir
    bpy.ops.render.render(animation=True)
    assert len(seen) == 3 and not np.array_equal(seen[0], seen[1]) and not np.array_equal(seen[1], seen[2])


def check_faces_may_change_between_frames():
    obj, scene = torus(), bpy.context.scene
    modifier = obj.modifiers.new("Decimate", "DECIMATE")
    for frame, ratio in ((1, 1.0), (3, 0.6)):
        modifier.ratio = ratio
        modifier.keyframe_insert("ratio", frame=frame)
    scene.frame_set(1)
    obj.brindle.follow = True
    make("STRIPES")
    counts = set()
    for frame in (2, 3):
        scene.frame_set(frame)
        mesh = obj.evaluated_get(bpy.context.evaluated_depsgraph_get()).data
        assert not obj.brindle.message and attribute(mesh, nodes.PHASE).any()
        counts.add(len(mesh.loops))
    assert len(counts) == 2


def check_modifiers_that_add_faces():
    obj = fresh(bpy.ops.mesh.primitive_cube_add)
    obj.modifiers.new("Subdivision", "SUBSURF").levels = 4
    before = arrays(obj.data)
    for kind in ("STRIPES", "TEXTURE"):
        make(kind)
    for mine, old in zip(arrays(obj.data), before):
        assert np.array_equal(mine, old)
    mesh = obj.evaluated_get(bpy.context.evaluated_depsgraph_get()).data
    data = obj.brindle.data_object.data
    assert len(mesh.loops) == 4 * 6 * 4 ** 4
    for name in (nodes.PHASE, nodes.BRANCH, nodes.UV):
        assert np.array_equal(attribute(mesh, name), attribute(data, name)) and attribute(mesh, name).any(), name
    make("STRIPES")  # on a mesh that has the attributes already
    assert [modifier.name for modifier in obj.modifiers] == ["Subdivision", "Brindle"]


def check_lengths_are_those_of_the_scene():
    def curves_of(obj):
        obj.brindle.field, obj.brindle.vector = "VECTOR", (0, 0, 1)
        obj.brindle.use_spacing, obj.brindle.spacing = True, 0.1
        make("CURVES")
        bpy.context.view_layer.update()
        curves = obj.brindle.curves_object
        return np.array([curves.matrix_world @ point.co.xyz for spline in curves.data.splines
                         for point in spline.points])

    plain = curves_of(ball())
    obj = ball()
    obj.data.transform(evaluated.Matrix.Diagonal((0.5, 0.25, 2, 1)))
    obj.scale = 2, 4, 0.5
    bpy.context.view_layer.update()
    assert abs(plain - curves_of(obj)).max() < 1e-4
    obj.rotation_euler, obj.location = (0.3, 0.5, 0.7), (1, 2, 3)
    bpy.context.view_layer.update()
    back = np.array(obj.matrix_world.normalized().inverted())
    turned = curves_of(obj) @ back[:3, :3].T + back[:3, 3]
    assert np.linalg.norm(turned[:, None] - plain, axis=2).min(1).max() < 0.02
    assert obj.brindle.bl_rna.properties["spacing"].unit == "LENGTH"


def check_failures_change_nothing():
    obj = ball(2)
    make("STRIPES")
    before = attribute(obj.data, nodes.PHASE), len(obj.data.attributes), len(bpy.data.objects), len(bpy.data.meshes)
    obj.brindle.live = False
    obj.brindle.field = "ATTRIBUTE"
    for name, message in (("", "choose one"), ("missing", "'missing' is no vector attribute")):
        obj.brindle.attribute = name
        assert message in error_of("STRIPES")
    obj.brindle.field = "SMOOTH"
    obj.brindle.solver, obj.brindle.use_sweeps = "relaxation", True
    assert "sweeps" in error_of("CURVES")
    obj.brindle.solver, obj.brindle.use_sweeps = "multilevel", False
    assert np.array_equal(before[0], attribute(obj.data, nodes.PHASE))
    assert before[1:] == (len(obj.data.attributes), len(bpy.data.objects), len(bpy.data.meshes))
    obj = fresh(bpy.ops.mesh.primitive_cylinder_add)
    assert "Triangulate modifier" in error_of("STRIPES")
    obj.modifiers.new("Triangulate", "TRIANGULATE")
    make("STRIPES")
    empty = bpy.data.objects.new("empty", bpy.data.meshes.new("empty"))
    bpy.context.collection.objects.link(empty)
    bpy.context.view_layer.objects.active = empty
    assert "has no faces" in error_of("STRIPES")


def angle_to(directions, wanted):
    cosines = abs((directions * wanted).sum(1)) / np.linalg.norm(wanted, axis=1)
    return np.degrees(np.arccos(np.clip(cosines, 0, 1)))


def field_of(obj):
    pattern = patterns.Pattern(obj, bpy.context.evaluated_depsgraph_get())
    return pattern.directions, pattern.mesh


def check_fields():
    obj = torus()
    around = np.cross((0, 0, 1), arrays(obj.data)[0])
    centres = np.array([polygon.center for polygon in obj.data.polygons])
    for name, domain, vectors in (("flow", "POINT", around), ("faces", "FACE", np.cross((0, 0, 1), centres))):
        made = obj.data.attributes.new(name, "FLOAT_VECTOR", domain)
        made.data.foreach_set("vector", vectors.astype(np.float32).ravel())
    obj.brindle.field = "ATTRIBUTE"
    for name in ("flow", "faces"):
        obj.brindle.attribute = name
        assert angle_to(field_of(obj)[0], around).max() < 2
    obj.brindle.field = "CURVATURE"
    assert np.median(angle_to(field_of(obj)[0], around)) > 85
    obj.brindle.curvature_direction = "min"
    assert np.median(angle_to(field_of(obj)[0], around)) < 5
    obj.brindle.field, obj.brindle.vector = "VECTOR", (0, 0, 1)
    directions, mesh = field_of(obj)
    assert np.array_equal(directions, mesh.surface.projected_field((0, 0, 1)))


def check_lines_guide_the_field():
    """Curves, annotations and marked edges, each alone, on a plane: the field follows all of them."""
    for guide in ("curve", "annotation", "sharp", "crease"):
        obj = fresh(bpy.ops.mesh.primitive_grid_add, x_subdivisions=20, y_subdivisions=20)
        obj.scale, obj.location = (3, 3, 3), (1, 0, 0)
        bpy.context.view_layer.update()
        ends = [(-2, -3, 0), (4, 3, 0)]  # the diagonal, in the world
        wanted = (1, 1, 0)
        if guide == "curve":
            curve = bpy.data.curves.new("line", "CURVE")
            curve.dimensions = "3D"
            curve.splines.new("POLY").points.add(1)
            for point, end in zip(curve.splines[0].points, ends):
                point.co = (*end, 1)
            obj.brindle.stroke_object = bpy.data.objects.new("line", curve)
            bpy.context.collection.objects.link(obj.brindle.stroke_object)
        elif guide == "annotation":
            notes = bpy.data.grease_pencils.new("notes")
            bpy.context.scene.grease_pencil = notes
            stroke = notes.layers.new("layer").frames.new(1).strokes.new()
            stroke.points.add(2)
            for point, end in zip(stroke.points, ends):
                point.co = end
            obj.brindle.use_annotations = True
        else:
            wanted = (1, 0, 0)
            for edge in obj.data.edges:
                a, b = (obj.data.vertices[vertex].co for vertex in edge.vertices)
                if abs(a.y) < 1e-3 and abs(b.y) < 1e-3:
                    edge.use_edge_sharp = guide == "sharp"
                    edge.crease = guide == "crease"
            obj.brindle.use_marked_edges = True
        obj.brindle.stroke_radius = 0.3
        obj.brindle.stroke_strength = 5
        directions, _ = field_of(obj)
        assert angle_to(directions, np.tile(wanted, (len(directions), 1))).max() < 3, guide
        bpy.context.scene.grease_pencil = None


def check_instances_at_samples():
    obj = ball()
    bpy.ops.mesh.primitive_cone_add()
    obj.brindle.instance = bpy.context.object
    obj.brindle.stripes = 20
    make("SAMPLES", obj)
    samples = obj.brindle.samples_object
    instances = [instance.matrix_world.copy() for instance in bpy.context.evaluated_depsgraph_get().object_instances
                 if instance.is_instance and instance.parent.original == samples]
    points = evaluated.column(samples.data.vertices, "co", np.float32, 3)
    normals, directions = attribute(samples.data, "surface_normal"), attribute(samples.data, "direction")
    assert len(instances) == len(points) > 50
    for matrix, point, normal, direction in zip(instances, points, normals, directions):
        assert abs(np.array(matrix.translation) - point).max() < 1e-5
        assert np.dot(np.array(matrix.col[2][:3]) / matrix.col[2].xyz.length, normal) > 0.999
        assert np.dot(np.array(matrix.col[0][:3]) / matrix.col[0].xyz.length, direction) > 0.999


def check_changed_settings_repeat_what_was_made():
    obj = ball()
    make("STRIPES")
    first = attribute(obj.data, nodes.PHASE)
    obj.brindle.stripes = 20
    second = attribute(obj.data, nodes.PHASE)
    assert not np.array_equal(first, second)
    obj.brindle.field, obj.brindle.attribute = "ATTRIBUTE", "missing"
    assert "'missing'" in obj.brindle.message and np.array_equal(second, attribute(obj.data, nodes.PHASE))
    obj.brindle.field = "SMOOTH"
    assert not obj.brindle.message
    obj.brindle.stripes = 40
    assert np.array_equal(first, attribute(obj.data, nodes.PHASE))


def check_copies_have_results_of_their_own():
    obj = ball(3)
    make("CURVES")
    first = obj.brindle.curves_object
    count = len(first.data.splines)
    copy = obj.copy()
    copy.data = obj.data.copy()
    bpy.context.collection.objects.link(copy)
    make("CURVES", copy)
    copy.brindle.stripes = 10
    assert copy.brindle.curves_object != first and len(first.data.splines) == count
    assert len(copy.brindle.curves_object.data.splines) < count


def check_page():
    page = (pathlib.Path(__file__).parents[2] / "docs/blender.md").read_text()
    fresh(bpy.ops.mesh.primitive_cube_add)
    exec(re.search(r"^```python\n(.*?)^```", page, re.DOTALL | re.MULTILINE).group(1), {})
    assert last(bpy.context.object).stripes.report["branches"] == 0
    assert bpy.context.object.active_material.name == nodes.STRIPES


def check_materials_are_kept():
    obj = ball(2)
    mine = bpy.data.materials.new("mine")
    obj.data.materials.append(mine)
    make("STRIPES")
    assert obj.active_material.name == nodes.STRIPES and mine.use_fake_user
    obj.active_material = mine
    obj.brindle.stripes = 20
    assert obj.active_material == mine, "a slider changes materials"
    obj.active_material = other = bpy.data.materials[nodes.STRIPES].copy()
    make("STRIPES")
    assert obj.active_material == other
    for _ in range(8):
        obj.data.uv_layers.new()
    assert "UV maps" in error_of("TEXTURE")


def check_every_option_has_its_rows_words():
    properties = ball(1).brindle.bl_rna.properties
    for name in rows.OPTIONS:
        row, made = rows.ROWS[name], properties[name]
        assert made.description.lower() == row["help"].lower() and made.name, name
        if row["kind"] in ("whole", "number") and row["standard"]:
            assert abs(made.default - float(row["standard"])) < 1e-6, name
        if row["kind"] == "choice":
            assert [item.identifier for item in made.enum_items] == row["form"].split("|"), name


if __name__ == "__main__":
    globals()[sys.argv[-1]]()
