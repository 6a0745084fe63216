"""The program hardsphere, which a wheel brings along: `python -m hardsphere.program measure x.pdb`, or `hardsphere` alone.

It is $HARDSPHERE_PROGRAM, else one beside this file, else the one in PATH."""
from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from typing import Any

_HERE = os.path.dirname(os.path.abspath(__file__))


def path() -> str:
    """Where the program is."""
    beside = os.path.join(_HERE, "hardsphere")
    found = os.environ.get("HARDSPHERE_PROGRAM") or (beside if os.path.isfile(beside) else shutil.which("hardsphere"))
    if not found:
        raise FileNotFoundError("there is no program hardsphere: set HARDSPHERE_PROGRAM to it, or put it into PATH")
    return found


def _environment() -> dict[str, str]:
    """For a program that is linked to the shared library beside it."""
    before = os.environ.get("LD_LIBRARY_PATH")
    return {**os.environ, "LD_LIBRARY_PATH": f"{_HERE}:{before}" if before else _HERE}


def said(command: str, file: str, *options: str, **named: Any) -> Any:
    """What the program says in JSON. named: options with values, or True for those without: radii="protor",
    no_water=True. ValueError: it refuses the file or an option."""
    words = list(options)
    for name, value in named.items():
        if value is not None and value is not False:
            words += [f"--{name.replace('_', '-')}", *([] if value is True else [str(value)])]
    run = subprocess.run([path(), command, "--json", *words, "--", os.fspath(file)], capture_output=True, text=True,
                         encoding="utf-8", errors="replace", env=_environment(), check=False)
    if run.returncode != 0:
        raise ValueError(run.stderr.strip() or f"the program ended with status {run.returncode}")
    return json.loads(run.stdout)


def main() -> None:
    """Becomes the program."""
    os.execve(path(), ["hardsphere", *sys.argv[1:]], _environment())


if __name__ == "__main__":
    main()
