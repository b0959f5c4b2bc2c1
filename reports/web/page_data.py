#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Prints the JSON that the page of a run holds. page_data.py PAGE.html"""
import base64
import json
import pathlib
import re
import sys
import zlib



def unpacked(rows):
    """The objects of a list that report_data.cpp packed as columns."""
    if isinstance(rows, list):
        return rows
    columns = [(key, column, kind == 'sparse') for kind, of in rows.items() for key, column in of.items()]
    count = len(columns[0][1]) if columns else 0
    return [{key: column[i] for key, column, sparse in columns if not (sparse and column[i] is None)}
            for i in range(count)]


page = pathlib.Path(sys.argv[1]).read_text(encoding='utf-8')
data = json.loads(zlib.decompress(base64.b64decode(re.search('id="report-data">(.*?)<', page)[1])))
data['findings'] = unpacked(data['findings'])
for drawn in data['maps']:
    drawn['cells'] = unpacked(drawn['cells'])
print(json.dumps(data, ensure_ascii=False, separators=(',', ':')))
