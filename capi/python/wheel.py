#!/usr/bin/env python3
"""Makes a wheel of the module, a shared library and the program, with nothing but Python itself and without a network.

  wheel.py [--lzma] SHARED-LIBRARY FOLDER [PROGRAM]    writes hardsphere-VERSION-py3-none-PLATFORM.whl into the folder

--lzma packs it a sixth smaller, for pip, which unpacks all that Python does; other installers may know deflate alone.
The library is what CMake builds with -DBUILD_SHARED_LIBS=ON, the program what it builds beside. On Linux the platform is
manylinux with the least version of glibc that their symbols ask for. The wheel's bytes depend on its contents alone."""
import base64
import hashlib
import re
import struct
import sys
import sysconfig
import zipfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
SUMMARY = "Exact areas, volumes, gradients, contacts, cavities, pores and pictures of unions of balls"


def versions_of_glibc(path):
    """Versions of glibc's symbols that an ELF file of 64 bits asks for, by its section .gnu.version_r."""
    data = Path(path).read_bytes()
    if data[:6] != b"\x7fELF\x02\x01":
        return set()
    table, = struct.unpack_from("<Q", data, 0x28)
    size, count = struct.unpack_from("<HH", data, 0x3A)
    sections = [struct.unpack_from("<IIQQQQIIQQ", data, table + k * size) for k in range(count)]
    found = set()
    for _, kind, _, _, at, _, link, files, _, _ in sections:
        if kind != 0x6FFFFFFE:
            continue
        names = sections[link][4]
        for _ in range(files):
            _, versions, _, first, following = struct.unpack_from("<HHIII", data, at)
            needed = at + first
            for _ in range(versions):
                _, _, _, name, after = struct.unpack_from("<IHHII", data, needed)
                end = data.index(b"\0", names + name)
                version = re.fullmatch(r"GLIBC_(\d+)\.(\d+)(?:\.\d+)?", data[names + name:end].decode())
                found |= {(int(version[1]), int(version[2]))} if version else set()
                needed += after
            at += following
    return found


def platform_of(paths):
    machine = re.sub("[-.]", "_", sysconfig.get_platform())
    versions = set().union(*map(versions_of_glibc, paths))
    if not machine.startswith("linux_") or not versions:
        return machine
    return "manylinux_{}_{}_{}".format(*max({(2, 5), *versions}), machine[len("linux_"):])  # no older one has a tag


def wheel(packing, library, folder, *program):
    version = re.search(r'HSP_VERSION_STRING "([^"]+)"', (ROOT / "include/hardsphere/version.h").read_text())[1]
    tag = f"py3-none-{platform_of([library, *program])}"
    info = f"hardsphere-{version}.dist-info"
    files = {f"hardsphere/{path.name}": path.read_bytes() for path in sorted((HERE / "hardsphere").glob("*.py*")) if path.is_file()}
    files["hardsphere/lammps_fix.py"] = (ROOT / "capi/clients/lammps_fix.py").read_bytes()
    files["hardsphere/libhardsphere.so.2"] = Path(library).read_bytes()
    for path in program:
        files["hardsphere/hardsphere"] = Path(path).read_bytes()
        files[f"{info}/entry_points.txt"] = b"[console_scripts]\nhardsphere = hardsphere.program:main\n"
    files[f"{info}/LICENSE"] = (ROOT / "LICENSE").read_bytes()
    files[f"{info}/WHEEL"] = f"Wheel-Version: 1.0\nGenerator: hardsphere\nRoot-Is-Purelib: false\nTag: {tag}\n".encode()
    files[f"{info}/METADATA"] = (f"Metadata-Version: 2.1\nName: hardsphere\nVersion: {version}\nSummary: {SUMMARY}\n"
                                 "Requires-Python: >=3.8\nProvides-Extra: numpy\n"
                                 "Requires-Dist: numpy; extra == 'numpy'\n").encode()
    rows = [f"{name},sha256={base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b'=').decode()},{len(data)}"
            for name, data in files.items()]
    files[f"{info}/RECORD"] = "\n".join([*rows, f"{info}/RECORD,,", ""]).encode()
    path = Path(folder) / f"hardsphere-{version}-{tag}.whl"
    with zipfile.ZipFile(path, "w", packing, compresslevel=9) as archive:
        for name, data in files.items():
            entry = zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0))
            mode = 0o100755 if name == "hardsphere/hardsphere" else 0o100644  # pip asks for the kind of file, too
            entry.external_attr, entry.compress_type = mode << 16, packing
            archive.writestr(entry, data, compresslevel=9)
    return path


if __name__ == "__main__":
    words = [word for word in sys.argv[1:] if word != "--lzma"]
    if len(words) not in (2, 3):
        sys.exit(__doc__)
    print(wheel(zipfile.ZIP_LZMA if "--lzma" in sys.argv else zipfile.ZIP_DEFLATED, *words))
