#!/usr/bin/env bash
#SBATCH --job-name=rupture
#SBATCH --nodes=1 --ntasks-per-node=1 --cpus-per-task=32
#SBATCH --mem-per-cpu=1100M
#SBATCH --time=2:00:00
#SBATCH --open-mode=append
##SBATCH --account=friction
##SBATCH --partition=short
# Type: sbatch recipes/reproduce/slurm/job.sh fig4. Lines with ## do not count until one # is removed.
mkdir -p build/log
log=build/log/dask-$SLURM_JOB_ID.log
export RUPTURE_SCHEDULER=$PWD/build/scheduler-$SLURM_JOB_ID.json
trap 'rm -f "$RUPTURE_SCHEDULER"' EXIT
dask scheduler --scheduler-file "$RUPTURE_SCHEDULER" --port 0 --no-dashboard &>"$log" &
srun --cpus-per-task="$SLURM_CPUS_PER_TASK" dask worker --scheduler-file "$RUPTURE_SCHEDULER" \
  --nthreads "$SLURM_CPUS_PER_TASK" --local-directory "${TMPDIR:-/tmp}" --no-dashboard &>>"$log" &
./reproduce.sh "$@"
