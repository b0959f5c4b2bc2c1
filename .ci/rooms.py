# SPDX-License-Identifier: MIT
"""The rooms of CMakeLists.txt as the table and the picture of docs/architecture.md."""
import re

PAGE, PICTURE = 'docs/architecture.md', 'docs/pictures/rooms.svg'
MARKS = '<!-- rooms -->\n', '<!-- /rooms -->'
# A colour for the rooms of each top folder, by first appearance.
COLOURS = ['#dbeafe', '#e5e7eb', '#dcfce7', '#fef3c7', '#fee2e2', '#ede9fe', '#cffafe', '#fce7f3', '#ecfccb', '#ffedd5']
BOX, BEND, GAP, FLOOR = 150, 14, 26, 84  # px: width of a box and of an arrow that passes, space beside, floor to floor
HEIGHT = 34  # px of a box


def read(path):
    with open(path, encoding='utf-8') as file:
        return file.read()


def rooms_of(text):
    """The rooms in the order of CMakeLists.txt, as {room: (rooms it uses, folders that are part of it)}."""
    rooms = {}
    for call in re.findall(r'^daylight_room\(([^)]*)\)', text, re.MULTILINE):
        words, key, lists = call.split(), None, {'USES': [], 'WITH': []}
        for word in words[1:]:
            if re.fullmatch(r'[A-Z]+', word):
                key = word
            elif key in lists:
                lists[key].append(word)
        rooms[words[0]] = (lists['USES'], lists['WITH'])
    return rooms


def table_of(rooms, lines):
    """A row for each room: its lines of sources and of tests, and the rooms that it may include. `lines` is
    {room: [sources, tests]}."""
    rows = ['| room | lines | of tests | may include |', '|---|---:|---:|---|']
    for room, (uses, _) in rooms.items():
        rows.append(f'| {room} | {lines[room][0]:,} | {lines[room][1]:,} | {", ".join(uses) or "nothing of ours"} |')
    total = [sum(column) for column in zip(*lines.values())]
    return '\n'.join(rows + [f'| all | {total[0]:,} | {total[1]:,} | |', ''])


def arrows_of(rooms):
    """The rooms that each room uses, without those that it also reaches through another, as {room: [room]}."""
    reach = {}
    for room, (uses, _) in rooms.items():
        reach[room] = set(uses).union(*(reach[other] for other in uses))
    return {room: [u for u in uses if not any(u in reach[v] for v in uses)] for room, (uses, _) in rooms.items()}


def floors_of(arrows):
    """Boxes and the bends of long arrows, floor by floor, and the hops between neighbouring floors."""
    floor = {}
    for room, below in arrows.items():
        floor[room] = 1 + max((floor[other] for other in below), default=-1)
    for room in reversed(arrows):  # as high as its users let it, where that makes no arrow longer
        users = [other for other in arrows if room in arrows[other]]
        if len(users) >= max(1, len(arrows[room])):
            floor[room] = min(floor[user] for user in users) - 1
    floors = [[room for room in arrows if floor[room] == i] for i in range(max(floor.values()) + 1)]
    hops = []
    for room, below in arrows.items():
        for other in below:
            last = room
            for i in range(floor[room] - 1, floor[other], -1):
                floors[i].append((room, other, i))
                hops.append((last, floors[i][-1]))
                last = floors[i][-1]
            hops.append((last, other))
    return floors, hops


def place(floors, hops):
    """x of the middle of everything: what is joined stands above one another as far as there is room."""
    near = {node: [] for row in floors for node in row}
    for upper, lower in hops:
        near[upper].append(lower)
        near[lower].append(upper)
    x = {node: 100.0 * i for row in floors for i, node in enumerate(row)}
    for step in range(60):
        for row in floors if step % 2 == 0 else reversed(floors):
            wish = {node: sum(x[n] for n in near[node]) / len(near[node]) if near[node] else x[node] for node in row}
            row.sort(key=lambda node: (wish[node], str(node)))
            at = 0.0
            for before, node in zip([None] + row, row):
                if before is not None:
                    at += (width(before) + width(node)) / 2 + GAP
                x[node] = at
            shift = sum(wish[node] - x[node] for node in row) / len(row)
            for node in row:
                x[node] += shift
    return x


