# shellcheck shell=bash
# Sourced by ./grade and ./test: the release build, silent where nothing changed.
# Wants what start (wrapper.sh) sets.

# prepare_build_folder: makes it, and holds its lock (descriptor 9) until close_build_folder, so
# that two terminals do not build at once.
prepare_build_folder() {
    local file
    mkdir -p "$build" 2> /dev/null || own_folder_needed
    for file in "$build" "$build/lock" "$build/build.log" "$build/build.ninja"; do
        [[ -w $file || ! -e $file ]] || own_folder_needed
    done
    exec 9> "$build/lock"
    if ! flock -n 9; then
        echo "Another ./grade or ./test builds here: waiting for it ..." >&2
        flock 9
    fi
}

close_build_folder() { exec 9>&-; }

own_folder_needed() {
    echo "$me: $build is not yours to write. If somebody else built there (root?), they can remove" \
        "it: rm -r '$root/build'. Or work in a copy of this folder that belongs to you." >&2
    exit 2
}

# describe_origin: sets $origin, what a build folder must be thrown away for when it changes: the
# place of the checkout, the system, the compiler.
describe_origin() {
    local compiler
    compiler=$(command -v c++) || compiler=none
    origin="$root | $system | $(stat -L -c '%s bytes of %Y' "$compiler" 2> /dev/null || true)"
}

# A build folder that was copied or moved with its checkout, or made by another system's compiler,
# fails in ways that nobody understands. It is emptied, so that the next step makes it anew.
discard_foreign_build() {
    local found='' home
    [[ ! -f $build/origin ]] || IFS= read -r found < "$build/origin" || true
    [[ $found != "$origin" ]] || return 0
    rm -f "$build/origin"
    [[ -f $build/CMakeCache.txt ]] || return 0
    home=$(sed -n 's/^CMAKE_HOME_DIRECTORY:INTERNAL=//p' "$build/CMakeCache.txt")
    # Without a trace of ours but in the right place, somebody typed cmake --preset release.
    if [[ -n $found || ! $home -ef $root ]]; then
        echo "$build was built in another place or by another system: building it afresh." >&2
        find "$build" -mindepth 1 -maxdepth 1 ! -name lock ! -name 'packages*' -exec rm -rf {} +
    fi
}

# A compiler wants up to 1 GiB here, so memory bounds the number of jobs. Sets $jobs.
count_jobs() {
    local key value
    jobs=$(nproc)
    while read -r key value _; do
        if [[ $key == MemAvailable: ]]; then
            ((value / 1048576 >= jobs)) || jobs=$((value / 1048576))
            break
        fi
    done < /proc/meminfo
    ((jobs > 0)) || jobs=1
}

# report_build_failure: the log from its first error on, and what to do next.
report_build_failure() {
    awk '/^FAILED:|CMake Error/ { found = 1 } found && ++lines <= 60 { print }
         END { exit !found }' "$build/build.log" >&2 || tail -n 60 "$build/build.log" >&2
    echo "$me: the build failed, see above (all of it: $build/build.log)." >&2
    echo "If the system was upgraded since the last build: rm -r '$build', then $me again." >&2
    exit 2
}

# say_once: one line before the first real step of a build. Not on standard output: that is the
# program's own (./grade --json -).
say_once() {
    [[ -z ${said:-} ]] || return 0
    said=yes
    echo "$1" >&2
}

# build_targets WHAT MINUTES TARGET...: configures where that is needed, then builds. MINUTES is
# what a first build costs one processor.
build_targets() {
    local what=$1 minutes=$2 sentence line log=$build/build.log
    shift 2
    describe_origin
    discard_foreign_build
    count_jobs
    sentence="Building $what (the first time takes about $((minutes / jobs + 1)) minutes) ..."
    : > "$log"
    if [[ ! -f $build/build.ninja || ! -f $build/origin ]]; then
        say_once "$sentence"
        (cd "$root" && cmake --preset release) >> "$log" 2>&1 || report_build_failure
    fi
    # The first step that ninja names is real work: all but those that it always makes. The fuzzers'
    # project (Fuzzers.cmake) is one of these, and builds silently.
    ninja -C "$build" -j "$jobs" "$@" 2>&1 < /dev/null | while IFS= read -r line; do
        printf '%s\n' "$line" >> "$log"
        case $line in
            "ninja: "* | *"Re-checking globbed directories"* | *" 'fuzzers'") ;;
            *) say_once "$sentence" ;;
        esac
    done || report_build_failure
    [[ -f $build/origin ]] || printf '%s\n' "$origin" > "$build/origin"
}
