#!/usr/bin/env bash
# Installs what is missing, builds, runs all tests. Arguments go to ctest, such as -R Avboit.
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/.."
scripts/build.sh
exec ctest --test-dir build --output-on-failure -j "$(nproc)" "$@"
