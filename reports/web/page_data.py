#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Prints the JSON that the page of a run holds. page_data.py PAGE.html"""
import base64
import pathlib
import re
import sys
import zlib

page = pathlib.Path(sys.argv[1]).read_text(encoding='utf-8')
print(zlib.decompress(base64.b64decode(re.search('id="report-data">(.*?)<', page)[1])).decode())
