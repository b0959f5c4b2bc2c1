#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""mutations_test.py: what mutations.py changes in a snippet, and what it leaves alone."""
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from mutations import mutated, mutations  # noqa: E402

failures = 0


def changes(text):
    return {(m.kind, mutated(m, text)) for m in mutations('x.cpp', text)}


def expect(text, *expected):
    """The changes are these, each a (kind, text), or a set of which one is there."""
    global failures
    found = changes(text)
    left = set(found)
    for wanted in expected:
        ways = wanted if isinstance(wanted, list) else [wanted]
        there = found & set(ways)
        left -= there
        if len(there) != 1:
            failures += 1
            print(f'{text!r}: {ways} is not there once, but {sorted(found)}')
    if left:
        failures += 1
        print(f'{text!r}: {sorted(left)} too')


expect('x = a + b;', ('operator', 'x = a - b;'), ('term', 'x = a;'), ('first term', 'x = b;'))
expect('x = a - f(b, c);', ('operator', 'x = a + f(b, c);'), ('term', 'x = a;'), ('first term', 'x = - f(b, c);'))
expect('x = a * b;', [('operator', 'x = a / b;'), ('factor', 'x = a;'), ('factor', 'x = b;')])
expect('x = a / b;', ('operator', 'x = a * b;'))
expect('x += -a;', ('operator', 'x -= -a;'), ('sign', 'x += a;'))
expect('if (a < b) f();', [('edge', 'if (a <= b) f();'), ('turn', 'if (a > b) f();')])
expect('if (a >= b) f();', [('edge', 'if (a > b) f();'), ('turn', 'if (a <= b) f();')])
expect('if (a == b) f();', ('operator', 'if (a != b) f();'))
expect('if (!a && b) f();', ('negation', 'if (a && b) f();'), ('operator', 'if (!a || b) f();'))
expect('m = m | n;', ('operator', 'm = m & n;'))
expect('return std::sqrt(x);', ('call', 'return (x);'))
expect('return std::fabs(larger(x, y));', ('call', 'return (larger(x, y));'), ('partner', 'return std::fabs(smaller(x, y));'))
expect('return std::min(x, y);', ('partner', 'return std::max(x, y);'))
expect('mpfr_add(v, a, b, MPFR_RNDU);', ('operator', 'mpfr_sub(v, a, b, MPFR_RNDU);'),
       ('partner', 'mpfr_add(v, a, b, MPFR_RNDD);'))
expect('f(true);', ('partner', 'f(false);'))
# Constants: a power of two to its root, zero to one, any other doubled or halved.
expect('x = 0x1p-60;', ('constant', 'x = 0x1p-30;'))
expect('x = 0.0;', ('constant', 'x = 1.0;'))
expect('x = y[0];', ('constant', 'x = y[1];'))
expect('x = 3.5;', [('constant', 'x = (3.5 * 2);'), ('constant', 'x = (3.5 / 2);')])
expect('x = 0x7ff;', [('constant', 'x = (0x7ff * 2);'), ('constant', 'x = (0x7ff / 2);')])
# A line's end stays, so that later lines keep their numbers.
expect('x = a +\n    b;', ('operator', 'x = a -\n    b;'), ('term', 'x = a\n;'), ('first term', 'x = \nb;'))
# Left alone: comments, strings, preprocessor, templates, pointers and references, lengths of arrays, assertions,
# definitions of operators and functions.
for quiet in ('// a + b < 1', '/* a * 2 */', 'f("a + 1", \'+\');', 'f(R"(a + 1)");', '#define A(x) \\\n  (x + 1)', '#if 2 < 3\n#endif',
              'std::array<double, 2> x;', 'template <class T, int N = 3>\nvoid f();', 'f<3>(x);', 'const auto* p = &x;',
              'T* f(const T& x);', 'double d[4];', 'static_assert(a + 1 < 2, "b");', 'T operator+(T a, T b);',
              'bool operator<(T a, T b);', 'double sqrt(double x);', 'p->x = *q;', 'x++;', 'auto f = [&](T&& x) {};'):
    expect(quiet)

# An id tells nothing of the lines around, and two changes of one line have two.
text = 'x = a + b + c;\n'
ids = [m.id for m in mutations('x.cpp', text)]
moved = [m.id for m in mutations('x.cpp', 'int y;\n' + text + 'z = a;\n')]
if ids != moved or len(set(ids)) != len(ids):
    failures += 1
    print('ids', ids, moved)
if len(mutations('x.cpp', text + text)) != 2 * len(ids) or len({m.id for m in mutations('x.cpp', text + text)}) != 2 * len(ids):
    failures += 1
    print('one line twice')

sys.exit(1 if failures else 0)
