// Regions in doubles, for drawing only: a rectangle or a box clipped by rows.

const TINY = 1e-9;

// A convex polygon as [{x, y, row}]: row is the one on which the edge to the next corner lies, -1: the frame.
export function polygonOf(rows, [x0, y0, x1, y1]) {
  let polygon = [[x0, y0], [x1, y0], [x1, y1], [x0, y1]].map(([x, y]) => ({ x, y, row: -1 }));
  const limits = rows.flatMap((row, i) => sides(row).map((side) => ({ ...side, i })));
  for (const { a: [p, q], b, i } of limits) polygon = cutPolygon(polygon, (c) => p * c.x + q * c.y - b, i);
  return polygon;
}

// Rows as upper limits a.x <= b; an equation is two.
function sides({ doubles, relation, rightDouble }) {
  const upper = { a: doubles, b: rightDouble };
  return relation === "=" ? [upper, { a: doubles.map((c) => -c), b: -rightDouble }] : [upper];
}

function cutPolygon(polygon, excess, row) {
  const out = [];
  polygon.forEach((c, k) => {
    const d = polygon[(k + 1) % polygon.length], u = excess(c), v = excess(d);
    if (u <= TINY) out.push(u <= TINY && v > TINY && u > -TINY ? { ...c, row } : c);
    if ((u < -TINY && v > TINY) || (u > TINY && v < -TINY)) {
      const t = u / (u - v), point = { x: c.x + t * (d.x - c.x), y: c.y + t * (d.y - c.y) };
      out.push({ ...point, row: v > u ? row : c.row });
    }
  });
  return out;
}

/* ---- in space -------------------------------------------------------------------------------- */

const CORNERS = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]];

// A convex polyhedron as faces [{points: [[x, y, z]...], row}]: the box [low, high] clipped by rows.
export function polyhedronOf(rows, low, high) {
  const corner = (k) => [0, 1, 2].map((j) => ((k >> j) & 1 ? high[j] : low[j]));
  let faces = CORNERS.map((list) => ({ points: list.map(corner), row: -1 }));
  rows.forEach((row, i) => {
    for (const { a, b } of sides(row)) faces = cutPolyhedron(faces, (p) => a[0] * p[0] + a[1] * p[1] + a[2] * p[2] - b, i);
  });
  return faces;
}

function cutPolyhedron(faces, excess, row) {
  const lid = [], left = [];
  for (const face of faces) {
    const points = [];
    face.points.forEach((p, k) => {
      const q = face.points[(k + 1) % face.points.length], u = excess(p), v = excess(q);
      if (u <= TINY) points.push(p);
      if (Math.abs(u) <= TINY) lid.push(p);
      if ((u < -TINY && v > TINY) || (u > TINY && v < -TINY)) {
        const t = u / (u - v), cut = p.map((c, j) => c + t * (q[j] - c));
        points.push(cut);
        lid.push(cut);
      }
    });
    if (points.length > 2) left.push({ ...face, points });
  }
  const around = inOrder(distinct(lid));
  if (around.length > 2 && !left.some((f) => f.points.every((p) => Math.abs(excess(p)) <= TINY))) left.push({ points: around, row });
  return left;
}

function distinct(points) {
  const found = [];
  for (const p of points) if (!found.some((q) => p.every((c, j) => Math.abs(c - q[j]) < 1e-7 * (1 + Math.abs(c))))) found.push(p);
  return found;
}

// Points of a plane in their order around their mean.
export function inOrder(points) {
  if (points.length < 3) return points;
  const mean = [0, 1, 2].map((j) => points.reduce((sum, p) => sum + p[j], 0) / points.length);
  const minus = (p, q) => p.map((c, j) => c - q[j]), dot = (p, q) => p.reduce((sum, c, j) => sum + c * q[j], 0);
  const cross = ([a, b, c], [d, e, f]) => [b * f - c * e, c * d - a * f, a * e - b * d];
  const u = minus(points[0], mean);
  let normal = [0, 0, 0];
  for (const p of points) {
    const n = cross(u, minus(p, mean));
    if (dot(n, n) > dot(normal, normal)) normal = n;
  }
  const v = cross(normal, u);
  const angle = (p) => Math.atan2(dot(minus(p, mean), v) / Math.hypot(...v), dot(minus(p, mean), u) / Math.hypot(...u));
  return points.map((p) => [angle(p), p]).sort((a, b) => a[0] - b[0]).map(([, p]) => p);
}

/* ---- hulls ----------------------------------------------------------------------------------- */

// Faces of the convex hull of a few points in space, by all planes through three of them.
export function hullOf(points) {
  const faces = new Map(), n = points.length;
  for (let i = 0; i < n; i++)
    for (let j = i + 1; j < n; j++)
      for (let k = j + 1; k < n; k++) {
        const on = facet(points, i, j, k);
        if (on) faces.set(on.join(), on.map((m) => points[m]));
      }
  return [...faces.values()].map(inOrder);
}

// The numbers of the points on the plane through three of them, if no two points lie on either side.
function facet(points, i, j, k) {
  const minus = (p, q) => p.map((c, m) => c - q[m]);
  const [a, b, c] = minus(points[j], points[i]), [d, e, f] = minus(points[k], points[i]);
  const normal = [b * f - c * e, c * d - a * f, a * e - b * d], size = Math.hypot(...normal);
  if (size < TINY) return null;
  const on = [];
  let above = false, below = false;
  points.forEach((p, m) => {
    const height = minus(p, points[i]).reduce((sum, x, q) => sum + x * normal[q], 0) / size;
    if (Math.abs(height) < 1e-7) on.push(m);
    else if (height > 0) above = true;
    else below = true;
  });
  return above && below ? null : on;
}
