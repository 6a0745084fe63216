#!/usr/bin/python3
"""Writes what is generated from the headers, or compares it.

  generate.py           writes
  generate.py --check   compares; fails if a file is not what would be written
  generate.py --of-parts FOLDER PART...
                        writes Fortran modules and table of functions of a library that has these parts alone
                        (lib/components.cmake)

Both fail on any open question: on what the comments leave open. Exit status 77: there is no python3-pycparser."""
import difflib
import sys
from pathlib import Path

sys.dont_write_bytecode = True
try:
    from read import read_interface
except ModuleNotFoundError as missing:
    if missing.name != "pycparser":
        raise
    print("skipped: there is no python3-pycparser here")
    sys.exit(77)

from read.components import restricted
from write.abi import abi_constants, abi_functions, abi_since, abi_structs, padded_structs
from write.cdef import cdef
from write.exactness import exactness_page
from write.foreign import julia_declarations, rust_declarations
from write.fortran import fortran_module
from write.function_index import function_index
from write.model_text import model_text
from write.python import python_module
from write.registry import registry
from write.workspace import workspace_header
from write.workspace_fortran import workspace_module
from write.wrapped_calls import wrapped_calls

ROOT = Path(__file__).resolve().parents[2]

# The files of the project, and what writes each of an interface.
GENERATED = {
    "capi/interface/model.txt": model_text,
    "include/hardsphere_workspace.h": workspace_header,
    "capi/fortran/hardsphere.f90": fortran_module,
    "capi/fortran/hardsphere_workspace.f90": workspace_module,
    "capi/abi/since.txt": abi_since,  # before functions.txt, which says what is new
    "capi/abi/functions.txt": abi_functions,
    "capi/abi/constants.txt": abi_constants,
    "capi/abi/structs.txt": abi_structs,
    "capi/guide/all_functions.md": function_index,
    "capi/guide/exactness.md": exactness_page,
    "capi/interface/hardsphere.cdef": cdef,
    "capi/python/hardsphere/_interface.py": python_module,
    "capi/bindings/hardsphere.rs": rust_declarations,
    "capi/bindings/hardsphere.jl": julia_declarations,
    "tests/laws/support/registry.c": registry,
    "tests/support/host/wrapped_calls.c": wrapped_calls,
}


# Files of their own for builds that leave out components.
OF_PARTS = ("capi/fortran/hardsphere.f90", "capi/fortran/hardsphere_workspace.f90", "tests/laws/support/registry.c")


def write_of_parts(interface, folder, parts):
    Path(folder).mkdir(parents=True, exist_ok=True)
    for name in OF_PARTS:
        (Path(folder) / Path(name).name).write_text(GENERATED[name](restricted(interface, parts)))
    return 0


def main(options):
    interface = read_interface(ROOT / "include")
    if options[:1] == ["--of-parts"]:
        return write_of_parts(interface, options[1], options[2:])
    questions = interface.open_questions() + padded_structs(interface)
    for question in questions:
        print(f"open: {question}")
    if questions:
        print("the comment has to say it: capi/interface/README.md")
        return 1
    failed = 0
    for name, write in GENERATED.items():
        path, text = ROOT / name, write(interface)
        if options != ["--check"]:
            path.write_text(text)
            continue
        present = path.read_text() if path.exists() else ""
        if present != text:
            failed = 1
            sys.stdout.writelines(list(difflib.unified_diff(present.splitlines(True), text.splitlines(True), name,
                                                            "generated"))[:40])
    if failed:
        print("bash capi/interface/generate.sh writes these files")
    else:
        print(f"{len(interface.functions)} functions, {len(GENERATED)} files")
    return failed


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
