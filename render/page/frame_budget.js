// The frame budget: measures frames, and chooses how fine they can be during motion.

const enoughMs = 110;           // a frame may take during motion
export const firstDivisor = 2;  // of software renderers
const roughest = 4;             // times fewer pixels along each side
export const restMs = 80;       // without motion, before a fine frame
const paceMemory = 3;           // frames; the first ones include compilation

export class FrameBudget {
  /**
   * `measures` is false while a page opens (PageView.beginOpening).
   * @param {{gl: WebGL2RenderingContext, isSoftware: boolean}} card
   */
  constructor({gl, isSoftware}) {
    this.gl = gl;
    /** @type {WebGLSync | null} */
    this.fence = null;
    this.begun = 0;
    this.divisor = isSoftware ? firstDivisor : 1;
    this.given = 1;
    /** @type {number[]} milliseconds of the last fine frames */
    this.fine = [];
    this.measures = true;
  }

  /**
   * A frame that began at this time has been sent to the card; `divisor` reduces the pixels along each side.
   * @param {number} divisor
   * @param {number} begun
   */
  gave(divisor, begun) {
    const {gl} = this;
    if (this.fence) gl.deleteSync(this.fence);
    Object.assign(this, {fence: gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0), given: divisor, begun});
    gl.flush();
  }
  /** True while the card still draws a frame. A further frame would make the view lag behind the pointer. */
  isBusy() {
    const {gl, fence} = this;
    if (!fence) return false;
    if (gl.getSyncParameter(fence, gl.SYNC_STATUS) !== gl.SIGNALED) return true;
    gl.deleteSync(fence);
    this.fence = null;
    if (this.measures) this.take(performance.now() - this.begun);
    return false;
  }
  /** @param {number} ms */
  take(ms) {
    if (this.given === 1) {
      this.fine = [...this.fine.slice(1 - paceMemory), ms];
      const least = Math.ceil(Math.sqrt(Math.min(...this.fine) / enoughMs));
      this.divisor = least <= 1 ? 1 : Math.max(2, Math.min(roughest, this.divisor > 1 ? this.divisor : least));
    } else if (ms > 1.5 * enoughMs) {
      this.divisor = Math.min(roughest, this.divisor + 1);
    } else if (ms < 0.3 * enoughMs) {
      this.divisor = Math.max(2, this.divisor - 1);
    }
  }
  /** Resolves when the card has finished all commands so far. */
  async drawn() {
    const {gl} = this, fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
    while (fence && gl.getSyncParameter(fence, gl.SYNC_STATUS) !== gl.SIGNALED)
      await new Promise((done) => setTimeout(done, 2));
    gl.deleteSync(fence);
  }
}
