#!/usr/bin/env python3
"""The core as one file: hardsphere.cpp and hardsphere.h, for builds without CMake. Part of a release.

    one_file.py FOLDER

Sources are those of lib/core_files.txt, each behind the headers that it needs. A header or source is where it is first
needed, without its includes of our own files. What is compiled a second time, for wider registers, is the kernels and their
headers: the rest is left out there. All of namespace hsp is local to the file, unless a second object has to find it.
"""
import os
import re
import sys

TREE = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
ROOTS = ["lib/ground", "lib/balls", "lib/union", "include", "capi/shims/core"]
OWN = re.compile(r'^#include "([^"]+)"\n', re.M)
HEAD = """\
/* hardsphere {version}: exact geometry of unions of balls, the core in one file; the functions of hardsphere.h. It needs a
 * compiler for C++20 and no library but memcpy, memmove, memset, memcmp and sqrt:
 *   g++ -std=c++20 -O2 -c hardsphere.cpp
 * Twice as fast on processors with AVX2, and as fast as before on others:
 *   g++ -std=c++20 -O2 -DHSP_AVX2=1 -c hardsphere.cpp
 *   g++ -std=c++20 -O2 -DHSP_TARGET=avx2 -mavx2 -mfma -mpopcnt -c hardsphere.cpp -o hardsphere_avx2.o
 * Results have the same bits either way, with every option of optimization and of the processor, but for those that give
 * up IEEE 754, which are refused. Options that make it smaller: -fno-exceptions -fno-rtti -fno-asynchronous-unwind-tables
 * -ffunction-sections.
 * Made by .ci/one_file.py of the project, from which it is maintained; do not change it.
 *
{licence} */
// No fused operations, and no vectorizer, as that of g++ 12 makes them all the same.
#if defined(__clang__)
// No parts of -ffast-math, of which clang names -ffinite-math-only alone. Some processors have no float_control.
#pragma GCC diagnostic ignored "-Wignored-pragmas"
#pragma float_control(precise, on)
#pragma STDC FP_CONTRACT OFF
#pragma GCC diagnostic ignored "-Wunused-const-variable"
#define HSP_FRIEND friend
#elif defined(__GNUC__)
// g++ gives these options to a friend that a class defines only if it has another attribute as well.
#define HSP_FRIEND __attribute__((__unused__)) friend
// With -O3 it takes the check of a struct of a later version for one of a struct that it knows.
#pragma GCC diagnostic ignored "-Warray-bounds"
#pragma GCC optimize("fp-contract=off", "no-tree-slp-vectorize", "no-tree-loop-vectorize", "no-math-errno", "no-exceptions")
#endif
{standard}#if defined(__GNUC__)
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC visibility push(hidden)  // behind the standard's functions, which are others'
#endif
#define HSP_NO_CONTRACTION 1
#if !defined(HSP_LANES) && (defined(__SSE2__) || defined(__aarch64__) || defined(__wasm_simd128__))
#define HSP_LANES 1
#endif
#if defined(HSP_TARGET)
#define HSP_AVX2 1
#define HSP_ALL 0
#else
#define HSP_TARGET baseline
#define HSP_ALL 1
#endif
#if HSP_AVX2
#define HSP_OPEN
#define HSP_CLOSE
#else
#define HSP_OPEN namespace {{
#define HSP_CLOSE }}
#endif
"""


def text_of(path):
    with open(os.path.join(TREE, path), encoding="utf-8") as file:
        return file.read()


def find(name, beside):
    for root in [os.path.dirname(beside)] + ROOTS:
        path = os.path.normpath(os.path.join(root, name))
        if os.path.exists(os.path.join(TREE, path)):
            return path
    raise SystemExit(f"{beside}: no file {name}")


def includes(path):
    """Own files that a file includes, and whether under a condition: such a one is put in place."""
    depth = 0
    for line in text_of(path).split("\n"):
        depth += line.startswith("#if") - line.startswith("#endif")
        found = OWN.match(line + "\n")
        if found:
            yield find(found.group(1), path), depth > 0


def needs(path, seen):
    """The files that a file includes, and itself, each behind what it includes; those that are in `seen` are not."""
    if path in seen:
        return []
    seen.add(path)
    order = []
    for own, in_place in includes(path):
        order += needs(own, seen)
        if in_place and own in order:
            order.remove(own)
    return order + [path]


def chunk(path):
    in_place = dict(includes(path))
    text = text_of(path).replace("#pragma once\n", "")
    text = re.sub(r"^(namespace hsp(?:::\w+)* \{)$", r"HSP_OPEN \1", text, flags=re.M)
    text = re.sub(r"^(\}  // namespace hsp(?:::\w+)*)$", r"HSP_CLOSE \1", text, flags=re.M)
    text = re.sub(r"^( +)friend (?!class |struct )", r"\1HSP_FRIEND ", text, flags=re.M)
    own = lambda m: chunk(find(m.group(1), path)) if in_place[find(m.group(1), path)] else ""
    return f"\n// {path}\n" + OWN.sub(own, text)


def public_header(licence, version):
    """The stable headers: what hardsphere.h includes without a component."""
    def of(path, seen):
        text = re.sub(r"^#if HSP_HAS_\w+\n(?:#include .*\n)+#endif\n", "", text_of(path), flags=re.M)
        return re.sub(OWN, lambda m: once(find(m.group(1), path), seen), text)

    def once(path, seen):
        if path in seen or path.endswith("components.h"):
            return ""
        seen.add(path)
        return of(path, seen)

    return f"/* hardsphere {version}, the core in one file.\n *\n{licence} */\n" + of("include/hardsphere.h", set())


def main():
    folder = sys.argv[1]
    os.makedirs(folder, exist_ok=True)
    version = re.search(r'HSP_VERSION_STRING "(.*)"', text_of("include/hardsphere/version.h")).group(1)
    licence = "".join(f" * {line}".rstrip() + "\n" for line in text_of("LICENSE").rstrip().split("\n"))
    sources = [line for line in text_of("lib/core_files.txt").split() if line.endswith(".cpp")]
    lanes = set(re.findall(r"lib/\S+\.cpp", re.search(r"set\(HSP_SOURCES_OF_LANES(.*?)\)", text_of("lib/library.cmake"),
                                                      re.S).group(1)))
    kernels = [source for source in sources if source.endswith(".kernel.cpp")]
    of_kernels, seen = set(), set()
    for kernel in kernels:
        of_kernels.update(needs(kernel, seen))
    parts, seen = [], set(find(name, "") for name in ["hardsphere.h"])
    for source in kernels + [source for source in sources if source not in kernels]:
        for path in needs(source, seen):
            if path.startswith("include/"):
                continue
            conditions = (["HSP_ALL"] if path not in of_kernels else []) + (["HSP_LANES"] if path in lanes else [])
            begin, end = (f"\n#if {' && '.join(conditions)}", "#endif\n") if conditions else ("", "")
            parts.append(begin + chunk(path) + end)
    standard = sorted(set(re.findall(r"^#include <\w+>\n", "".join(parts), flags=re.M)))
    head = HEAD.format(version=version, licence=licence, standard="".join(standard))
    with open(os.path.join(folder, "hardsphere.h"), "w", encoding="utf-8") as file:
        file.write(public_header(licence, version))
    with open(os.path.join(folder, "hardsphere.cpp"), "w", encoding="utf-8") as file:
        file.write(head + '#include "hardsphere.h"\n' + "".join(parts))


main()
