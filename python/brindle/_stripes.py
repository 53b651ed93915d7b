"""Stripe patterns."""

from __future__ import annotations

import json
from functools import cached_property
from time import perf_counter
from typing import TYPE_CHECKING, Any, Mapping, Optional

from . import _core
from ._arguments import (Match, PhaseShift, Result, Solver, Weights, check_scalar,
                         count_and_frequency, described, flag, kept_property, number, options_of,
                         path_of, solving, warn, whole_number, word)
from ._surface import Progress, Surface, _flat_tensors, _last_of_stripes, as_surface

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    from ._curves import Curves
    from ._textures import TexturedMesh

_TENSOR_COLUMNS = (6, 9)
_TURN = "turn_deg"


_DETAIL = ("field_smoothing", "field_weight", "fill", "field_arrows", "field_singularities", "hold_out",
           "frequency_smoothing")
_OWN_WEIGHTS = ("length", "anisotropy")


def _is_number(frequency: Any) -> bool:
    """Whether the frequency is uniform: a number or the default."""
    return not isinstance(frequency, (str, list, tuple)) and not getattr(frequency, "shape", ())


class Field:
    """Directions of a pattern, and their origin. ``options`` may have those of measured fields;
    the ``symmetry`` of crosses is 4."""

    def __init__(self, surface: Surface, given: Any, along: bool,
                 previous: "Optional[Stripes]" = None, match: Optional[Match] = None,
                 options: Optional[Mapping[str, Any]] = None, symmetry: int = 2,
                 measured: bool = True, oriented: bool = False) -> None:
        """``oriented``: vectors of a named array have signs: opposite ones cancel."""
        begin = perf_counter()
        self.origin = _core.FieldOrigin()
        self.origin.measured = given is not None and measured
        self._signs = oriented or (options or {}).get("field_arrows") is True
        self.directions = (self._following(surface, previous, match)
                           if given is None and previous is not None
                           else self._directions(surface, given))
        self.is_detailed = self._smooth_data(surface, options or {}, symmetry)
        if along:
            if not self.is_detailed:  # smoothing comes before the turn
                self.directions = surface.turned_field(self.directions, 90)
            self.origin.turn_deg = 90
        self.origin.milliseconds = 1000 * (perf_counter() - begin)

    def _smooth_data(self, surface: Surface, options: Mapping[str, Any], symmetry: int) -> bool:
        """Whether the options request smoothing. Raises Error for options without effect."""
        given = {name: options[name] for name in _DETAIL if options.get(name) is not None}
        if flag(given.pop("field_arrows", False), "field_arrows"):
            given["field_arrows"] = True
        for name in ("field_smoothing", "fill", "field_singularities", "hold_out",
                     "frequency_smoothing"):
            check_scalar(name, given.get(name))
        request = _core.SmoothingArguments()
        request.periods = number(given.get("field_smoothing", 0), "field_smoothing")
        request.frequency_periods = number(given.get("frequency_smoothing", 0), "frequency_smoothing")
        request.frequency_varies = not _is_number(options.get("frequency"))
        request.symmetry = 1 if "field_arrows" in given and symmetry == 2 else symmetry
        if "fill" in given:
            request.fill = number(given["fill"], "fill")
        if "field_singularities" in given:
            request.singularities = whole_number(given["field_singularities"],
                                                "field_singularities")
        if "hold_out" in given:
            request.hold_out = number(given["hold_out"], "hold_out")
        weight = given.get("field_weight")
        self.origin.smooth_data(options_of(given), request,
                                  self._weights(surface, weight) if request.periods else None)
        return request.periods > 0

    def _weights(self, surface: Surface, weight: Any) -> Any:
        if not isinstance(weight, str) or weight in _OWN_WEIGHTS:
            return weight
        _, array, is_of_cells = surface._core.array_named(weight)
        return array if is_of_cells and self._of_triangles else surface.array(weight)

    def _following(self, surface: Surface, previous: "Stripes", match: Optional[Match]) -> Any:
        """The smooth field that goes on from that of a pattern, before it was turned."""
        self.origin.source = "the smooth field"
        before = previous.directions
        if previous._core.turn_deg != 0:
            before = previous.surface.turned_field(before, -previous._core.turn_deg)
        field, turned = surface._smooth_field(last=_last_of_stripes(previous, before, match))
        self.origin.field_turned_deg = turned
        return field

    def _directions(self, surface: Surface, given: Any) -> Any:
        self.origin.source = "the field"
        if given is None:
            self.origin.source = "the smooth field"
            return surface.smooth_field()
        if isinstance(given, str):
            self.origin.source = f"the array '{given}'"
            name, array, is_of_cells = surface._core.array_named(given)
            rows = surface.array(given) if self._signs else surface.axes(given)
            directions = self._of_array(surface, name, rows)
            if is_of_cells:  # before the transfer to vertices
                self.origin.rows_nonfinite = _core.nonfinite_rows(array)
                if self.origin.tensor is None:
                    self._of_triangles = True
                    self.origin.set_data(name, array, True)
            return directions
        if isinstance(given, (list, tuple)):
            given = _core.unmasked(given)
        shape: tuple[int, ...] = getattr(given, "shape", ())
        if len(shape) == 2 and shape[1] == 2 or len(shape) == 3 or (
                len(shape) == 2 and shape[1] in _TENSOR_COLUMNS):
            return self._of_array(surface, "directions", given)
        if len(shape) == 2 and shape[1] == 3:
            self.origin.set_data("directions", given, False)
        return given

    _of_triangles = False  # whether rows are those of triangles

    def _of_array(self, surface: Surface, name: str, array: Any) -> Any:
        array = _flat_tensors(array)
        if len(array.shape) == 2 and array.shape[1] in _TENSOR_COLUMNS:
            directions, nonfinite, near_normal, isotropic, _ = _core.tensor_field(
                surface._core, name, array, "major")
            self.origin.tensor = (near_normal, isotropic)
        else:
            directions, nonfinite = _core.array_field(surface._core, name, array)
        self.origin.rows_nonfinite = nonfinite
        self.origin.set_data(name, array, False)
        return directions


