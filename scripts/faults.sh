#!/usr/bin/env bash
# Faults at every moment at which they can strike, where the tests of each day try some: a full disk at each operation of each
# command that writes, a device lost at each submission, memory that runs out at each allocation, 200 kills and 200 times Ctrl+C, presets that are
# replaced while they are read 2000 times. After each: a message, the right exit code, nothing partial, and --resume.
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/.."
scripts/build.sh
export PLUME_EVERY_FAULT=1
build/plume_unit_tests --gtest_filter='FilesThatDoNotFit.*:ReplacedPreset.*'
build/plume_gpu_tests --gtest_filter='*NoRoomTest.*:DeviceNeedsTest.*'
exec build/plume_command_tests --gtest_filter='FullDiskTest.*:FailureTest.*:KillTest.*:KeptPipelinesTest.*:ReplacedPresetTest.*:ShaderEditTest.*'
