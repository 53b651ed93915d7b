"""Node trees: the material's stripes and tiles, attributes of other meshes, instances."""
import bpy

CORNERS = PHASE, BRANCH, UV = "brindle_phase", "brindle_branch", "Brindle"
STRIPES, TILES = "Brindle Stripes", "Brindle Tiles"
# Dark blue on ivory, in linear light.
_DARK, _LIGHT = (0.0116, 0.0395, 0.1022, 1), (0.9047, 0.9047, 0.8, 1)


def add_socket(tree, in_or_out, kind, name, default=None):
    """A socket of a node group; Blender 4.0 moved them."""
    if hasattr(tree, "interface"):
        socket = tree.interface.new_socket(name, in_out=in_or_out, socket_type=kind)
    else:
        socket = (tree.inputs if in_or_out == "INPUT" else tree.outputs).new(kind, name)
    if default is not None:
        socket.default_value = default
    return socket


class Nodes:
    """Adds nodes to a tree, each to the right of the last."""

    def __init__(self, tree):
        self.tree = tree
        self.count = 0

    def add(self, kind, **settings):
        node = self.tree.nodes.new(kind)
        for name, value in settings.items():
            setattr(node, name, value)
        node.location = (220 * (self.count // 5), -190 * (self.count % 5))
        self.count += 1
        return node

    def put(self, socket, value):
        """Links a socket to another one, or sets its number."""
        if isinstance(value, bpy.types.NodeSocket):
            self.tree.links.new(value, socket)
        else:
            socket.default_value = value

    def math(self, operation, *values):
        node = self.add("ShaderNodeMath", operation=operation)
        for socket, value in zip(node.inputs, values):
            self.put(socket, value)
        return node.outputs[0]

    def vector(self, name):
        """The three numbers of an attribute."""
        attribute = self.add("ShaderNodeAttribute", attribute_name=name)
        apart = self.add("ShaderNodeSeparateXYZ")
        self.put(apart.inputs[0], attribute.outputs["Vector"])
        return apart.outputs


def _gained(nodes, own, following, last):
    """l of corners.py, at barycentric coordinates: the edge opposite the least of them is the nearest."""
    least = nodes.math("MINIMUM", nodes.math("MINIMUM", own, following), last)
    height = nodes.math("MULTIPLY_ADD", least, -3, 1)

    def along(start, a, b):  # an edge from where b is 1 to where a is 1
        return nodes.math("ADD", start, nodes.math("DIVIDE", nodes.math("SUBTRACT", a, b), height))

    first, second, third = along(1, following, own), along(3, last, following), along(5, own, last)
    is_first = nodes.math("LESS_THAN", last, nodes.math("MINIMUM", own, following))
    is_second = nodes.math("LESS_THAN", own, following)
    later = nodes.math("MULTIPLY_ADD", nodes.math("SUBTRACT", second, third), is_second, third)
    sixths = nodes.math("MULTIPLY_ADD", nodes.math("SUBTRACT", first, later), is_first, later)
    return nodes.math("DIVIDE", sixths, 6)


def _fill_stripes(tree):
    """Position within the period and a mask from attributes of corners, as corners.py describes."""
    add_socket(tree, "INPUT", "NodeSocketFloat", "Width", 0.5)
    add_socket(tree, "INPUT", "NodeSocketFloat", "Offset", 0.0)
    add_socket(tree, "OUTPUT", "NodeSocketFloat", "Mask")
    add_socket(tree, "OUTPUT", "NodeSocketFloat", "Distance")
    nodes = Nodes(tree)
    given, out = nodes.add("NodeGroupInput"), nodes.add("NodeGroupOutput")
    value_a, value_b, side = nodes.vector(PHASE)
    turns_a, turns_b, following = nodes.vector(BRANCH)
    is_b = nodes.math("LESS_THAN", side, 0)

    def chosen(a, b):
        return nodes.math("MULTIPLY_ADD", nodes.math("SUBTRACT", b, a), is_b, a)

    own = nodes.math("ABSOLUTE", side)
    last = nodes.math("SUBTRACT", nodes.math("SUBTRACT", 1, own), following)
    value = nodes.math("MULTIPLY_ADD", chosen(turns_a, turns_b), _gained(nodes, own, following, last),
                       chosen(value_a, value_b))
    value = nodes.math("SUBTRACT", value, given.outputs["Offset"])
    apart = nodes.math("ABSOLUTE", nodes.math("SUBTRACT", value, nodes.math("ROUND", value)))
    nodes.put(out.inputs["Distance"], apart)
    width = nodes.math("MULTIPLY", given.outputs["Width"], 0.5)
    nodes.put(out.inputs["Mask"], nodes.math("LESS_THAN", apart, width))


def _fill_tiles(tree):
    """Two by two squares per tile from the UV map."""
    add_socket(tree, "OUTPUT", "NodeSocketFloat", "Mask")
    nodes = Nodes(tree)
    u, v, _ = nodes.vector(UV)
    squares = nodes.add("ShaderNodeCombineXYZ")
    for socket, value in zip(squares.inputs, (u, v)):
        # Half a square off, so that squares have corners, and tiles a square, in the middle.
        nodes.put(socket, nodes.math("MULTIPLY_ADD", value, 2, 0.5))
    nodes.put(squares.inputs[2], 0.5)  # not on a border of the checker
    checker = nodes.add("ShaderNodeTexChecker")
    nodes.put(checker.inputs["Vector"], squares.outputs[0])
    nodes.put(checker.inputs["Scale"], 1)
    out = nodes.add("NodeGroupOutput")
    nodes.put(out.inputs["Mask"], checker.outputs["Fac"])


def _tree(name, kind, fill):
    tree = bpy.data.node_groups.get(name)
    if tree is None:
        tree = bpy.data.node_groups.new(name, kind)
        fill(tree)
    return tree


def material(name):
    """The material with this node group; one that was changed stays as it is."""
    found = bpy.data.materials.get(name)
    if found is not None:
        return found
    group_tree = _tree(name, "ShaderNodeTree", _fill_stripes if name == STRIPES else _fill_tiles)
    made = bpy.data.materials.new(name)
    made.use_nodes = True
    nodes = Nodes(made.node_tree)
    made.node_tree.nodes.clear()
    group = nodes.add("ShaderNodeGroup", node_tree=group_tree)
    mix = nodes.add("ShaderNodeMixRGB")
    surface = nodes.add("ShaderNodeBsdfPrincipled")
    out = nodes.add("ShaderNodeOutputMaterial")
    for number, node in enumerate((group, mix, surface, out)):
        node.location = (-600 + 220 * number, 0)
    for socket, value in (("Fac", group.outputs["Mask"]), ("Color1", _LIGHT), ("Color2", _DARK)):
        nodes.put(mix.inputs[socket], value)
    nodes.put(surface.inputs["Base Color"], mix.outputs[0])
    nodes.put(surface.inputs["Roughness"], 0.5)
    nodes.put(out.inputs["Surface"], surface.outputs[0])
    return made


def shows(shown, name):
    """Whether a material has this node group."""
    return shown is not None and shown.use_nodes and any(
        node.type == "GROUP" and node.node_tree and node.node_tree.name == name for node in shown.node_tree.nodes)


def _socket(sockets, name, kind):
    """A node has a socket of one name per type of its values."""
    return next(socket for socket in sockets if socket.name == name and socket.type == kind)


def _geometry_tree(name):
    """An empty tree of this name, and its nodes, input and output."""
    tree = bpy.data.node_groups.get(name) or bpy.data.node_groups.new(name, "GeometryNodeTree")
    if not len(tree.nodes):
        add_socket(tree, "INPUT", "NodeSocketGeometry", "Geometry")
        add_socket(tree, "OUTPUT", "NodeSocketGeometry", "Geometry")
    tree.nodes.clear()
    nodes = Nodes(tree)
    return nodes, nodes.add("NodeGroupInput").outputs[0], nodes.add("NodeGroupOutput").inputs[0]


def _named(nodes, name, kind):
    attribute = nodes.add("GeometryNodeInputNamedAttribute", data_type=kind)
    attribute.inputs["Name"].default_value = name
    return _socket(attribute.outputs, "Attribute", "VECTOR" if kind == "FLOAT_VECTOR" else "VALUE")


def _modifier(obj, name, tree):
    modifier = obj.modifiers.get(name) or obj.modifiers.new(name, "NODES")
    modifier.node_group = tree


def take_attributes(obj, source, names):
    """A last modifier that copies attributes of corners from an object whose mesh has the same corners."""
    nodes, geometry, out = _geometry_tree(f"Brindle of {obj.name}")
    info = nodes.add("GeometryNodeObjectInfo")
    info.inputs["Object"].default_value = source
    index = nodes.add("GeometryNodeInputIndex")
    for name in names:
        sample = nodes.add("GeometryNodeSampleIndex", data_type="FLOAT_VECTOR", domain="CORNER")
        nodes.put(sample.inputs["Geometry"], info.outputs["Geometry"])
        nodes.put(_socket(sample.inputs, "Value", "VECTOR"), _named(nodes, name, "FLOAT_VECTOR"))
        nodes.put(sample.inputs["Index"], index.outputs[0])
        store = nodes.add("GeometryNodeStoreNamedAttribute", data_type="FLOAT_VECTOR", domain="CORNER")
        nodes.put(store.inputs["Geometry"], geometry)
        nodes.put(store.inputs["Name"], name)
        nodes.put(_socket(store.inputs, "Value", "VECTOR"), _socket(sample.outputs, "Value", "VECTOR"))
        geometry = store.outputs[0]
    nodes.put(out, geometry)
    _modifier(obj, "Brindle", nodes.tree)


def place_instances(obj, instance):
    """A modifier that places an object at all points: Z along the normal, X along the field, one unit per
    spacing."""
    nodes, geometry, out = _geometry_tree(f"Instances of {obj.name}")
    info = nodes.add("GeometryNodeObjectInfo")
    info.inputs["Object"].default_value = instance
    place = nodes.add("GeometryNodeInstanceOnPoints")
    for socket, value in (("Points", geometry), ("Instance", info.outputs["Geometry"]),
                          ("Rotation", _named(nodes, "rotation", "FLOAT_VECTOR")),
                          ("Scale", _named(nodes, "spacing", "FLOAT"))):
        nodes.put(place.inputs[socket], value)
    nodes.put(out, place.outputs[0])
    _modifier(obj, "Instances", nodes.tree)
