#!/usr/bin/env bash
# scripts/soak.sh ticks [N]: walks the scene `everything` for N ticks (otherwise 10^6), by steps and by seeks, and fails on a
# value that is not finite, a state that depends on the road to it, or memory that grows: tests/gpu/soak_test.cpp.
# Takes hours without a GPU: walking 1200 ticks takes 10 s on two idle cores, besides the checkpoints. Quicker without
# the 200,000 particles of its mist: PLUME_SOAK_WITHOUT=mist scripts/soak.sh ticks
# scripts/soak.sh frames [N]: draws N frames (otherwise 100,000) of the window's work without a window, and fails on a
# picture, an amount of memory or a number of objects that is not what it was: tests/gpu/frame_soak_test.cpp. With
# PLUME_SOAK_VALIDATE=1 validation messages fail it too, and the heap, of which the layers take more and more, may grow.
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/.."
case "${1:-}" in
  ticks) export PLUME_SOAK_TICKS="${2:-1000000}"; filter='SoakTest.*' ;;
  frames) export PLUME_SOAK_FRAMES="${2:-100000}"; filter='FrameSoakTest.*' ;;
  *) echo "usage: scripts/soak.sh ticks|frames [N]" >&2; exit 2 ;;
esac
scripts/build.sh plume_gpu_tests
exec build/plume_gpu_tests --gtest_filter="$filter"