def width(node):
    return BOX if isinstance(node, str) else BEND


def picture_of(rooms):
    """The rooms as boxes, floor by floor, as SVG."""
    floors, hops = floors_of(arrows_of(rooms))
    x = place(floors, hops)
    left = min(x[n] - width(n) / 2 for n in x) - GAP
    right = max(x[n] + width(n) / 2 for n in x) + GAP
    y = {node: (len(floors) - 1 - i) * FLOOR + GAP for i, row in enumerate(floors) for node in row}
    size = f'{right - left:.0f} {max(y.values()) + HEIGHT + GAP}'
    tops = list(dict.fromkeys(room.split('/')[0] for room in rooms))
    lines = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {size}" font-family="sans-serif" font-size="14">',
             '<title>Who includes whom: each room stands above what it uses</title>',
             '<defs><marker id="head" viewBox="0 0 8 8" refX="8" refY="4" markerWidth="7" markerHeight="7" orient="auto">'
             '<path d="M0,0L8,4L0,8z" fill="#64748b"/></marker></defs>', '<rect width="100%" height="100%" fill="#fff"/>']
    for upper, lower in hops:
        a, b = x[upper] - left, x[lower] - left
        top = y[upper] + (HEIGHT if isinstance(upper, str) else HEIGHT / 2)
        end = y[lower] + (0 if isinstance(lower, str) else HEIGHT / 2)
        head = ' marker-end="url(#head)"' if isinstance(lower, str) else ''
        middle = (top + end) / 2
        lines.append(f'<path d="M{a:.0f},{top:.0f}C{a:.0f},{middle:.0f} {b:.0f},{middle:.0f} {b:.0f},{end:.0f}" '
                     f'fill="none" stroke="#64748b"{head}/>')
    for room in rooms:
        colour = COLOURS[tops.index(room.split('/')[0]) % len(COLOURS)]
        lines.append(f'<rect x="{x[room] - left - BOX / 2:.0f}" y="{y[room]}" width="{BOX}" height="{HEIGHT}" rx="6" '
                     f'fill="{colour}" stroke="#475569"/>')
        lines.append(f'<text x="{x[room] - left:.0f}" y="{y[room] + 22}" text-anchor="middle">{room}</text>')
    return '\n'.join(lines + ['</svg>', ''])


def page_with(table):
    before, _, rest = read(PAGE).partition(MARKS[0])
    return before + MARKS[0] + table + MARKS[1] + rest.partition(MARKS[1])[2]


def write(rooms, lines):
    for path, text in ((PICTURE, picture_of(rooms)), (PAGE, page_with(table_of(rooms, lines)))):
        with open(path, 'w', encoding='utf-8') as file:
            file.write(text)


def violations(rooms, lines):
    """Yields (path, line, what) of each part of the page or the picture that is not today's. Lines may drift."""
    page, again = read(PAGE), '.ci/includes --draw writes it anew'
    numbers = re.compile(r' [\d,]+ (?=\|)')
    if numbers.sub('', page) != numbers.sub('', page_with(table_of(rooms, lines))):
        yield PAGE, 1, f'the table of rooms is not that of CMakeLists.txt; {again}'
    if read(PICTURE) != picture_of(rooms):
        yield PICTURE, 1, f'the picture is not that of CMakeLists.txt; {again}'
    for room, (sources, tests) in lines.items():
        if 4 * (sources + tests) > sum(map(sum, lines.values())):
            yield 'CMakeLists.txt', 1, f'{room}/ holds more than a quarter of all lines'
    for room in rooms:
        if not re.search(rf'^\| `{room}/` \| ', page, re.MULTILINE):
            yield PAGE, 1, f'{room}/ is for what? There is no row for it'
