"""A SLURM cluster of one node, this machine, without systemd and apart from any that is installed.

As a program it starts one, runs a command in it and stops it again:

    cluster.py ./reproduce.sh fig3 --profile slurm
"""

import os
import pwd
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
from contextlib import ExitStack, contextmanager, suppress
from pathlib import Path

PROGRAMS = "slurmctld slurmd srun scancel sinfo squeue sbatch salloc".split()
SEARCH_PATH = os.pathsep.join([os.environ.get("PATH", os.defpath), "/usr/sbin", "/sbin"])
START_WITHIN = 60  # [s]

CONFIGURATION = """\
ClusterName=rupture
SlurmctldHost={host}(127.0.0.1)
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/none
CredType=cred/none
SlurmctldPort={ports[0]}
SlurmdPort={ports[1]}
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerParameters=sched_min_interval=100000,batch_sched_delay=0
MinJobAge=86400
ReturnToService=2
SlurmdParameters=config_overrides
NodeName={host} NodeAddr=127.0.0.1 CPUs={cores} RealMemory=16000 State=UNKNOWN
PartitionName=main Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""


def missing_programs():
    return [name for name in PROGRAMS if not shutil.which(name, path=SEARCH_PATH)]


def processes_with(mark):
    """Yields the processes of this user that were started with this in their environment, but not
    this one."""
    for folder in Path("/proc").glob("[0-9]*"):
        try:
            if mark in (folder / "environ").read_bytes() and int(folder.name) != os.getpid():
                yield int(folder.name)
        except OSError:
            continue  # it has just ended, or is another user's


def free_ports(count):
    with ExitStack() as stack:
        servers = [socket.create_server(("127.0.0.1", 0)) for _ in range(count)]
        return [stack.enter_context(each).getsockname()[1] for each in servers]


class Cluster:
    """Its daemons are this process's children, and end by their process ids."""

    def __init__(self, folder, cores):
        self.folder = Path(folder)
        self.host = socket.gethostname().split(".")[0]
        self.processes = {}
        for name in ("state", "spool"):
            (self.folder / name).mkdir(mode=0o700)
        user = pwd.getpwuid(os.geteuid()).pw_name
        names = {"host": self.host, "user": user, "folder": self.folder, "cores": cores}
        configuration = self.folder / "slurm.conf"
        configuration.write_text(CONFIGURATION.format(**names, ports=free_ports(2)))
        self.environment = os.environ | {"SLURM_CONF": str(configuration), "PATH": SEARCH_PATH}

    def launch_daemons(self):
        for name, *options in (["slurmctld"], ["slurmd", "-N", self.host]):
            with open(self.folder / f"{name}.out", "ab") as output:
                self.processes[name] = subprocess.Popen(
                    [name, "-D", *options],
                    env=self.environment,
                    stdin=subprocess.DEVNULL,
                    stdout=output,
                    stderr=output,
                    start_new_session=True,  # what ends the caller does not end it
                )

    def wait_until_idle(self):
        end = time.monotonic() + START_WITHIN
        while self.run("sinfo", "--noheader", "--format=%t").strip() != "idle":
            if time.monotonic() > end or any(p.poll() is not None for p in self.processes.values()):
                logs = (
                    path.read_text(errors="replace")[-2000:] for path in self.folder.glob("*.out")
                )
                raise RuntimeError("\n".join(["the node does not become idle:", *logs]))
            time.sleep(0.1)

    def run(self, *command):
        """Standard output of a command of SLURM's."""
        return subprocess.run(command, env=self.environment, capture_output=True, text=True).stdout

    def stop(self):
        self.run("scancel", "--full", f"--user={os.getuid()}")
        for process in reversed(self.processes.values()):
            process.terminate()
            with suppress(subprocess.TimeoutExpired):
                process.wait(20)
            process.kill()
            process.wait()
        # such as a srun whose run was killed
        for number in processes_with(f"SLURM_CONF={self.environment['SLURM_CONF']}\0".encode()):
            os.kill(number, signal.SIGKILL)


@contextmanager
def running_cluster(cores):
    """In a folder for temporary files."""
    with tempfile.TemporaryDirectory(prefix="rupture-slurm-") as folder:
        cluster = Cluster(folder, cores)
        try:
            cluster.launch_daemons()
            cluster.wait_until_idle()
            yield cluster
        finally:
            cluster.stop()


def main(*command):
    if missing_programs():
        sys.exit(f"cluster.py: {', '.join(missing_programs())}: install slurm-wlm")
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))
    with running_cluster(os.cpu_count()) as cluster:
        return subprocess.run(command, env=cluster.environment, check=False).returncode


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
