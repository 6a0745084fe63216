"""Makes a shared library of the archive that the build has, without compiling anything: the functions of the interface
are hidden in its objects, and visible in copies of them.
    exported.py ARCHIVE SHARED-LIBRARY C-COMPILER"""
import struct
import subprocess
import sys
import tempfile
from pathlib import Path

SYMBOL_TABLE, DEFAULT, HIDDEN = 2, 0, 2


def make_visible(path):
    """Of an ELF object of 64 bits: symbols hsp_* that are hidden get the default visibility."""
    data = bytearray(path.read_bytes())
    assert data[:6] == b"\x7fELF\x02\x01", f"{path}: no ELF object of 64 bits"
    table, = struct.unpack_from("<Q", data, 0x28)
    size, count = struct.unpack_from("<HH", data, 0x3A)
    sections = [struct.unpack_from("<IIQQQQIIQQ", data, table + k * size) for k in range(count)]
    for _, kind, _, _, offset, length, link, _, _, entry in sections:
        if kind != SYMBOL_TABLE:
            continue
        names = sections[link][4]
        for place in range(offset, offset + length, entry):
            name = names + struct.unpack_from("<I", data, place)[0]
            if data.startswith(b"hsp_", name) and data[place + 5] == HIDDEN:
                data[place + 5] = DEFAULT
    path.write_bytes(data)


def main(archive, library, compiler):
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run(["ar", "x", Path(archive).resolve()], cwd=folder, check=True)
        objects = sorted(Path(folder).iterdir())
        for path in objects:
            make_visible(path)
        subprocess.run([compiler, "-shared", "-Wl,-soname,libhardsphere.so.2", "-o", library, *objects, "-lm"], check=True)


if __name__ == "__main__":
    main(*sys.argv[1:])
