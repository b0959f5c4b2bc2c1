#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""hostile_test.py DAYLIGHT: guests that do what they can to hurt. Each is named, and the run goes to its end. The
results of all others are those without the guest. No process is left, and the run resumes.

The test has a PID namespace of its own, so that a guest that broke out would reach no other process.
"""
import os
import shutil
import sqlite3
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
OUTSIDE = 'HOSTILE_TEST_OUTSIDE'  # set inside the namespace: the number of the one outside
OTHERS = 'decide,libccd'
PAIRS = 600  # more than a batch
PATIENCE = 3000  # looks, 0.1 s apart, before a process counts as left: far beyond what ending takes anywhere

# Right as far as it goes; some of the heights, by their bits, make it do its worst.
PLUGIN = r'''
#include <fenv.h>
#include <math.h>
#include <pthread.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>
#include "plugin.h"
#define IS(word) (strcmp(mode, word) == 0)
static volatile int spin = 1;
static void* spinning(void* x) { while (spin) { } return x; }
static void deep(volatile char* from) { volatile char here[4096]; here[0] = *from; deep(here); }
static void with_all(void (*act)(int)) { int fd; for (fd = 0; fd < 1024; ++fd) act(fd); }
static void scribble(int fd) { ssize_t ignored = write(fd, "garbage garbage garbage garbage", 31); (void)ignored; }
static void shut(int fd) { close(fd); }
static int misbehave(const char* mode, double* a, double* more) {
  int i;
  if (IS("segv")) raise(SIGSEGV);
  if (IS("stack")) { char start = 0; deep(&start); }
  if (IS("exit")) exit(0);
  if (IS("_exit")) _exit(0);
  if (IS("blocked-loop")) { sigset_t all; sigfillset(&all); sigprocmask(SIG_BLOCK, &all, 0); while (spin) { } }
  if (IS("print")) for (i = 0; i < 100; ++i) { puts("garbage"); fputs("garbage\n", stderr); }
  if (IS("close")) with_all(shut);
  if (IS("scribble")) with_all(scribble);
  if (IS("fork") && fork() == 0) while (1) pause();
  if (IS("rounding")) fesetround(FE_UPWARD);
  if (IS("far-more")) for (i = 0; i < 20000; ++i) more[i] = 1;
  if (IS("near-more")) for (i = 7; i < 12; ++i) more[i] = 1;
  if (IS("inputs")) memset(a, 0, 64);
  if (IS("77")) return 77;
  if (IS("kill-all")) kill(-1, SIGKILL);
  if (IS("thread")) { pthread_t t; pthread_create(&t, 0, spinning, 0); }
  if (IS("limits")) {
    struct rlimit none = {0, 0};
    struct itimerval soon = {{0, 1000}, {0, 1000}};
    setrlimit(RLIMIT_NOFILE, &none);
    setrlimit(RLIMIT_FSIZE, &none);
    signal(SIGALRM, SIG_IGN);
    setitimer(ITIMER_REAL, &soon, 0);
  }
  if (IS("bomb")) for (i = 0; i < 1 << 20; ++i) memset(malloc(1 << 20), 1, 1 << 20);
  if (IS("claims-memory")) while (1) *(volatile char*)malloc(1 << 28) = 1;
  if (IS("infinite")) more[0] = INFINITY;
  if (IS("stop")) raise(SIGSTOP);
  return DAYLIGHT_DECLINED;
}
static int is_time(double height) {
  unsigned long long bits;
  memcpy(&bits, &height, sizeof bits);
  return height != 0 && (bits * 0x9e3779b97f4a7c15ull >> 40) % 200 == 0;
}
static int ask(const double* a, const double* b, double* more) {
  const char* mode = getenv("HOSTILE");
  const double reach = hypot(a[6], a[7] / 2) + hypot(b[6], b[7] / 2);
  const double apart = hypot(hypot(b[0] - a[0], b[1] - a[1]), b[2] - a[2]);
  if (mode && is_time(a[7])) {
    const int word = misbehave(mode, (double*)a, more);
    if (word != DAYLIGHT_DECLINED) return word;
  }
  return apart > reach * (1 + 1e-9) ? DAYLIGHT_DISJOINT : DAYLIGHT_UNDECIDED;
}
__attribute__((constructor)) static void at_load(void) {
  const char* mode = getenv("HOSTILE");
  if (!mode) return;
  if (IS("load-exit")) exit(0);
  if (IS("load-segv")) raise(SIGSEGV);
  if (IS("load-stop")) raise(SIGSTOP);
  if (IS("load-fork")) fork();
  if (IS("load-print")) puts("GARBAGE at load");
}
static const struct DaylightMethod hostile = {DAYLIGHT_PLUGIN_ABI, "hostile", "1", 0, 0, 0, ask, 0, 0, 0, 0};
const struct DaylightMethod* daylight_method(void) { return &hostile; }
'''

COMMAND = r'''
import json, os, signal, struct, subprocess, sys
mode = os.environ.get('HOSTILE', '')
for line in sys.stdin:
    pair = json.loads(line)
    a = pair['a']
    bits = struct.unpack('<Q', struct.pack('<d', a['height']))[0]
    if ((bits * 0x9e3779b97f4a7c15) % 2**64 >> 40) % 200 == 0 and a['height']:
        if mode == 'kill-all':
            os.kill(-1, signal.SIGKILL)
        elif mode == 'kill-group':
            os.kill(0, signal.SIGKILL)
        elif mode == 'kill-parent':
            os.kill(os.getppid(), signal.SIGKILL)
        elif mode == 'orphan':
            subprocess.Popen(['setsid', 'sleep', '1000'])
        elif mode == 'fork-bomb':
            while True:
                os.fork()
        elif mode == 'stop':
            os.kill(os.getpid(), signal.SIGSTOP)
        elif mode == 'close':
            os.closerange(0, 100)
    print(json.dumps({'verdict': 'undecided'}), flush=True)
'''

WHATEVER = object()  # whether it is named hangs on the system's shell

# What it does, and how the finding of it reads; nothing where it does no harm.
NAMED = {
    'segv': ('crash', 'SIGSEGV'),
    'stack': ('crash', 'SIGSEGV'),
    'exit': ('crash', 'called exit()'),
    '_exit': ('crash', 'ended its process with status 0'),
    'blocked-loop': ('hang', 'ms of CPU time'),
    'print': None,
    'close': None,
    'scribble': None,
    'fork': ('crash', 'called clone(), which a method may not'),
    'rounding': ('side_effect', 'the rounding mode changed'),
    'far-more': ('crash', 'SIG'),
    'near-more': ('side_effect', 'wrote behind'),
    'inputs': None,
    '77': ('malformed', '77'),
    'kill-all': ('crash', 'called kill(), which a method may not'),
    'thread': ('side_effect', 'thread'),
    'limits': None,
    'bomb': ('', ''),  # a crash where the cap on memory is met first, a hang where that on time is
    'claims-memory': ('crash', 'SIGSEGV'),
    'infinite': ('non_finite', 'inf'),
}
COMMAND_NAMED = {
    'kill-all': WHATEVER,  # beside it there is the shell that started it, or none
    'kill-group': ('crash', 'SIGKILL'),
    'kill-parent': WHATEVER,
    'orphan': None,
    'close': ('crash', ''),
}
AT_LOAD = {'load-exit': 'ended', 'load-segv': 'SIGSEGV', 'load-stop': 'did not load within', 'load-fork': 'may not'}


def run(daylight, *words, status=None, mode=None):
    env = dict(os.environ)
    env.pop('HOSTILE', None)
    if mode:
        env['HOSTILE'] = mode
    done = subprocess.run([daylight, *words], env=env, capture_output=True, text=True, timeout=1200)
    if status is not None and done.returncode not in status:
        sys.exit(f'{mode}: exit status {done.returncode}, not {status}: {words}\n{done.stdout[-2000:]}{done.stderr[-2000:]}')
    return done


def results_of(folder, of_guest):
    """The tallies and findings of the guest in a run, or of all others."""
    with sqlite3.connect(folder / 'run.sqlite') as store:
        sign = '=' if of_guest else '<>'
        tallies = store.execute('SELECT method, family, asked, declined, failed, contract, resolution, undecided FROM tally '
                                f"WHERE method {sign} 'hostile' AND method NOT LIKE 'referee%' ORDER BY 1, 2").fetchall()
        findings = store.execute('SELECT pair_index, method, kind, severity, reason FROM finding '
                                 f"WHERE method {sign} 'hostile' AND method NOT LIKE 'referee%' ORDER BY 1, 2").fetchall()
    return tallies, findings


def processes():
    """All processes of this namespace except this one, which adopts orphans. Waits for those that are about to end. A
    keeper ends its guest when it sees that its own parent is gone, which may be after the end of the program."""
    for _ in range(PATIENCE):
        try:
            while os.waitpid(-1, os.WNOHANG)[0]:
                pass
        except ChildProcessError:
            pass
        left = {int(p.name) for p in Path('/proc').iterdir() if p.name.isdigit()} - {os.getpid()}
        if not left:
            break
        time.sleep(0.1)
    return left


def command_of(process):
    try:
        return Path(f'/proc/{process}/cmdline').read_bytes().replace(b'\0', b' ').decode(errors='replace')
    except OSError:
        return 'one that has ended since'


def check(daylight, guest, mode, named, alone):
    out = Path('runs') / f'{guest[0][2:]}-{mode}'
    campaign = ('campaign', '--pairs', str(PAIRS), '--seed', '3', '--cases', '', '--methods', f'{OTHERS},hostile', *guest)
    run(daylight, *campaign, '--out', str(out), status=(0, 2), mode=mode)
    faults = []
    if results_of(out, False) != alone:
        faults.append('the answers of others changed')
    tallies, findings = results_of(out, True)
    asked = sum(t[2] for t in tallies)
    if asked != PAIRS:
        faults.append(f'{asked} of {PAIRS} pairs were asked')
    if named is WHATEVER:
        pass
    elif named and not any(named[0] in kind and named[1] in reason for *_, kind, _, reason in findings):
        faults.append(f'not named as {named}: {findings[:3]}')
    elif not named and findings:
        faults.append(f'named: {findings[:3]}')
    run(daylight, 'campaign', '--resume', str(out), '--pairs', str(PAIRS + 100), status=(0, 2), mode=mode)
    left = processes()
    if left:
        faults.append('left processes: ' + str([command_of(p) for p in left]))
    print(f'{guest[0][2:]} {mode}: ' + ('; '.join(faults) or 'ok'), flush=True)
    return not faults


def pid_namespace():
    return str(os.stat('/proc/self/ns/pid').st_ino)


def inside(daylight):
    if os.getpid() != 1 or os.environ[OUTSIDE] == pid_namespace():
        sys.exit('not the first process of a PID namespace: what guests signal here would reach others')
    Path('hostile.c').write_text(PLUGIN)
    Path('hostile.py').write_text(COMMAND)
    subprocess.run(['cc', '-shared', '-fPIC', '-O1', '-I', ROOT / 'oracles', 'hostile.c', '-o', 'hostile.so', '-lm',
                    '-lpthread'], check=True)
    plugin, command = ('--plugin', './hostile.so'), ('--command', 'hostile=python3 hostile.py')
    run(daylight, 'campaign', '--pairs', str(PAIRS), '--seed', '3', '--cases', '',
        '--methods', OTHERS, '--out', 'runs/alone', status=(0, 2))
    alone = results_of(Path('runs/alone'), False)
    good = True
    for mode, named in NAMED.items():
        good = check(daylight, plugin, mode, named, alone) and good
    for mode, named in COMMAND_NAMED.items():
        good = check(daylight, command, mode, named, alone) and good
    for mode, message in AT_LOAD.items():
        done = run(daylight, 'campaign', '--pairs', '5', *plugin, '--out', 'runs/never', status=(64,), mode=mode)
        if message not in done.stderr or processes():
            print(f'{mode}: {done.stderr} {processes()}')
            good = False
    pair = '{"a":{"center":[0,0,0],"axis":[0,0,1],"radius":1,"height":2},"b":{"center":[9,0,0],"axis":[0,0,1],"radius":1,"height":2}}'
    Path('pair.jsonl').write_text(pair + '\n')
    if 'GARBAGE' in run(daylight, 'check', *plugin, '--method', 'hostile', 'pair.jsonl', mode='load-print').stdout:
        print('what a library prints reaches standard output')
        good = False
    for mode in ('kill-all', 'scribble', 'rounding'):
        run(daylight, 'gate', '--pairs', '2000', *plugin, status=(0, 2, 3), mode=mode)
    return 0 if good else 1


def main():
    daylight = os.path.abspath(sys.argv[1])
    if os.environ.get(OUTSIDE):
        return inside(daylight)
    apart = ['unshare', '--pid', '--fork', '--mount-proc', '--kill-child']
    for more in ([], ['--user', '--map-root-user']):
        if subprocess.run([*apart, *more, 'true'], stderr=subprocess.DEVNULL).returncode == 0:
            scratch = tempfile.mkdtemp()
            try:
                return subprocess.run([*apart, *more, sys.executable, __file__, daylight], cwd=scratch,
                                      env={**os.environ, OUTSIDE: pid_namespace()}).returncode
            finally:
                shutil.rmtree(scratch)
    return subprocess.run([ROOT / '.ci/skip', 'this system allows no PID namespace']).returncode


sys.exit(main())
