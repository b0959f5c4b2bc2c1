#!/usr/bin/env node
// SPDX-License-Identifier: MIT
// daylight-vectors MODULE [--tier T] [--tolerance LENGTH] [--limit SECONDS] [--exclude FILE] [--store FILE]
// Exit status: 0 nothing is wrong, 2 something is, 64 wrong usage.
import { parseArgs } from 'node:util';
import { Run } from './runner.mjs';

async function main() {
  const names = ['tier', 'tolerance', 'limit', 'exclude', 'store'];
  const options = Object.fromEntries(names.map((name) => [name, { type: 'string' }]));
  const { values, positionals } = parseArgs({ options, allowPositionals: true });
  if (positionals.length !== 1) throw new Error(`daylight-vectors MODULE [--${names.join(' X] [--')} X]`);
  for (const name of ['tolerance', 'limit'])
    if (name in values && !((values[name] = Number(values[name])) >= 0)) throw new Error(`--${name}: not a number`);
  const run = new Run(positionals[0], values);
  for (const cell of run.cells()) {
    const report = await run.report(cell);
    if (report) console.log(`${cell[0]}: ${report}`);
  }
  run.finish();
  const of = (word) => [...run.results.values()].filter((result) => result === word).length;
  const wrong = run.vectors.filter(run.isWrong).length;
  console.log(`${run.results.size} asked: ${of('right')} right, ${of('acceptable')} within the tolerance, ` +
    `${of('declined')} declined, ${wrong} wrong; ${run.excluded.length} excluded`);
  return wrong ? 2 : 0;
}

process.exitCode = await main().catch((error) => (console.error(error.message), 64));
