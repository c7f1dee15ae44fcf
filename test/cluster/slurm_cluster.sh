#!/bin/bash
# SPDX-FileCopyrightText: 2026 the linelet authors
# SPDX-License-Identifier: BSD-3-Clause
#
# slurm_cluster.sh COMMAND...: starts a Slurm cluster on this machine, runs COMMAND, and
# stops the cluster. Needs root and the packages slurm-wlm and munge. It uses its own key
# and folders and listens on the loopback device only.
set -euo pipefail
dir=$(mktemp -d)
chmod 755 "$dir"
pids=()
finish() {
  for pid in "${pids[@]}"; do kill "$pid" 2> /dev/null || true; done
  wait 2> /dev/null || true
  rm -rf "$dir"
}
trap finish EXIT

export SLURM_CONF=$dir/slurm.conf
mkdir -m 700 "$dir/munge"
head -c 1024 /dev/urandom > "$dir/munge/key"
chmod 400 "$dir/munge/key"
chown -R munge: "$dir/munge"
chmod 755 "$dir/munge"
socket=$dir/munge/socket
runuser -u munge -- munged --foreground --socket="$socket" --key-file="$dir/munge/key" \
  --pid-file="$dir/munge/pid" --seed-file="$dir/munge/seed" \
  --log-file="$dir/munge/log" 2> "$dir/munged.err" &
pids+=($!)

name=$(hostname -s)
cat > "$SLURM_CONF" << END
ClusterName=one
SlurmctldHost=$name(127.0.0.1)
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket=$socket
CredType=cred/munge
SlurmctldPort=16817
SlurmdPort=16818
SlurmctldPidFile=$dir/slurmctld.pid
SlurmdPidFile=$dir/slurmd.pid
SlurmctldLogFile=$dir/slurmctld.log
SlurmdLogFile=$dir/slurmd.log
SlurmdSpoolDir=$dir/spool
StateSaveLocation=$dir/state
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
JobRequeue=1
ReturnToService=2
NodeName=$name NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=$name Default=YES MaxTime=INFINITE State=UP
END
mkdir "$dir/spool" "$dir/state"
for _ in $(seq 100); do [ -S "$socket" ] && break; sleep 0.1; done
slurmctld -D -c 2> "$dir/slurmctld.err" &
pids+=($!)
slurmd -D 2> "$dir/slurmd.err" &
pids+=($!)
for _ in $(seq 300); do
  [ "$(sinfo -h -o %T 2> /dev/null || true)" = idle ] && break
  sleep 0.1
done
if [ "$(sinfo -h -o %T)" != idle ]; then
  tail "$dir"/*.log >&2
  exit 1
fi
"$@"
