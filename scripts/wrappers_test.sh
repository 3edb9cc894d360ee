#!/usr/bin/env bash
# wrappers_test.sh: ./grade and ./test on a machine made of fakes. Each case has a checkout of its
# own (with a space in its path) that holds the wrappers and nothing else, and sees only the
# programs that it is given: fakes of apt-get, dpkg-query, sudo, id, cmake, ninja and ctest, which
# write down how they were called, and the few real ones that a shell script needs.

# shellcheck disable=SC2016 # what a fake is to expand, this script must not

set -euo pipefail

repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failures=0

# fake NAME: a program whose body comes from standard input. It finds the case's files in $case.
fake() {
    { echo '#!/usr/bin/env bash'; echo "case='$case'"; cat; } > "$case/bin/$1"
    chmod +x "$case/bin/$1"
}

# new_case NAME: a machine on which everything is installed, run by an ordinary user without sudo.
new_case() {
    case_name=$1
    case="$work/$1"
    checkout="$case/a checkout"
    browser_tests="$checkout/grader/browser_tests"
    mkdir -p "$case/bin" "$case/dpkg" "$checkout/build" "$browser_tests" "$checkout/grader/tests"
    touch -d '2021-01-01' "$browser_tests/package-lock.json"
    cp -r "$repository/grade" "$repository/test" "$repository/scripts" "$repository/.ci" "$checkout"
    local tool
    for tool in awk bash cat cp dirname env find flock grep mkdir nproc perl readlink rm sed sh stat \
        tail touch; do
        ln -s "$(command -v "$tool")" "$case/bin/$tool"
    done
    touch -d '2020-01-01' "$case/dpkg/status"
    : > "$case/absent"   # packages that are not installed
    : > "$case/calls"    # what the fakes were called with
    echo 1000 > "$case/uid"
    fake id <<< 'cat "$case/uid"'
    # Knows every package that was asked for, less the absent ones; fails when there are any.
    fake dpkg-query <<'END'
echo dpkg-query >> "$case/calls"
shift 3
code=0
for package in "$@"; do
    if grep -qx "$package" "$case/absent"; then code=1; else echo "$package installed"; fi
done
exit $code
END
    fake apt-get <<'END'
echo "apt-get $*" >> "$case/calls"
[[ ! -f $case/apt-fails ]] || { echo "E: Unable to locate package"; exit 100; }
[[ $* != *install* ]] || : > "$case/absent"
END
    fake cmake <<'END'
echo "cmake $* in $PWD" >> "$case/calls"
[[ ! -f $case/cmake-fails ]] || { echo "CMake Error: no such compiler"; exit 1; }
mkdir -p build/release/grader
echo "CMAKE_HOME_DIRECTORY:INTERNAL=$PWD" > build/release/CMakeCache.txt
touch build/release/build.ninja
cp "$case/bin/grader" build/release/grader/grader
END
    fake ninja <<'END'
echo "ninja $*" >> "$case/calls"
[[ ! -f $case/ninja-fails ]] || { echo "FAILED: grader.o"; echo "the first error"; exit 1; }
[[ ! -f $case/work ]] || { rm "$case/work"; echo "[1/1] Linking grader"; exit; }
echo "ninja: Entering directory"
echo "ninja: no work to do."
END
    fake npm <<'END'
echo "npm $* in $PWD" >> "$case/calls"
[[ ! -f $case/npm-fails ]] || { echo "npm error network"; exit 1; }
mkdir -p node_modules
touch node_modules/.package-lock.json
END
    fake ctest <<< 'echo "ctest $* in $PWD" >> "$case/calls"; exit 8'
    fake grader <<'END'
printf 'grader:%s in %s\n' "$(printf ' <%s>' "$@")" "$PWD" >> "$case/calls"
[[ $* != *lost* ]] || exit 1
END
}

with_sudo() {
    fake sudo <<< 'echo "sudo" >> "$case/calls"; echo 0 > "$case/uid"; exec "$@"'
}

# run FOLDER COMMAND...: runs it there, as this machine; sets $code and $output.
run() {
    local folder=$1
    shift
    code=0
    output=$(cd "$folder" && env -i PATH="$case/bin" DPKG_ADMINDIR="$case/dpkg" "$@" \
        2>&1 < /dev/null) || code=$?
    [[ $output != *"stopped at line"* ]] || complain "a command failed that nobody expected to"
}

complain() {
    failures=$((failures + 1))
    printf 'FAILED in case %s: %s\noutput was:\n%s\ncalls were:\n%s\n\n' "$case_name" "$1" \
        "$output" "$(cat "$case/calls")"
}
expect_code() { [[ $code == "$1" ]] || complain "exit code $code, expected $1"; }
expect_output() { [[ $output == *"$1"* ]] || complain "expected the output to hold: $1"; }
expect_silence() { [[ -z $output ]] || complain "expected no output"; }
expect_call() { grep -qxF -- "$1" "$case/calls" || complain "expected the call: $1"; }
expect_no_call() { ! grep -q "^$1" "$case/calls" || complain "expected no call of $1"; }
forget_calls() { : > "$case/calls"; }

