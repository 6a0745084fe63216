"""The page of the guide with all functions."""
import re

from .abi import versions

OPENING = """\
# All functions

In the order in which `hardsphere.h` says to read the headers; what each function does in full, its arguments, statuses,
properties and cost stand there. Behind each stand the statuses that it has besides `HSP_OK`, without `HSP_`, and the
version since which it is declared as it is. Stable headers stay as they are from version 1.0 on, provisional ones may
change with any minor version. Every function that takes a handle may also return `HSP_E_HANDLE`. The
[tutorial](tutorial.md) shows the most important ones at work, [other programs](coming_from.md) says what you called
before, and [splitting the work](splitting_the_work.md) which ones threads may share.
"""
GENERATED = "<!-- Generated from the headers by capi/interface/generate.sh -->"


def function_index(interface):
    rows = [OPENING, GENERATED, ""]
    since = versions(interface)
    for header, subject in interface.headers.items():
        rows += [f"## {header}", "", f"{plain(subject[:1].upper() + subject[1:])}: "
                 f"[hardsphere/{header}](../../include/hardsphere/{header}). {interface.tiers[header].capitalize()}.", "",
                 "| function | what it does | statuses | since |", "|---|---|---|---|"]
        for function in interface.functions:
            if function.header == header:
                statuses = ", ".join(s.removeprefix("HSP_") for s in function.statuses if s != "HSP_OK")
                rows.append(f"| `{function.name}` | {plain(function.brief)} | {statuses} | {since[function.name]} |")
        rows.append("")
    return "\n".join(rows)


def plain(text):
    """A text in which nothing is markup."""
    return re.sub(r"([*|<>`\\])", r"\\\1", text)
