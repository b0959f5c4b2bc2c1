#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""compare.py finds a slower executable while the machine does other work. Programs of made-up times show it."""
import os
import subprocess
import sys
import tempfile

compare = os.path.join(os.path.dirname(os.path.abspath(__file__)), 'compare.py')
# Ten families; the machine gets slower by a tenth with each run, and each time is a little off.
fake = '''#!/usr/bin/env python3
import json, os, sys
count = os.path.join(os.path.dirname(os.path.abspath(sys.argv[0])), 'runs')
n = int(open(count).read()) if os.path.exists(count) else 0
open(count, 'w').write(str(n + 1))
rows = [dict(method='intersect', query='verdict', family=f'family{i}',
             median_ns=10 * (1 + i) * (1 + 0.1 * n) * (1 + 0.01 * ((7 * n + 3 * i) % 5)) * (FACTOR if i in SLOW else 1))
        for i in range(10)]
json.dump(dict(results=rows), open(sys.argv[sys.argv.index('--json') + 1], 'w'))
'''


def run(factor, slow, turns=4):
    """Returns the exit code and the text, of a new program that is slower by `factor` on the families `slow`."""
    with tempfile.TemporaryDirectory() as folder:
        files = []
        for name, f in (('old', 1.0), ('new', factor)):
            files.append(os.path.join(folder, name))
            with open(files[-1], 'w', encoding='utf-8') as text:
                text.write(fake.replace('FACTOR', str(f)).replace('SLOW', repr(list(slow))))
            os.chmod(files[-1], 0o755)
        done = subprocess.run([sys.executable, compare, *files, '--turns', str(turns)], capture_output=True, text=True,
                              check=False)
        return done.returncode, done.stdout + done.stderr


failures = 0
for what, factor, slow, code, line in [
        ('the same', 1.0, range(10), 0, 'nothing is slower'),
        ('faster', 0.7, range(10), 0, 'nothing is slower'),
        ('a tenth slower everywhere', 1.1, range(10), 2, 'slower: intersect (verdict), (10 families)'),
        ('one family alone, by half', 1.5, [3], 2, 'intersect (verdict), family3'),
        ('one family, by a twentieth', 1.05, [3], 0, 'nothing is slower'),
]:
    got, text = run(factor, slow)
    if got != code or line not in text:
        failures += 1
        print(f'{what}: exit code {got} for {code}\n{text}')
got, text = run(1.0, [], turns=1)
if got != 0 or 'inf' not in text:
    failures += 1
    print(f'one turn shows nothing: {got}\n{text}')
sys.exit(failures != 0)
