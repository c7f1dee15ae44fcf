#!/bin/bash
# SPDX-FileCopyrightText: 2026 the linelet authors
# SPDX-License-Identifier: BSD-3-Clause
#
# ssh_hosts.sh COMMAND...: runs COMMAND while this machine acts as two hosts, "dying"
# and "alive", reached by ssh with the settings in $SSH_CONFIG. The host "dying" is
# killed, with everything running on it, after two jobs of $JOBLOG have ended. Needs
# root and openssh-server. Uses its own keys and listens on the loopback device only.
set -euo pipefail
dir=$(mktemp -d)
pids=()
finish() {
  for pid in "${pids[@]}"; do kill "$pid" 2> /dev/null || true; done
  wait 2> /dev/null || true
  rm -rf "$dir"
}
trap finish EXIT

mkdir -p /run/sshd
ssh-keygen -q -t ed25519 -N '' -f "$dir/host"
ssh-keygen -q -t ed25519 -N '' -f "$dir/user"
export SSH_CONFIG=$dir/config
port=16820
for host in dying alive; do
  port=$((port + 1))
  cat > "$dir/$host.sshd" << END
ListenAddress 127.0.0.1
Port $port
HostKey $dir/host
AuthorizedKeysFile $dir/user.pub
PidFile none
StrictModes no
UsePAM no
PasswordAuthentication no
END
  cat >> "$SSH_CONFIG" << END
Host $host
  HostName 127.0.0.1
  Port $port
  IdentityFile $dir/user
  IdentitiesOnly yes
  UserKnownHostsFile $dir/known
  StrictHostKeyChecking no
  LogLevel ERROR
END
  /usr/sbin/sshd -D -f "$dir/$host.sshd" 2> "$dir/$host.err" &
  pids+=($!)
done
dying=${pids[0]}
for host in dying alive; do
  for _ in $(seq 100); do
    ssh -n -F "$SSH_CONFIG" "$host" true 2> /dev/null && break
    sleep 0.1
  done
done
: > "$JOBLOG"
(
  until [ "$(grep -c $'\tdying\t' "$JOBLOG")" -ge 2 ]; do sleep 0.05; done
  pkill -KILL -P "$dying" || true # its connections
  kill -KILL "$dying"
) &
pids+=($!)
"$@"
if kill -0 "$dying" 2> /dev/null; then
  echo "the host did not die" >&2
  exit 1
fi
