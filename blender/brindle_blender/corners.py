"""Patterns as attributes of the corners of triangles and quads.

Blender draws a quad as two triangles, whose phases need not agree at the corners that they share: a stripe
may begin between them. So a corner has values for both: A for the first triangle, B for the second one, and
`side`, +1 at the corner of the first alone, -1 at that of the second alone and 0 at the shared ones, so that
its sign tells the triangles apart and its size is the first barycentric coordinate. `next` is the second one.

Values are in turns from the middle of a stripe. In a triangle around which the phase gains k turns, that is
sum(t_i value_i) + k l(t), where l grows by a third of a turn linearly along each edge (F. Knöppel et al.,
Stripe patterns on surfaces, 2015), so that neighbours agree.
"""
import numpy as np

_TROUGH = 0.5
_FORWARD = np.arange(3)


def own_corners(loops, others):
    """(k,) the corner of each triangle that the other triangle does not have."""
    return np.argmin((loops[:, :, None] == others[:, None, :]).any(2), axis=1)


def _from_corner(rows, first):
    """Rows (k, 3, ...) of triangles in turn from another first corner."""
    return rows[np.arange(len(rows))[:, None], (first[:, None] + _FORWARD) % 3]


def triangle_values(pattern):
    """(m, 3) values of the triangles' corners, and (m,) turns gained around each."""
    turns = pattern.branch_indices.astype(np.float64)
    values = pattern.corner_phases / (2 * np.pi) - 0.25 - turns[:, None] * _FORWARD / 3
    # Corners around a singularity cannot be oriented alike: distances from the stripe's middle have no sign.
    faces = pattern.surface.faces
    apart = np.angle(pattern.phases) / (2 * np.pi) - 0.25
    apart = np.abs(apart - np.round(apart))[faces]
    no_wave = ~np.any(pattern.directions != 0, axis=1)[faces].any(1)
    singular = np.isnan(values).any(1)
    values = np.where(singular[:, None], np.where(no_wave[:, None], _TROUGH, apart), values)
    return values, np.where(singular, 0, turns)


def stripe_corners(mesh, pattern):
    """Two vectors per corner, (A, B, side) and (turns of A, turns of B, next)."""
    values, turns = triangle_values(pattern)
    one, two = np.zeros((2, len(mesh.corners), 3))
    first, second = mesh.quads()
    is_quad = second >= 0
    own = np.zeros(len(first), int)
    own[is_quad] = own_corners(mesh.loops[first[is_quad]], mesh.loops[second[is_quad]])
    loops = _from_corner(mesh.loops[first], own)
    ordered = _from_corner(values[first], own) + (turns[first] * own / 3)[:, None]
    for column in (0, 1):
        one[loops, column] = ordered
        two[loops, column] = turns[first][:, None]
    one[loops[:, 0], 2] = 1
    two[loops[:, 1], 2] = 1
    _put_second(mesh, values, turns, second[is_quad], loops[is_quad], one, two)
    return one.astype(np.float32), two.astype(np.float32)


def _put_second(mesh, values, turns, second, first_loops, one, two):
    """B of the second triangles of quads, given the first ones' corners from their own one on."""
    own = own_corners(mesh.loops[second], first_loops)
    loops = _from_corner(mesh.loops[second], own)
    ordered = _from_corner(values[second], own) + (turns[second] * own / 3)[:, None]
    # Where `next` comes last, the triangle is passed the other way round: k l is then -k l, and k turns.
    sign = np.where(two[loops[:, 1], 2] == 1, 1, -1)
    four = np.concatenate([loops, first_loops[:, :1]], axis=1)
    one[loops, 1] = ordered
    two[four, 0] = two[first_loops[:, :1], 0]
    two[four, 1] = (sign * turns[second])[:, None]
    one[loops[:, 0], 0] = ordered[:, 0]
    one[loops[:, 0], 2] = -1


def uv_corners(mesh, uv, quarter_turns=False):
    """(corners, 2) of coordinates (m, 3, 2). A quad's second triangle is turned by half turns (or quarter
    turns) and moved by whole tiles to where the first one is."""
    uv = np.nan_to_num(uv.astype(np.float64))
    result = np.zeros((len(mesh.corners), 2))
    first, second = mesh.quads()
    result[mesh.loops[first]] = uv[first]
    first, second = first[second >= 0], second[second >= 0]
    loops, others = mesh.loops[second], mesh.loops[first]
    own = own_corners(loops, others)
    loops, uv = _from_corner(loops, own), _from_corner(uv[second], own)
    turn = uv[..., 0] + 1j * uv[..., 1]
    there = result[loops] @ (1, 1j)
    rotations = 1j ** np.arange(0, 4, 1 if quarter_turns else 2)
    misfit = np.abs((there[:, 2] - there[:, 1])[:, None] - rotations * (turn[:, 2] - turn[:, 1])[:, None])
    turn *= rotations[np.argmin(misfit, axis=1)][:, None]
    placed = turn[:, 0] + np.round(there[:, 1] - turn[:, 1])
    result[loops[:, 0]] = np.stack([placed.real, placed.imag], axis=1)
    return result.astype(np.float32)


def whole_triangles(texture, face_count, faces):
    """(m, 3, 2) coordinates on the triangles before crosses split the singular ones."""
    origins, split = texture.face_origins, texture.surface.faces
    uv = np.zeros((face_count, 3, 2), np.float32)
    whole = np.bincount(origins, minlength=face_count)[origins] == 1
    uv[origins[whole]] = texture.corner_uv[whole]
    for part in np.flatnonzero(~whole):
        for corner, vertex in enumerate(split[part]):
            uv[origins[part], faces[origins[part]] == vertex] = texture.corner_uv[part, corner]
    return uv
