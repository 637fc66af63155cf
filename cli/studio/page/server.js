// Requests to the program: JSON in, JSON or bytes out; a refusal is an error with its messages.

export class Refusal extends Error {
  /**
   * @param {number} status of HTTP; 0 without an answer
   * @param {{message: string, hint?: string}[]} errors
   */
  constructor(status, errors) {
    super(errors[0]?.message || `the studio answers ${status}`);
    this.status = status;
    this.errors = errors;
  }
}
export class Server {
  /** @param {string} token */
  constructor(token) {
    this.token = token;
    this.alive = true;
  }
  /**
   * @param {string} path
   * @param {object} [body] a POST; none: a GET
   */
  async ask(path, body) {
    let reply;
    try {
      reply = await fetch(path, {
        method: body ? 'POST' : 'GET',
        headers: {'X-Pomona-Token': this.token, ...(body ? {'Content-Type': 'application/json'} : {})},
        body: body ? JSON.stringify(body) : undefined
      });
    } catch {
      this.alive = false;
      throw new Refusal(
        0,
        [{message: 'The studio does not answer.', hint: 'start it again; what was drawn is kept beside the template'}]);
    }
    this.alive = true;
    if (reply.ok) return reply;
    const told = await reply.json().catch(() => ({errors: []}));
    throw new Refusal(reply.status, told.errors || []);
  }
  /**
   * @param {string} path
   * @param {object} [body]
   */
  async json(path, body) { return (await this.ask(path, body)).json(); }
  /**
   * @param {string} path
   * @param {object} [body]
   */
  async bytes(path, body) { return new Uint8Array(await (await this.ask(path, body)).arrayBuffer()); }
  /**
   * A section: {head, pictures: [{view, width, height, corner, right, down, image}]}.
   * @param {object} body
   */
  async section(body) {
    const bytes = await this.bytes('/api/section', body), length = new DataView(bytes.buffer).getUint32(0, true);
    const head = JSON.parse(new TextDecoder().decode(bytes.subarray(4, 4 + length)));
    let at = 4 + length;
    for (const picture of head.pictures) {
      const size = 4 * picture.width * picture.height;
      picture.image =
        new ImageData(new Uint8ClampedArray(bytes.buffer.slice(at, at + size)), picture.width, picture.height);
      at += size;
    }
    return head;
  }
}

/**
 * Runs one task at a time; of the requests in the meantime only the last.
 * @template T
 */
export class Latest {
  /** @param {(what: T) => Promise<void>} work */
  constructor(work) {
    this.work = work;
    /** @type {{what: T} | null} */
    this.wanted = null;
    this.busy = false;
  }
  /** @param {T} what */
  async ask(what) {
    this.wanted = {what};
    if (this.busy) return;
    this.busy = true;
    while (this.wanted) {
      const {what: next} = this.wanted;
      this.wanted = null;
      await this.work(next);
    }
    this.busy = false;
  }
}
