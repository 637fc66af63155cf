// What the knives leave: which pieces there are, and where they lie when they are pulled apart or laid open.
'use strict';

/** Points of the fruit that stand for all of it: some of its skin, some of its nodes inside. */
function samplesOf(header, skin, winding, most = 2500) {
  const points = [], corners = skin.length / 10, every = Math.max(1, Math.floor(corners / most));
  for (let i = 0; i < corners; i += every) points.push([skin[10 * i], skin[10 * i + 1], skin[10 * i + 2]]);
  if (winding) {
    const [nx, ny, nz] = header.count, step = Math.max(2, Math.round(Math.cbrt(nx * ny * nz / 8000)));
    for (let z = 0; z < nz; z += step) for (let y = 0; y < ny; y += step) for (let x = 0; x < nx; x += step) {
      if (winding[(z * ny + y) * nx + x] !== 0) points.push([x, y, z]);
    }
  }
  return points;
}

/** Pieces by their sides of all knives: {keep: [+1, -1, ...], middle, points}. Fewer points than a hundredth are a crumb. */
function piecesOf(samples, knives) {
  const laid = knives.map((knife) => [knife, knife.frame, knife.profile]), found = new Map();
  for (const p of samples) {
    const keep = laid.map(([knife, frame, profile]) => knife.sideOf(p, frame, profile)), key = keep.join();
    if (!found.has(key)) found.set(key, {keep, points: []});
    found.get(key).points.push(p);
  }
  return [...found.values()].filter(({points}) => points.length > 0.004 * samples.length).map((piece) =>
    ({...piece, middle: V.mul(piece.points.reduce(V.add, [0, 0, 0]), 1 / piece.points.length)}));
}

/**
 * Where each piece lies: a rigid motion each. Pulled apart, pieces move away from the middle of all; laid open, the half
 * before a single knife swings round like the cover of a book, so that both faces are seen, and each half stands on the
 * table by itself.
 */
function placed(pieces, knives, fruit, apart, open) {
  const upright = [0, 1, 0], low = Math.min(...pieces.flatMap(({points}) => points.map((p) => p[1])));
  const book = knives.length === 1 && pieces.length === 2 ? open : 0;
  return pieces.map((piece) => {
    const away = V.mul(V.sub(piece.middle, fruit.middle), 1.5 * apart * (1 - book));
    if (book === 0) return {...piece, motion: M.rigid(upright, 0, fruit.middle, away)};
    const {origin, u, v, n} = knives[0].frame;
    const edge = Math.max(...pieces.flatMap(({points}) => points.map((p) => V.dot(V.sub(p, origin), u))));
    const hinge = V.add(origin, V.mul(u, edge + 0.06 * fruit.reach)), front = piece.keep[0] > 0;
    // Both covers lean in a little.
    const angle = front ? book * (Math.PI - 0.32) : 0, back = V.mul(u, -book * (edge + 0.06 * fruit.reach));
    let motion = M.product(M.rigid(v, book * 0.16, hinge, V.add(back, away)), M.rigid(v, angle, hinge, [0, 0, 0]));
    const lowest = Math.min(...piece.points.map((p) => M.point(motion, p)[1]));
    motion = M.product(M.rigid(upright, 0, [0, 0, 0], [0, book * (low - lowest), 0]), motion);
    return {...piece, motion, n};
  });
}
