// How fast the card draws frames, and how fine they may therefore be while something moves.

const enoughMs = 110;           // of a frame while something moves
export const firstDivisor = 2;  // of software that stands for a card
const roughest = 4;             // times fewer pixels along each side
export const restMs = 80;       // after which what has moved is drawn finely
const paceMemory = 3;           // frames: the first ones take the compiler's time, too

export class Pace {
  /**
   * `measures`: not while a page opens (Board.beginOpening).
   * @param {{gl: WebGL2RenderingContext, isSoftware: boolean}} card
   */
  constructor({gl, isSoftware}) {
    this.gl = gl;
    /** @type {WebGLSync | null} */
    this.fence = null;
    this.begun = 0;
    this.divisor = isSoftware ? firstDivisor : 1;
    this.given = 1;
    /** @type {number[]} milliseconds of the last frames that were drawn finely */
    this.fine = [];
    this.measures = true;
  }

  /**
   * A frame, begun at this time, has gone to the card, with so many times fewer pixels along each side.
   * @param {number} divisor
   * @param {number} begun
   */
  gave(divisor, begun) {
    const {gl} = this;
    if (this.fence) gl.deleteSync(this.fence);
    Object.assign(this, {fence: gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0), given: divisor, begun});
    gl.flush();
  }
  /** While the card works on a frame nothing new is given to it: what is seen would lag behind the hand. */
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
  /** When the card has drawn all that it has been given until now. */
  async drawn() {
    const {gl} = this, fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
    while (fence && gl.getSyncParameter(fence, gl.SYNC_STATUS) !== gl.SIGNALED)
      await new Promise((done) => setTimeout(done, 2));
    gl.deleteSync(fence);
  }
}
