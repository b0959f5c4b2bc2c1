import json, math, sys
print(json.dumps({'name': 'spheres', 'takes': ['sphere'], 'claim': {'relative': 1e-12}}), flush=True)
for line in sys.stdin:
    a, b = (json.loads(line)[k] for k in 'ab')
    apart = math.dist(a['center'], b['center']) > a['rounding'] + b['rounding']
    print(json.dumps({'verdict': 'disjoint' if apart else 'intersecting'}), flush=True)
