#!/usr/bin/python3
"""Writes what is generated from the headers, or compares it.

  generate.py           writes
  generate.py --check   compares; fails if a file is not what would be written

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

from write.model_text import model_text
from write.registry import registry

ROOT = Path(__file__).resolve().parents[2]

# The files of the project, and what writes each of an interface.
GENERATED = {
    "capi/interface/model.txt": model_text,
    "tests/laws/support/registry.c": registry,
}


def main(options):
    interface = read_interface(ROOT / "include")
    questions = interface.open_questions()
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
