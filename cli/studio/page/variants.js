// The strip of variants: small sections of the first seeds.
import {$} from '../../../render/page/messages.js';

export async function showVariants(studio) {
  const strip = $('strip'), texts = studio.texts, round = studio.round = (studio.round || 0) + 1;
  if (strip.children.length === 0)
    for (let seed = 0; seed < 7; ++seed) {
      const button = document.createElement('button'), canvas = document.createElement('canvas');
      Object.assign(button, {type: 'button', title: seed ? `Seed ${seed}` : 'As drawn'});
      button.setAttribute('aria-label', button.title);
      button.append(canvas);
      button.addEventListener('click', () => {
        $('seed').value = seed;
        studio.look.seed = seed;
        studio.assets.ask({texts: studio.texts});
        markSeed(studio);
      });
      strip.append(button);
    }
  markSeed(studio);
  for (let seed = 0; seed < 7; ++seed) {
    // After everything that the user waits for.
    while (studio.sections.busy || studio.assets.busy) await new Promise((done) => setTimeout(done, 60));
    if (round !== studio.round || studio.dragging) return;
    try {
      const head = await studio.server.section(studio.wanted(texts, {seed, detail: 0.4, size: 64}));
      const {image} = head.pictures[0];
      const canvas = strip.children[seed].firstChild;
      Object.assign(canvas, {width: image.width, height: image.height});
      canvas.getContext('2d', {willReadFrequently: true}).putImageData(image, 0, 0);
    } catch {
      // A drawing may be valid and a variant of it not: then it has no picture.
      strip.children[seed].firstChild.width = 64;
    }
  }
  studio.loads.variants = performance.now();
}
export function markSeed(studio) {
  [...$('strip').children].forEach(
    (button, seed) => button.setAttribute('aria-pressed', String(seed === studio.look.seed)));
}
