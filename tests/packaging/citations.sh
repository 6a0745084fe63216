#!/usr/bin/env bash
# Everything that comments and pages cite is there: the files of the repository that they name, and the sections of
# PROOFS.md (of the citing file's room if it has one, else lib/ground/exact).
#   citations.sh SOURCE-FOLDER
set -euo pipefail
cd "$1"
folders="lib capi include tests bench fuzz .github .ci"

# A page of capi/guide may cite the program that its blocks in C make, which has its name; that of README.md is water.c.
# hardsphere.cpp is in a release, made by .ci/one_file.py.
# A file is cited by its path from the root, from lib/, a wing of it, capi/, include/ or tests/, from the citing file's folder, or by its name.
find $folders ./*.* -type f | sed 's,^\./,,' | awk '
  function in_wing(name,   wing) {
    for (wing in wings) if (("lib/" wing "/" name) in path) return 1
    return 0
  }
  function exists(name, from,   page) {
    if (from == "README.md" && name == "water.c" || name == "hardsphere.cpp") return 1
    page = "capi/guide/" name
    if (sub(/\.(c|f90)$/, ".md", page) && from == page) return 1
    sub(/[^\/]*$/, "", from)
    while (name ~ /^\.\.\//) { sub(/^\.\.\//, "", name); sub(/[^\/]*\/$/, "", from) }
    return name in path || ("lib/" name) in path || in_wing(name) || ("capi/" name) in path || ("include/" name) in path || ("tests/" name) in path ||
      (from name) in path || name in bare
  }
  function cite(file, line, text,   name, number) {
    if (text ~ /^ *# *include/) return
    while (match(text, /[A-Za-z0-9_.][A-Za-z0-9_\/.-]+\.(hpp|cpp|h|c|md|sh|awk|f90|cmake)/)) {
      name = substr(text, RSTART, RLENGTH)
      text = substr(text, RSTART + RLENGTH)
      if (text ~ /^[A-Za-z0-9_(]/ || name ~ /^(tests\/a\/|_)/) continue  # parts of names, and how files are named
      ++citations
      if (!exists(name, file)) { print file ":" line ": no file \"" name "\""; failed = 1 }
      if (name ~ /PROOFS.md$/ && match(text, /^, section [0-9]+/)) {
        number = substr(text, 11, RLENGTH - 10)
        if (!((file ~ /^lib\/smooth\/surface\// ? "surface " : "exact ") number in section)) { print file ":" line ": PROOFS.md has no section " number; failed = 1 }
      }
    }
  }
  { path[$0] = 1; if (split($0, part, "/") > 2 && part[1] == "lib") wings[part[2]] = 1; name = $0; sub(/.*\//, "", name); bare[name] = 1; files[++count] = $0 }
  END {
    for (k = split("exact surface", room, " "); k > 0; --k) {
      proofs = "lib/" (room[k] == "exact" ? "ground/" : "smooth/") room[k] "/PROOFS.md"
      while ((getline text < proofs) > 0) {
        if (text ~ /^## [0-9]+\./) { split(text, part, /[ .]/); section[room[k] " " part[2]] = 1 }
      }
      close(proofs)
    }
    for (k = 1; k <= count; ++k) {
      page = files[k] ~ /\.md$/
      if (!page && files[k] !~ /\.(hpp|cpp|h|c|f90)$/) continue
      for (line = 1; (getline text < files[k]) > 0; ++line) {
        if (page || match(text, /(^|[ ;{}])(\/\/|\/\*)|^ *[*!]/)) cite(files[k], line, page ? text : substr(text, RSTART))
      }
      close(files[k])
    }
    print citations " citations of files"
    exit failed || citations == 0
  }'
