#!/usr/bin/env python3
"""Writes the transcripts anew, as the program goes now: every difference is then to be looked at.

transcripts_anew.py PROGRAM
"""
import pathlib
import shlex
import subprocess
import sys


def session(line, program, folder):
    """The lines of a call: itself, its output, its errors and its status; or one line, where it is refused and was so."""
    call, refused, _ = line.partition("  ? ")
    arguments = shlex.split(call[len("$ hardsphere"):].replace("'", "\\'").replace("#", "\\#"))
    done = subprocess.run([program, *arguments], cwd=folder, capture_output=True, check=False)
    out, err = (text.decode("utf-8", "surrogateescape").split("\n")[:-1] for text in (done.stdout, done.stderr))
    if refused and done.returncode != 0 and not out and len(err) == 1:
        return ["%s  ? %d  %s" % (call, done.returncode, err[0][len("hardsphere: "):])]
    return [call] + out + ["! " + text for text in err] + (["? %d" % done.returncode] if done.returncode != 0 else [])


def written_anew(text, program, folder):
    """A transcript with the same calls and remarks, and blank lines where it has them before these."""
    lines, begun, blank = [], False, False
    for line in text.split("\n")[:-1]:
        call, remark = line.startswith("$ hardsphere"), line.startswith("#")
        if (call or remark) and begun and blank:
            lines.append("")
        if remark:
            lines.append(line)
        if call:
            short = "  ? " in line
            line = line.split("  ? ")[0]
            outcome = session(line, program, folder)
            if short and len(outcome) == 2 and outcome[0].startswith("! hardsphere: "):
                lines.append("%s  %s  %s" % (line, outcome[1], outcome[0].removeprefix("! hardsphere: ")))
            else:
                lines += [line, *outcome]
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
