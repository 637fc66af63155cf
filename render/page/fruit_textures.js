// The textures of one fruit: grid, cells, triangles, guides, and paint.

/** A shell (spared.js) with points of its own surface, and some that represent it among the fruit's points. */
function shellOf({first, count, points}, stone) {
  const rim = new Float32Array(count), samples = [], every = 3 * Math.max(1, Math.floor(points.length / 3 / 300));
  for (let i = 0; i < count / 3; ++i) rim.set(stone.subarray(10 * (first + 3 * i), 10 * (first + 3 * i) + 3), 3 * i);
  for (let i = 0; i < points.length; i += every) samples.push([...points.subarray(i, i + 3)]);
  for (let i = 0; i < rim.length; i += 3 * Math.max(1, Math.floor(count / 900)))
    samples.push([...rim.subarray(i, i + 3)]);
  return {stone: [first, count], socket: [first, count], points, rim, samples};
}

/** The kind of a detail by example (shaders/detail.glsl). */
export const byExample = 5;

export class FruitTextures {
  /** `header`: of an asset, or a placeholder. */
  constructor(card, header) {
    const {spacing, origin} = header;
    this.card = card;
    this.header = header;
    this.lattice = [...origin, spacing];
    this.ready = false;
    this.hasNoise = false;
    this.showsRim = false;
    this.details = [];
    this.spared = null;
    // Until the rest arrives, noise and materials are unknown.
    const plain = [1, 0.3, 1, 0, 1, 1, 1, 0, 0.7, 0.8, 0.8, 100, 0, 0, 0, 0, 0.4, 0, 0, 0];
    this.takeLook({
      noise: new Float32Array(0),
      details: new Float32Array(0),
      materials: Float32Array.from(header.parts.flatMap(() => plain))
    });
  }

  takeLook({noise, details, materials}) {
    const {card} = this, {gl} = card;
    this.look = {
      noise_styles: card.floats(noise, gl.NEAREST),
      detail_styles: card.longFloats(details),
      materials: card.floats(materials, gl.NEAREST)
    };
    this.hasNoise = noise.length > 0;
    // Gels and parts with relief look different near their rims (shaders/material.glsl: relief is in the last texel of
    // a part).
    this.showsRim = false;
    for (let i = 0; i < materials.length; i += 20)
      if (materials[i + 3] > 0.0034 || materials[i + 19] !== 0) this.showsRim = true;
  }

  /** Takes the worker's data of the whole asset; from now on the fruit can be cut. */
  takeRest(rest) {
    const {card} = this, {gl} = card, {count, guide} = this.header;
    this.grid = card.volume(count, gl.SRGB8_ALPHA8, gl.RGBA, gl.UNSIGNED_BYTE, rest.grid, gl.LINEAR);
    this.cell = card.volume(count, gl.RG32UI, gl.RG_INTEGER, gl.UNSIGNED_INT, rest.cell, gl.NEAREST);
    this.list = card.table(2048, gl.R32UI, gl.RED_INTEGER, gl.UNSIGNED_INT, rest.list, 1);
    this.triangle = card.table(4096, gl.RGBA32UI, gl.RGBA_INTEGER, gl.UNSIGNED_INT, rest.triangle, 4);
    this.range = [rest.low, rest.high];
    this.takeLook(rest);
    this.guide = card.volume(
      guide ? guide.count : [1, 1, 1], gl.RGBA16F, gl.RGBA, gl.FLOAT, guide ? rest.guide : new Float32Array(4),
      gl.LINEAR);
    this.shares =
      card.table(32, gl.RGBA8, gl.RGBA, gl.UNSIGNED_BYTE, guide ? rest.share : new Uint8Array(128), 4, gl.LINEAR);
    // Details of cut faces: the first value of their texels is the kind, -1 for none.
    for (let i = 0; guide && i < 4 && 28 * i < rest.details.length; ++i) {
      const kind = rest.details[28 * i];
      if (kind >= 0) this.details.push({number: i, kind});
    }
    // Examples change linear light, before the others change OKLab.
    this.details.sort((a, b) => Number(b.kind === byExample) - Number(a.kind === byExample));
    if (rest.spared) {
      const {stone, socket, shells} = rest.spared;
      this.spared = {
        stone: card.skin(stone),
        socket: card.skin(socket),
        data: rest.spared,
        parts: this.header.spared,
        nearlyAsMuch: this.header.shells.nearly_as_much,
        shells: shells.map((shell) => shellOf(shell, stone))
      };
    }
    this.ready = true;
  }
}
