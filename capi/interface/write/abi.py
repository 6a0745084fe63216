"""The record of the binary interface, in capi/abi: declarations, constants, layouts of structs, and since when."""
import re
from pathlib import Path

from read.interface import SCALARS

RECORD = Path(__file__).resolve().parents[3] / "capi" / "abi"
POINTER = (8, 4)  # bytes on targets of 64 and 32 bits
# Numbers that change with every release by themselves are no part of the record.
OF_RELEASES = re.compile(r".*_VERSION_|HSP_(ABI|PROVISIONAL|NUMERICS|PROVISIONAL_NUMERICS)_NUMBER")


NUMBERS = {"stable": ("HSP_ABI_NUMBER", "ABI number"), "provisional": ("HSP_PROVISIONAL_NUMBER", "provisional number")}


def by_tier(interface, what, rows_of, more=""):
    """The rows of each tier behind a title; rows_of(header) has them by header."""
    text = []
    for tier, (constant, words) in NUMBERS.items():
        number = interface.constants[constant].value
        text.append(f"# {what} of {words} {number}{more}")
        text += [row for rows in rows_of(tier) for row in rows]
    return "\n".join([*text, ""])


def sorted_rows(interface, tier, items):
    """The rows of those of some pairs of header and row that are of a tier."""
    return sorted(row for header, row in items if interface.tiers[header] == tier)


def abi_functions(interface):
    declared = [(f.header, f.c) for f in interface.functions]
    declared += [(header, f"typedef struct {handle} {handle}") for handle, header in interface.handles.items()]
    declared += [(interface.homes[name], callback) for name, callback in interface.callbacks.items()]
    macros = [(m.header, f"{m.name}({','.join(m.parameters)}) {m.text}") for m in interface.macros.values()]
    return by_tier(interface, "Declarations",
                   lambda tier: [sorted_rows(interface, tier, declared), sorted_rows(interface, tier, macros)])


def abi_constants(interface):
    rows = [(c.header, f"{c.name} {c.value}") for c in interface.constants.values() if not OF_RELEASES.match(c.name)]
    return by_tier(interface, "Constants", lambda tier: [sorted_rows(interface, tier, rows)])


def of_targets(numbers):
    """A number of targets with pointers of 8 bytes and of 4."""
    return str(numbers[0]) if numbers[0] == numbers[1] else "/".join(map(str, numbers))


def struct_sizes(interface):
    """Bytes of each struct, with pointers of 8 bytes and of 4."""
    rows = (row.split() for row in abi_structs(interface).split("\n") if not row.startswith("#"))
    return {row[0]: tuple(map(int, (row[1].split("/") * 2)[:2])) for row in rows if len(row) == 2}


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
    more = ": size, then offset of each field, its type, and how many; a/b: of 8 and 4 bytes a pointer"
    return by_tier(interface, "Structs", lambda tier: [rows[name] for name in sorted(rows)
                                                       if interface.tiers[interface.structs[name].header] == tier], more)


def padded_structs(interface):
    """Structs with padding between or behind fields, on targets with pointers of 8 bytes or of 4 where each scalar lies
    at multiples of its size."""
    sizes = {name: (size, size) for name, size in SCALARS.items()} | {"size_t": POINTER}
    aligned, padded = dict(sizes), []
    for struct in interface.structs_inside_first():
        places, most = (0, 0), (1, 1)
        for field in struct.fields:
            size, step = (POINTER, POINTER) if field.stars else (sizes[field.base], aligned[field.base])
            if any(place % to for place, to in zip(places, step)):
                padded.append(f"{struct.name}: padding before {field.name}")
            places = tuple(place + field.count * bytes for place, bytes in zip(places, size))
            most = tuple(map(max, most, step))
        if any(place % to for place, to in zip(places, most)):
            padded.append(f"{struct.name}: padding at its end")
        sizes[struct.name], aligned[struct.name] = places, most
    return padded


def abi_since(interface):
    since = versions(interface)
    return "\n".join(["# The version since which each function is declared as it is, and its tier",
                      *sorted(f"{f.name} {since[f.name]} {interface.tiers[f.header]}" for f in interface.functions), ""])


def versions(interface):
    """The version since which each function is declared as it is. What the record does not have, or has otherwise, is
    of the version that is worked on."""
    declared = (RECORD / "functions.txt").read_text().split("\n")
    since = dict(row.split()[:2] for row in (RECORD / "since.txt").read_text().split("\n")[1:-1])
    present = interface.texts["HSP_VERSION_STRING"]
    return {f.name: since.get(f.name, present) if f.c in declared else present for f in interface.functions}
