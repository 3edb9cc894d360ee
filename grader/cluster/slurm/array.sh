#!/usr/bin/env bash
# One part of a class, as a task of a Slurm job array:
#
#     sbatch --array=1-8 array.sh COURSE SUBMISSIONS ASSIGNMENT OUT SEED [MORE OPTIONS OF batch…]
#
# COURSE is the course's folder with a built grader, OUT a folder that all nodes see: task i writes to
# OUT/part-i, and goes on there when it is requeued. SEED is the same number for all parts; keep it
# secret until the marks are out. When all tasks have ended:
#
#     COURSE/grade merge OUT/part-* --out OUT/all
#
# README.md says more.
#SBATCH --job-name=grade
#SBATCH --cpus-per-task=1
#SBATCH --requeue
#SBATCH --open-mode=append
#SBATCH --signal=B:INT@60

set -euo pipefail
if (($# < 5)); then
    sed -n '2,/^# README/s/^# \{0,1\}//p' "$0" >&2
    exit 2
fi
course=$1 submissions=$2 assignment=$3 out=$4 seed=$5
shift 5
part=${SLURM_ARRAY_TASK_ID:?this is started by sbatch --array}
parts=${SLURM_ARRAY_TASK_MAX:?this is started by sbatch --array}

mkdir -p "$out"
export COURSE_SEED=$seed  # others can read a command line
# A signal before the time is up reaches the grader, which ends what it has begun and writes it down.
exec "$course/build/release/grader/grader" batch "$submissions" --assignment "$assignment" \
    --out "$out/part-$part" --shard "$part/$parts" \
    --jobs "${SLURM_CPUS_PER_TASK:-1}" "$@"
