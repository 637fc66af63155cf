// The pictures under the drawing: loaded once, drawn where the SVG places them, and sampled for colours.
import {A} from './svg_text.js';

const mostPixelsAcross = 4096;

export class Pictures {
  constructor(server, {changed, failed}) {
    this.server = server;
    this.changed = changed;
    this.failed = failed;
    this.loaded = new Map();
  }

  get(href) {
    const known = this.loaded.get(href);
    if (known) return known.image ? known : null;
    const entry = {image: null};
    this.loaded.set(href, entry);
    this.load(href)
      .then((image) => {
        // Tracing and picking read all pixels, and every redraw draws them, so limit them to those of a screen.
        const scale = Math.min(1, mostPixelsAcross / Math.max(image.width, image.height));
        const canvas = document.createElement('canvas');
        Object.assign(
          canvas,
          {width: Math.max(1, Math.round(scale * image.width)), height: Math.max(1, Math.round(scale * image.height))});
        entry.pixels = canvas.getContext('2d', {willReadFrequently: true});
        entry.pixels.imageSmoothingQuality = 'high';
        entry.pixels.drawImage(image, 0, 0, canvas.width, canvas.height);
        image.close();
        entry.image = canvas;
        this.changed();
      })
      .catch(
        (error) => this.failed(`The picture ${
          href.startsWith('data:') ? 'within the drawing'
                                   : href.slice(0, 80)} cannot be shown: ${error.message || 'it is no PNG or JPEG'}`));
    return null;
  }
  async load(href) {
    // Only embedded pictures, or pictures that the server finds beside the template.
    if (/^data:image\/(png|jpeg);base64,/.test(href)) {
      const text = atob(href.slice(href.indexOf(',') + 1).replace(/\s/g, ''));
      return createImageBitmap(new Blob([Uint8Array.from(text, (c) => c.charCodeAt(0))]));
    }
    const reply = await this.server.ask(`/api/picture?href=${encodeURIComponent(decodeURIComponent(href))}`);
    return createImageBitmap(await reply.blob());
  }

  /** The matrix from pixels of a picture to the page. */
  placement({matrix, x, y, width, height, aspect}, {image}) {
    let sx = width / image.width, sy = height / image.height, dx = 0, dy = 0;
    if (!aspect.startsWith('none')) {
      const s = aspect.endsWith('slice') ? Math.max(sx, sy) : Math.min(sx, sy);
      [dx, dy, sx, sy] = [(width - s * image.width) / 2, (height - s * image.height) / 2, s, s];
    }
    return A.product(matrix, [sx, 0, 0, sy, x + dx, y + dy]);
  }

  /** The colour at a place of the page, as the median over a small square: {color: '#rrggbb', linear}, or null. */
  colorAt(images, place) {
    for (const picture of [...images].reverse()) {
      const loaded = this.get(picture.href);
      if (!loaded) continue;
      const [px, py] = A.point(A.inverse(this.placement(picture, loaded)), place).map(Math.floor);
      const {width, height} = loaded.image;
      if (px < 0 || py < 0 || px >= width || py >= height) continue;
      const reach = Math.max(1, Math.round(Math.max(width, height) / 200)), left = Math.max(0, px - reach);
      const top = Math.max(0, py - reach);
      const {data} = loaded.pixels.getImageData(
        left, top, Math.min(width, px + reach + 1) - left, Math.min(height, py + reach + 1) - top);
      const channels = [[], [], []];
      for (let i = 0; i < data.length; i += 4)
        if (data[i + 3] >= 128)
          for (let k = 0; k < 3; ++k) channels[k].push(data[i + k]);
      if (channels[0].length === 0) continue;
      return `#${channels.map((c) => c.sort((a, b) => a - b)[c.length >> 1].toString(16).padStart(2, '0')).join('')}`;
    }
    return null;
  }
}
