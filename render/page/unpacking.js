// Assets of the page, unpacked by a worker one after another.
import {$, sorry} from './messages.js';

export class Unpacking {
  constructor() {
    const url = URL.createObjectURL(new Blob([$('worker').textContent], {type: 'text/javascript'}));
    this.worker = new Worker(url);
    this.waiting = new Map();
    this.next = 0;
    /** A worker begins only where the page lets the browser do so: what keeps the page busy should wait for it. */
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
   * `element`: what holds it. `onSkin({header, skin, index})` comes early; the promise brings the rest, for
   * FruitTextures.
   */
  asset(element, onSkin = () => {}) { return this.unpack(element, false, onSkin); }
  /** The promise brings {header, solids}. */
  scene(element) { return this.unpack(element, true, () => {}); }
  unpack(element, isScene, onSkin) {
    const job = this.next++;
    return new Promise((done, failed) => {
      this.waiting.set(job, {onSkin, done, failed});
      // Not before it is up: what it has been told until then it hears only when the page has nothing to do.
      this.isUp.then(
        () =>
          this.worker.postMessage({job, isScene, text: element.textContent, length: Number(element.dataset.length)}));
    });
  }
}
