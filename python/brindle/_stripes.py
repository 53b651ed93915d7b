"""Stripe patterns."""

from __future__ import annotations

import json
from functools import cached_property
from time import perf_counter
from typing import TYPE_CHECKING, Any, Mapping, Optional

from . import _core
from ._arguments import (check_scalar, count_and_frequency, described, flag, kept_property, number,
                         options_of, path_of, solving, warn, whole_number, word)
from ._surface import Progress, Surface, _flat_tensors, _last_of_stripes, as_surface

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    from ._curves import Curves
    from ._textures import TexturedMesh

_TENSOR_COLUMNS = (6, 9)
_TURN = "turn_deg"


_DETAIL = ("field_detail", "field_weight", "fill", "field_arrows", "field_singularities",
           "frequency_detail")
_OWN_WEIGHTS = ("length", "anisotropy")


def _is_number(frequency: Any) -> bool:
    """Whether it is the same everywhere: a number, or none is given."""
    return not isinstance(frequency, (str, list, tuple)) and not getattr(frequency, "shape", ())


class Field:
    """Directions that a pattern follows, and where they come from. ``options`` may have those of
    measured fields; of crosses, the ``symmetry`` is 4."""

    def __init__(self, surface: Surface, given: Any, along: bool,
                 previous: "Optional[Stripes]" = None, match: Optional[str] = None,
                 options: Optional[Mapping[str, Any]] = None, symmetry: int = 2,
                 measured: bool = True, oriented: bool = False) -> None:
        """``oriented``: vectors of a named array have signs, and opposite ones cancel each
        other."""
        begin = perf_counter()
        self.origin = _core.FieldOrigin()
        self.origin.measured = given is not None and measured
        self._signs = oriented or (options or {}).get("field_arrows") is True
        self.directions = (self._following(surface, previous, match)
                           if given is None and previous is not None
                           else self._directions(surface, given))
        self.is_detailed = self._see_at_detail(surface, options or {}, symmetry)
        if along:
            if not self.is_detailed:  # which is seen before it is turned
                self.directions = surface.turned_field(self.directions, 90)
            self.origin.turn_deg = 90
        self.origin.milliseconds = 1000 * (perf_counter() - begin)

    def _see_at_detail(self, surface: Surface, options: Mapping[str, Any], symmetry: int) -> bool:
        """Whether the options ask for it. Raises Error for those that have no effect."""
        given = {name: options[name] for name in _DETAIL if options.get(name) is not None}
        if flag(given.pop("field_arrows", False), "field_arrows"):
            given["field_arrows"] = True
        for name in ("field_detail", "fill", "field_singularities", "frequency_detail"):
            check_scalar(name, given.get(name))
        request = _core.DetailArguments()
        request.periods = number(given.get("field_detail", 0), "field_detail")
        request.frequency_periods = number(given.get("frequency_detail", 0), "frequency_detail")
        request.frequency_varies = not _is_number(options.get("frequency"))
        request.symmetry = 1 if "field_arrows" in given and symmetry == 2 else symmetry
        if "fill" in given:
            request.fill = number(given["fill"], "fill")
        if "field_singularities" in given:
            request.singularities = whole_number(given["field_singularities"],
                                                "field_singularities")
        weight = given.get("field_weight")
        self.origin.see_at_detail(options_of(given), request,
                                  self._weights(surface, weight) if request.periods else None)
        return request.periods > 0

    def _weights(self, surface: Surface, weight: Any) -> Any:
        if not isinstance(weight, str) or weight in _OWN_WEIGHTS:
            return weight
        _, array, is_of_cells = surface._core.array_named(weight)
        return array if is_of_cells and self._of_triangles else surface.array(weight)

    def _following(self, surface: Surface, previous: "Stripes", match: Optional[str]) -> Any:
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
            if is_of_cells:  # before rows were moved to vertices
                self.origin.rows_nonfinite = _core.nonfinite_rows(array)
                if self.origin.tensor is None:
                    self._of_triangles = True
                    self.origin.set_data(name, array, True)
            return directions
        if isinstance(given, (list, tuple)):
            given = _core.unmasked(given)
        shape = getattr(given, "shape", ())
        if len(shape) == 2 and shape[1] == 2 or len(shape) == 3 or (
                len(shape) == 2 and shape[1] in _TENSOR_COLUMNS):
            return self._of_array(surface, "directions", given)
        if len(shape) == 2 and shape[1] == 3:
            self.origin.set_data("directions", given, False)
        return given

    _of_triangles = False  # whether the data are

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
    """What a report says of a call, as JSON: the options that are not the defaults."""
    return json.dumps({"version": _core.version(), "command": command, "input": surface.name,
                       "options": described(options, defaults)})


