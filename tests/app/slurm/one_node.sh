#!/usr/bin/env bash
# one_node.sh start FOLDER PID   starts a Slurm of one node of its own (slurmctld, slurmd, munged) with all its files in FOLDER, and
#                                returns when it takes jobs with FOLDER/slurm.conf; it ends with the process PID at the latest
# one_node.sh stop FOLDER        ends it
# Needs root, as slurmd does; touches no other Slurm, no service and no file outside FOLDER.
set -euo pipefail
usage() {
    echo "usage: one_node.sh start FOLDER PID | stop FOLDER" >&2
    exit 2
}

[ $# -ge 2 ] || usage
folder=$2
owner=${3-}
# Daemons in sbin are not on everybody's path.
PATH=$PATH:/usr/sbin:/sbin

# A port that nobody listens on.
free_port() {
    python3 -c 'import socket; s = socket.socket(); s.bind(("", 0)); print(s.getsockname()[1])'
}

end_daemon() {
    local pid
    pid=$(cat "$1" 2>/dev/null) || return 0
    kill "$pid" 2>/dev/null || return 0
    for _ in $(seq 100); do
        kill -0 "$pid" 2>/dev/null || return 0
        sleep 0.1
    done
    kill -9 "$pid" 2>/dev/null || true
}

start() {
    mkdir -p "$folder"/{state,spool,munge}
    chmod 700 "$folder" "$folder/munge"
    dd if=/dev/urandom of="$folder/munge/key" bs=128 count=1 2>/dev/null
    chmod 600 "$folder/munge/key"
    munged --force --key-file="$folder/munge/key" --socket="$folder/munge/socket" --pid-file="$folder/munge/pid" \
        --log-file="$folder/munge/log" --seed-file="$folder/munge/seed"
    local host memory
    host=$(hostname -s)
    memory=$(($(awk '/^MemTotal/ {print $2}' /proc/meminfo) / 1024))
    cat >"$folder/slurm.conf" <<CONF
ClusterName=rubble
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$(free_port)
SlurmdPort=$(free_port)
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket=$folder/munge/socket
CredType=cred/munge
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
MessageTimeout=30
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU_Memory
SchedulerParameters=sched_interval=1,batch_sched_delay=0
JobAcctGatherType=jobacct_gather/linux
JobAcctGatherFrequency=task=1
JobAcctGatherParams=OverMemoryKill
PreemptType=preempt/partition_prio
PreemptMode=REQUEUE
KillWait=2
ReturnToService=2
NodeName=$host NodeAddr=127.0.0.1 CPUs=2 RealMemory=$memory State=UNKNOWN
PartitionName=main Nodes=$host Default=YES MaxTime=INFINITE State=UP
PartitionName=urgent Nodes=$host MaxTime=INFINITE State=UP PriorityTier=10
CONF
    export SLURM_CONF=$folder/slurm.conf
    slurmctld -c -f "$SLURM_CONF"
    slurmd -c -f "$SLURM_CONF"
    # However long a busy machine takes: only a daemon that has ended, or a test that has, makes waiting vain.
    while [ "$(sinfo --noheader --format=%T 2>/dev/null)" != idle ]; do
        if ! runs slurmctld || ! runs slurmd || ! kill -0 "$owner" 2>/dev/null; then
            return 1
        fi
        sleep 0.2
    done
}

# A daemon has written its process down and lives, or is still on its way to that (a minute at most).
runs() {
    local pid
    for _ in $(seq 300); do
        pid=$(cat "$folder/$1.pid" 2>/dev/null) && [ -n "$pid" ] && break
        sleep 0.2
    done
    [ -n "$pid" ] && kill -0 "$pid" 2>/dev/null
}

tell_logs() {
    echo "the node did not come up: a daemon ended; the logs:" >&2
    tail -n 20 "$folder"/*.log >&2
}

stop() {
    end_daemon "$folder/slurmd.pid"
    end_daemon "$folder/slurmctld.pid"
    end_daemon "$folder/munge/pid"
}

case $1 in
    start)
        [ -n "$owner" ] || usage
        # A port that was free may be taken by another program before a daemon has it: then with others.
        start || { stop; start; } || { tell_logs; stop; exit 1; }
        # A test that is killed leaves no daemons.
        (while kill -0 "$owner" 2>/dev/null; do sleep 1; done; stop) </dev/null >/dev/null 2>&1 &
        ;;
    stop) stop ;;
    *) usage ;;
esac
