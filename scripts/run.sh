#!/usr/bin/env bash
# From a clean clone to a measured comparison: installs what is missing, builds, compares nine methods on the default scene
# (all of them, `--methods all`, take more than a minute on two cores: peeling draws everything once for each layer).
# Arguments go to `plume compare` instead of the default ones.
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/.."
scripts/build.sh plume
[ $# -gt 0 ] || set -- street --methods reference,tile_sorted,sorted,mlab,wboit,moments,wavelets,vboit,avboit --out out/street
exec build/plume compare "$@"