def frequencies_of(surface: Surface, frequency: Any) -> Any:
    """A frequency, or those of a named array."""
    return surface.array(frequency) if isinstance(frequency, str) else frequency


def invocation(command: str, surface: Surface, options: Mapping[str, Any],
               defaults: Mapping[str, Any]) -> str:
    """The call in reports, as JSON: options other than the defaults."""
    return json.dumps({"version": _core.version(), "command": command, "input": surface.name,
                       "options": described(options, defaults)})


def defaults_of(function: Any) -> dict[str, Any]:
    """The defaults of its arguments."""
    return dict(function.__kwdefaults__ or {})


class Stripes(Result):
    """Stripes over a surface: what ``brindle.stripes`` returns.

    Arrays share the pattern's memory if possible, are read-only, and keep it alive.
    """

    def __init__(self, core: "_core.Stripes", surface: Surface, said: str,
                 also_on: tuple[Surface, ...] = ()) -> None:
        self._core = core
        self._said = said
        self._also_on = also_on
        self.surface = surface

    def __repr__(self) -> str:
        branches = "" if self.surface.is_points else f"{self.report['branches']} branches, "
        return f"<brindle.Stripes: {branches}spacing {self._spacing():.4g}, on {self.surface!r}>"

    def _spacing(self) -> float:
        """One mean period of the waves; 1 if there are none."""
        import numpy as np
        frequencies = self.frequency[np.any(self.directions != 0, axis=1)]
        return 1 / float(np.mean(frequencies, dtype=np.float64)) if len(frequencies) else 1

    @property
    def phases(self) -> "NDArray[np.complex64]":
        """(n,) exp(i Phi) per vertex; stripes are where Phi is near pi / 2. Without a wave it is
        a meaningless 1j: ``point_data`` has NaN there, and ``valid`` 0. Shares memory."""
        return self._core.phases

    @property
    def frequency(self) -> "NDArray[np.float32]":
        """(n,) stripes per unit length. Shares memory."""
        return self._core.frequency

    @property
    def frequency_wanted(self) -> "NDArray[np.float32]":
        """(n,) requested stripes per unit length: ``frequency`` before the spacing tolerance."""
        return self._core.frequency_wanted

    @property
    def frequency_change(self) -> Optional[dict[str, Any]]:
        """With ``slack``, metrics of the change of frequencies: ratios of chosen to requested
        ones, the share of vertices at the bounds, and so on."""
        return self._core.frequency_change()

    @property
    def turned(self) -> Optional[dict[str, float]]:
        """With ``winding``, the turn of the field, and the energy before."""
        return self._core.turned()

    @property
    def cancelled_branches(self) -> Optional[dict[str, float]]:
        """With ``cancel_branches``: cancelled pairs, branches and energy before and after."""
        return self._core.cancelled_branches()

    def windings(self) -> dict[str, Optional[int]]:
        """Winding numbers of ``surface.loops()``, by name: 0 are rings, 1 a right-handed spiral,
        -1 a left-handed one. None if the field has no orientation along the loop."""
        return _core.windings(self._core)

    @property
    def directions(self) -> "NDArray[np.float32]":
        """(n, 3) unit tangent vectors, zero where there is no wave. Shares memory."""
        return self._core.directions

    @kept_property
    def corner_phases(self) -> "NDArray[np.float32]":
        """(m, 3) lifted phases at the corners of triangles, in radians, linear within each; NaN
        for triangles without (a singularity of the field, a corner without wave)."""
        return self._core.corner_phases()

    @kept_property
    def branches(self) -> "NDArray[np.int8]":
        """(m,) 1 in triangles where a stripe begins or ends, including singularities of the
        field; 0 elsewhere."""
        return self._core.branches()

    @kept_property
    def branch_indices(self) -> "NDArray[np.int8]":
        """(m,) the phase gained around each triangle, over 2 pi; 0 in singularities."""
        return self._core.branch_indices()

    @kept_property
    def singularities(self) -> "NDArray[np.bool_]":
        """(m,) True in triangles whose corners' directions cannot be aligned."""
        return self._core.kinds() == 2

    @kept_property
    def angle_errors(self) -> "NDArray[np.float32]":
        """(m,) degrees between the phase's gradient and the field; -1 in irregular triangles."""
        return self._core.angle_errors()

    @cached_property
    def report(self) -> dict[str, Any]:
        """All metrics of the pattern, with the keys of the tool's ``--report``."""
        return json.loads(self._core.report(self._said))

    @kept_property
    def point_data(self) -> "dict[str, NDArray[Any]]":
        """Named arrays with a row per vertex, as in the tool's mesh files: phase (radians; NaN
        without a wave), direction, frequency, branch, sin_phase, valid, original_id."""
        return self._core.point_arrays()

    @kept_property
    def cell_data(self) -> "dict[str, NDArray[Any]]":
        """Named arrays with a row per triangle: branch, corner_phase."""
        return self._core.cell_arrays()

    def curves(self, *, join: bool = False, trim: Optional[float] = None, fair: float = 0,
               offset: float = 0, min_length: float = 0, simplify: Optional[float] = None,
               resample: Optional[float] = None) -> "Curves":
        """The centre lines of the stripes: ``points, edges = p.curves()`` gives (k, 3) and (l,
        2).

        ``join``: where curves end in one branch, joins them in pairs. ``trim``: cuts ends at branches
        and singularities back to where no neighbour is nearer than this share of the spacing (0.6 by
        default; 0: as traced), without hooks; not together with ``join``. ``fair``: takes out kinks
        shorter than about this share of the spacing (0.25 is good; 0 leaves them). ``offset``: moved by
        so many periods (0.5: the middle of the gaps). ``min_length``, ``resample`` (distance between
        points) and ``simplify`` (tolerance) are lengths.
        """
        from ._curves import curves_of
        return curves_of(self, join, trim, fair, offset, min_length, simplify, resample)

    def mesh(self) -> "TexturedMesh":
        """A mesh with texture coordinates: U across the stripes, one unit per period."""
        from ._textures import TexturedMesh
        return TexturedMesh(_core.textured_stripes(self._core), self)

    def write(self, path: Any, *, uv: bool = False) -> None:
        """Writes .vtp, .ply, .gltf, .glb or .obj as ``brindle stripe --output``, atomically: the
        arrays of the pattern and of the surface; one with a name of the pattern's becomes
        "NAME_input". ``uv``: adds texture coordinates, which splits vertices. Warns of arrays
        that the format cannot hold."""
        if flag(uv, "uv"):
            self.mesh().write(path)
            return
        points, cells = fitting(path_of(path), self.point_data, self.cell_data)
        if self.surface.is_points:
            points = {"normal": self.surface.normals, **points}
        # The turn in the surface's arrays belongs to other waves.
        beside = {name: array for name, array in self.surface.point_data.items() if name != _TURN}
        for line in _core.write_surface(path_of(path), self.surface._core, points, cells, beside,
                                        self.surface.cell_data):
            warn(line)

    def put_on(self, mesh: Any, *, prefix: str = "") -> Any:
        """Puts the pattern's arrays on a mesh of pyvista, trimesh, meshio or VTK with the same
        number of vertices: ``point_data`` and ``cell_data``, with ``prefix`` before their names.
        Replaces those of an earlier pattern; raises Error if another array has one of the names.
        Returns the mesh."""
        from ._meshes import put_pattern
        return put_pattern(mesh, self.surface, self.point_data, self.cell_data, word(prefix, "prefix"))


