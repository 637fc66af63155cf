// Undo and redo: the texts as they were.

export class History {
  constructor(texts) {
    this.past = [];
    this.next = [];
    this.now = texts;
  }
  /** A step that can be taken back. */
  push(texts) {
    if (texts.toml === this.now.toml && texts.svg === this.now.svg) return false;
    this.past.push(this.now);
    if (this.past.length > 300) this.past.shift();
    this.now = texts;
    this.next = [];
    return true;
  }
  undo() {
    if (this.past.length) {
      this.next.push(this.now);
      this.now = this.past.pop();
      return true;
    }
    return false;
  }
  redo() {
    if (this.next.length) {
      this.past.push(this.now);
      this.now = this.next.pop();
      return true;
    }
    return false;
  }
}
