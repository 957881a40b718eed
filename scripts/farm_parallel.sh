#!/bin/bash
# Draws a replay or a comparison on several machines by GNU parallel over ssh, and merges what they drew.
#
#     scripts/farm_parallel.sh SHARDS OUT replay street --size 1280x720
#
# MACHINES names a file for parallel's --sshloginfile: one `1/user@host` a line, the number being how many
# shards it draws at a time (`1/:` is this machine, and what is used without MACHINES). All of them see the
# folder this is started in under the same path, and the program: PLUME, otherwise build/plume beside this script.
# A shard whose machine or program dies is tried on another up to three times and goes on from what it had. If
# that was not enough, the same command again does what is left.
set -euo pipefail
if [ $# -lt 3 ]; then
  sed -n '2,/^set/{/^#/s/^# \{0,1\}//p}' "$0" >&2
  exit 2
fi
shards=$1 out=$2
shift 2
plume=${PLUME:-$(cd "$(dirname "$0")/.." && pwd)/build/plume}
machines=${MACHINES:-}

mkdir -p "$out/shards"
if [ -z "$machines" ]; then
  machines=$out/shards/machines
  echo '1/:' > "$machines"
fi
printf -v draw '%q ' "$plume" "$@" --resume --isolate
printf -v place '%q' "$out/shards"

seq 0 $((shards - 1)) | parallel --sshloginfile "$machines" --jobs 100% --workdir "$PWD" --retries 3 \
  --joblog "$out/shards/joblog" --resume-failed --line-buffer --tag \
  "$draw --shard {}/$shards --out $place/{} > /dev/null"

parts=()
for ((i = 0; i < shards; ++i)); do parts+=("$out/shards/$i"); done
exec "$plume" merge "${parts[@]}" --out "$out"
