#!/usr/bin/env bash
# Installs what is missing, configures and builds the release preset in build/. Arguments are targets; otherwise everything is built.
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/.."
scripts/install.sh
cmake --preset release >&2
cmake --build --preset release ${1:+--target "$@"} >&2
