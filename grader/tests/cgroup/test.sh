#!/usr/bin/env bash
# test.sh COURSE UNIT_TESTS GRADER: what cgroups do, on a kernel that surely has them. Linux as an
# ordinary program (package user-mode-linux) starts with the files of this machine, which it cannot
# change, and runs there the tests of cgroups, the doctor and an honest submission: first as root, then
# as a user who was given a cgroup. Exit code 77: it was not tried, and why.
#
# In there this script is the first process, and knows it by its number.

set -euo pipefail
done_line="everything about cgroups holds"

not_run() {
    echo "NOT RUN: $1"
    exit 77
}

outside() {
    local grader=$3 linux output
    linux=$(command -v linux.uml) || not_run "linux.uml is missing (package user-mode-linux)"
    [[ $1$2$3 != *" "* ]] ||
        not_run "a path with a space does not fit into a kernel's command line"
    # In there compilers are slow: what they make comes out of the object cache, filled here.
    "$grader" 06-rotation --submission "$1/solutions" > /dev/null
    # What follows -- are arguments of the first process.
    output=$(timeout --kill-after 5 240 "$linux" root=/dev/root rootfstype=hostfs rootflags=/ ro \
        mem=2G quiet loglevel=1 con=null con0=null,fd:1 "init=$(readlink -f "$0")" -- "$@" \
        < /dev/null 2>&1 | tr -d '\r' | tee >(cat >&2))
    if [[ $output != *"$done_line"* ]]; then
        echo "not everything was as it must be: see above"
        exit 1
    fi
}

# as_user COMMAND…: in a cgroup that the user may divide up, as systemd gives it with Delegate=yes, and
# alone there.
as_user() (
    given=/sys/fs/cgroup/given-$BASHPID
    mkdir "$given"
    chown 1000:1000 "$given" "$given"/cgroup.{procs,subtree_control}
    echo "$BASHPID" > "$given/cgroup.procs"
    exec setpriv --reuid 1000 --regid 1000 --clear-groups "$@"
)

# run_all AS…: all that is to be seen, by that user.
run_all() {
    local said
    said=$("$@" "$unit_tests" --gtest_filter='RealCgroup.*' --gtest_brief=1 2>&1) || true
    echo "$said"
    [[ $said == *"[  PASSED  ] "[1-9]* && $said != *FAILED* && $said != *SKIPPED* ]]
    { "$@" "$grader" doctor || true; } | grep '✓ limits on memory and threads in sum'
    "$@" "$grader" 06-rotation --submission solutions
}

inside() {
    course=$1 unit_tests=$2 grader=$3
    export PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/tmp LANG=C.UTF-8
    mount -t proc proc /proc
    mount -t sysfs sys /sys
    mount -t cgroup2 none /sys/fs/cgroup
    mount -t devtmpfs dev /dev 2> /dev/null || true
    mkdir -p /dev/pts /dev/shm
    mount -t devpts pts /dev/pts
    local each
    for each in /dev/shm /tmp /run /var/cache; do
        mount -t tmpfs -o mode=1777 none "$each"
    done
    ip link set lo up
    cd "$course"

    echo "== root"
    run_all env

    echo "+memory +pids" > /sys/fs/cgroup/cgroup.subtree_control
    if as_user test -x "$grader"; then
        echo "== a user with a cgroup"
        run_all as_user
    else
        echo "== not tried as an ordinary user, who cannot reach $grader"
    fi
    echo "$done_line"
}

if (($$ != 1)); then
    outside "$@"
    exit
fi
set +e
(
    set -e
    inside "$@"
)
# The first process must not end before the machine does.
echo o > /proc/sysrq-trigger
sleep 10
