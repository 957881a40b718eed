#!/usr/bin/env bash
# scripts/validate.sh [sync]: runs what draws by every method with synchronization validation, which looks for hazards between draws,
# dispatches and copies, at several times the cost. Any message fails a test. Further arguments go to the tests, such as
# --gtest_filter=StressTest.* It sees no accesses through buffer addresses.
# scripts/validate.sh gpu: draws scenes by every method with GPU-assisted validation, which looks at every access that shaders make, and
# exits with 1 if there is any message. Further arguments go to `plume compare`. It needs layers of version 1.4, as Debian 13 has; those of
# Debian 12 (1.3.239) report pushed descriptors, which all shaders here use, as uninitialized.
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/.."
job="${1:-sync}"
shift || true
case "$job" in
  sync)
    scripts/build.sh plume_gpu_tests
    export PLUME_TEST_SYNCHRONIZATION=1 VK_LAYER_SYNCVAL_SHADER_ACCESSES_HEURISTIC=1
    exec build/plume_gpu_tests \
      --gtest_filter='*MethodProperties.*:*StressTest.*:AvboitVariants.*:*Simulation*:*Lighting*:SynchronizationTest.*:HazardTest.*' "$@"
    ;;
  gpu)
    manifest=$({ find /usr/share/vulkan /usr/local/share/vulkan /etc/vulkan -name VkLayer_khronos_validation.json 2>/dev/null || true; } | head -1)
    version=$(sed -n 's/.*"api_version": *"\([0-9.]*\)".*/\1/p' "${manifest:-/dev/null}")
    if [ "$(printf '1.4\n%s\n' "${version:-0}" | sort -V | head -1)" != 1.4 ]; then
      echo "GPU-assisted validation needs Vulkan's validation layers of version 1.4, here is ${version:-none}: run it on Debian 13" >&2
      exit 3
    fi
    scripts/build.sh plume
    VK_LAYER_SETTINGS_PATH=tests/gpu_assisted exec build/plume compare street glass coloured haze focus fireball explosion \
      --methods all --size 48x27 --frames 1 --validate --out out/gpu_assisted "$@"
    ;;
  *)
    echo "usage: scripts/validate.sh [sync|gpu] [ARGUMENT...]" >&2
    exit 2
    ;;
esac
