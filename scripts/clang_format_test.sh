#!/usr/bin/env bash
# clang_format_test.sh: every C++ file that git keeps is formatted as .clang-format says.
# Other versions of clang-format differ in details, so only version 14 (Debian 12's) is asked;
# without it the test ends with 77, which CTest shows as skipped.

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

skip() {
    echo "skipped: $1"
    exit 77
}

program=
for each in clang-format-14 clang-format; do
    if [[ $("$each" --version 2> /dev/null) == *"version 14."* ]]; then
        program=$each
        break
    fi
done
[[ -n $program ]] || skip "clang-format 14 is missing (Debian 12: apt-get install clang-format)"
git rev-parse --is-inside-work-tree > /dev/null 2>&1 ||
    skip "git does not call this folder a checkout, so which files are kept is unknown"

# A mistake is the inside of a function and stands alone in its file; students write as they like.
mapfile -d '' files < <(git ls-files -z -- '*.h' '*.cpp' ':!solutions/*/mistakes/*' ':!grader/tests/hostile/*' \
    ':!grader/examples/*')
((${#files[@]} > 0)) || { echo "git keeps no C++ file here: expected some"; exit 1; }
"$program" --dry-run -Werror "${files[@]}" ||
    { echo "format them: clang-format -i FILE"; exit 1; }
echo "${#files[@]} files are formatted"
