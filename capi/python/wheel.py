#!/usr/bin/env python3
"""Makes a wheel of the module and a shared library, with nothing but Python itself and without a network.

  wheel.py SHARED-LIBRARY FOLDER    writes hardsphere-VERSION-py3-none-PLATFORM.whl into the folder

The library is what CMake builds with -DBUILD_SHARED_LIBS=ON. The wheel's bytes depend on its contents alone."""
import base64
import hashlib
import re
import sys
import sysconfig
import zipfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
SUMMARY = "Exact areas, volumes, gradients, contacts, cavities, pores and pictures of unions of balls"


def wheel(library, folder):
    version = re.search(r'HSP_VERSION_STRING "([^"]+)"', (ROOT / "include/hardsphere/version.h").read_text())[1]
    tag = f"py3-none-{re.sub('[-.]', '_', sysconfig.get_platform())}"
    info = f"hardsphere-{version}.dist-info"
    files = {f"hardsphere/{path.name}": path.read_bytes() for path in sorted((HERE / "hardsphere").glob("*.py"))}
    files["hardsphere/lammps_fix.py"] = (ROOT / "capi/clients/lammps_fix.py").read_bytes()
    files["hardsphere/py.typed"] = b""
    files["hardsphere/libhardsphere.so.2"] = Path(library).read_bytes()
    files[f"{info}/LICENSE"] = (ROOT / "LICENSE").read_bytes()
    files[f"{info}/WHEEL"] = f"Wheel-Version: 1.0\nGenerator: hardsphere\nRoot-Is-Purelib: false\nTag: {tag}\n".encode()
    files[f"{info}/METADATA"] = (f"Metadata-Version: 2.1\nName: hardsphere\nVersion: {version}\nSummary: {SUMMARY}\n"
                                 "Requires-Python: >=3.8\nProvides-Extra: numpy\n"
                                 "Requires-Dist: numpy; extra == 'numpy'\n").encode()
    rows = [f"{name},sha256={base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b'=').decode()},{len(data)}"
            for name, data in files.items()]
    files[f"{info}/RECORD"] = "\n".join([*rows, f"{info}/RECORD,,", ""]).encode()
    path = Path(folder) / f"hardsphere-{version}-{tag}.whl"
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, data in files.items():
            entry = zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0))
            entry.external_attr, entry.compress_type = 0o644 << 16, zipfile.ZIP_DEFLATED
            archive.writestr(entry, data)
    return path


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    print(wheel(*sys.argv[1:]))
