#!/usr/bin/env python3
"""Writes the transcripts anew, as the program goes now: every difference is then to be looked at.

transcripts_anew.py PROGRAM
"""
import pathlib
import shlex
import subprocess
import sys


def session(line, program, folder):
    """The lines that follow a call: its output, its errors and its status."""
    arguments = shlex.split(line[len("$ hardsphere"):].replace("'", "\\'").replace("#", "\\#"))
    done = subprocess.run([program, *arguments], cwd=folder, capture_output=True, check=False)
    lines = done.stdout.decode("utf-8", "surrogateescape").split("\n")[:-1]
    lines += ["! " + text for text in done.stderr.decode("utf-8", "surrogateescape").split("\n")[:-1]]
    return lines + (["? %d" % done.returncode] if done.returncode != 0 else [])


def written_anew(text, program, folder):
    """A transcript with the same calls and remarks, and blank lines where it has them before these."""
    lines, begun, blank = [], False, False
    for line in text.split("\n")[:-1]:
        call, remark = line.startswith("$ hardsphere"), line.startswith("#")
        if (call or remark) and begun and blank:
            lines.append("")
        if call or remark:
            lines.append(line)
        if call:
            lines += session(line, program, folder)
            begun = True
        blank = line == ""
        if blank and not begun:
            lines.append("")
    return "\n".join(lines) + "\n"


here = pathlib.Path(__file__).resolve().parent
program_path = str(pathlib.Path(sys.argv[1]).resolve())
for path in sorted((here / "transcripts").glob("*.txt")):
    old = path.read_text(encoding="utf-8", errors="surrogateescape")
    path.write_text(written_anew(old, program_path, here / "inputs"), encoding="utf-8", errors="surrogateescape")
