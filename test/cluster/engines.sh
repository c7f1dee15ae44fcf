#!/bin/bash
# SPDX-FileCopyrightText: 2026 the linelet authors
# SPDX-License-Identifier: BSD-3-Clause
#
# engines.sh LINELET: runs the schedulers of doc/cluster.md on this machine and compares
# their results with those of one process. Skips those that are not installed.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
tool=$(realpath "$1")
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
cd "$dir"
mkdir bin
ln -s "$tool" bin/linelet
export PATH=$dir/bin:$PATH
failures=0

mkdir tiles
for i in 0 1 2; do linelet generate corridor tiles/t$i.laz --seed $((i + 1)) > /dev/null; done
job="tensor --radius 1.5 --engine tree"
linelet $job tiles whole > /dev/null

plan() {
  rm -rf out out.fragments
  linelet plan $job --chunk 150 tiles out
}
compare() {
  linelet merge out > /dev/null
  if diff -r whole out > /dev/null; then echo "$1: equal"; else
    echo "$1: DIFFERENT"
    failures=1
  fi
}

if command -v parallel > /dev/null; then
  # Stands in for ssh: the host "dying" rejects everything after its second job.
  cat > bin/fakessh << 'END'
#!/bin/bash
while [ "${1#-}" != "$1" ]; do shift; done
host=$1
shift
[ "${1-}" = -- ] && shift
if [ "$host" = dying ]; then
  echo x >> dying.jobs
  [ "$(wc -l < dying.jobs)" -gt 2 ] && exit 255
fi
exec bash -c "$*"
END
  chmod +x bin/fakessh
  plan
  seq 6 | PARALLEL_SSH=$dir/bin/fakessh parallel --sshlogin 1/dying,1/alive \
    --workdir "$dir" --joblog jobs.log --retries 3 \
    "PATH=$PATH linelet work out --every {}/6" > /dev/null
  compare "GNU parallel, a host dies"
  plan
  seq 6 | parallel -j 1 --joblog jobs2.log \
    'if [ {} = 2 ] && [ ! -e killed ]; then touch killed; kill -9 $$; fi
     linelet work out --every {}/6' > /dev/null || true
  seq 6 | parallel -j 1 --joblog jobs2.log --resume-failed \
    'if [ {} = 2 ] && [ ! -e killed ]; then touch killed; kill -9 $$; fi
     linelet work out --every {}/6' > /dev/null
  compare "GNU parallel, a job killed, --resume-failed"
fi

if command -v parallel > /dev/null && [ -x /usr/sbin/sshd ] && [ "$(id -u)" = 0 ]; then
  plan
  export JOBLOG=$dir/jobs3.log
  seq 24 | "$here/ssh_hosts.sh" bash -c 'PARALLEL_SSH="ssh -F $SSH_CONFIG" parallel \
    --sshlogin 1/dying,1/alive --workdir "$PWD" --joblog "$JOBLOG" --retries 5 \
    "PATH=$PATH linelet work out --every {}/24"' > /dev/null
  compare "GNU parallel over ssh, a host dies"
fi

if command -v slurmctld > /dev/null && [ "$(id -u)" = 0 ]; then
  plan
  "$here/slurm_cluster.sh" sbatch --wait --array=1-4 --requeue --output=slurm-%a.txt --wrap \
    'linelet work out --threads 1 --every $SLURM_ARRAY_TASK_ID/4'
  compare "Slurm array"
fi

if command -v snakemake > /dev/null; then
  rm -rf out out.fragments
  sed "s/tensor --radius 1 /$job --chunk 150 /" "$here/../../doc/Snakefile" > Snakefile
  snakemake --quiet --cores 2 --config tiles=tiles out=out workers=4
  if diff -r whole out > /dev/null; then echo "Snakemake: equal"; else
    echo "Snakemake: DIFFERENT"
    failures=1
  fi
fi

if command -v mpirun > /dev/null; then
  plan
  mpirun --allow-run-as-root --oversubscribe -n 3 linelet work out --every auto > /dev/null
  compare "mpirun"
fi
exit $failures
