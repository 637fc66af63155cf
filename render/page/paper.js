// The paper in the background: a tile of soft grain, light or dark.
import {$} from './messages.js';

export class Paper {
  constructor(board, style) {
    this.board = board;
    this.style = style;
    this.set(matchMedia('(prefers-color-scheme: dark)').matches);
  }
  toggle() {
    this.set(!this.board.dark);
    this.lay();
  }
  set(dark) {
    const {style, board} = this;
    board.dark = dark;
    document.documentElement.classList.toggle('dark', dark);
    $('dark').setAttribute('aria-pressed', String(dark));
    document.documentElement.style.setProperty('--paper', dark ? '#211e1b' : style.paper);
    board.changed();
  }
  /** Draws the grain. It takes some hundredths of a second, so it comes after the fruit. */
  lay() {
    const {style, board} = this, tile = document.createElement('canvas'), size = 192;
    const grain = 255 * 2.2 * style.grain * (board.dark ? 0.5 : 1);
    tile.width = tile.height = size;
    // Keep it in main memory, so that it need not be read back from a busy card.
    const context = tile.getContext('2d', {willReadFrequently: true}), image = context.createImageData(size, size);
    const {data} = image;
    let seed = 1;
    const noise = Float32Array.from({length: size * size}, () => {
      seed = Math.imul(seed, 1664525) + 1013904223 >>> 0;
      return seed / 2 ** 32 - 0.5;
    });
    for (let i = 0, at = 0; i < size * size; ++i) {
      const x = i % size, near = noise[i] + noise[i - x + (x + 1) % size] + noise[(i + size) % (size * size)];
      const v = grain * near * 0.5;
      data[at++] = v > 0 ? 255 : 40;
      data[at++] = v > 0 ? 255 : 30;
      data[at++] = v > 0 ? 255 : 20;
      data[at++] = Math.min(255, Math.abs(v) * 1.6);
    }
    context.putImageData(image, 0, 0);
    document.body.style.backgroundImage = grain > 0 ? `url(${tile.toDataURL()})` : 'none';
  }
}
