#!/bin/bash
# Draws a replay or a comparison as a Slurm job array, and merges what its tasks drew.
#
#     scripts/farm_slurm.sh SHARDS OUT replay street --size 1280x720
#
# Prints the numbers of both jobs; OUT/shards/I.log and OUT/shards/merge.log have what they say. SBATCH has
# further flags for the array, such as SBATCH="--partition=gpu --gres=gpu:1"; PLUME names the program, otherwise
# build/plume beside this script. All nodes see the folder this is started in.
# A task whose program dies starts it again up to three times, one whose node dies is queued again by Slurm, and
# both go on from what they had. If that was not enough the merge is not run: the same command again does what
# is left, and shards that are complete take no time.
set -euo pipefail
if [ $# -lt 3 ]; then
  sed -n '2,/^set/{/^#/s/^# \{0,1\}//p}' "$0" >&2
  exit 2
fi
shards=$1 out=$2
shift 2
plume=${PLUME:-$(cd "$(dirname "$0")/.." && pwd)/build/plume}

mkdir -p "$out/shards"
parts=()
for ((i = 0; i < shards; ++i)); do parts+=("$out/shards/$i"); done
printf -v draw '%q ' "$plume" "$@" --resume --isolate
printf -v place '%q' "$out/shards"
printf -v merge '%q ' "$plume" merge "${parts[@]}" --out "$out"

# shellcheck disable=SC2086  # SBATCH is several words
array=$(sbatch --parsable --job-name=plume --array=0-$((shards - 1)) --requeue --open-mode=append \
  --output="$out/shards/%a.log" ${SBATCH:-} <<END
#!/bin/bash
for try in 1 2 3; do
  $draw --shard \$SLURM_ARRAY_TASK_ID/$shards --out $place/\$SLURM_ARRAY_TASK_ID && exit 0
done
exit 1
END
)
merged=$(sbatch --parsable --job-name=plume-merge --dependency="afterok:$array" --kill-on-invalid-dep=yes \
  --output="$out/shards/merge.log" --wrap "exec $merge")
echo "array $array, merge $merged"
