#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# A real Slurm, private to this test, runs four shards on two nodes; one is killed and requeued; merged they are what
# one run is.
set -euo pipefail

export DAYLIGHT=$1
here=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")
PATH=$PATH:/usr/sbin
for program in slurmctld slurmd munged sbatch; do
  command -v "$program" >/dev/null || exec "$here/../../.ci/skip" "no $program here: apt-get install slurmctld slurmd slurm-client munge"
done
# shellcheck source=SCRIPTDIR/same_run.sh
source "$here/same_run.sh"

scratch=$(mktemp -d)
pids=()
stop() {
  scancel --user="$(id -un)" >/dev/null 2>&1 || true
  local pid
  for file in "$scratch"/run/*.pid "$scratch"/munge/pid; do
    [[ -s $file ]] && pids+=("$(<"$file")")
  done
  for pid in "${pids[@]}"; do kill "$pid" 2>/dev/null || true; done
  for pid in "${pids[@]}"; do
    for _ in {1..100}; do kill -0 "$pid" 2>/dev/null && sleep 0.1; done
    kill -KILL "$pid" 2>/dev/null || true
  done
  rm -rf -- "$scratch"
}
trap stop EXIT
cd -- "$scratch"
mkdir munge state run log
chmod 755 "$scratch"
chmod 700 munge

read -r ctl one two < <(python3 -c '
import socket
sockets = [socket.socket() for _ in range(3)]
for s in sockets: s.bind(("127.0.0.1", 0))
print(*[s.getsockname()[1] for s in sockets])')
host=$(hostname -s) user=$(id -un)
cat >slurm.conf <<CONF
ClusterName=test
SlurmctldHost=$host(127.0.0.1)
SlurmUser=$user
SlurmdUser=$user
AuthType=auth/munge
AuthInfo=socket=$scratch/munge/sock
CryptoType=crypto/munge
SlurmctldPort=$ctl
StateSaveLocation=$scratch/state
SlurmdSpoolDir=$scratch/spool-%n
SlurmctldPidFile=$scratch/run/slurmctld.pid
SlurmdPidFile=$scratch/run/slurmd-%n.pid
SlurmctldLogFile=$scratch/log/slurmctld.log
SlurmdLogFile=$scratch/log/slurmd-%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerType=sched/builtin
MpiDefault=none
ReturnToService=2
MessageTimeout=100
BatchStartTimeout=300
NodeName=n1 NodeHostname=$host NodeAddr=127.0.0.1 Port=$one CPUs=1 State=UNKNOWN
NodeName=n2 NodeHostname=$host NodeAddr=127.0.0.1 Port=$two CPUs=1 State=UNKNOWN
PartitionName=night Nodes=n1,n2 Default=YES MaxTime=INFINITE State=UP
CONF
# No job uses cgroups; the default, to detect their version, fails without a cgroup file system, as in a chroot.
echo 'CgroupPlugin=cgroup/v1' >cgroup.conf
export SLURM_CONF=$scratch/slurm.conf
unset "${!SLURM_JOB@}" "${!SBATCH_@}"
(umask 077 && head -c 1024 /dev/urandom >munge/key)
munged --force --key-file="$scratch/munge/key" --socket="$scratch/munge/sock" --pid-file="$scratch/munge/pid" \
  --log-file="$scratch/munge/log" --seed-file="$scratch/munge/seed" 2>/dev/null
# A daemon that does not start says why in its log alone.
start() { "$@" -f "$SLURM_CONF" || { tail -n 20 log/*; exit 1; }; }
start slurmctld
start slurmd -N n1
start slurmd -N n2
# until_true NAME COMMAND.. : within a quarter of an hour.
until_true() {
  local name=$1
  shift
  for _ in {1..4500}; do
    if "$@"; then return; fi
    sleep 0.2
  done
  echo "never: $name"
  squeue || true
  tail -n 20 log/* out/*.log || true
  exit 1
}
idle() { [[ $(sinfo -h -t idle -o %D 2>/dev/null) == 2 ]]; }
until_true 'two nodes' idle

run=(--seed 7 --pairs 100000 --methods intersect,fcl-libccd,bullet --families tiny_and_huge,random --cases '')
"$DAYLIGHT" campaign "${run[@]}" --out whole >/dev/null 2>&1 || [[ $? == 2 ]]
read -r array merge < <("$here/submit.sh" 4 out "${run[@]}")
kill_shard "$scratch/out" 1
requeue() { scontrol requeue "${array}_1" 2>/dev/null; }
until_true 'the killed one is requeued' requeue
# Slurm holds a requeued job back for two minutes, in case its node is ill: asked again, it lets it go.
over() {
  scontrol update "JobId=${array}_1" StartTime=now >/dev/null 2>&1 || true
  [[ -z $(squeue -h -j "$array,$merge" 2>/dev/null) ]]
}
until_true 'all jobs end' over
grep -q '^incomplete' out/merge.log && { cat out/merge.log; exit 1; }
grep -qE '^pairs: 100000, ' out/merge.log || { cat out/*.log; exit 1; }
same_run whole out
