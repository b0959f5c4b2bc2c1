#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""family_table.py puts each time into its column, and says nothing of what was not measured."""
import importlib.util
import os

place = os.path.join(os.path.dirname(os.path.abspath(__file__)), 'family_table.py')
spec = importlib.util.spec_from_file_location('family_table', place)
table = importlib.util.module_from_spec(spec)
spec.loader.exec_module(table)

rows = [('intersect', 'verdict', 'one', 10), ('intersect', 'batch', 'one', 5), ('decide', 'certificate', 'one', 20),
        ('decide', 'batch', 'one', 15), ('distance', 'distance', 'one', 100), ('distance', 'depth', 'one', 300),
        ('intersect', 'verdict', 'two', 4), ('decide', 'certificate', 'two', 32)]
document = {
    'results': [dict(method=m, query=q, family=f, median_ns=ns, p99_ns=2.0 * ns) for m, q, f, ns in rows],
    'summary': {'verdict': {'families': [
        dict(method='intersect', family='one', right=dict(ratio=17.5)),
        dict(method='decide', family='one', right=dict(ratio=3)),
        dict(method='intersect', family='two', right=None)]}}}
found = list(table.lines(document))
assert found[2] == '| one | 10.0 | 20 | 17.5 | 5.0 | 20 | 2.0 | 15 | 100 | 300 |', found[2]
assert found[3] == '| two | 4.0 | 8 | - | - | 32 | 8.0 | - | - | - |', found[3]
assert found[4] == '| geometric mean | | | 17.5 | | | 4.0 | | | |', found[4]
assert len(found) == 5 and all(line.count('|') == 11 for line in found), found
