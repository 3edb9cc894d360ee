#!/usr/bin/env bash
# run.sh: grades the submission beside it, in the image that was built from image/ and
# Dockerfile.autolab. All that it prints is shown to the student; Autolab reads the points in the
# last line. Without a mark there is no such line, and the exit code is 2.

set -uo pipefail
grader=/course/build/release/grader/grader
seconds=540

# The submission is what is not ours.
mkdir -p handin
shopt -s dotglob
for each in *; do
    case $each in
        Makefile | autograde-Makefile | autograde.tar | run.sh | handin) ;;
        *) mv -- "$each" handin/ ;;
    esac
done

# Autolab's user may start the grader, and nothing else, as root. The grader then makes the
# submission another user's, who can read neither solutions nor what is here.
chmod go= handin
as_root=()
[[ $(id -u) == 0 ]] || as_root=(sudo -n)
# In the environment, for other users may read command lines.
export COURSE_SEED=@SEED@
code=0
"${as_root[@]}" /usr/bin/timeout --kill-after=10 "$seconds" "$grader" \
    @ASSIGNMENT@ --harness autolab 2> error || code=$?
((code != 0)) || exit 0
cat error
echo "There is no mark, and that is not your mistake: tell your instructor. The grader of commit" \
    "@COMMIT@ ended with exit code $code (2: see above; 124 or 137: after $seconds s or without" \
    "memory; 127: it is not in the image)."
exit 2
