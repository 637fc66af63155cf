// A worker decompresses the page's assets one after another.
import {$, sorry} from './messages.js';

export class Unpacking {
  constructor() {
    const url = URL.createObjectURL(new Blob([$('worker').textContent], {type: 'text/javascript'}));
    this.worker = new Worker(url);
    this.waiting = new Map();
    this.next = 0;
    /** A worker starts only while the page is idle: long work should wait for it. */
    this.isUp = new Promise((up) => {
      this.up = up;
    });
    this.worker.onmessage = ({data}) => {
      if (data.isUp) return this.up();
      const job = this.waiting.get(data.job);
      if (data.error) {
        sorry(`The fruit cannot be unpacked: ${data.error}`);
        return job.failed(new Error(data.error));
      }
      try {
        if (data.skin) return job.onSkin(data);
        this.waiting.delete(data.job);
        job.done(data);
      } catch (error) {
        sorry(`The fruit cannot be drawn: ${error.message}`);
        throw error;
      }
    };
    this.worker.onerror = (event) => sorry(`The fruit cannot be unpacked: ${event.message}`);
  }
  stop() { this.worker.terminate(); }
  /**
   * `element` holds the asset. `onSkin({header, skin, index})` is called early; the promise gives the rest, for
   * FruitTextures.
   */
  asset(element, onSkin = () => {}) { return this.unpack(element, false, onSkin); }
  /** The promise gives {header, solids}. */
  scene(element) { return this.unpack(element, true, () => {}); }
  unpack(element, isScene, onSkin) {
    const job = this.next++;
    return new Promise((done, failed) => {
      this.waiting.set(job, {onSkin, done, failed});
      // Not before it runs: it would get earlier messages only when the page is idle.
      this.isUp.then(
        () =>
          this.worker.postMessage({job, isScene, text: element.textContent, length: Number(element.dataset.length)}));
    });
  }
}
