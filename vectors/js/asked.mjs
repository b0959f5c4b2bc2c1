// SPDX-License-Identifier: MIT
// The thread that calls `collide`: a hang ends it, and not the run.
import { parentPort, workerData } from 'node:worker_threads';

process.exit = (code) => { throw new Error(`called process.exit(${code})`); };
const { collide } = await import(workerData);
if (typeof collide !== 'function') throw new Error(`${workerData} exports no function collide`);
parentPort.on('message', async ({ a, b, result }) => {
  try {
    const said = await collide(a, b);
    const plain = said == null || ['boolean', 'number', 'string'].includes(typeof said);
    parentPort.postMessage(plain ? { said } : { failure: `said ${JSON.stringify(said)}, which is no answer` });
  } catch (error) {
    const refused = error instanceof RangeError && result === 'invalid';
    parentPort.postMessage(refused ? { said: 'invalid' } : { failure: `threw ${error}` });
  }
});
parentPort.postMessage('ready');