def defaults_of(function: Any) -> dict[str, Any]:
    """What its arguments are unless they are given."""
    return dict(function.__kwdefaults__ or {})


class Stripes:
    """Stripes over a surface: what ``brindle.stripes`` returns.

    Arrays share the pattern's memory where they can, are read-only, and keep it alive.
    """

    def __init__(self, core: "_core.Stripes", surface: Surface, said: str,
                 also_on: tuple[Surface, ...] = ()) -> None:
        self._core = core
        self._said = said
        self._also_on = also_on
        self.surface = surface

    def __repr__(self) -> str:
        return f"<brindle.Stripes on {self.surface!r}>"

    @property
    def phases(self) -> "NDArray[np.complex64]":
        """(n,) exp(i Phi) per vertex; stripes are where Phi is near pi / 2. Where there is no wave
        it is 1j and says nothing: ``point_data`` has NaN there, and its ``valid`` 0. Shares
        memory."""
        return self._core.phases

    @property
    def frequency(self) -> "NDArray[np.float32]":
        """(n,) stripes per unit length. Shares memory."""
        return self._core.frequency

    @property
    def frequency_wanted(self) -> "NDArray[np.float32]":
        """(n,) stripes per unit length that were asked for: those of ``frequency`` but for slack."""
        return self._core.frequency_wanted

    @property
    def frequency_change(self) -> Optional[dict[str, Any]]:
        """With slack, what has become of the frequencies: ratios of those chosen to those asked
        for, the share of vertices at the bounds, and so on."""
        return self._core.frequency_change()

    @property
    def turned(self) -> Optional[dict[str, float]]:
        """With winding, how far the field was turned for it, and the energy before."""
        return self._core.turned()

    @property
    def merged(self) -> Optional[dict[str, float]]:
        """With merge_branches: the pairs that are gone, branches and energy before and after."""
        return self._core.merged()

    def windings(self) -> dict[str, Optional[int]]:
        """How many stripes wind round each of ``surface.loops()``, by its name: 0 are rings, 1 a
        right-handed spiral, -1 a left-handed one. None where the field has no orientation there."""
        return _core.windings(self._core)

    @property
    def directions(self) -> "NDArray[np.float32]":
        """(n, 3) unit tangent vectors, zero where there is no wave. Shares memory."""
        return self._core.directions

    @kept_property
    def corner_phases(self) -> "NDArray[np.float32]":
        """(m, 3) lifted phases at the corners of triangles, in radians, linear in the triangle; NaN
        where a triangle has none (a singularity of the field, a corner without wave)."""
        return self._core.corner_phases()

    @kept_property
    def branches(self) -> "NDArray[np.int8]":
        """(m,) 1 in triangles where a stripe begins or ends, singularities of the field among them;
        0 elsewhere."""
        return self._core.branches()

    @kept_property
    def branch_indices(self) -> "NDArray[np.int8]":
        """(m,) what the phase gains around each triangle, over 2 pi; 0 in singularities."""
        return self._core.branch_indices()

    @kept_property
    def singularities(self) -> "NDArray[np.bool_]":
        """(m,) True in triangles whose corners' directions cannot be oriented alike."""
        return self._core.kinds() == 2

    @kept_property
    def angle_errors(self) -> "NDArray[np.float32]":
        """(m,) degrees between the phase's gradient and the field; -1 in irregular triangles."""
        return self._core.angle_errors()

    @cached_property
    def report(self) -> dict[str, Any]:
        """Every figure about the pattern, with the keys of the tool's ``--report``."""
        return json.loads(self._core.report(self._said))

    @kept_property
    def point_data(self) -> "dict[str, NDArray[Any]]":
        """Named arrays of a row per vertex, those of the tool's mesh files: phase (radians; NaN
        where there is no wave), direction, frequency, branch, sin_phase, valid, original_id."""
        return self._core.point_arrays()

    @kept_property
    def cell_data(self) -> "dict[str, NDArray[Any]]":
        """Named arrays of a row per triangle: branch, corner_phase."""
        return self._core.cell_arrays()

    def curves(self, *, join: bool = False, trim: Optional[float] = None, fair: float = 0,
               offset: float = 0, min_length: float = 0, simplify: Optional[float] = None,
               resample: Optional[float] = None) -> "Curves":
        """The centre lines of the stripes: ``points, edges = p.curves()`` gives (k, 3) and (l, 2).

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
        """A mesh with texture coordinates: U across the stripes, one unit a period."""
        from ._textures import TexturedMesh
        return TexturedMesh(_core.textured_stripes(self._core), self.surface)

    def write(self, path: Any, *, uv: bool = False) -> None:
        """Writes .vtp, .ply, .gltf, .glb or .obj as ``brindle stripe --output``, whole or not at
        all: the pattern's arrays and those of the surface, of which one with a name of the pattern's
        is called "NAME_input". ``uv``: with texture coordinates, where
        vertices are split. Warns of arrays that the format cannot hold."""
        if flag(uv, "uv"):
            self.mesh().write(path)
            return
        points, cells = fitting(path_of(path), self.point_data, self.cell_data)
        if self.surface.is_points:
            points = {"normal": self.surface.normals, **points}
        # The surface's turn is that of other waves.
        beside = {name: array for name, array in self.surface.point_data.items() if name != _TURN}
        for line in _core.write_surface(path_of(path), self.surface._core, points, cells, beside,
                                        self.surface.cell_data):
            warn(line)

    def put_on(self, mesh: Any, *, prefix: str = "") -> Any:
        """Puts the pattern's arrays on a mesh of pyvista, trimesh, meshio or VTK, the one that it
        was made for or another one with as many vertices: ``point_data`` and ``cell_data`` of this,
        their names after ``prefix``. Replaces those of an earlier pattern; raises Error where
        another array of the mesh has one of the names. Returns the mesh."""
        from ._meshes import put_pattern
        return put_pattern(mesh, self.surface, self.point_data, self.cell_data, word(prefix, "prefix"))


def has_solver(name: str) -> bool:
    """Whether this build has the solver: all but "global" are always there."""
    return _core.has_solver(word(name, "name"))


def fitting(path: str, points: Mapping[str, Any], cells: Mapping[str, Any]) -> tuple[dict, dict]:
    """Arrays of waves as a format has them: glTF has no NaN and no cells, OBJ has no waves."""
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
            solver: str = "multilevel",
            phase_shift: str = "aligned", weights: str = "paper", epsilon: Optional[float] = None,
            momentum: Optional[float] = None, seed: Optional[int] = None,
            sweeps: Optional[int] = None, cycles: Optional[int] = None,
            global_iterations: Optional[int] = None, slack: Any = None,
            calm: "Optional[ArrayLike]" = None, anchor_boundary: Optional[float] = None,
            winding: Any = None, merge_branches: Optional[float] = None,
            merge_distance: Optional[float] = None, previous: Optional[Stripes] = None,
            lambda_: Optional[float] = None, match: Optional[str] = None,
            field_detail: Optional[float] = None,
            field_weight: Any = None, fill: Optional[float] = None, field_arrows: bool = False,
            field_singularities: Optional[int] = None, frequency_detail: Optional[float] = None,
            threads: int = 0, progress: Optional[Progress] = None) -> Stripes:
    """Lays stripes over a surface, across ``directions``: waves run along them.

    ``surface``: a Surface, or whatever ``brindle.as_surface`` takes. ``directions``: (n, 3) vectors
    of any length, up to sign, a row per vertex, projected into the tangent planes (unit tangent
    vectors stay as they are); zero or NaN for no wave; or the name of an array of vectors or
    tensors that the surface has; None: ``surface.smooth_field()``. ``along``: stripes run along
    them instead.

    ``stripes``: so many along the bounding box's diagonal (40 unless one of the others is given).
    ``frequency``: stripes per unit length, a number, an array (n,), where NaN means no wave
    (of vectors (n, 3) the length counts), or the name of one. ``spacing``: distance between
    stripes, the same as a ``frequency`` of 1 / spacing.

    ``solver``: "multilevel", "relaxation", "averaged" or "global" (where built with CHOLMOD).
    ``phase_shift``: "aligned", "common_source" or "trapezoid". ``weights``: "paper" or
    "cotangent". ``sweeps`` and ``cycles`` are of multilevel; ``epsilon``, ``momentum`` and ``seed``
    of relaxation and averaged; ``global_iterations`` of global.

    ``slack``: lets frequencies vary between f / (1 + S) and f (1 + S) for fewer branches, a number
    S or an array (n,); 0 or None: not at all. ``calm``: weights (n,) from 0 to 1, avoids branches
    there. ``p.frequency`` then is what was chosen.

    ``anchor_boundary``: lays the first stripe along boundaries, so many periods inside (0: on the
    rim, 0.5: the rim is in the middle of a gap). ``winding``: how many stripes wind round a loop as
    helices, of a surface with one way round a number, else a dict by the names of
    ``surface.loops()``; turns the field by small angles.

    ``merge_branches``: removes pairs of opposite branches, those first that raise the energy least,
    as long as it stays within 1 + so much times what it was; 0: those alone that lower it.
    ``merge_distance``: how far the two of a pair may be from each other, in periods (10).

    ``previous``: stays near to the phases of another pattern by ``lambda_`` (0.025), whose vertices
    are matched by "number" or "position" (``match``; by number if the triangles are the same). The
    smooth field (``directions`` None) then goes on from that pattern's field, as it was before
    ``along`` turned it, unless ``lambda_`` is 0.

    ``field_detail``: smooths measured directions over so many periods of the stripes (0: not; 1 for
    noisy data).
    ``field_weight``: how much each counts, 0 or NaN if there is none: an array (n,), the name of
    one, "length" or "anisotropy". ``fill``: how far holes are filled, in periods (2).
    ``field_arrows``: directions have a sign. ``field_singularities``: pairs of singularities are
    cancelled, the nearest first, until at most so many remain or no pair is left.
    ``p.point_data["agreement"]`` says how much they agree. ``frequency_detail``: sees an array of
    frequencies at the scale of so many periods, its NaN filled as far as ``fill``.

    ``threads``: at most so many, 0 for all; results do not depend on it. ``progress(stage,
    fraction)`` hears of stages, and cancels by returning False. Other threads of Python run
    meanwhile; Ctrl-C stops it.

    Raises brindle.Error for values that cannot be, brindle.Cancelled, TypeError for wrong types.
    """
    given = dict(locals())
    surface = as_surface(given.pop("surface"))
    given.pop("progress")
    if previous is not None and not isinstance(previous, Stripes):
        raise TypeError(f"previous: expected brindle.Stripes, got {type(previous).__name__}")
    options = solving(given, surface.is_points)
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
                        phase_shift: str = "aligned") -> Stripes:
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
                                     field.origin, solving({"phase_shift": phase_shift}, surface.is_points))
    return Stripes(made, surface, invocation("stripes_from_phases", surface, given,
                                             defaults_of(stripes_from_phases)))
