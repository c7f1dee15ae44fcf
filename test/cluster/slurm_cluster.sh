#!/bin/bash
# SPDX-FileCopyrightText: 2026 the linelet authors
# SPDX-License-Identifier: BSD-3-Clause
#
# slurm_cluster.sh COMMAND...: starts a Slurm cluster on this machine, runs COMMAND, and
# stops the cluster. Needs root and the packages slurm-wlm and munge. It uses its own key
# and folders and listens on the loopback device only.
set -euo pipefail
room=$(mktemp -d)
chmod 755 "$room"
pids=()
finish() {
  for pid in "${pids[@]}"; do kill "$pid" 2> /dev/null || true; done
  wait 2> /dev/null || true
  rm -rf "$room"
}
trap finish EXIT

export SLURM_CONF=$room/slurm.conf
mkdir -m 700 "$room/munge"
head -c 1024 /dev/urandom > "$room/munge/key"
chmod 400 "$room/munge/key"
chown -R munge: "$room/munge"
chmod 755 "$room/munge"
socket=$room/munge/socket
runuser -u munge -- munged --foreground --socket="$socket" --key-file="$room/munge/key" \
  --pid-file="$room/munge/pid" --seed-file="$room/munge/seed" \
  --log-file="$room/munge/log" 2> "$room/munged.err" &
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
SlurmctldPidFile=$room/slurmctld.pid
SlurmdPidFile=$room/slurmd.pid
SlurmctldLogFile=$room/slurmctld.log
SlurmdLogFile=$room/slurmd.log
SlurmdSpoolDir=$room/spool
StateSaveLocation=$room/state
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
mkdir "$room/spool" "$room/state"
for _ in $(seq 100); do [ -S "$socket" ] && break; sleep 0.1; done
slurmctld -D -c 2> "$room/slurmctld.err" &
pids+=($!)
slurmd -D 2> "$room/slurmd.err" &
pids+=($!)
for _ in $(seq 300); do
  [ "$(sinfo -h -o %T 2> /dev/null || true)" = idle ] && break
  sleep 0.1
done
if [ "$(sinfo -h -o %T)" != idle ]; then
  tail "$room"/*.log >&2
  exit 1
fi
"$@"
