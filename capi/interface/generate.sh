#!/usr/bin/env bash
# Writes all files that are generated from the headers; with --check compares them. Debian's Python has
# python3-pycparser; another one that comes first in PATH need not have it.
set -euo pipefail
exec /usr/bin/python3 "$(dirname "$0")/generate.py" "$@"
