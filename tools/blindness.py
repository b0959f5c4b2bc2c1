#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""How much of what a fuzzing engine does not see do the mutator and the counters of this folder show it?

    blindness.py run PROGRAM --side NAME --out ROWS [--seeds 1-5] [--seconds 120] [--mutants 861,862]
    blindness.py table ROWS >TABLE

Runs PROGRAM, one of fuzz_core_mutants_libfuzzer and fuzz_core_mutants_plain_libfuzzer, on one core from a corpus of
one input, all zeros, once for every mutant whose `set` in props/mutants/mutants.jsonl is `narrow` and every seed, until its
ledger has a finding or its CPU time is used up. A finding counts where the program without the fault has none on the
same record. ROWS gets a line of JSON as each run ends; a run that is there is not made again. `table` sums up.
"""
import argparse
import json
import os
import resource
import signal
import subprocess
import sys
import tempfile
import time

TOP = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
RECORD_SIZE = 128
LOOK_SECONDS = 0.1


def narrow_mutants():
    with open(os.path.join(TOP, 'props/mutants/mutants.jsonl'), encoding='ascii') as file:
        entries = [json.loads(line) for line in file if line.strip()]
    return {e['number']: e['what'] for e in entries if e.get('set') == 'narrow'}


def read_rows(path):
    if not os.path.exists(path):
        return []
    with open(path, encoding='utf-8') as file:
        return [json.loads(line) for line in file]


def environment(mutant, **more):
    kept = {key: value for key, value in os.environ.items() if not key.startswith('DAYLIGHT_')}
    return dict(kept, DAYLIGHT_MUTANT=str(mutant), ASAN_OPTIONS='malloc_context_size=2:quarantine_size_mb=16', **more)


def finds(program, record, mutant):
    """Whether the program with that fault, 0 for none, has a finding on the record."""
    done = subprocess.run([program, record], env=environment(mutant, DAYLIGHT_FUZZ_ABORT='1'), capture_output=True,
                          text=True, errors='replace')
    if done.returncode != 0 and 'DEDUP_TOKEN' not in done.stderr:
        sys.exit(f'{program} ends with {done.returncode} on {record}:\n{done.stderr}')
    return done.returncode != 0


def watch(process, folder, innocent):
    """Waits for the end of the process or a finding that is not `innocent`: which; how many are; whether time ended it."""
    common = set()
    while True:
        ended, status, usage = os.wait4(process.pid, os.WNOHANG)
        new = sorted(set(os.listdir(folder)) - common) if os.path.isdir(folder) else []
        for name in new:
            if os.path.getsize(f'{folder}/{name}') == RECORD_SIZE and innocent(f'{folder}/{name}'):
                common.add(name)
        if not ended and set(new) - common:
            process.kill()
            ended, status, usage = os.wait4(process.pid, 0)
        if ended:
            over = os.WIFSIGNALED(status) and os.WTERMSIG(status) == signal.SIGXCPU
            return sorted(set(new) - common), len(common), over, usage.ru_utime + usage.ru_stime
        time.sleep(LOOK_SECONDS)


def run_once(program, mutant, seed, seconds):
    with tempfile.TemporaryDirectory() as folder:
        os.mkdir(folder + '/corpus')
        with open(folder + '/corpus/zeros', 'wb') as file:  # no pair; the engine ends where nothing runs at all
            file.write(bytes(RECORD_SIZE))
        command = [program, folder + '/corpus', f'-max_len={RECORD_SIZE}', '-len_control=0', f'-seed={seed}',
                   f'-artifact_prefix={folder}/']
        with open(folder + '/log', 'w+', encoding='utf-8', errors='replace') as log:
            process = subprocess.Popen(command, env=environment(mutant, DAYLIGHT_FUZZ_OUT=folder), stdout=log,
                                       stderr=log, preexec_fn=lambda: resource.setrlimit(
                                           resource.RLIMIT_CPU, (seconds, seconds + 5)))
            found, common, over, cpu = watch(process, folder + '/findings', lambda record: finds(program, record, 0))
            process.returncode = 0  # waited for
            log.seek(0)
            text = log.read()
        if not found and not over:
            sys.exit(f'{program} ended after {cpu:.1f} s without a finding:\n{text[-2000:]}')
        note = ''
        if found:
            with open(folder + '/findings.jsonl', encoding='utf-8') as file:
                note = next(case['note'] for case in map(json.loads, file) if case['id'] == found[0])
        with open(folder + '/visited', 'rb') as file:
            executions = int.from_bytes(file.read(8), sys.byteorder)
        return {'found': bool(found), 'cpu_seconds': round(cpu, 1), 'executions': executions, 'finding': note,
                'findings_without_fault': common}


def run(arguments):
    mutants = narrow_mutants()
    chosen = [int(n) for n in arguments.mutants.split(',')] if arguments.mutants else sorted(mutants)
    first, last = (arguments.seeds.split('-') * 2)[:2]
    program = os.path.abspath(arguments.program)
    done = {(r['side'], r['mutant'], r['seed']) for r in read_rows(arguments.out)}
    for seed in range(int(first), int(last) + 1):
        for mutant in chosen:
            if (arguments.side, mutant, seed) in done:
                continue
            row = {'side': arguments.side, 'mutant': mutant, 'seed': seed, 'limit': arguments.seconds}
            row.update(run_once(program, mutant, seed, arguments.seconds))
            with open(arguments.out, 'a', encoding='utf-8') as file:
                file.write(json.dumps(row) + '\n')
            print(f'{arguments.side} {mutant} seed {seed}:', f'{row["cpu_seconds"]} s' if row['found'] else
                  f'not in {arguments.seconds} s', row['finding'], file=sys.stderr, flush=True)


def table(arguments):
    rows, what = read_rows(arguments.rows), narrow_mutants()
    sides = sorted({r['side'] for r in rows})
    print('CPU seconds until found, one number a seed. A dash means that the limit was reached.\n')
    print('| fault | ' + ' | '.join(sides) + ' |\n|---|' + '---|' * len(sides))
    for mutant in sorted({r['mutant'] for r in rows}):
        cells = []
        for side in sides:
            mine = sorted((r for r in rows if (r['side'], r['mutant']) == (side, mutant)), key=lambda r: r['seed'])
            cells.append(', '.join(f'{r["cpu_seconds"]}' if r['found'] else '-' for r in mine))
        print(f'| {mutant}: {what[mutant]} | ' + ' | '.join(cells) + ' |')
    print()
    for side in sides:
        mine = [r for r in rows if r['side'] == side]
        print(f'{side}: {sum(r["found"] for r in mine)} of {len(mine)} found, limit',
              ' or '.join(str(n) for n in sorted({r['limit'] for r in mine})), 's, seeds',
              ' '.join(str(n) for n in sorted({r['seed'] for r in mine})) + '.\n')


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(required=True)
    running = commands.add_parser('run')
    running.set_defaults(act=run)
    running.add_argument('program')
    running.add_argument('--side', required=True)
    running.add_argument('--out', required=True)
    running.add_argument('--seeds', default='1-5')
    running.add_argument('--seconds', type=int, default=120)
    running.add_argument('--mutants', default='')
    tabling = commands.add_parser('table')
    tabling.set_defaults(act=table)
    tabling.add_argument('rows')
    arguments = parser.parse_args()
    arguments.act(arguments)


main()
