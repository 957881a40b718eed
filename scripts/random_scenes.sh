#!/usr/bin/env bash
# Draws 500 scenes that nobody wrote, or as many as the first argument says, of the seeds from 1, or from the second, on, by every
# method with validation on: tests/property/random_scenes_test.cpp. What fails keeps its files and says how it is drawn again.
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/.."
scripts/build.sh
PLUME_RANDOM_SCENES="${1:-500}" PLUME_RANDOM_FIRST="${2:-1}" exec build/plume_gpu_tests --gtest_filter='RandomScenes.*'
