#!/usr/bin/env bash
# Walks the scene `everything` for 10^6 ticks, or as many as the argument says, by steps and by seeks, and fails on a
# value that is not finite, a state that depends on the road to it, or memory that grows: tests/gpu/soak_test.cpp.
# Takes hours without a GPU: walking 1200 ticks takes 10 s on two idle cores, besides the checkpoints. Quicker without
# the 200,000 particles of its mist: PLUME_SOAK_WITHOUT=mist scripts/soak.sh
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/.."
scripts/build.sh
PLUME_SOAK_TICKS="${1:-1000000}" exec build/plume_gpu_tests --gtest_filter='SoakTest.*'
