// How far colours of a section are from those of the C++ field, in 1/255 of sRGB, and where in and out are mistaken.
import {readFileSync} from 'node:fs';

export const bars = {
  rms: 1,
  p95: 1.5,
  wrong: 0
};

/**
 * What write_sections has left of a fruit: its squares, each with true colours. `what`: "sections" for bare colours,
 * "looks" for those with noise and details.
 */
export function readSections(folder, name, what = 'sections') {
  const {size, squares} = JSON.parse(readFileSync(`${folder}/${name}.json`));
  const bytes = readFileSync(`${folder}/${name}.${what}`);
  const all = new Float32Array(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength));
  return squares.map(
    (square, i) => ({...square, size, truth: all.subarray(4 * size * size * i, 4 * size * size * (i + 1))}));
}

export const srgb = (l) => {
  const c = Math.min(1, Math.max(0, l));
  return 255 * (c <= 0.0031308 ? 12.92 * c : 1.055 * c ** (1 / 2.4) - 0.055);
};

/** `colorAt(i)`: 0..255 of sRGB, or null in air. Counted are pixels further than two from where in and out meet. */
export function errorsOf({size, truth}, colorAt) {
  const inside = (i) => truth[4 * i + 3] > 0.5, worst = [];
  let squares = 0, wrong = 0;
  for (let y = 2; y < size - 2; ++y)
    for (let x = 2; x < size - 2; ++x) {
      const i = y * size + x;
      let isWell = true;
      for (let dy = -2; dy <= 2 && isWell; ++dy)
        for (let dx = -2; dx <= 2; ++dx)
          if (inside(i + dy * size + dx) !== inside(i)) isWell = false;
      if (!isWell) continue;
      const color = colorAt(i);
      if ((color !== null) !== inside(i)) {
        ++wrong;
        continue;
      }
      if (color === null) continue;
      const away = [0, 1, 2].map((k) => Math.abs(color[k] - srgb(truth[4 * i + k])));
      worst.push(Math.max(...away));
      squares += away.reduce((sum, d) => sum + d * d / 3, 0);
    }
  worst.sort((a, b) => a - b);
  // Long fruit may be too thin across for any pixel to lie well inside.
  const pixels = worst.length;
  return {
    pixels,
    wrong,
    rms: Math.sqrt(squares / Math.max(1, pixels)),
    p95: pixels > 0 ? worst[Math.floor(0.95 * (pixels - 1))] : 0
  };
}

export const holds = (e) => e.wrong <= bars.wrong && e.rms <= bars.rms && e.p95 <= bars.p95;
export const line = (e) =>
  `${e.pixels} pixels, RMS ${e.rms.toFixed(2)}, 95th percentile ${e.p95.toFixed(2)}, in or out wrong ${e.wrong}`;
