// The paper behind everything: a tile of soft grain, light or dark.
'use strict';
class Paper {
  constructor(board, style) {
    Object.assign(this, {board, style});
    this.set(matchMedia('(prefers-color-scheme: dark)').matches);
  }
  toggle() { this.set(!this.board.dark); }
  set(dark) {
    this.board.dark = dark;
    document.documentElement.classList.toggle('dark', dark);
    $('dark').setAttribute('aria-pressed', String(dark));
    this.lay();
    this.board.changed();
  }
  lay() {
    const {style, board} = this, tile = document.createElement('canvas'), size = 192, grain = 255 * 2.2 * style.grain * (board.dark ? 0.5 : 1);
    document.documentElement.style.setProperty('--paper', board.dark ? '#211e1b' : style.paper);
    tile.width = tile.height = size;
    const context = tile.getContext('2d'), image = context.createImageData(size, size);
    let seed = 1;
    const noise = Float32Array.from({length: size * size}, () => { seed = Math.imul(seed, 1664525) + 1013904223 >>> 0; return seed / 2 ** 32 - 0.5; });
    for (let i = 0; i < size * size; ++i) {
      const x = i % size, near = noise[i] + noise[i - x + (x + 1) % size] + noise[(i + size) % (size * size)], v = grain * near * 0.5;
      image.data.set([v > 0 ? 255 : 40, v > 0 ? 255 : 30, v > 0 ? 255 : 20, Math.min(255, Math.abs(v) * 1.6)], 4 * i);
    }
    context.putImageData(image, 0, 0);
    document.body.style.backgroundImage = grain > 0 ? `url(${tile.toDataURL()})` : 'none';
  }
}
