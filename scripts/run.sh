#!/usr/bin/env bash
# From a clean clone to a measured comparison: installs what is missing, builds, compares the default methods on the default scene.
# Arguments go to `plume compare` instead of the default ones.
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/.."
scripts/build.sh plume
[ $# -gt 0 ] || set -- street --out out/street
exec build/plume compare "$@"
