#!/usr/bin/env bash
# Runs what draws by every method with synchronization validation, which looks for hazards between draws, dispatches and
# copies, at several times the cost. Any message fails a test. Arguments go to the tests, such as --gtest_filter=StressTest.*
# It sees no accesses through buffer addresses.
#
# GPU-assisted validation is not run: with the layers of Debian 12 (1.3.239) on lavapipe it reports pushed descriptors, which all
# shaders here use, as uninitialized, even in the empty scene, and one frame of `three_cards` was not done after four minutes.
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/.."
scripts/build.sh plume_gpu_tests
export PLUME_TEST_SYNCHRONIZATION=1
exec build/plume_gpu_tests \
  --gtest_filter='*MethodProperties.*:*StressTest.*:AvboitVariants.*:*Simulation*:*Lighting*:SynchronizationTest.*:HazardTest.*' "$@"
