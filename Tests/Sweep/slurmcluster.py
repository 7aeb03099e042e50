"""A Slurm cluster on this computer for tests: munged, slurmctld and two slurmd of Debian's packages, on free ports of the loopback, with all
their files in one folder and nothing of the system's own Slurm. All processes end with the `with` block, and with this program."""
import ctypes
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import sys
import time

os.environ["PATH"] += ":/usr/sbin:/sbin"
PROGRAMS = ["munged", "slurmctld", "slurmd", "sbatch", "squeue", "sinfo", "scontrol"]
NODES = ["node1", "node2"]
PR_SET_PDEATHSIG, PR_SET_CHILD_SUBREAPER = 1, 36

CONFIGURATION = """
ClusterName=antinode
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={ports[0]}
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
CredType=cred/munge
SlurmUser={user}
SlurmdUser={user}
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool-%n
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd-%n.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd-%n.log
ProctrackType=proctrack/pgid
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
MpiDefault=none
SwitchType=switch/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerType=sched/builtin
SchedulerParameters=batch_sched_delay=0,sched_interval=2,requeue_delay=1
SlurmdParameters=config_overrides
ReturnToService=2
SlurmctldTimeout=30
SlurmdTimeout=6
MessageTimeout=5
KillWait=2
MinJobAge=10
NodeName={nodes[0]} NodeHostname={host} NodeAddr=127.0.0.1 Port={ports[1]} CPUs=1 State=UNKNOWN
NodeName={nodes[1]} NodeHostname={host} NodeAddr=127.0.0.1 Port={ports[2]} CPUs=1 State=UNKNOWN
PartitionName=all Nodes={nodes[0]},{nodes[1]} Default=YES MaxTime=INFINITE State=UP
"""


def missing_programs():
    """Those of Slurm and munge that are not installed."""
    return [name for name in PROGRAMS if shutil.which(name) is None]


def version():
    """Year and month of Slurm."""
    said = subprocess.run(["slurmd", "-V"], capture_output=True, text=True, check=True).stdout
    return tuple(int(number) for number in said.split()[1].split(".")[:2])


def free_ports(count):
    """Ports that nobody listens at now."""
    listeners = [socket.create_server(("127.0.0.1", 0)) for _ in range(count)]
    ports = [listener.getsockname()[1] for listener in listeners]
    for listener in listeners:
        listener.close()
    return ports


def command_line(process):
    """Of a process, by its id: its words; none where it has ended."""
    try:
        return pathlib.Path(f"/proc/{process}/cmdline").read_bytes().decode(errors="replace").split("\0")[:-1]
    except OSError:
        return []


def descendants():
    """The ids of all processes that this one has started, with those that they have started."""
    parents = {}
    for stat in pathlib.Path("/proc").glob("[0-9]*/stat"):
        try:
            # "1234 (name) S 1 ...": the name may hold anything.
            parents[int(stat.parent.name)] = int(stat.read_text(errors="replace").rpartition(")")[2].split()[1])
        except OSError:
            pass
    found = {os.getpid()}
    while more := {each for each, parent in parents.items() if parent in found} - found:
        found |= more
    return found - {os.getpid()}


def run_guarded(work):
    """What `work` returns, from a process of its own, which a signal to this one ends by way of all that it has to stop and remove: also a
    signal that this one cannot handle."""
    first = os.getpid()
    child = os.fork()
    if child == 0:
        def end(number, frame):
            raise SystemExit(128 + number)

        signal.signal(signal.SIGTERM, end)
        signal.signal(signal.SIGINT, signal.SIG_IGN)  # comes as SIGTERM, once
        ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGTERM, 0, 0, 0)
        sys.exit(work() if os.getppid() == first else 1)
    signal.signal(signal.SIGTERM, lambda number, frame: os.kill(child, number))
    signal.signal(signal.SIGINT, lambda number, frame: os.kill(child, signal.SIGTERM))
    return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])


