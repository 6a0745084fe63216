#!/usr/bin/env python3
"""Small mistakes in the core, drawn at random and compiled in at once, each behind a number (mutant.hpp), for tests to notice.

    drawn.py TREE FOLDER COUNT

A mistake is another operator, comparison or constant, or a statement left out. Statements, and one mistake for each, are drawn by
hashes of the version and the statement's text, so that a change of code elsewhere does not change the draw. Mistakes that the
compiler refuses are left out. A first run finds which mistakes each test reaches. A mistake is tried with the tests that reach
it, the quickest first, until one fails; a mistake that is explained is tried with tests of less than two seconds alone.
FOLDER/verdicts.tsv has number, test or nothing, file, line, text before and after; a later run in FOLDER tries what is left. The
exit status is 0 if of 100 mistakes 98 are killed or explained by a line of explained.txt, with tabs between file, text before, text
after and reason.
"""
import collections
import concurrent.futures
import hashlib
import json
import os
import pathlib
import re
import resource
import shutil
import subprocess
import sys
import time

TREE, FOLDER, COUNT = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2]), int(sys.argv[3])
COPY, BUILD, HERE = f"{FOLDER}/tree", f"{FOLDER}/build", os.path.dirname(os.path.abspath(__file__))
SWAPS = {" < ": (" <= ", " > "), " > ": (" >= ", " < "), " <= ": (" < ", " >= "), " >= ": (" > ", " <= "), " == ": (" != ",),
         " != ": (" == ",), " && ": (" || ",), " || ": (" && ",), " + ": (" - ",), " - ": (" + ",), " * ": (" + ",),
         " / ": (" * ",), " += ": (" -= ",), " -= ": (" += ",), " & ": (" | ",), " | ": (" & ",), " |= ": (" &= ",),
         " &= ": (" |= ",), " << ": (" >> ",), " >> ": (" << ",), " ^ ": (" | ",), "++": ("--",), "--": ("++",),
         "std::min(": ("std::max(",), "std::max(": ("std::min(",), "true": ("false",), "false": ("true",), "!": ("",),
         " ? ": (" ? false && ",)}
DECLARATION = re.compile(r"((?:const )?(?!return\b|else\b|using\b|constexpr\b|static\b|case\b)[\w:]+(?:<[\w:<>, ]*>)?"
                         r"(?: const)?[*&]* (?:const )?\w+\s+=\s+)(?=[^{\s])")
VALUE = re.compile(r"return\s+(?=[^{\s;])")
EXPRESSION = re.compile(r"(?![\w:]+(?:<[^;]*>)?[*&]*\s+[*&]*\w|\w+:\s|(?:break|continue);|static_assert|template)"
                        r"(?!(?:if|while|for) \()(?:[\w(*]|\+\+|--)")
# Comments, strings and lines of the preprocessor.
NO_CODE = re.compile(r"//[^\n]*|/\*.*?\*/|\"(?:\\.|[^\"\\\n])*\"|'(?:\\.|[^'\\\n])'|^[ ]*#(?:\\\n|[^\n])*", re.S | re.M)
Mistake = collections.namedtuple("Mistake", "hash file begin end value old new line")
ROOMS = "lanes|core|exact|model|sphere|boundary|topology|measure|contacts"
NOUNS = f"header|version|status|element|query|handle_every|gradient|{ROOMS}"
text_of = lambda path: pathlib.Path(path).read_text(encoding="utf-8")
plain = lambda text: " ".join(text.split())
TESTS = re.compile(rf"(laws|unit_({ROOMS})|api_({NOUNS})|differential_(query|degenerate|scans|gradient|{ROOMS}))_")


def end_of(code, at, stop):
    """Where `stop` stands outside of brackets, from `at`; None if a bracket is closed before."""
    depth = 0
    for k in range(at, len(code)):
        if depth == 0 and code[k] == stop:
            return k
        depth += (code[k] in "([{") - (code[k] in ")]}")
        if depth < 0:
            return None


def statements(code):
    """(begin, end, whether a value) of conditions, values and statements."""
    brackets, in_head = [], []
    for k, letter in enumerate(code):
        if letter in "([{":
            brackets.append(letter)
        elif letter in ")]}" and brackets:
            brackets.pop()
        elif letter == ";" and brackets[-1:] == ["("]:
            in_head.append(k)
    starts = {m.end() for m in re.finditer(r"[;{}]\s*|\belse\s+|\b(?:case [\w:]+|default):\s+", code) if m.start() not in in_head}
    for head in re.finditer(r"\b(if|while|for) \(", code):
        end = end_of(code, head.end(), ")")
        starts.add(re.compile(r"\s*").match(code, end + 1).end())
        middle = [k for k in in_head if head.end() <= k < end]
        if head.group(1) != "for":
            yield head.end(), end, True
        elif len(middle) == 2:
            yield middle[0] + 2, middle[1], True
    for at in starts:
        value = VALUE.match(code, at) or DECLARATION.match(code, at)
        end = end_of(code, at, ";")
        if end and (value or EXPRESSION.match(code, at)):
            yield value.end() if value else at, end, bool(value)


