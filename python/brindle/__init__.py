"""Brindle lays evenly spaced stripes over surfaces, along or across a direction that you choose.

    import brindle
    s = brindle.shape("trefoil")                  # or brindle.read(path), brindle.Surface(V, F)
    d = s.curvature_field("max")                  # (n, 3): waves run along it, stripes across it
    p = brindle.stripes(s, d, stripes=40)
    points, edges = p.curves()                    # (k, 3), (l, 2)
    brindle.write_png("trefoil.png", brindle.render(s, p))

Arrays are numeric numpy arrays in any memory order; results share memory if possible and keep their
owner alive. Lengths are in the units of the vertices, frequencies in stripes per unit length, phases
in radians. Errors that a caller can fix are brindle.Error, a ValueError; wrong types are TypeError.
Calls that fail or are interrupted (Ctrl-C) change nothing. Functions are thread-safe and release
Python's lock. Results are the same bits for any number of threads, and those of the brindle tool.
brindle.advanced has what is rarely needed.
"""

import importlib

# Loaded on demand, because the C++ module loads a dozen libraries.
_HOMES = {
    "_animate": ("Animator", "FieldAnimator", "TextureAnimator"),
    "_arguments": ("Cancelled", "Error", "PatternWarning"),
    "_interop": ("to_meshio", "to_pyvista", "to_trimesh"),
    "_options": ("Layout", "Look", "Measured", "Previous", "Slack", "Solver"),
    "_outputs": ("Curves", "Samples", "Stripes", "Texture", "TexturedMesh"),
    "_paths": ("Paths", "paths"),
    "_patterns": ("crosses", "samples", "stripes", "texture"),
    "_pictures": ("has_opengl", "read_png", "render", "write_png"),
    "_relief": ("Relief", "relief"),
    "_surface": ("Loop", "Stroke", "Surface", "as_surface", "points", "read", "shape", "shape_help",
                 "shape_names"),
}
_HOME_OF = {name: home for home, names in _HOMES.items() for name in names}

__all__ = sorted(_HOME_OF)


def __getattr__(name):
    if name == "__version__":
        value = importlib.import_module("._core", __name__).version()
    elif name == "advanced":
        value = importlib.import_module(".advanced", __name__)
    elif name in _HOME_OF:
        value = getattr(importlib.import_module("." + _HOME_OF[name], __name__), name)
    else:
        raise AttributeError(f"module 'brindle' has no attribute '{name}'")
    globals()[name] = value
    return value


def __dir__():
    return sorted({*globals(), *__all__, "__version__", "advanced"})
