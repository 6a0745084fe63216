"""The functions as a table in C, for tests/laws and fuzz: what each argument is, which statuses there are, a call."""
from textwrap import wrap

LAST_COLUMN = 120


def registry(interface):
    rows = ["/* Generated from include/hardsphere/: bash capi/interface/generate.sh */", "/* clang-format off */",
            '#include "registry.h"', ""]
    for function in interface.functions:  # each has its own rows, which no other function changes
        rows += [*arguments(interface, function), *call(interface, function), ""]
    rows.append("const function registry[] = {")
    rows += [entry(interface, function) for function in interface.functions]
    rows += ["};", "const size_t registry_size = sizeof registry / sizeof registry[0];", ""]
    rows.append("const field registry_fields[] = {")
    rows += ["\n".join(filled(f'{{"{s.name}", "{f.name}", "{f.base}{star(f)}", offsetof({s.name}, {f.name}), {f.count}}},'))
             for s in interface.structs.values() for f in s.fields]
    rows += ["};", "const size_t registry_fields_size = sizeof registry_fields / sizeof registry_fields[0];", ""]
    return "\n".join(rows)


def star(field):
    return " *" if field.stars else ""


def arguments(interface, function):
    if not function.arguments:
        return []
    return [f"static const argument of_{function.name}[] = {{",
            *(argument(interface, a, *holder) for a, *holder in with_fields(function)), "};"]


def with_fields(function):
    """The arguments, each behind it followed by its fields; with a field, the place and the type of what holds it."""
    rows = []
    for a in function.arguments:
        place = len(rows)
        rows += [(a, 0, ""), *((part, place, a.base) for part in a.fields)]
    return rows


def argument(interface, a, place, holder):
    sized = a.base not in ("void", "char") and a.base not in interface.handles and a.base not in interface.callbacks
    parts = [f'"{a.name}"', f'"{a.base}"', f".kind = KIND_{a.kind}"]
    if sized:
        parts.append(f".size = sizeof({a.base})")
    if a.extents:
        parts.append(f'.extent = "{a.extents[0]}"')
    if a.extents[1:]:
        parts.append(f".row = {' * '.join(a.extents[1:])}")
    if a.base in interface.handles:
        parts.append(f".noun = NOUN_{a.base.removeprefix('hsp_')}")
    if a.null != "never":
        parts.append(f".null = NULL_{a.null}")
    if place:
        parts += [f".of = {place}", f".offset = offsetof({holder}, {a.name})"]
    parts += [f".{flag} = 1" for flag, holds in (("is_const", a.const), ("held", a.held)) if holds]
    return "\n".join(filled(f"{{{', '.join(parts)}}},"))


def call(interface, function):
    values = ", ".join(f"v[{i}].{member(interface, a)}" for i, (a, of, _) in enumerate(with_fields(function)) if not of)
    cast = "(int64_t)(intptr_t)" if function.result.endswith("*") else "(int64_t)"
    body = filled(f"return {cast}{function.name}({values});")
    return [f"static int64_t call_{function.name}(const value *v) {{", *([] if values else ["  (void)v;"]), *body, "}"]


def member(interface, a):
    if a.base in interface.callbacks:
        return "f"
    if a.stars:
        return "p"
    return {"double": "d", "size_t": "z", "int32_t": "i"}.get(a.base, "u")


def entry(interface, function):
    handles = any(a.kind == "handle" for a in function.arguments)
    result = {"int32_t": "status", "uint32_t": "id" if handles else "number"}.get(function.result, "text")
    statuses = list(function.statuses)
    if result == "status":
        statuses = ["HSP_OK", *(["HSP_E_HANDLE"] if handles else []), *(s for s in statuses if s != "HSP_OK")]
    table = f"of_{function.name}" if function.arguments else "NULL"
    bits = " | ".join(f"BIT({status})" for status in statuses) or "0"
    row = f'"{function.name}", "{function.noun}", RESULT_{result}, {len(with_fields(function))}, {table}'
    return "\n".join(filled(f"{{{row}, call_{function.name}, {bits}}},"))


def filled(text):
    return wrap(text, LAST_COLUMN, initial_indent="  ", subsequent_indent="      ", break_long_words=False,
                break_on_hyphens=False)
