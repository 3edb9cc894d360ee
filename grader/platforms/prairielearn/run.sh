#!/usr/bin/env bash
# run.sh: the entry point of PrairieLearn's grading job, as root in the image that was built from
# image/. What the student sees is in results.json.

set -uo pipefail
job=/grade
course=/course
seconds=240 # README.md asks PrairieLearn for 300, and it takes a job without an end for a fault

# This is the result unless there is another one below: no mark, no attempt used.
mkdir -p "$job/results"
cp "$job/tests/not-graded.json" "$job/results/results.json"

# The image is public; solutions come with the question, and nothing here is the submission's to
# read: it runs as another user where it cannot be put into namespaces of its own.
chmod -R go= "$job"
if [[ -d $job/tests/solutions ]]; then
    cp -r "$job/tests/solutions" "$course/"
fi

# In the environment, for other users may read command lines.
export COURSE_SEED=@SEED@
code=0
timeout --kill-after=10 "$seconds" "$course/build/release/grader/grader" \
    @ASSIGNMENT@ --harness prairielearn || code=$?
((code == 0)) ||
    echo "There is no mark. The grader of commit @COMMIT@ ended with exit code $code (2: see above;" \
        "124 or 137: after $seconds s or without memory; 127: the image has none)."
