# SPDX-License-Identifier: MIT
"""Calls a function in a process of its own, so that a hang or a crash is an answer too."""
import importlib
import json
import numbers
import os
import queue
import subprocess
import sys
import threading


def function_of(name):
    """`mine:collide`, from the folder that this runs in or from what is installed."""
    module, _, attribute = name.partition(':')
    if not attribute:
        raise ValueError(f'{name}: not MODULE:FUNCTION')
    if os.getcwd() not in sys.path:
        sys.path.insert(0, os.getcwd())
    return getattr(importlib.import_module(module), attribute)


class Asker:
    """Keeps a process that answers, and starts another after one that hung or ended."""

    def __init__(self, name, limit):
        self.name, self.limit, self.process = name, limit, None
        self.start()  # a function that is not there is noticed at once

    def start(self):
        path = os.pathsep.join(filter(None, sys.path))
        self.process = subprocess.Popen([sys.executable, '-c', f'from {__name__} import serve; serve({self.name!r})'],
                                        stdin=subprocess.PIPE, stdout=subprocess.PIPE, encoding='utf-8',
                                        env=dict(os.environ, PYTHONPATH=path))
        self.lines = queue.Queue()
        threading.Thread(target=self.listen, args=(self.process.stdout, self.lines), daemon=True).start()
        error = self.reply(None).get('failure')
        if error:
            self.close()
            raise ValueError(error)

    @staticmethod
    def listen(stream, lines):
        for line in stream:
            lines.put(line)
        lines.put(json.dumps({'failure': 'ended its process'}))

    def reply(self, seconds):
        try:
            return json.loads(self.lines.get(timeout=seconds))
        except queue.Empty:
            return {'failure': f'gave no answer within {seconds:g} s'}

    def ask(self, a, b, may_refuse):
        """(what it said, None), or (None, why it gave no answer)."""
        if self.process is None:
            self.start()
        try:
            self.process.stdin.write(json.dumps([a, b, may_refuse]) + '\n')
            self.process.stdin.flush()
        except OSError:  # it ended; the reply is why
            pass
        reply = self.reply(self.limit)
        if reply.get('ends', True) and 'said' not in reply:
            self.close()
        return reply.get('said'), reply.get('failure')

    def close(self):
        if self.process is not None:
            self.process.kill()
            self.process.wait()
            self.process.stdin.close()
            self.process = None


def answer(function, a, b, may_refuse):
    try:
        said = function(a, b)
        if not isinstance(said, (str, numbers.Real)) and getattr(said, 'ndim', 1) == 0:
            said = said.item()  # of NumPy
        if isinstance(said, numbers.Real) and not isinstance(said, bool):
            said = float(said)
    except ValueError as error:
        return {'said': 'invalid'} if may_refuse else {'failure': f'raised {error!r}', 'ends': False}
    except Exception as error:  # what a library raises is a finding
        return {'failure': f'raised {error!r}', 'ends': False}
    if said is not None and not isinstance(said, (str, bool, float)):
        return {'failure': f'said {said!r}, which is no answer', 'ends': False}
    return {'said': said}


def serve(name):
    """The process: a pair a line, and an answer a line. What the function prints goes to standard error."""
    answers = os.fdopen(os.dup(1), 'w', encoding='utf-8')
    os.dup2(2, 1)
    try:
        function = function_of(name)
    except (ValueError, OSError, ImportError, AttributeError) as error:
        print(json.dumps({'failure': str(error)}), file=answers, flush=True)
        return
    print(json.dumps({'said': None}), file=answers, flush=True)
    for line in sys.stdin:
        print(json.dumps(answer(function, *json.loads(line))), file=answers, flush=True)
