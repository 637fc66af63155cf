// Assets of the page, unpacked by a worker one after another.
'use strict';
class Unpacking {
  constructor() {
    const url = URL.createObjectURL(new Blob([$('worker').textContent], {type: 'text/javascript'}));
    this.worker = new Worker(url);
    this.waiting = new Map();
    this.next = 0;
    this.worker.onmessage = ({data}) => {
      const job = this.waiting.get(data.job);
      if (data.error) { sorry(`The fruit cannot be unpacked: ${data.error}`); return job.failed(new Error(data.error)); }
      try {
        if (data.skin) return job.onSkin(data);
        this.waiting.delete(data.job);
        job.done(data);
      } catch (error) { sorry(`The fruit cannot be drawn: ${error.message}`); throw error; }
    };
    this.worker.onerror = (event) => sorry(`The fruit cannot be unpacked: ${event.message}`);
  }
  /** `element`: what holds it. `onSkin({header, skin})` comes early; the promise brings the rest, for FruitTextures. */
  asset(element, onSkin = () => {}) { return this.unpack(element, false, onSkin); }
  /** The promise brings {header, solids}. */
  scene(element) { return this.unpack(element, true, () => {}); }
  unpack(element, isScene, onSkin) {
    const job = this.next++;
    return new Promise((done, failed) => {
      this.waiting.set(job, {onSkin, done, failed});
      this.worker.postMessage({job, isScene, text: element.textContent, length: Number(element.dataset.length)});
    });
  }
}
