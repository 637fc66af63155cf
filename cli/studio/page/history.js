// Undo and redo of the texts.

/** @typedef {{toml: string, svg: string}} Texts */

export class History {
  /** @param {Texts} texts */
  constructor(texts) {
    /** @type {Texts[]} */
    this.past = [];
    /** @type {Texts[]} */
    this.next = [];
    this.now = texts;
  }
  /**
   * Adds a step that can be undone.
   * @param {Texts} texts
   */
  push(texts) {
    if (texts.toml === this.now.toml && texts.svg === this.now.svg) return false;
    this.past.push(this.now);
    if (this.past.length > 300) this.past.shift();
    this.now = texts;
    this.next = [];
    return true;
  }
  undo() { return this.go(this.past, this.next); }
  redo() { return this.go(this.next, this.past); }
  /**
   * @param {Texts[]} from
   * @param {Texts[]} to
   */
  go(from, to) {
    const texts = from.pop();
    if (!texts) return false;
    to.push(this.now);
    this.now = texts;
    return true;
  }
}
