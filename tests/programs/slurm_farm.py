#!/usr/bin/env python3
"""A batch on a real Slurm of one node: submitted, one task killed, it and another requeued, merged; the tree must be that of a run
by itself.

    slurm_farm.py PROGRAM FOLDER      77: not tried, for a reason that is told

munged, slurmctld and slurmd run for this test alone, on ports and in a folder of their own. The last two want root.
"""

import json
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "cli" / "batch"))
from batches import tree  # noqa: E402

PROGRAM, FOLDER = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
TASKS = 4
NEEDED = ("munged", "slurmctld", "slurmd", "sbatch", "squeue", "scontrol", "setpriv")

# Items that take long enough to be caught at work.
BATCH = """
[batch]
format = 1
name = "farm"
title = "On a farm"
seed = 3
thumbnail = 64

[[entry]]
name = "cut"
templates = ["kiwi", "tomato"]
count = 12
knives = ["half", "across"]
"""

CONFIGURATION = """
ClusterName=pomona
SlurmctldHost={host}(127.0.0.1)
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket={folder}/munge/munge.socket,cred_expire=10
CredType=cred/munge
SlurmctldPort={ports[0]}
SlurmdPort={ports[1]}
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SlurmdParameters=config_overrides
SwitchType=switch/none
MpiDefault=none
ReturnToService=2
NodeName={host} NodeAddr=127.0.0.1 CPUs=2 CoresPerSocket=2 State=UNKNOWN
PartitionName=main Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""


def fail(why):
    sys.exit(f"slurm_farm: error: {why}")


def skip(why):
    print(f"slurm_farm: NOT TRIED: {why}", flush=True)
    sys.exit(77)


def run(*words, status=0, **options):
    result = subprocess.run([str(word) for word in words], text=True, capture_output=True, **options)
    if status is not None and result.returncode != status:
        fail(f"{words}: status {result.returncode}\n{result.stdout}{result.stderr}")
    return result


def waited_for(what, question, seconds=240, otherwise=fail):
    """The first answer that is neither None nor False."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        answer = question()
        if answer:
            return answer
        time.sleep(0.1)
    otherwise(f"{what}: not within {seconds} s")


def free_ports(count):
    sockets = [socket.socket() for _ in range(count)]
    for each in sockets:
        each.bind(("127.0.0.1", 0))
    ports = [each.getsockname()[1] for each in sockets]
    for each in sockets:
        each.close()
    return ports


class Slurm:
    """The three daemons, as children of this process, which end with it. Where one does not start, nothing is tried."""

    def __init__(self):
        # munged wants its folder to be its own, and all above it closed to others.
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="pomona-slurm-"))
        self.folder.chmod(0o755)
        for name in ("munge", "state", "spool"):
            (self.folder / name).mkdir(mode=0o755)
        key = self.folder / "munge" / "munge.key"
        key.write_bytes(os.urandom(1024))
        key.chmod(0o400)
        shutil.chown(self.folder / "munge", "munge", "munge")
        shutil.chown(key, "munge", "munge")
        self.daemons = []

    def start(self):
        munge = self.folder / "munge"
        self.spawn("setpriv", "--reuid", "munge", "--regid", "munge", "--clear-groups", "munged", "-F", "-f",
                   f"--key-file={key_of(munge)}", f"--socket={munge}/munge.socket", f"--pid-file={munge}/munged.pid",
                   f"--log-file={munge}/munged.log", f"--seed-file={munge}/seed")
        waited_for("munged", lambda: (munge / "munge.socket").exists(), 30, skip)

        # The controller, then the node.
        configuration = self.folder / "slurm.conf"
        configuration.write_text(CONFIGURATION.format(host=socket.gethostname(), folder=self.folder, ports=free_ports(2)))
        os.environ["SLURM_CONF"] = str(configuration)
        self.spawn("slurmctld", "-D", "-c")
        waited_for("slurmctld", lambda: run("scontrol", "ping", status=None).returncode == 0, 60, skip)
        self.spawn("slurmd", "-D")
        waited_for("slurmd", lambda: "idle" in run("sinfo", "-h", "-o", "%T", status=None).stdout, 60, skip)

    def spawn(self, *words):
        log = open(self.folder / f"{pathlib.Path(words[0]).name}-{len(self.daemons)}.out", "wb")
        self.daemons.append(subprocess.Popen(words, stdin=subprocess.DEVNULL, stdout=log, stderr=log))

    def stop(self):
        for daemon in reversed(self.daemons):
            daemon.terminate()
            try:
                daemon.wait(20)
            except subprocess.TimeoutExpired:
                daemon.kill()
                daemon.wait()
        shutil.rmtree(self.folder, ignore_errors=True)

    def logs(self):
        return "\n".join(f"--- {log}\n{log.read_text(errors='replace')[-3000:]}" for log in self.folder.glob("slurm*.log"))