def mistakes_in(code, value):
    if not value and not re.match(r"return\s*\{", code):  # without a value of its type a function has no meaning
        yield ""
    for old, news in SWAPS.items():
        for m in re.finditer(rf"\b{old}\b" if old.isalpha() else re.escape(old) + ("(?!=)" if old == "!" else ""), code):
            yield from (code[:m.start()] + new + code[m.end():] for new in news)
    for m in re.finditer(r"(?<![\w.])(\d+)(?![\w']|\.\d*[eE])(U?)", code):
        yield code[:m.start()] + str(int(m.group(1)) + 1) + code[m.end(1):]


def draw():
    """Of each statement in the core one mistake, in the order in which they are drawn."""
    version = re.search(r'HSP_VERSION_STRING "(.*)"', text_of(f"{TREE}/include/hardsphere/version.h")).group(1)
    hashed = lambda *words: hashlib.sha256("|".join((version,) + words).encode()).hexdigest()
    found = []
    for file in re.findall(r"\S+\.[ch]pp\b", text_of(f"{TREE}/lib/core_files.txt")):
        text = text_of(f"{TREE}/{file}")
        code = NO_CODE.sub(lambda m: re.sub(r"[^\n]", " ", m.group()), text)
        seen = collections.Counter()
        for begin, end, value in sorted(set(statements(code))):
            old = code[begin:end]
            if ";" in old or (value and " = " in old) or re.search("[\"']", text[begin:end]):
                continue
            news = {plain(new): new for new in mistakes_in(old, value)} if old.strip() else {}
            if news:
                seen[old] += 1
                place = (file, plain(old), str(seen[old]))
                new = min(news, key=lambda n: hashed(*place, n))
                found.append(Mistake(hashed(*place), file, begin, end, value, old, news[new], text.count("\n", 0, begin) + 1))
    print(f"version {version}: {len(found)} statements", flush=True)
    return sorted(found)[:COUNT]


def write(drawn, refused):
    """The files with mistakes, numbered from 1 in the order of `drawn`; those that are refused are left out."""
    for file in {mistake.file for mistake in drawn}:
        text = text_of(f"{TREE}/{file}")
        here = [(m, number) for number, m in enumerate(drawn, 1) if m.file == file and number not in refused]
        for m, number in sorted(here, key=lambda item: -item[0].begin):
            if m.value:
                text = f"{text[:m.begin]}(hsp_mutant_is({number}) ? ({m.new}) : ({m.old})){text[m.end:]}"
            else:
                text = f"{text[:m.begin]}{{ if (hsp_mutant_is({number})) {{ {m.new}; }} else {{ {m.old}; }} }}{text[m.end + 1:]}"
        text = re.sub(r"(#pragma once\n|\A(?!.*#pragma once))", r'\1#include "mutant.hpp"\n', text, count=1, flags=re.S)
        pathlib.Path(f"{COPY}/{file}").write_text(text, encoding="utf-8")


def refused_by_the_compiler():
    """Numbers beside its errors in the core as one file."""
    subprocess.run(["python3", f"{COPY}/.ci/one_file.py", f"{FOLDER}/one_file"], check=True)
    lines, bad = text_of(f"{FOLDER}/one_file/hardsphere.cpp").split("\n"), set()
    for options in ([], ["-DHSP_TARGET=avx2", "-mavx2", "-mfma", "-mpopcnt"]):
        run = subprocess.run(["g++", "-std=c++20", "-w", "-fsyntax-only", "-fmax-errors=0", *options, "hardsphere.cpp"],
                             cwd=f"{FOLDER}/one_file", capture_output=True, text=True)
        for at in map(int, re.findall(r"hardsphere\.cpp:(\d+):\d+: error", run.stderr)):
            # The number of a mistake over several lines stands above.
            numbers = (re.findall(r"hsp_mutant_is\((\d+)\)", lines[k]) for k in range(at - 1, max(0, at - 7), -1))
            bad.update(map(int, next(filter(None, numbers), [])))
        if run.returncode and not bad:
            raise SystemExit(run.stderr[:4000])
    return bad


def build():
    """Draws, and builds the copy; gives the mistakes by their numbers."""
    shutil.copytree(TREE, COPY, dirs_exist_ok=True, ignore=shutil.ignore_patterns("build", ".git"))
    shutil.copy(f"{HERE}/mutant.hpp", f"{COPY}/lib/ground")
    drawn, refused = draw(), set()
    write(drawn, refused)
    while bad := refused_by_the_compiler():
        refused |= bad
        write(drawn, refused)
    print(f"{len(drawn)} drawn, {len(refused)} refused by the compiler", flush=True)
    options = "BENCH=OFF FORTRAN=OFF FUZZ=OFF INSTALL=OFF TOOL=OFF COMPONENTS= CHECKED_LIBRARY=ON".split()
    quiet = {"check": True, "stdout": subprocess.DEVNULL}
    subprocess.run(["cmake", "-G", "Ninja", "-S", COPY, "-B", BUILD, "-DCMAKE_BUILD_TYPE=Release",
                    "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -w", *(f"-DHSP_{option}" for option in options)], **quiet)
    subprocess.run(["cmake", "--build", BUILD], **quiet)
    return {number: mistake for number, mistake in enumerate(drawn, 1) if number not in refused}


