#!/usr/bin/env bash
# Comments of the headers leave no question open, and the files that are generated from the headers are up to date. Exit
# status 77: there is no parser of C here.
#   generated.sh SOURCE-FOLDER
set -euo pipefail
bash "$1/capi/interface/generate.sh" --check
