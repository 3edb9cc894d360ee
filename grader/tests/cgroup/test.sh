#!/usr/bin/env bash
# test.sh COURSE UNIT_TESTS GRADER HOSTILE: what cgroups do, on a kernel that surely has them. Linux as
# an ordinary program (package user-mode-linux) starts with the files of this machine, which it cannot
# change, and runs the tests of cgroups, an honest submission and a greedy one: first as root, then as
# a user who was given a cgroup. Exit code 77: that program is not here, so nothing was tried.
#
# In there, this script is the first process, and knows it by its number.

set -euo pipefail
attack=run-children-eat-memory
done_line="everything about cgroups holds"

outside() {
    local grader=$3 hostile=$4 linux output
    if ! linux=$(command -v linux.uml); then
        echo "NOT RUN: linux.uml is missing (package user-mode-linux)"
        exit 77
    fi
    # In there compilers are slow: what they make comes out of the object cache, filled here.
    "$grader" 06-rotation --submission solutions > /dev/null
    "$hostile" --only "$attack" > /dev/null
    # What follows -- are arguments of the first process.
    output=$(timeout --kill-after 5 240 "$linux" root=/dev/root rootfstype=hostfs rootflags=/ ro \
        mem=3G quiet loglevel=1 con=null con0=null,fd:1 "init=$(readlink -f "$0")" -- "$@" \
        < /dev/null 2>&1 | tr -d '\r' | tee /dev/stderr)
    [[ $output == *"$done_line"* ]] || { echo "not everything was as it must be: see above" && exit 1; }
}

# as_user COMMAND…: in the cgroup that the user was given, and alone there.
as_user() (
    echo "$BASHPID" > /sys/fs/cgroup/given/cgroup.procs
    exec setpriv --reuid 1000 --regid 1000 --clear-groups "$@"
)

# run_all WHO AS…: the tests, by that user.
run_all() {
    local who=$1 said
    shift
    echo "== $who"
    said=$("$@" "$unit_tests" --gtest_filter='RealCgroup.*' --gtest_brief=1 2>&1) || true
    echo "$said"
    [[ $said == *"[  PASSED  ] "[1-9]* && $said != *SKIPPED* ]]
    { "$@" "$grader" doctor || true; } | grep '✓ limits on memory and threads in sum'
    "$@" "$grader" 06-rotation --submission solutions --json /tmp/result.json
    rm /tmp/result.json
}

inside() {
    course=$1 unit_tests=$2 grader=$3 hostile=$4
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

    run_all "root" env
    "$hostile" --only "$attack"

    # A cgroup that an ordinary user may divide up, as systemd gives it with Delegate=yes.
    echo "+memory +pids" > /sys/fs/cgroup/cgroup.subtree_control
    mkdir /sys/fs/cgroup/given
    chown 1000:1000 /sys/fs/cgroup/given /sys/fs/cgroup/given/cgroup.{procs,subtree_control}
    run_all "a user with a cgroup" as_user
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
