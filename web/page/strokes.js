// Strokes in links: differences of successive points, in two-thousandths of the surface's diagonal.
const perDiagonal = 2000;

export const brushed = (points, diagonal) => ({ points, radius: 0.08 * diagonal, strength: 4 });

export function writtenStrokes(strokes, diagonal) {
  return strokes.map(({ points }) => {
    const places = points.map((x) => Math.round(x * perDiagonal / diagonal));
    return places.map((place, i) => place - (places[i - 3] ?? 0)).join('.');
  }).join('~');
}

/** Empty if the text is no list of strokes. */
export function readStrokes(text, diagonal) {
  const strokes = text.split('~').map((stroke) => {
    const places = stroke.split('.').map((number) => (/^-?\d{1,5}$/.test(number) ? Number(number) : NaN));
    for (let i = 3; i < places.length; ++i) places[i] += places[i - 3];
    return brushed(places.map((place) => place * diagonal / perDiagonal), diagonal);
  });
  const whole = strokes.every(({ points }) => points.length >= 6 && points.length % 3 === 0 && points.every(Number.isFinite));
  return whole ? strokes : [];
}