def passes(test, variable, value, seconds):
    """Whether it passes, and its processor seconds; not if it takes far more of them, or more memory, than it should."""
    properties = {p["name"]: p["value"] for p in test.get("properties", [])}
    limits = lambda: (resource.setrlimit(resource.RLIMIT_CPU, (int(2 + 4 * seconds),) * 2),
                      resource.setrlimit(resource.RLIMIT_AS, (8 << 30,) * 2))
    run = subprocess.Popen(test["command"], cwd=properties.get("WORKING_DIRECTORY"), env={**os.environ, variable: str(value)},
                           preexec_fn=limits, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    _, status, used = os.wait4(run.pid, 0)
    run.returncode = os.waitstatus_to_exitcode(status)
    return run.returncode in (0, properties.get("SKIP_RETURN_CODE")), used.ru_utime + used.ru_stime


def reached_by(test):
    """Its seconds, and the numbers of the mistakes that it comes to: none if it fails without a mistake, or takes a minute."""
    marks = pathlib.Path(f"{FOLDER}/marks_{test['name']}")
    marks.write_bytes(bytes(1 << 16))
    well, seconds = passes(test, "HSP_REACHED", marks, 14)
    numbers = [number for number, mark in enumerate(marks.read_bytes()) if mark]
    marks.unlink()
    if not well:
        print(f"fails, or takes too long: {test['name']}", flush=True)
    return seconds, numbers if well else []


def kept(name, make):
    path = pathlib.Path(f"{FOLDER}/{name}.json")
    if not path.exists():
        path.write_text(json.dumps(make()), encoding="utf-8")
    return json.loads(text_of(path))


def main():
    begun = time.time()
    os.makedirs(FOLDER, exist_ok=True)
    pool = concurrent.futures.ThreadPoolExecutor(os.cpu_count())
    mistakes = {int(n): Mistake(*m) for n, m in kept("drawn", build).items()}
    listed = subprocess.run(["ctest", "--test-dir", BUILD, "--show-only=json-v1"], capture_output=True, check=True).stdout
    tests = {test["name"]: test for test in json.loads(listed)["tests"] if TESTS.match(test["name"]) and "command" in test}
    reached = kept("reached", lambda: dict(zip(tests, pool.map(reached_by, tests.values()))))
    order = sorted(tests, key=lambda name: reached[name][0])
    reasons = {tuple(line.split("\t")[:3]) for line in text_of(f"{HERE}/explained.txt").split("\n")}
    explained = {number for number, m in mistakes.items() if (m.file, plain(m.old), plain(m.new)) in reasons}
    comes_to = {number: [name for name in order if number in reached[name][1]] for number in mistakes}

    def killer(number):
        room, unit = re.search(r"(\w+)/(\w+)[\w.]*$", mistakes[number].file).groups()
        near = sorted(comes_to[number], key=lambda name: 2 - name.startswith(f"unit_{room}") - (name == f"unit_{room}_{unit}"))
        tried = [name for name in near if number not in explained or reached[name][0] < 2]
        fails = (name for name in tried if not passes(tests[name], "HSP_MUTANT", number, reached[name][0])[0])
        return number, next(fails, "")

    path = f"{FOLDER}/verdicts.tsv"
    verdicts = dict(re.findall(r"^(\d+)\t(.*?)\t", text_of(path), re.M)) if os.path.exists(path) else {}
    with open(path, "a", encoding="utf-8") as file:
        running = [pool.submit(killer, number) for number in mistakes if str(number) not in verdicts]
        for number, test in (done.result() for done in concurrent.futures.as_completed(running)):
            m = mistakes[number]
            verdicts[str(number)] = test
            print(number, test, m.file, m.line, plain(m.old), plain(m.new), sep="\t", file=file, flush=True)
    live = [int(number) for number, test in verdicts.items() if not test]
    unexplained = [mistakes[number] for number in live if number not in explained]
    for m in unexplained:
        print(f"lives: {m.file}:{m.line} | {plain(m.old)} | {plain(m.new)}")
    kinds = collections.Counter(test.split("_")[0] for test in verdicts.values() if test)
    print(f"{len(mistakes)} made, killed by {dict(kinds)}, explained {len(live) - len(unexplained)}, not {len(unexplained)}; "
          f"{(time.time() - begun) / 60:.0f} minutes")
    return len(unexplained) > 0.02 * len(mistakes)


sys.exit(main())
