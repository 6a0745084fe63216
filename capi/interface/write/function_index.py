"""The page of the guide with all functions."""
import re

from .abi import versions

OPENING = """\
# All functions

This page lists the functions in the order in which `hardsphere.h` says to read the headers. Each header has the rest:
arguments, properties, cost and what each status means. The statuses are those besides `HSP_OK`, without `HSP_`; every
function that takes a handle may also return `HSP_E_HANDLE`. The last column is the version since which a function is
declared as it is. Stable headers stay as they are from version 1.0 on, provisional ones may change with any minor version.

Next: [the guide](README.md)
"""
GENERATED = "<!-- Generated from the headers by capi/interface/generate.sh -->"


def function_index(interface):
    rows = [OPENING, GENERATED, ""]
    since = versions(interface)
    for header, subject in interface.headers.items():
        rows += [f"## {header}", "", f"{plain(subject[:1].upper() + subject[1:])}: "
                 f"[hardsphere/{header}](../../include/hardsphere/{header}). {interface.tiers[header].capitalize()}.", ""]
        own = [function for function in interface.functions if function.header == header]
        if not own:
            continue
        rows += ["| function | what it does | statuses | since |", "|---|---|---|---|"]
        for function in own:
            statuses = ", ".join(s.removeprefix("HSP_") for s in function.statuses if s != "HSP_OK")
            rows.append(f"| `{function.name}` | {plain(function.brief)} | {statuses} | {since[function.name]} |")
        rows.append("")
    return "\n".join(rows)


def plain(text):
    """A text in which nothing is markup."""
    return re.sub(r"([*|<>`\\])", r"\\\1", text)
