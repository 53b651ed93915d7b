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

export const distance = (a, b) => Math.hypot(...a.map((x, i) => x - b[i]));
const middle = (a, b) => a.map((x, i) => (x + b[i]) / 2);

/**
 * Whether a line between two places that are seen at pixels leaves the surface: between them there is
 * nothing, or a jump to another part of the surface. `pick` gives the place that is seen at a pixel, or null.
 */
export function leavesSurface(from, to, pick) {
  const apart = distance(from.place, to.place);
  for (let halvings = 0; halvings < 6; ++halvings) {
    const pixel = middle(from.pixel, to.pixel), place = pick(pixel);
    if (!place) return true;
    if (distance(place, middle(from.place, to.place)) <= 0.25 * distance(from.place, to.place)) return false;
    if (distance(place, from.place) > distance(place, to.place)) to = { pixel, place };
    else from = { pixel, place };
  }
  // A surface that goes on is as near as the pixels are, at its rim as their roots.
  return distance(from.place, to.place) > 0.25 * apart;
}