def key_of(munge):
    return munge / "munge.key"


def status_of(output):
    result = run(PROGRAM, "farm", "status", output, "--json", "--threads", 1, status=None)
    return json.loads(result.stdout) if result.returncode in (0, 1) else fail(result.stderr)


def shard_at_work(output, but=0):
    """A shard that has finished an item and has more to do, and its process."""
    for shard in status_of(output)["shards"]:
        if shard["state"] != "running" or not shard["done"] or not shard["missing"] or shard["shard"] == but:
            continue
        wanted = [b"--shard", f"{shard['shard']}/{TASKS}".encode()]
        for process in pathlib.Path("/proc").glob("[0-9]*"):
            try:
                words = (process / "cmdline").read_bytes().split(b"\0")
            except OSError:
                continue
            if words[0] == bytes(PROGRAM) and bytes(output) in words and wanted[1] in words:
                return shard["shard"], int(process.name)
    return None


def disturb(output):
    """One task loses its process and is requeued, another is requeued as it runs: their numbers."""
    array = status_of(output)["jobs"]["array"]
    killed, process = waited_for("a task at work", lambda: shard_at_work(output))
    os.kill(process, signal.SIGKILL)
    run("scontrol", "requeue", f"{array}_{killed}")
    found = waited_for("another task at work", lambda: shard_at_work(output, but=killed))
    run("scontrol", "requeue", f"{array}_{found[0]}")
    return array, (killed, found[0])


def check(slurm):
    slurm.start()
    shutil.rmtree(FOLDER, ignore_errors=True)
    FOLDER.mkdir(parents=True)
    here = FOLDER.resolve()
    (here / "farm.toml").write_text(BATCH)
    output = here / "it's 100% \"$HOME\" `out`; #SBATCH"

    # Submitted, disturbed, waited for.
    run(PROGRAM, "farm", "slurm", "farm.toml", "-o", output, "--tasks", TASKS, cwd=here)
    again = run(PROGRAM, "farm", "slurm", "farm.toml", "-o", output, "--tasks", TASKS, cwd=here, status=75)
    assert "in the queue already" in again.stderr, again.stderr
    array, disturbed = disturb(output)
    restarts = [run("scontrol", "show", "job", f"{array}_{task}").stdout for task in disturbed]
    assert all("Restarts=1" in text for text in restarts), restarts
    final = waited_for("the merge", lambda: (now := status_of(output))["complete"] and now["merge"] == "done" and now)
    assert [shard["state"] for shard in final["shards"]] == ["done"] * TASKS, final

    # The same as a run by itself.
    run(PROGRAM, "batch", "farm.toml", "-o", "alone", "--quiet", cwd=here)
    assert tree(output) == tree(here / "alone"), "the trees differ"
    print(f"slurm_farm: {final['items']} items in {TASKS} tasks; tasks {disturbed[0]} (killed) and {disturbed[1]} requeued; "
          "the tree is that of a run by itself")


def main():
    os.environ["PATH"] += ":/usr/sbin"  # where daemons are, which is on nobody's PATH but root's
    missing = [program for program in NEEDED if not shutil.which(program)]
    if missing:
        fail(f"not installed: {' '.join(missing)} (scripts/setup.sh programs)")
    if os.geteuid() != 0:
        skip("slurmctld, slurmd and munged are started here as root and as munge, and this is neither")
    slurm = Slurm()
    try:
        check(slurm)
    except BaseException:
        print(slurm.logs(), file=sys.stderr)
        raise
    finally:
        slurm.stop()


main()