class SlurmCluster:
    """Daemons in a folder. Orphans, such as slurmstepd whose slurmd was killed, become children of this program, so that it can end them."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self.running = {}
        self.environment = {**{key: value for key, value in os.environ.items() if not key.startswith(("SLURM", "SBATCH", "SQUEUE"))},
                            "SLURM_CONF": str(self.folder / "slurm.conf")}
        self._libc = ctypes.CDLL(None, use_errno=True)

    def __enter__(self):
        self._libc.prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0)
        try:
            self._begin()
        except BaseException:
            self.__exit__()
            raise
        return self

    def _begin(self):
        self.folder.mkdir(mode=0o700)
        os.chmod(self.folder, 0o755)
        (self.folder / "state").mkdir()
        key = self.folder / "munge.key"
        key.write_bytes(os.urandom(128))
        key.chmod(0o400)
        host = socket.gethostname().partition(".")[0]
        user = subprocess.run(["id", "-un"], capture_output=True, text=True, check=True).stdout.strip()
        (self.folder / "slurm.conf").write_text(
            CONFIGURATION.format(folder=self.folder, host=host, user=user, ports=free_ports(3), nodes=NODES))
        if version() >= (24, 5):
            # Else slurmd asks systemd for a control group, which a container need not have. Older ones do not know the word.
            (self.folder / "cgroup.conf").write_text("CgroupPlugin=disabled\n")
        for name in ["munged", "slurmctld", *NODES]:
            self.start(name)
        self._wait_for_nodes()

    def start(self, name):
        """Starts a daemon: "munged", "slurmctld" or a node."""
        commands = {
            "munged": ["munged", "--foreground", "--force", f"--key-file={self.folder}/munge.key", f"--socket={self.folder}/munge.socket",
                       f"--pid-file={self.folder}/munge.pid", f"--log-file={self.folder}/munge.log",
                       f"--seed-file={self.folder}/munge.seed", "--num-threads=2"],
            "slurmctld": ["slurmctld", "-D", "-f", f"{self.folder}/slurm.conf"],
        }
        command = commands.get(name, ["slurmd", "-D", "-N", name, "-f", f"{self.folder}/slurm.conf"])

        def end_with_this_program():
            self._libc.prctl(PR_SET_PDEATHSIG, signal.SIGKILL, 0, 0, 0)

        with open(self.folder / f"{name}.output", "ab") as output:
            self.running[name] = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=output, stderr=output, env=self.environment,
                                                  preexec_fn=end_with_this_program)
        if name == "munged":
            self._wait(lambda: (self.folder / "munge.socket").exists(), "munged")

    def kill(self, name):
        """Kills a daemon, as a power cut would."""
        self.running[name].kill()
        self.running[name].wait()

    def repair(self):
        """What an administrator does after a power cut: the controller saves its jobs every few seconds only, so one that was killed gives the
        numbers of tasks it has forgotten to others. A node that still has such a task refuses the other ("Duplicate jobid"), is taken out of
        service and the other is held, for good without this."""
        for node, state in self._listed("sinfo", "--Node", "--format=%N %T"):
            if state.startswith("drain"):
                self._administrate("update", f"NodeName={node}", "State=RESUME")
        for job, *reason in self._listed("squeue", "--array", "--format=%i %r"):
            if "held" in " ".join(reason):
                self._administrate("release", job)

    def _listed(self, *command):
        said = subprocess.run([*command, "--noheader"], env=self.environment, capture_output=True, text=True)
        return [line.split() for line in said.stdout.splitlines()] if said.returncode == 0 else []

    def _administrate(self, *words):
        subprocess.run(["scontrol", *words], env=self.environment, capture_output=True)

    def revive(self):
        """Starts every daemon that does not run."""
        for name, process in list(self.running.items()):
            if process.poll() is not None:
                self.start(name)

    def report(self):
        """What Slurm says of its queue and nodes, the processes, and the ends of all logs: for the message of a test that fails."""
        commands = [["squeue"], ["sinfo", "--Node", "--long"]]
        said = [subprocess.run(command, env=self.environment, capture_output=True, text=True) for command in commands]
        processes = [f"{each} {' '.join(command_line(each))}" for each in sorted(descendants())]
        logs = [f"{file.name}:\n{file.read_text(errors='replace')[-3000:]}" for file in sorted(self.folder.glob("*.output"))]
        return "\n".join([each.stdout + each.stderr for each in said] + processes + logs)

    def _wait_for_nodes(self):
        def idle():
            return self._listed("sinfo", "--Node", "--format=%T") == [["idle"]] * len(NODES)

        self._wait(idle, "the nodes")

    def _wait(self, is_there, what, seconds=60):
        end = time.monotonic() + seconds
        while not is_there():
            if time.monotonic() > end or any(process.poll() is not None for process in self.running.values()):
                logs = "\n".join(file.read_text(errors="replace")[-1000:] for file in self.folder.glob("*.output"))
                raise RuntimeError(f"{what}: not there after {seconds} s, or a daemon has ended\n{logs}")
            time.sleep(0.1)

    def __exit__(self, *_):
        """Ends all that was started, whatever it has started itself, until nothing is left."""
        for _ in range(100):
            left = descendants()
            if not left:
                return
            for process in left:
                try:
                    os.kill(process, signal.SIGKILL)
                    os.waitpid(process, os.WNOHANG)
                except (ProcessLookupError, ChildProcessError):
                    pass
            time.sleep(0.05)
        raise RuntimeError(f"processes are left: {sorted(descendants())}")
