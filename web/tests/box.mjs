// A box whose faces are cut into squares and share the vertices at its edges.

/** 3 x 2 x 1, n squares a unit. `loose`: every face has vertices of its own. */
export function box(n, loose = false) {
  const sides = [3, 2, 1], positions = [], triangles = [], known = new Map();
  const vertex = (place, face) => {
    const key = loose ? `${face}:${place}` : String(place);
    if (!known.has(key)) {
      known.set(key, positions.length / 3);
      positions.push(...place.map((c) => c / n));
    }
    return known.get(key);
  };
  for (let face = 0; face < 6; ++face) {
    const axis = face % 3, far = face < 3, u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (let i = 0; i < sides[u] * n; ++i) {
      for (let j = 0; j < sides[v] * n; ++j) {
        const at = (a, b) => {
          const place = [0, 0, 0];
          [place[axis], place[u], place[v]] = [far ? sides[axis] * n : 0, i + a, j + b];
          return vertex(place, face);
        };
        const [a, b, c, d] = far ? [at(0, 0), at(1, 0), at(1, 1), at(0, 1)] : [at(0, 0), at(0, 1), at(1, 1), at(1, 0)];
        triangles.push(a, b, c, a, c, d);
      }
    }
  }
  return { positions, triangles };
}

/** The same as a file. */
export function objOf({ positions, triangles }) {
  const rows = (letter, numbers) => Array.from({ length: numbers.length / 3 }, (_, i) => `${letter} ${numbers.slice(3 * i, 3 * i + 3).join(' ')}\n`);
  return [...rows('v', positions), ...rows('f', triangles.map((corner) => corner + 1))].join('');
}