new_case first_run_builds_then_grades
run "$checkout" ./grade
expect_code 0
expect_output "Building the grader (the first time takes about"
expect_call "cmake --preset release in $checkout"
expect_call "grader: <> in $checkout"
expect_no_call apt-get

# The second time nothing is asked, configured or said; arguments arrive as they are, and the
# grader runs where the user is, so that a folder of theirs means the same to it.
forget_calls
mkdir "$case/somewhere else"
run "$case/somewhere else" "$checkout/grade" --submission "my files" --yes '*' ''
expect_code 0
expect_silence
expect_no_call dpkg-query
expect_no_call cmake
expect_call "grader: <--submission> <my files> <*> <> in $case/somewhere else"

# A change of the sources is built, with one line.
touch "$case/work"
run "$checkout" ./grade
expect_code 0
expect_output "Building the grader"

# A link to the wrapper is the wrapper.
ln -s "$checkout/grade" "$case/link"
run "$case" ./link 07-camera
expect_code 0
expect_call "grader: <07-camera> in $case"

# The grader's verdict is the exit code.
run "$checkout" ./grade lost
expect_code 1

# What dpkg knows is asked again as soon as its list has changed.
forget_calls
touch -d tomorrow "$case/dpkg/status"
run "$checkout" ./grade
expect_call dpkg-query
expect_no_call apt-get

new_case without_rights_one_line_to_type
printf 'g++\nlibglm-dev\n' > "$case/absent"
run "$checkout" ./grade
expect_code 2
expect_output "su -c 'apt-get update && apt-get install -y --no-install-recommends g++ libglm-dev'"
expect_no_call apt-get
expect_no_call cmake

new_case nobody_to_ask
with_sudo
echo mold > "$case/absent"
run "$checkout" ./grade
expect_code 2
expect_output "sudo sh -c 'apt-get update && apt-get install -y --no-install-recommends mold'"
expect_no_call sudo
run "$checkout" ./grade --yes 06-rotation
expect_code 0
expect_call sudo
expect_call "apt-get -q install -y --no-install-recommends mold"
expect_call "grader: <06-rotation> in $checkout"

new_case root_is_not_asked
echo 0 > "$case/uid"
printf 'xvfb\nmold\n' > "$case/absent"
run "$checkout" ./grade
expect_code 0
expect_call "apt-get -q install -y --no-install-recommends mold"

new_case tests_want_more_packages
echo 0 > "$case/uid"
printf 'xvfb\nmold\n' > "$case/absent"
run "$checkout" ./test -R 'common|style'
expect_code 8  # as CTest says
expect_call "apt-get -q install -y --no-install-recommends mold xvfb"
expect_call "ctest --preset release -R common|style in $checkout"

new_case the_browsers_driver_is_installed_when_its_lock_file_changed
run "$checkout" ./test
expect_code 8
expect_output "driver of the browser tests"
expect_call "npm ci --ignore-scripts in $browser_tests"
forget_calls
run "$checkout" ./test
expect_no_call npm
touch -d tomorrow "$browser_tests/package-lock.json"
run "$checkout" ./test
expect_call "npm ci --ignore-scripts in $browser_tests"

new_case the_browsers_driver_cannot_be_had
touch "$case/npm-fails"
run "$checkout" ./test
expect_code 2
expect_output "npm error network"
expect_output "needs the network once"
expect_no_call cmake
expect_no_call ctest

new_case students_need_no_browser
run "$checkout" ./grade
expect_code 0
expect_no_call npm

new_case the_students_copy_has_no_tests_of_browsers_and_clusters
rm -r "$checkout/grader"
echo 0 > "$case/uid"
printf 'chromium\nclang\nmunge\nnodejs\nxvfb\n' > "$case/absent"
run "$checkout" ./test
expect_code 8
expect_call "apt-get -q install -y --no-install-recommends xvfb"
expect_no_call npm

new_case npm_comes_with_node_or_as_a_package
echo 0 > "$case/uid"
printf 'chromium\nnodejs\nnpm\n' > "$case/absent"
run "$checkout" ./test
expect_call "apt-get -q install -y --no-install-recommends nodejs chromium"
mv "$case/bin/npm" "$case/npm"
fake apt-get <<'END'
echo "apt-get $*" >> "$case/calls"
[[ $* != *install* ]] || { : > "$case/absent"; cp "$case/npm" "$case/bin/npm"; }
END
echo npm > "$case/absent"
run "$checkout" ./test
expect_code 8
expect_call "apt-get -q install -y --no-install-recommends npm"

new_case continuous_integration
fake ctest <<'END'
echo "ctest $*, CI=$CI" >> "$case/calls"
echo "1/3 Test  #1: common.quick ....   Passed    0.02 sec"
echo "2/3 Test  #2: common.slow .....***Failed   10.50 sec"
echo "3/3 Test #30: common.medium ...   Passed    9.00 sec"
printf '\n67%% tests passed, 1 tests failed out of 3\n\nTotal Test time (real) =  19.52 sec\n'
exit 8
END
run "$case" "$checkout/.ci/run"
expect_code 8
expect_call "ctest --preset release, CI=true"
expect_output "The slowest tests:
  2/3 Test  #2: common.slow .....***Failed   10.50 sec
  3/3 Test #30: common.medium ...   Passed    9.00 sec
  1/3 Test  #1: common.quick ....   Passed    0.02 sec

