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

# The event is GitHub's; of it only a number and two commits are used.
number=$(perl -MJSON::PP -0777 -ne 'print 0 + decode_json($_)->{pull_request}{number}' \
    "${GITHUB_EVENT_PATH:?names the file that tells of the pull request}")
head=$(perl -MJSON::PP -0777 -ne 'print decode_json($_)->{pull_request}{head}{sha}' "$GITHUB_EVENT_PATH")

git fetch --quiet --no-tags --no-recurse-submodules origin "+refs/pull/$number/head:refs/pull/$number/head"
if ! git cat-file -e "$head^{commit}"; then
    echo "grade.sh: pull request $number has moved on from $head, which is gone; its next run grades it." >&2
    exit 2
fi
# What follows needs no network, and no token.
git config --local --unset-all http.https://github.com/.extraheader || true

exec "$@" pull-request --repository "$PWD" --pass-from "${PASS_FROM:-60}" \
    --report "${REPORT:-pull-request-report}"
