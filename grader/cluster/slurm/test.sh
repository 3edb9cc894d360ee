#!/usr/bin/env bash
# test.sh COURSE GRADER: a real Slurm with two nodes on this machine grades the example class as a job
# array; one task is cancelled midway and requeued; the parts are merged, and must give the very
# marks of a local run. Exit code 77: Slurm is not installed, so nothing was tried.

set -euo pipefail
course=$1 grader=$2
for each in slurmctld slurmd sbatch scontrol munged mungekey; do
    if ! command -v "$each" > /dev/null; then
        echo "NOT RUN: $each is missing (packages slurm-wlm and munge)"
        exit 77
    fi
done
if ((EUID != 0)); then
    echo "NOT RUN: only root can start Slurm's daemons"
    exit 77
fi

work=$(mktemp -d "${TMPDIR:-/tmp}/slurm-test-XXXXXX")
daemons=()
stop() {
    local code=$?
    if ((code != 0)); then
        tail -n 30 "$work"/*.log "$work"/out/*.txt 2> /dev/null || true
    fi
    ((${#daemons[@]} == 0)) || kill "${daemons[@]}" 2> /dev/null || true
    wait
    rm -rf "$work"
    exit "$code"
}
trap stop EXIT

# wait_until SECONDS WHAT COMMAND…
wait_until() {
    local tenths=$(($1 * 10)) what=$2
    shift 2
    until "$@" > /dev/null 2>&1; do
        if ((tenths-- == 0)); then
            echo "gave up waiting until $what"
            return 1
        fi
        sleep 0.1
    done
}

host=$(hostname -s)
mkdir "$work/munge" "$work/state" "$work/out"
chmod 700 "$work/munge"
chmod 755 "$work"
mungekey --create --keyfile "$work/munge/key"
munged --foreground --force --key-file "$work/munge/key" --socket "$work/munge.socket" \
    --pid-file "$work/munge/pid" --seed-file "$work/munge/seed" --log-file "$work/munged.log" \
    2> "$work/munged.err.log" &
daemons+=($!)
port=$((20000 + $$ % 10000 * 4))  # below those that the system hands out
cat > "$work/slurm.conf" << END
ClusterName=course
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$port
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket=$work/munge.socket
CredType=cred/munge
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool-%n
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd-%n.pid
SlurmctldLogFile=$work/slurmctld.log
SlurmdLogFile=$work/slurmd-%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=batch_sched_delay=0,sched_min_interval=0
ReturnToService=2
JobRequeue=1
KillWait=5
NodeName=node1 NodeHostname=$host NodeAddr=127.0.0.1 Port=$((port + 1)) CPUs=1
NodeName=node2 NodeHostname=$host NodeAddr=127.0.0.1 Port=$((port + 2)) CPUs=1
PartitionName=all Nodes=node1,node2 Default=YES MaxTime=60 State=UP
END
echo "CgroupPlugin=cgroup/v1" > "$work/cgroup.conf"
export SLURM_CONF=$work/slurm.conf
wait_until 20 "munge answers" test -S "$work/munge.socket"
slurmctld -D -f "$SLURM_CONF" > "$work/slurmctld.out.log" 2>&1 &
daemons+=($!)
wait_until 60 "the controller answers" scontrol ping
for node in node1 node2; do
    slurmd -D -N "$node" -f "$SLURM_CONF" > "$work/$node.out.log" 2>&1 &
    daemons+=($!)
done
# shellcheck disable=SC2016 # expanded by the inner shell
wait_until 60 "both nodes are idle" sh -c 'test "$(sinfo -h -N -o %T | grep -c idle)" = 2'

class=$course/grader/examples/class
options=(--roster "$class/roster.csv" --times "$class/times.csv" --policy "$class/policy.json"
    --overrides "$class/overrides.csv" --quiet)
parts=3
# The array finds the grader where a course has it.
mkdir -p "$work/course/build/release"
ln -s "$(dirname "$grader")" "$work/course/build/release/grader"
job=$(sbatch --parsable --array=1-$parts --output="$work/out/%a.txt" \
    "$course/grader/cluster/slurm/array.sh" "$work/course" "$class/submissions" 06-rotation \
    "$work/out" 424242 "${options[@]}")
echo "job $job has $parts tasks on two nodes"

# One task is cancelled midway, and requeued.
wait_until 120 "task 1 has graded something" sh -c "ls $work/out/part-1/students/*/key"
scancel "${job}_1"
ended() {
    [[ -z $(squeue -h -t running,completing -j "${job}_1") ]]
}
wait_until 60 "task 1 is cancelled" ended
known=("$work"/out/part-1/students/*/key)
[[ ! -f $work/out/part-1/results.json ]] || echo "(task 1 had ended before it was cancelled)"
stat -c '%n %y' "${known[@]}" > "$work/known"
scontrol requeue "${job}_1"
scontrol update "JobId=${job}_1" StartTime=now  # it would wait for two minutes
echo "task 1 is cancelled after ${#known[@]} submissions, and requeued"
finished() {
    [[ -z $(squeue -h -j "$job") ]]
}
wait_until 600 "all tasks have ended" finished
for ((part = 1; part <= parts; ++part)); do
    [[ -f $work/out/part-$part/results.json ]] || {
        echo "part $part has no results"
        exit 1
    }
done
stat -c '%n %y' "${known[@]}" | diff "$work/known" - || {
    echo "what task 1 knew already was graded again"
    exit 1
}
"$grader" merge "$work"/out/part-* --out "$work/out/all"
"$grader" batch "$class/submissions" --assignment 06-rotation --out "$work/local" --seed 424242 \
    "${options[@]}"
diff "$work/local/results.csv" "$work/out/all/results.csv"
echo "the marks of the array are those of a local run"
