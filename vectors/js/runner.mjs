// SPDX-License-Identifier: MIT
// Puts vectors to the function `collide` of a module and judges what it returns, as python/vectors does.
import assert from 'node:assert';
import { once } from 'node:events';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { after, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { Worker } from 'node:worker_threads';

const words = ['disjoint', 'touching', 'intersecting', 'invalid'];
const here = (path) => new URL(path, import.meta.url);
const folder = existsSync(here('v1')) ? 'v1' : '../v1'; // as packed, or as in the source tree
const read = (path) => JSON.parse(readFileSync(path, 'utf8'));
const flags = read(here(`${folder}/flags.json`));

/** The vectors of smoke, standard, or a file of `daylight vectors`. */
export const load = (tier = 'smoke') =>
  read(['smoke', 'standard'].includes(tier) ? here(`${folder}/${tier}.json`) : tier).vectors;

/** The ids of a file with an id and a reason a line. */
function exclusions(path) {
  const lines = path ? readFileSync(path, 'utf8').split('\n').filter((line) => /^\s*[^#\s]/.test(line)) : [];
  for (const line of lines) assert(/\S\s+\S/.test(line), `${path}: ${line.trim()} is excluded without a reason`);
  return lines.map((line) => line.trim().split(/\s/)[0]);
}

/** A copy with numbers where JSON has words. */
function solid(s) {
  const number = (x) => (Array.isArray(x) ? x.map(number) : Number(String(x).replace('inf', 'Infinity')));
  return { rounding: 0, ...Object.fromEntries(Object.entries(s).map(([name, x]) => [name, number(x)])) };
}

/** 'right', 'acceptable' (within the tolerance that the library states), 'declined', or in words what is wrong. */
export function judge(v, said, tolerance = 0) {
  if (said == null) return 'declined';
  if (typeof said === 'string' && !words.includes(said)) return `said '${said}', which is none of ${words.join(', ')}`;
  if (v.result === 'invalid' || said === 'invalid')
    return v.result === said ? 'right' : `said ${said} of a pair that is ${v.result}`;
  const [low, high] = v.distance;
  const number = typeof said === 'number';
  const meets = typeof said === 'boolean' ? said : said !== 'disjoint';
  const right = meets === (v.result !== 'disjoint') && (said !== 'touching' || v.result === 'touching');
  if (number ? low <= said && said <= high : right) return 'right';
  if (number ? low - tolerance <= said && said <= high + tolerance : tolerance > v.acceptable_below) return 'acceptable';
  return `said ${said}; they are ${v.result}, at a distance of ${low} to ${high}`;
}

/** 1e-03: a margin of 1e-3 to 1e-2 of the size. */
const decade = ({ result, margin }) => ['invalid', 'touching'].includes(result) ? result
  : margin ? `1e-${String(-Math.floor(Math.log10(margin))).padStart(2, '0')}` : 'unknown';

/** Asks about each vector once, at first about those that failed last time. */
export class Run {
  constructor(module, { tier, tolerance = 0, exclude, store = '.daylight-vectors.json', limit = 10 } = {}) {
    Object.assign(this, { tolerance, store, limit, results: new Map(), excluded: exclusions(exclude) });
    this.url = module instanceof URL ? module.href : pathToFileURL(resolve(module)).href;
    this.before = existsSync(store) ? read(store) : [];
    this.vectors = load(tier).filter((v) => !this.excluded.includes(v.id));
    this.first = this.vectors.filter((v) => this.before.includes(v.id));
  }

  async ask(v) {
    try {
      this.worker ??= new Worker(here('asked.mjs'), { workerData: this.url });
      if (!this.ready) this.ready = await once(this.worker, 'message');
      this.worker.postMessage({ a: solid(v.a), b: solid(v.b), result: v.result });
      const [{ said, failure }] = await once(this.worker, 'message', { signal: AbortSignal.timeout(this.limit * 1000) });
      return failure ?? judge(v, said, this.tolerance);
    } catch (error) {
      if (!this.ready) throw error;
      this.worker = this.ready = this.worker.terminate() && undefined;
      return error.name === 'AbortError' ? `gave no answer within ${this.limit} s` : `threw ${error}`;
    }
  }

  isWrong = (v) => !['right', 'acceptable', 'declined'].includes(this.results.get(v.id) ?? 'right');

  /** [name, vectors]: a vector is in the cell of each of its flags; what failed last time is first. */
  cells() {
    const cells = {};
    for (const v of new Set([...this.first, ...this.vectors]))
      for (const flag of v.flags.length ? v.flags : ['General']) (cells[`${flag} ${decade(v)}`] ??= []).push(v);
    return Object.entries(cells);
  }

  /** How many are wrong, the simplest pair, and what is known of the class of bug; or nothing. */
  async report([name, vectors]) {
    for (const v of [...this.first, ...vectors])
      if (!this.results.has(v.id)) this.results.set(v.id, await this.ask(v));
    const pair = ({ a, b }) => JSON.stringify({ a, b });
    const [simplest, ...more] = vectors.filter(this.isWrong).sort((v, w) => pair(v).length - pair(w).length);
    if (!simplest) return '';
    const { means, bugs, met_by: met } = flags[name.split(' ')[0]] ?? { means: 'No flag.', bugs: ['any'], met_by: [] };
    return `${more.length + 1} wrong. The simplest, ${simplest.id}: ${this.results.get(simplest.id)}
  ${pair(simplest)}\n  ${means} Class of bug: ${bugs.join(', ')}. ${met.length ? `Met by ${met.join(', ')}` : ''}`;
  }

  /** Stores the ids that fail; those that were not asked this time keep what they were. */
  finish() {
    this.worker?.terminate();
    const failed = this.vectors.filter(this.isWrong).map((v) => v.id);
    const kept = [...failed, ...this.before.filter((id) => !this.results.has(id))];
    if (kept.length || existsSync(this.store)) writeFileSync(this.store, `${JSON.stringify(kept.sort())}\n`);
  }
}

/** A test of node:test for each flag and decade of margin. */
export function tests(module, options) {
  const run = new Run(module, options);
  after(() => run.finish());
  for (const cell of run.cells())
    test(`daylight ${cell[0]}`, async (t) => {
      const report = await run.report(cell);
      if (report) throw new Error(report);
      if (cell[1].every((v) => run.results.get(v.id) === 'declined')) t.skip('declined');
    });
}
