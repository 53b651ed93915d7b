// The camera: a rotation from world to view coordinates, and a zoom.
const turn = (axis, angle) => {
  const s = Math.sin(angle / 2);
  return [axis[0] * s, axis[1] * s, axis[2] * s, Math.cos(angle / 2)];
};

function product([ax, ay, az, aw], [bx, by, bz, bw]) {
  const q = [aw * bx + ax * bw + ay * bz - az * by, aw * by - ax * bz + ay * bw + az * bx,
             aw * bz + ax * by - ay * bx + az * bw, aw * bw - ax * bx - ay * by - az * bz];
  const length = Math.hypot(...q);
  return q.map((x) => x / length);
}

function rotated([x, y, z, w], v) {
  const t = [2 * (y * v[2] - z * v[1]), 2 * (z * v[0] - x * v[2]), 2 * (x * v[1] - y * v[0])];
  return [v[0] + w * t[0] + y * t[2] - z * t[1], v[1] + w * t[1] + z * t[0] - x * t[2],
          v[2] + w * t[2] + x * t[1] - y * t[0]];
}

const X = [1, 0, 0], Y = [0, 1, 0];
const radians = Math.PI / 180;
const half = Math.tan(14 * radians);  // of the angle of view, along the shorter side

export class Camera {
  constructor() {
    this.reset();
    this.radius = 1;
  }

  reset() {
    this.rotation = product(turn(X, 20 * radians), turn(Y, -30 * radians));
    this.zoom = 1;
  }

  /** Frames a ball of this radius. */
  frame(radius) {
    this.radius = radius || 1;
  }

  /** Rotates by a drag in pixels across a picture of `size` pixels. */
  drag(dx, dy, size) {
    const angle = Math.hypot(dx, dy) * 3.2 / size;
    if (angle > 0) this.rotation = product(turn([dy, dx, 0].map((c) => c / Math.hypot(dx, dy)), angle), this.rotation);
  }

  /** Rotates about the world's vertical axis. */
  spin(angle) {
    this.rotation = product(this.rotation, turn(Y, angle));
  }

  zoomBy(factor) {
    this.zoom = Math.min(60, Math.max(0.4, this.zoom * factor));
  }

  /** Matrices for a picture of this size. */
  view(width, height) {
    const columns = [X, Y, [0, 0, 1]].map((axis) => rotated(this.rotation, axis));
    const distance = this.radius / Math.sin(Math.atan(half)) * 1.12;
    const near = Math.max(distance - 1.3 * this.radius, 0.01 * distance), far = distance + 1.3 * this.radius;
    const side = Math.min(width, height);
    return {
      viewFromWorld: [...columns[0], 0, ...columns[1], 0, ...columns[2], 0, 0, 0, -distance, 1],
      clipFromView: [this.zoom * side / (half * width), 0, 0, 0, 0, this.zoom * side / (half * height), 0, 0,
                     0, 0, (far + near) / (near - far), -1, 0, 0, 2 * far * near / (near - far), 0],
      up: columns[1],
      distance,
    };
  }

  /** The ray through a pixel, in world coordinates relative to the centre. */
  ray(x, y, width, height) {
    const { distance } = this.view(width, height), side = Math.min(width, height);
    const back = [-this.rotation[0], -this.rotation[1], -this.rotation[2], this.rotation[3]];
    const across = (2 * x / width - 1) * half * width / (side * this.zoom);
    const upwards = (1 - 2 * y / height) * half * height / (side * this.zoom);
    return { from: rotated(back, [0, 0, distance]), along: rotated(back, [across, upwards, -1]) };
  }
}

/** The first intersection of a ray with the triangles, or null. */
export function firstHit({ from, along }, { positions, triangles }, center) {
  const [ox, oy, oz] = from.map((c, axis) => c + center[axis]), [dx, dy, dz] = along;
  let nearest = Infinity;
  for (let i = 0; i < triangles.length; i += 3) {
    const a = 3 * triangles[i], b = 3 * triangles[i + 1], c = 3 * triangles[i + 2];
    const ax = positions[a], ay = positions[a + 1], az = positions[a + 2];
    const ux = positions[b] - ax, uy = positions[b + 1] - ay, uz = positions[b + 2] - az;
    const vx = positions[c] - ax, vy = positions[c + 1] - ay, vz = positions[c + 2] - az;
    const px = dy * vz - dz * vy, py = dz * vx - dx * vz, pz = dx * vy - dy * vx;
    const size = ux * px + uy * py + uz * pz;
    if (size === 0) continue;
    const sx = ox - ax, sy = oy - ay, sz = oz - az;
    const u = (sx * px + sy * py + sz * pz) / size;
    if (u < 0 || u > 1) continue;
    const qx = sy * uz - sz * uy, qy = sz * ux - sx * uz, qz = sx * uy - sy * ux;
    const v = (dx * qx + dy * qy + dz * qz) / size;
    if (v < 0 || u + v > 1) continue;
    const t = (vx * qx + vy * qy + vz * qz) / size;
    if (t > 0 && t < nearest) nearest = t;
  }
  return nearest === Infinity ? null : [ox + nearest * dx, oy + nearest * dy, oz + nearest * dz];
}
