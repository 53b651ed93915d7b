"""Brindle lays evenly spaced stripes over surfaces, along or across a direction that you choose.

    import brindle
    s = brindle.shape("trefoil")                  # or brindle.read(path), brindle.Surface(V, F)
    d = s.curvature_field("max")                  # (n, 3): waves run along it, stripes across it
    p = brindle.stripes(s, d, stripes=40)
    points, edges = p.curves()                    # (k, 3), (l, 2)
    brindle.write_png("trefoil.png", brindle.render(s, p))

Arrays are numpy's, of any real or whole numbers, in any order of memory; what comes back shares
memory where it can, and keeps its owner alive. Lengths are in the units of the vertices,
frequencies in stripes per unit length, phases in radians. What a caller can mend is brindle.Error, a
ValueError; wrong types are TypeError. Nothing that fails or is interrupted (Ctrl-C) changes an
object. Functions may be called from several threads at once; Python's lock is released while they
work. Results are the same, bit for bit, for any number of threads, and those of the brindle tool.
"""

import importlib

# What is loaded when it is first asked for: the C++ side brings a dozen libraries along.
_HOMES = {
    "_animate": ("Animator", "FieldAnimator", "FieldDetail", "PatternFrames", "TextureAnimator"),
    "_arguments": ("Cancelled", "Error", "PatternWarning"),
    "_curves": ("Curves", "Samples", "samples", "samples_of"),
    "_pictures": ("has_opengl", "read_png", "render", "write_png"),
    "_stripes": ("Stripes", "has_solver", "stripes", "stripes_from_phases"),
    "_surface": ("Loop", "Stroke", "Surface", "as_surface", "points", "read", "read_strokes", "shape",
                 "shape_help", "shape_names", "write_strokes"),
    "_textures": ("Texture", "TexturedMesh", "crosses", "texture"),
}
_HOME_OF = {name: home for home, names in _HOMES.items() for name in names}

__all__ = sorted(_HOME_OF)


def __getattr__(name):
    if name == "__version__":
        value = importlib.import_module("._core", __name__).version()
    elif name in _HOME_OF:
        value = getattr(importlib.import_module("." + _HOME_OF[name], __name__), name)
    else:
        raise AttributeError(f"module 'brindle' has no attribute '{name}'")
    globals()[name] = value
    return value


def __dir__():
    return sorted({*globals(), *__all__, "__version__"})
