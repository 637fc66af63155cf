// Verdicts of a long test, a line each: it goes on after what fails, and a stopped run goes on where it was.
import assert from 'node:assert';
import {createHash} from 'node:crypto';
import {appendFileSync, existsSync, mkdirSync, readFileSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';

/** The table `name`.tsv in a folder: verdicts of the same program by the same script are kept, others are dropped. */
export class Verdicts {
  constructor(program, folder, name, columns) {
    mkdirSync(folder, {recursive: true});
    this.file = join(folder, `${name}.tsv`);
    const hash = createHash('sha256');
    for (const asked of [program, process.argv[1]]) hash.update(readFileSync(asked));
    const head = ['verdict', ...columns, `of ${hash.digest('hex').slice(0, 16)}`].join('\t');
    const lines = existsSync(this.file) ? readFileSync(this.file, 'utf8').trimEnd().split('\n') : [];
    if (lines[0] !== head) writeFileSync(this.file, head + '\n');
    console.log(head);
    /** The rows by their subjects, the first column. */
    this.rows =
      new Map((lines[0] === head ? lines.slice(1) : []).map((line) => line.split('\t')).map((row) => [row[1], row]));
  }

  /** Calls `ask`, which returns what is wrong and the other columns, unless the subject has passed before. */
  take(subject, ask) {
    const before = this.rows.get(subject);
    if (before?.[0] === 'passed') return console.log(before.join('\t'));
    let wrong, columns = [];
    try {
      ({wrong, columns} = ask());
    } catch (fault) { wrong = [fault instanceof Error ? fault.message : String(fault)]; }
    const row = [wrong.length ? 'failed' : 'passed', subject, ...columns, wrong.join('; ')].map(
      (cell) => String(cell).replaceAll(/\s+/g, ' '));
    this.rows.set(subject, row);
    appendFileSync(this.file, row.join('\t') + '\n');
    console.log(row.join('\t'));
  }

  /** Fails if one of the subjects has not passed. */
  finish(subjects) {
    const failed = subjects.filter((subject) => this.rows.get(subject)?.[0] !== 'passed');
    assert.deepEqual(failed, [], `${failed.length} of ${subjects.length} failed: ${this.file}`);
  }
}

/** A watch that throws after so many seconds of processor time. */
export function timeLimit(seconds) {
  const begin = process.cpuUsage().user;
  return () => {
    const spent = (process.cpuUsage().user - begin) / 1e6;
    if (spent > seconds) throw new Error(`no verdict after ${spent.toFixed(0)} s of processor time`);
  };
}
