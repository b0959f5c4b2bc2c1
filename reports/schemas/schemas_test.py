#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks the JSON that the program of the first argument writes with the schemas of this folder. Each schema also has
to refuse changes: a field more, a field less, an unknown word."""
import copy
import functools
import json
import operator
import pathlib
import shutil
import subprocess
import sys
import tempfile

try:
    import jsonschema
except ImportError:
    root = pathlib.Path(__file__).resolve().parents[2]
    sys.exit(subprocess.run([root / '.ci/skip', 'no jsonschema here: apt-get install python3-jsonschema']).returncode)

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
PROGRAM = pathlib.Path(sys.argv[1]).resolve()
BOX = {'shape': 'box', 'center': [0, 0, 0], 'edges': [1, 2, 0], 'quaternion': [2, 0, 0, 1], 'rounding': 0.5}
PAIR = ('{"a":{"center":[0,0,0],"axis":[0,0,1],"radius":1,"height":2},'
        '"b":{"center":[%s,0,0],"axis":[0,1,0],"radius":1,"height":2}}')


def run(*arguments, given='', codes=(0, 2, 3)):
    done = subprocess.run([PROGRAM, *map(str, arguments)], input=given, capture_output=True, encoding='utf-8')
    if done.returncode not in codes:
        sys.exit(f'{arguments}: exit code {done.returncode}\n{done.stdout[-2000:]}{done.stderr[-2000:]}')
    return done.stdout


def changed(document):
    """The document with one thing wrong, in three ways; of a list its first object is changed."""
    target = document[0] if isinstance(document, list) else document
    for change in ('more', 'less', 'kind'):
        copied = copy.deepcopy(document)
        it = copied[0] if isinstance(copied, list) else copied
        first = next(iter(target))
        if change == 'more':
            it['nobody knows this'] = 1
        elif change == 'less':
            del it[first]
        else:
            it[first] = {'nobody': 'knows'} if not isinstance(it[first], dict) else 7
        yield change, copied


def planted(document, path, value):
    """The document with another value at `path`, or without it if there is no value."""
    document = copy.deepcopy(document)
    *above, last = (int(part) if part.isdigit() else part for part in path.split('/'))
    place = functools.reduce(operator.getitem, above, document)
    if value is None:
        del place[last]
    else:
        place[last] = value
    return document


def hold(name, documents, refused=('more', 'less', 'kind'), faults=()):
    schema = json.loads((HERE / name).read_text())
    jsonschema.Draft7Validator.check_schema(schema)
    validator = jsonschema.Draft7Validator(schema, resolver=jsonschema.RefResolver(f'{HERE.as_uri()}/{name}', schema))
    documents = list(documents)
    if not documents:
        sys.exit(f'{name}: nothing was written')
    for document in documents:
        for error in validator.iter_errors(document):
            sys.exit(f'{name}: {"/".join(map(str, error.absolute_path))}: {error.message[:400]}')
    for change, wrong in changed(documents[0]):
        if change in refused and validator.is_valid(wrong):
            sys.exit(f'{name} takes what has a field {change}')
    for path, value in faults:
        if validator.is_valid(planted(documents[0], path, value)):
            sys.exit(f'{name} takes {value} at {path}')


def lines(text):
    return [json.loads(line) for line in text.splitlines() if line.strip()]


def main():
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        methods = 'intersect,decide,distance,fcl-libccd,ode,seedbook-printed,bullet-gjkepa2'
        asked = '\n'.join(PAIR % x for x in ('2.5', '1', '2', '1e-300', '1e300', '"no"')) + '\n{"a":1}\n'
        cases = [line for file in sorted((ROOT / 'corpus/cases').glob('*.jsonl')) for line in lines(file.read_text())]
        hold('case.json', cases, ('more', 'kind'))
        boxes = [{'a': BOX, 'b': {key: BOX[key] for key in ('shape', 'center', 'edges')}}]
        hold('case.json', boxes + [{'a': BOX, 'b': {'shape': 'half_space', 'point': [0, 0, -1], 'normal': [0, 0, 2]}}])
        pairs = '\n'.join(json.dumps({'a': case['a'], 'b': case['b']}) for case in cases)
        said = [run('check', '--distance', given=asked, codes=(65,)), run('check', '--distance', given=pairs)]
        said += [run('check', '--method', name, given=pairs, codes=(0, 2, 3, 65)) for name in methods.split(',')]
        hold('answer.json', [answer for text in said for answer in lines(text)], ('more', 'kind'))
        hold('answer.json', [v['answer'] for v in lines(run('vectors', '--count', 200, '--seed', 2))], ('more', 'kind'))
        for night in ('one', 'two'):
            run('campaign', '--pairs', 400, '--seed', ord(night[0]), '--methods', methods, '--cases', '',
                '--out', folder / 'runs' / night)
            run('triage', folder / 'runs' / night, '--for', '3s', '--json', folder / f'{night}.json')
        given = [{'id': json.loads(line)['id'], **said} for line, said in zip(
            run('ask', '--pairs', 4, '--seed', 1).splitlines(),
            ({'verdict': 'disjoint', 'distance': 0.25, 'direction': [0, 0, 1]}, {'declined': 'no disks'},
             {'verdict': 'intersecting', 'point': [0, [1, 1e-17], 2]}, {'error': 'no convergence'}))]
        (folder / 'said.jsonl').write_text(''.join(json.dumps(line) + '\n' for line in given))
        (folder / 'asked.jsonl').write_text(run('ask', '--pairs', 4, '--seed', 1))
        if 'unreadable' in run('judge', folder / 'said.jsonl', '--pairs', folder / 'asked.jsonl', '--name', 'mine'):
            sys.exit('judge does not read what guest_answer.json describes')
        hold('guest_answer.json', [given[1], *given], ('kind',))
        hold('causes.json', [json.loads((folder / f'{night}.json').read_text()) for night in ('one', 'two')])
        hold('report_data.json', [json.loads(subprocess.check_output(
            [ROOT / 'reports/web/page_data.py', folder / 'runs' / night / 'report.html'])) for night in ('one', 'two')])
        if shutil.which('node'):  # what the tests of the page make up has the form that the program writes
            write = 'import("./reports/web/run/sample.mjs").then((m) => console.log(JSON.stringify(m.sample(60))))'
            made_up = subprocess.run(['node', '-e', write], cwd=ROOT, check=True, capture_output=True).stdout
            hold('report_data.json', [json.loads(made_up)])
        (folder / 'alone.jsonl').write_text('{"name":"alone","center":[0,0,0],"axis":[0,0,1],"radius":1,"height":2}\n')
        scenes, examples = [], ROOT / 'corpus/scenes'
        for asked in ([examples / 'crane.urdf'], [examples / 'hand.xml'], [folder / 'alone.jsonl'],
                      [examples / 'crane.urdf', '--prove']):
            run('scene', *asked, '--configurations', 20, '--json', folder / 'scene.json')
            scenes.append(json.loads((folder / 'scene.json').read_text()))
        hold('scene.json', scenes, faults=(
            ('bodies/1/solid/axis', None), ('bodies/1/solid/radius', -1), ('bodies/0/solid/edges', [1, 2]),
            ('pairs/0/needs', 'inner capsule'), ('pairs/0/models/5', None), ('bodies/0/solid', None),
            ('pairs/0/known', None), ('colour', 'red')))
        if len(scenes[3]['motions']) != len(scenes[3]['pairs']) or len(scenes[3]['exemptions']) != 1:
            sys.exit('scene --prove does not list each pair and each exemption')
    print('passed')


main()
