#!/usr/bin/env bash
# Runs the tests of the reader with Debian's Python. Exit status 77: there is no parser of C here.
#   reader.sh TEST.py
set -euo pipefail
PYTHONDONTWRITEBYTECODE=1 exec /usr/bin/python3 "$1"
