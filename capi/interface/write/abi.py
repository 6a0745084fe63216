"""The record of the binary interface, in capi/abi: declarations, constants, layouts of structs, and since when."""
import re
from pathlib import Path

from read.interface import SCALARS

RECORD = Path(__file__).resolve().parents[3] / "capi" / "abi"
POINTER = (8, 4)  # bytes on targets of 64 and 32 bits
# What changes with every release by itself is no part of the record.
OF_RELEASES = re.compile(r".*_VERSION_|HSP_(ABI|NUMERICS)_NUMBER")


def opening(interface, what):
    return f"# {what} of ABI number {interface.constants['HSP_ABI_NUMBER'].value}"


def abi_functions(interface):
    declared = [f.c for f in interface.functions] + [f"typedef struct {h} {h}" for h in interface.handles]
    macros = [f"{m.name}({','.join(m.parameters)}) {m.text}" for m in interface.macros.values()]
    return "\n".join([opening(interface, "Declarations"), *sorted([*declared, *interface.callbacks.values()]),
                      *sorted(macros), ""])


def abi_constants(interface):
    rows = [f"{c.name} {c.value}" for c in interface.constants.values() if not OF_RELEASES.match(c.name)]
    return "\n".join([opening(interface, "Constants"), *sorted(rows), ""])


def of_targets(numbers):
    """A number of targets with pointers of 8 bytes and of 4."""
    return str(numbers[0]) if numbers[0] == numbers[1] else "/".join(map(str, numbers))


def abi_structs(interface):
    """Fields follow each other without padding, which abi.sh asks compilers for many targets."""
    rows, sizes = {}, {name: (size, size) for name, size in SCALARS.items()} | {"size_t": POINTER}
    for struct in interface.structs_inside_first():
        places, fields = (0, 0), []
        for field in struct.fields:
            kind, size = (f"{field.base}*", POINTER) if field.stars else (field.base, sizes[field.base])
            fields.append(f"{struct.name}.{field.name} {of_targets(places)} {kind} {field.count}")
            places = tuple(place + field.count * bytes for place, bytes in zip(places, size))
        sizes[struct.name] = places
        rows[struct.name] = [f"{struct.name} {of_targets(places)}", *fields]
    title = opening(interface, "Structs")
    title += ", for every target: size, then offset of each field, its type, and how many; a/b: of 8 and 4 bytes a pointer"
    return "\n".join([title, *(row for name in sorted(rows) for row in rows[name]), ""])


def abi_since(interface):
    return "\n".join(["# The version since which each function is declared as it is",
                      *(f"{name} {version}" for name, version in sorted(versions(interface).items())), ""])


def versions(interface):
    """The version since which each function is declared as it is. What the record does not have, or has otherwise, is
    of the version that is worked on."""
    declared = (RECORD / "functions.txt").read_text().split("\n")
    since = dict(row.split() for row in (RECORD / "since.txt").read_text().split("\n")[1:-1])
    present = interface.texts["HSP_VERSION_STRING"]
    return {f.name: since.get(f.name, present) if f.c in declared else present for f in interface.functions}
