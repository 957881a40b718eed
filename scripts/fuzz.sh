#!/usr/bin/env bash
# Fuzzes what reads files, with sanitizers: installs what is missing, builds, and runs each fuzzer for so long, as many at a time as there are
# processors. Any finding is an error, and its file is in build-fuzz/found/. What it learns stays in build-fuzz/learnt/, for the next time.
#     scripts/fuzz.sh [SECONDS_EACH [effect|scene|replay|png|exr]…]      600 s, all of them
# The two halves alone, as the tests have them: `--build` builds the fuzzers, `--run SECONDS_EACH TARGET…` runs what was built.
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/.."

build() {
  if ! command -v clang++-14 >/dev/null; then
    echo "The fuzzers need clang++-14: scripts/install.sh installs it." >&2
    exit 1
  fi
  cmake --preset fuzz >&2
  cmake --build --preset fuzz >&2
}

run() {   # SECONDS TARGET
  local seconds=$1 target=$2 log=build-fuzz/$2.log folder seeds=() words=() code=0
  # As in tests/unit/fuzz_corpus_test.cpp.
  for folder in "tests/fuzz/corpus/$target" "presets/${target}s" "tests/malformed/${target}s"; do
    [ ! -d "$folder" ] || seeds+=("$folder")
  done
  [[ $target = png || $target = exr ]] || words=(-dict=tests/fuzz/toml.dict)
  mkdir -p "build-fuzz/learnt/$target" build-fuzz/found
  # Of memory, what the largest pictures that are read from so little take, and no more.
  "build-fuzz/fuzz_$target" -max_total_time="$seconds" -timeout=20 -rss_limit_mb=2048 -malloc_limit_mb=1024 -print_final_stats=1 \
    "${words[@]}" -artifact_prefix="build-fuzz/found/$target-" "build-fuzz/learnt/$target" "${seeds[@]}" >"$log" 2>&1 || code=$?
  if [ $code -ne 0 ]; then
    grep -a -E -A 25 'what\(\):|ERROR:|runtime error:|No such file|Test unit written' "$log" >&2 || tail -20 "$log" >&2
    echo "fuzz_$target FAILED. Again: build-fuzz/fuzz_$target FILE, with the file named above; all of it is in $log" >&2
    return 1
  fi
  awk -v target="$target" '/cov: / { for (i = 1; i < NF; ++i) if ($i == "cov:") edges = $(i + 1); else if ($i == "ft:") features = $(i + 1) }
    /number_of_executed_units/ { runs = $2 }
    END { printf "%s: nothing found in %d runs, %d edges, %d features\n", target, runs, edges, features }' "$log"
}

step=all
case ${1:-} in
  --build) build; exit ;;
  --run) step=run; shift ;;
  -*) echo "unknown argument \`$1\`, expected --build, --run or a number of seconds" >&2; exit 2 ;;
esac
seconds=${1:-600}
[[ $seconds =~ ^[1-9][0-9]*$ ]] || { echo "\`$seconds\` is no number of seconds, expected one above 0" >&2; exit 2; }
[ $# -eq 0 ] || shift
targets=("$@")
[ $# -gt 0 ] || targets=(effect scene replay png exr)
for target in "${targets[@]}"; do
  [ -f "tests/fuzz/${target}_check.cpp" ] || { echo "no fuzzer \`$target\`, expected effect, scene, replay, png or exr" >&2; exit 2; }
done
if [ $step = all ]; then
  scripts/build.sh plume_sandbox   # installs, and builds what the fuzzers are linked with
  build
fi

failed=0 running=0
for target in "${targets[@]}"; do
  if [ $running -ge "$(nproc)" ]; then
    wait -n || failed=1
    running=$((running - 1))
  fi
  run "$seconds" "$target" &
  running=$((running + 1))
done
while [ $running -gt 0 ]; do
  wait -n || failed=1
  running=$((running - 1))
done
exit $failed
