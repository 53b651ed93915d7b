"""Evaluated meshes as Brindle's surfaces, in the object's axes and the scene's lengths."""
import brindle
import numpy as np
from mathutils import Matrix


def column(items, name, kind, width=1):
    """One number, or `width` of them, for every item of a collection of Blender's."""
    values = np.empty(len(items) * width, kind)
    items.foreach_get(name, values)
    return values.reshape(-1, width) if width > 1 else values


def remembered(memory, key, make):
    """The value of the same key as last time, or a new one: sliders leave most steps as they were."""
    if memory.get("key") != key:
        memory.update(key=key, value=make())
    return memory["value"]


def stretch_of(obj):
    """The scale of an object without its rotation, (3, 3): a symmetric matrix, which keeps the axes."""
    _, scales, axes = np.linalg.svd(np.array(obj.matrix_world.to_3x3(), np.float64))
    stretch = (axes.T * scales) @ axes
    return np.eye(3) if np.allclose(stretch, np.eye(3), atol=1e-6) else stretch


class EvaluatedMesh:
    """What modifiers, shape keys and drivers leave of an object's mesh. `surface` has its lengths in units
    of the scene, also if the object is scaled."""

    _surface = {}

    def __init__(self, obj, depsgraph, crease_angle, last=None):
        """With the faces of `last`, a mesh before it moved, it keeps that one's creases."""
        self.stretch = stretch_of(obj)
        evaluated = obj.evaluated_get(depsgraph)
        mesh = evaluated.to_mesh()
        try:
            self._read(obj, mesh)
        finally:
            evaluated.to_mesh_clear()
        if not len(self.loops):
            raise brindle.Error(f"'{obj.name}' has no faces")
        self.is_moved = (last is not None and np.array_equal(self.loops, last.loops)
                         and np.array_equal(self.corners, last.corners))
        if self.is_moved:
            self._copied = last._copied
            self.surface = last.surface.with_vertices(np.concatenate([self.points, self.points[self._copied]]))
        else:
            faces = self.corners[self.loops]
            self.surface = remembered(self._surface, (self.points.tobytes(), faces.tobytes(), crease_angle),
                                      lambda: brindle.Surface(self.points, faces, crease_angle=crease_angle))
            self._copied = self.surface.crease_vertices

    def _read(self, obj, mesh):
        mesh.calc_loop_triangles()
        self.points = self._stretched(column(mesh.vertices, "co", np.float32, 3))
        self.corners = column(mesh.loops, "vertex_index", np.int32)
        self.loops = column(mesh.loop_triangles, "loops", np.int32, 3)
        self.polygons = column(mesh.loop_triangles, "polygon_index", np.int32)
        # Modifiers that only deform leave corners as they are: results then belong on the mesh itself.
        self.is_own = np.array_equal(self.corners, column(obj.data.loops, "vertex_index", np.int32))
        self.marked_edges = _marked_edges(mesh) if obj.brindle.use_marked_edges else ()
        self._vectors = {attribute.name: (attribute.domain, column(attribute.data, "vector", np.float32, 3))
                         for attribute in mesh.attributes
                         if attribute.data_type == "FLOAT_VECTOR" and attribute.domain in ("POINT", "FACE")}

    def vectors(self, name):
        """(n, 3): a vector attribute at the vertices, those of faces as means of axes."""
        if name not in self._vectors:
            found = ", ".join(sorted({*self._vectors} - {"position"})) or "none"
            raise brindle.Error(f"'{name}' is no vector attribute of points or faces; there are: {found}")
        domain, vectors = self._vectors[name]
        vectors = self._stretched(vectors)
        if domain == "FACE":
            return self.surface.cells_to_points(vectors[self.polygons], name, axes=True)
        return np.concatenate([vectors, vectors[self._copied]])

    def _stretched(self, vectors):
        if np.array_equal(self.stretch, np.eye(3)):
            return vectors
        return (vectors @ self.stretch.T).astype(np.float32)

    @property
    def from_surface(self):
        """The matrix from coordinates of the surface to those of the object."""
        return Matrix(np.linalg.inv(self.stretch).tolist()).to_4x4()

    def placed(self, points, matrix):
        """Points of another object or of the world on the surface; `matrix` leads to the object's axes."""
        matrix = np.array(matrix)
        return (points @ matrix[:3, :3].T + matrix[:3, 3]) @ self.stretch.T

    def quads(self):
        """The polygons as pairs of triangles: (k,) first ones and (k,) second ones, or -1."""
        count = np.bincount(self.polygons)
        if len(count) and count.max() > 2:
            face = int(np.argmax(count > 2))
            raise brindle.Error(f"face {face} has {count[face] + 2} corners, and corners of faces hold the pattern: "
                                "at most 4 are possible; add a Triangulate modifier")
        first = np.flatnonzero(np.diff(self.polygons, prepend=-1))
        return first, np.where(count[self.polygons[first]] == 2, first + 1, -1)


def _marked_edges(mesh):
    """(k, 2) vertices of the edges that are marked sharp or have a crease."""
    marked = column(mesh.edges, "use_edge_sharp", bool)
    if "crease_edge" in mesh.attributes:  # from Blender 4.0 on
        marked |= column(mesh.attributes["crease_edge"].data, "value", np.float32) > 0
    elif hasattr(mesh.edges[0] if len(mesh.edges) else None, "crease"):
        marked |= column(mesh.edges, "crease", np.float32) > 0
    return column(mesh.edges, "vertices", np.int32, 2)[marked]
