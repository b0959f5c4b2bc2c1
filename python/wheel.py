# SPDX-License-Identifier: MIT
"""Makes a wheel:   wheel.py MODULE.so VERSION FOLDER"""
import base64
import hashlib
import pathlib
import sys
import sysconfig
import zipfile

library, version, folder = pathlib.Path(sys.argv[1]), sys.argv[2], pathlib.Path(sys.argv[3])
python = f'cp{sys.version_info.major}{sys.version_info.minor}'
tag = f'{python}-{python}-{sysconfig.get_platform().replace("-", "_").replace(".", "_")}'
info = f'daylight-{version}.dist-info'
files = {
    library.name: library.read_bytes(),
    'daylight-stubs/__init__.pyi': pathlib.Path(__file__).with_name('daylight.pyi').read_bytes(),
    f'{info}/METADATA': f'Metadata-Version: 2.1\nName: daylight\nVersion: {version}\nRequires-Dist: numpy\n'.encode(),
    f'{info}/WHEEL': f'Wheel-Version: 1.0\nGenerator: daylight\nRoot-Is-Purelib: false\nTag: {tag}\n'.encode(),
}
record = ''.join(f'{name},sha256={base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()},{len(data)}\n'
                 for name, data in files.items())
wheel = folder / f'daylight-{version}-{tag}.whl'
with zipfile.ZipFile(wheel, 'w', zipfile.ZIP_DEFLATED) as archive:
    for name, data in {**files, f'{info}/RECORD': f'{record}{info}/RECORD,,\n'.encode()}.items():
        archive.writestr(name, data)
print(wheel)
