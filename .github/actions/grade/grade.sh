#!/usr/bin/env bash
# grade.sh [GRADER...]: grades a pull request, on GitHub or anywhere. The current folder is a checkout
# of the base branch, with its history. Fetches the commits of the pull request that the file
# $GITHUB_EVENT_PATH tells of from the remote `origin`, and never checks them out: GRADER (default
# ./grade --yes) reads the students' files out of git. Exit codes: those of ./grade pull-request.
#
#   PASS_FROM   percent of an assignment's points from which on it passes; default 60
#   REPORT      folder for report, pictures and result.json; default pull-request-report

set -euo pipefail

if (($# == 0)); then
    set -- ./grade --yes
fi

fail() {
    echo "grade.sh: $1" >&2
    exit 2
}

# The event is GitHub's; of it only a number and a commit are used.
event=${GITHUB_EVENT_PATH:-}
[[ -r $event ]] || fail "\$GITHUB_EVENT_PATH must name the file that tells of the pull request"
told() {
    perl -MJSON::PP -0777 -ne "print decode_json(\$_)->{pull_request}$1 // exit 1" "$event" ||
        fail "$event does not tell of a pull request"
}
number=$(told '{number}')
head=$(told '{head}{sha}')
# The base is what is checked out: the event may name an older commit, from before the instructor's
# last changes, which would then count as the student's.
base=$(git rev-parse HEAD) || fail "$PWD is no checkout of the base branch"

git fetch --quiet --no-tags --no-recurse-submodules origin "+refs/pull/$number/head:refs/pull/$number/head" ||
    fail "the commits of pull request $number cannot be fetched"
git cat-file -e "$head^{commit}" ||
    fail "pull request $number has moved on from $head, which is gone; its next run grades it."
# What follows needs no network, and no token.
git config --local --unset-all http.https://github.com/.extraheader || true

exec "$@" pull-request --repository "$PWD" --base "$base" --head "$head" \
    --pass-from "${PASS_FROM:-60}" --report "${REPORT:-pull-request-report}"