67% tests passed, 1 tests failed out of 3

Total Test time (real) =  19.52 sec"

new_case apt_fails
echo 0 > "$case/uid"
echo mold > "$case/absent"
touch "$case/apt-fails"
run "$checkout" ./grade
expect_code 2
expect_output "Unable to locate package"
expect_output "apt-get install -y --no-install-recommends mold"

new_case no_apt
rm "$case/bin/apt-get" "$case/bin/dpkg-query"
run "$checkout" ./grade
expect_code 0
expect_output "Needed are the counterparts of: g++ cmake"

new_case configuring_fails
touch "$case/cmake-fails"
run "$checkout" ./grade
expect_code 2
expect_output "CMake Error: no such compiler"

new_case building_fails
touch "$case/ninja-fails"
run "$checkout" ./grade
expect_code 2
expect_output "the first error"
expect_output "the system was upgraded"
expect_no_call grader
rm "$case/ninja-fails"
run "$checkout" ./grade
expect_code 0

new_case moved_checkout
run "$checkout" ./grade
mv "$checkout" "$case/moved"
touch "$case/moved/build/release/left-over"
run "$case/moved" ./grade
expect_code 0
expect_output "built in another place"
expect_call "cmake --preset release in $case/moved"
[[ ! -e $case/moved/build/release/left-over ]] || complain "expected the old build folder to be gone"
forget_calls
run "$case/moved" ./grade
expect_silence
expect_no_call cmake

new_case copied_cache_without_a_trace
mkdir -p "$checkout/build/release"
echo "CMAKE_HOME_DIRECTORY:INTERNAL=/elsewhere" > "$checkout/build/release/CMakeCache.txt"
touch "$checkout/build/release/left-over"
run "$checkout" ./grade
expect_code 0
expect_output "built in another place"
[[ ! -e $checkout/build/release/left-over ]] || complain "expected the old build folder to be gone"

new_case configured_by_hand
mkdir -p "$checkout/build/release"
echo "CMAKE_HOME_DIRECTORY:INTERNAL=$checkout" > "$checkout/build/release/CMakeCache.txt"
touch "$checkout/build/release/kept"
run "$checkout" ./grade
expect_code 0
[[ -e $checkout/build/release/kept ]] || complain "expected the build folder to be kept"

new_case two_at_once
mkdir -p "$checkout/build/release"
(exec 8> "$checkout/build/release/lock"; flock 8; sleep 2) &
until ! flock -n "$checkout/build/release/lock" true; do
    kill -0 $! || break
    sleep 0.01
done
run "$checkout" ./grade
wait
expect_code 0
expect_output "waiting for it"

new_case paths_that_break_the_build_tools
for name in "it's" 'a & b' 'c#' 'x[1]' 'what?' 'a;b' '50$' 'a]b' 'a\b' $'tab\t'; do
    mv "$checkout" "$case/$name"
    checkout="$case/$name"
    run "$checkout" ./grade
    expect_code 2
    expect_output "Move or rename the folder"
    expect_no_call cmake
done
for name in 'course (1)' 'Übung' 'a+b,c=d@e~f!%{}'; do
    mv "$checkout" "$case/$name"
    checkout="$case/$name"
    run "$checkout" ./grade
    expect_code 0
done

new_case doubts
while IFS=: read -r name doubt; do
    output=$(source "$repository/scripts/packages.sh" && doubt_about "$name")
    expect_output "$doubt"
    [[ -n $doubt ]] || expect_silence
done <<'END'
debian 12:
debian 13:tried on debian 13 once
ubuntu 24.04:nobody has tried them there
fedora 40:are Debian's
END

# The test of the students' copy, up to where it calls the grader.
new_case the_students_copy_is_made_of_a_commit_whoever_it_belongs_to
students_copy() {
    code=0
    output=$(CI=$1 "$repository/grader/tests/students_copy_test.sh" "$checkout" false 2>&1) || code=$?
}
students_copy false
expect_code 77
students_copy true
expect_code 1
expect_output "git has no commit of $checkout"
git -C "$checkout" init -q
git -C "$checkout" -c user.name=A -c user.email=a@example.org commit -q --allow-empty -m "A commit"
[[ $(id -u) != 0 ]] || chown -R 65534 "$checkout"
students_copy true
expect_code 1
expect_output "two copies are the same"

if [[ $(id -u) != 0 ]]; then
    new_case somebody_elses_build
    mkdir -p "$checkout/build/release"
    chmod a-w "$checkout/build/release"
    run "$checkout" ./grade
    chmod u+w "$checkout/build/release"
    expect_code 2
    expect_output "not yours to write"
fi

((failures == 0)) || exit 1
echo "passed"
