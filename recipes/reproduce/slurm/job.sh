#!/usr/bin/env bash
#SBATCH --job-name=rupture
#SBATCH --ntasks=32
#SBATCH --mem-per-cpu=1000M
#SBATCH --time=2:00:00
#SBATCH --open-mode=append
##SBATCH --account=friction
##SBATCH --partition=short
# Type: sbatch recipes/reproduce/slurm/job.sh fig4. Lines with ## do not count until one # is removed.
exec ./reproduce.sh "$@" --profile slurm