def has_solver(name: str) -> bool:
    """Whether this build has the solver; only "global" may be missing."""
    return _core.has_solver(word(name, "name"))


def fitting(path: str, points: Mapping[str, Any], cells: Mapping[str, Any]) -> tuple[dict, dict]:
    """The waves' arrays that a format can hold: glTF has no NaN and no cells, OBJ no waves."""
    kind = path.lower().rpartition(".")[2]
    if kind == "obj":
        return {name: points[name] for name in ("normal", "uv") if name in points}, {}
    if kind not in ("gltf", "glb"):
        return dict(points), dict(cells)
    import numpy as np
    return {name: np.nan_to_num(array) if name.startswith(("phase", "sin_phase")) else array
            for name, array in points.items()}, {}


def stripes(surface: Any, directions: "Optional[ArrayLike]" = None, *, stripes: Any = None,
            frequency: Any = None, spacing: Optional[float] = None, along: bool = False,
            solver: Solver = "multilevel",
            phase_shift: PhaseShift = "aligned", weights: Weights = "paper", epsilon: Optional[float] = None,
            momentum: Optional[float] = None, seed: Optional[int] = None,
            sweeps: Optional[int] = None, cycles: Optional[int] = None,
            global_iterations: Optional[int] = None, slack: Any = None,
            avoid_branches: "Optional[ArrayLike]" = None, anchor_boundary: Optional[float] = None,
            winding: Any = None, cancel_branches: Optional[float] = None,
            cancel_distance: Optional[float] = None, previous: Optional[Stripes] = None,
            lambda_: Optional[float] = None, match: Optional[Match] = None,
            field_smoothing: Optional[float] = None,
            field_weight: Any = None, fill: Optional[float] = None, field_arrows: bool = False,
            field_singularities: Optional[int] = None, hold_out: Optional[float] = None,
            frequency_smoothing: Optional[float] = None, threads: int = 0,
            progress: Optional[Progress] = None) -> Stripes:
    """Lays stripes over a surface, across ``directions``: waves run along them.

    ``surface``: a Surface, or anything that ``brindle.as_surface`` accepts. ``directions``: (n,
    3) vectors of any length, up to sign, one per vertex, projected into the tangent planes (unit
    tangent vectors are not changed); zero or NaN for no wave; or the name of an array of vectors
    or tensors of the surface; None: ``surface.smooth_field()``. ``along``: stripes run along the
    directions instead.

    ``stripes``: so many along the bounding box's diagonal (40 unless one of the others is given).
    ``frequency``: stripes per unit length, a number, an array (n,), where NaN means no wave
    (of vectors (n, 3) the length counts), or the name of one. ``spacing``: distance between
    stripes, the same as a ``frequency`` of 1 / spacing.

    ``solver``: "multilevel", "relaxation", "averaged" or "global" (in builds with CHOLMOD).
    ``phase_shift``: "aligned", "common_source" or "trapezoid". ``weights``: "paper" or
    "cotangent". ``sweeps`` and ``cycles`` belong to multilevel; ``epsilon``, ``momentum`` and
    ``seed`` to relaxation and averaged; ``global_iterations`` to global.

    ``slack``: spacing tolerance S, a number or an array (n,): frequencies may vary between f / (1
    + S) and f (1 + S) for fewer branches; 0 or None: not at all. ``avoid_branches``: weights (n,) from 0 to
    1, avoids branches there. ``p.frequency`` is then the chosen one.

    ``anchor_boundary``: lays the first stripe along boundaries, this many periods inside (0: on
    the rim, 0.5: the rim is in the middle of a gap). ``winding``: the number of stripes that wind
    around a loop as helices: a number on surfaces with one loop, else a dict by the names of
    ``surface.loops()``. It turns the field by small angles.

    ``cancel_branches``: cancels pairs of opposite branches, cheapest first, while the energy stays
    within 1 + this share of its value before; 0: only pairs that lower it. ``cancel_distance``:
    greatest distance within a pair, in periods (default 10).

    ``previous``: stays near to the phases of another pattern by ``lambda_`` (0.025), whose vertices
    are matched by "number" or "position" (``match``; by number if the triangles are the same). The
    smooth field (``directions`` None) then goes on from that pattern's field, as it was before
    ``along`` turned it, unless ``lambda_`` is 0. It solves again, and so moves phases a little even
    where the input is that of the other pattern; ``brindle.Animator`` then keeps them, and is faster,
    for the frames of one surface. Use ``previous`` where triangles change, or for single steps.

    ``field_smoothing``: smooths measured directions over so many periods of the stripes (0: not; 1 for
    noisy data).
    ``field_weight``: how much each counts, 0 or NaN if there is none: an array (n,), the name of
    one, "length" or "anisotropy". ``fill``: how far holes are filled, in periods (2).
    ``field_arrows``: directions have a sign. ``field_singularities``: pairs of singularities are
    cancelled, the nearest first, until at most so many remain or no pair is left.
    ``hold_out``: reports the mean angle between this share of the data and the field of the others.
    ``p.point_data`` has ``coherence``, how much data agree around a vertex, and ``filled``, 1 where
    the direction or frequency fills a hole. ``frequency_smoothing``: sees an array of
    frequencies at the scale of so many periods, its NaN filled as far as ``fill``.

    ``threads``: at most this many, 0 for all; results do not depend on it. ``progress(stage,
    fraction)`` receives progress, and cancels by returning False. Other Python threads run
    meanwhile; Ctrl-C cancels.

    Raises brindle.Error for invalid values, brindle.Cancelled, TypeError for wrong types.
    """
    given = dict(locals())
    surface = as_surface(given.pop("surface"))
    given.pop("progress")
    if previous is not None and not isinstance(previous, Stripes):
        raise TypeError(f"previous: expected brindle.Stripes, got {type(previous).__name__}")
    options = solving(given, surface)
    field = Field(surface, directions, flag(along, "along"),
                  None if options.lambda_ == 0 else previous, match, given)
    count, frequency = count_and_frequency(stripes, frequencies_of(surface, frequency), spacing)
    made = _core.stripes(surface._core, field.directions, count, frequency, field.origin, options,
                         None if previous is None else previous._core,
                         "" if match is None else word(match, "match"), progress)
    warn(made.warnings(field.origin.source))
    return Stripes(made, surface, invocation("stripes", surface, given, _DEFAULTS))


_DEFAULTS = defaults_of(stripes)


def stripes_from_phases(surface: Any, phases: "ArrayLike", directions: "ArrayLike", *,
                        stripes: Any = None, frequency: Any = None,
                        spacing: Optional[float] = None,
                        phase_shift: PhaseShift = "aligned") -> Stripes:
    """The pattern of phases that are known, such as those of ``Animator.frame`` or of a file:
    complex (n,), exp(i Phi) per vertex; where they are 0 or NaN (``np.exp(1j *
    p.point_data["phase"])``), there is no wave. Directions and frequencies are those of the frame.
    Lifted to the triangles and measured like any other."""
    given = {"phase_shift": phase_shift, "stripes": stripes, "frequency": frequency,
             "spacing": spacing}
    surface = as_surface(surface)
    field = Field(surface, directions, False)
    count, frequency = count_and_frequency(stripes, frequencies_of(surface, frequency), spacing)
    made = _core.stripes_from_phases(surface._core, phases, field.directions, count, frequency,
                                     field.origin, solving({"phase_shift": phase_shift}, surface))
    return Stripes(made, surface, invocation("stripes_from_phases", surface, given,
                                             defaults_of(stripes_from_phases)))
