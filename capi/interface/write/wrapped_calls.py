"""A function around each of the interface, for `ld --wrap`: tests of programs in other floating-point environments."""
from textwrap import wrap

LAST_COLUMN = 120


def wrapped_calls(interface):
    rows = ["/* Generated from include/hardsphere/: bash capi/interface/generate.sh */", "/* clang-format off */",
            "#include <hardsphere.h>", "", '#include "host_calls.h"', ""]
    for function in interface.functions:
        real = function.c.replace(function.name, f"__real_{function.name}", 1)
        wrapped = function.c.replace(function.name, f"__wrap_{function.name}", 1)
        result = function.c.split(function.name, 1)[0].strip()
        gap = "" if result.endswith("*") else " "
        arguments = ", ".join(a.name for a in function.arguments)
        rows += [*filled(f"{real};"), *filled(f"{wrapped};"), *filled(f"{wrapped} {{"), f"  {result}{gap}result;",
                 "  host_call call;", f'  host_call_begins(&call, "{function.name}");',
                 *filled(f"  result = __real_{function.name}({arguments});"), "  host_call_ends(&call);",
                 "  return result;", "}", ""]
    return "\n".join(rows[:-1]) + "\n"


def filled(line):
    indent = line[: len(line) - len(line.lstrip())]
    return wrap(line, LAST_COLUMN, initial_indent="", subsequent_indent=indent + "    ", break_long_words=False)
