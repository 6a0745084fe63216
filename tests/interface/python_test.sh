#!/usr/bin/env bash
# Runs a test of capi/interface with Debian's Python. Exit status 77: there is no parser of C here.
#   python_test.sh TEST.py
set -euo pipefail
/usr/bin/python3 -c 'import pycparser' 2>/dev/null || { echo "skipped: there is no python3-pycparser here" && exit 77; }
here=$(cd "$(dirname "$0")" && pwd)
PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=$here:$here/../../capi/interface exec /usr/bin/python3 "$1"
