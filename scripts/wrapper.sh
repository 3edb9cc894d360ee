# shellcheck shell=bash
# Sourced by ./grade and ./test: what both begin with. The steps are
#   start NAME ARGUMENT...    sets $me, $root, $build, $system, $yes and $arguments
#   ensure_packages ...       packages.sh
#   build_targets ...         build.sh
# and then the program takes the place of the shell. A run with nothing to do must stay under
# 0.1 s and silent, so every step first looks for the trace that it left the last time.

source "${BASH_SOURCE[0]%/*}/packages.sh"
source "${BASH_SOURCE[0]%/*}/build.sh"

start() {
    trap unexpected_failure ERR
    me=$1
    shift
    root=$(readlink -f "${BASH_SOURCE[0]%/*}/..")
    build=$root/build/release
    refuse_odd_path
    yes=no
    arguments=()
    local argument
    for argument in "$@"; do
        if [[ $argument == --yes ]]; then
            yes=yes
        else
            arguments+=("$argument")
        fi
    done
    read_system /etc/os-release
    prepare_build_folder
}

# 1 would mean that something was graded. The command itself has said what is wrong.
unexpected_failure() {
    echo "$me: stopped at line $(caller)" >&2
    exit 2
}

# In a folder with such a character in its path, CMake fails, or Ninja misreads what depends on what
# and builds everything every time. Spaces, (1) and letters of any language are fine.
refuse_odd_path() {
    local odd=$'\'"&#;*?|\\^<>`$[]\t\n'
    [[ $root == *["$odd"]* ]] || return 0
    echo "$me: the path of this folder has one of the characters ' \" & # ; * ? | \\ ^ < > \` \$ [ ]," \
        "which the build tools cannot handle: $root" >&2
    echo "Move or rename the folder, then run $me again." >&2
    exit 2
}
