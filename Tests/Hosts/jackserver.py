"""A JACK server without hardware and a recorder at it. The server waits for its clients (synchronous), and may run freely
while it is recorded, so that a busy computer makes a test slower, not wrong. JACK names the socket of a client
by the client alone: of two servers on a computer the clients of one name may meet, so only one test has a server at a time."""

import array
import contextlib
import os
import pathlib
import shutil
import signal
import subprocess
import tempfile
import threading

QUIET = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
# ms, of the server for a client that is late. It waits ten times as long where a client joins or leaves. More would not help: after 3 s the program
# says that its device has stopped.
PATIENCE = 2500
LONGEST = 600  # s: beyond it a test hangs; on a busy computer the longest takes 100


def missing(test, tools):
    """Whether tools are missing, which is printed: the test is then skipped."""
    absent = [tool for tool in ("jackd", "jack_wait", *tools) if not shutil.which(tool)]
    if absent:
        print(f"{test}: {', '.join(absent)} missing; Scripts/packages hosts installs them")
    return bool(absent)


@contextlib.contextmanager
def server(rate, block, outputs, inputs=2):
    """A running server, as the environment its clients need."""
    name = f"antinode-{os.getpid()}"
    environment = dict(os.environ, JACK_DEFAULT_SERVER=name, JACK_NO_START_SERVER="1")
    environment.pop("DISPLAY", None)
    process = subprocess.Popen(["jackd", "-n", name, "-r", "-S", "-t", str(PATIENCE), "-d", "dummy", "-r", str(rate), "-p", str(block),
                                "-P", str(outputs), "-C", str(inputs)], **QUIET)
    watch = threading.Timer(LONGEST, end_what_hangs)
    watch.daemon = True
    watch.start()
    try:
        subprocess.run(["jack_wait", "-w", "-t", "300", "-s", name], env=environment, check=True, **QUIET)
        yield environment
    finally:
        stop(process)
        watch.cancel()


def end_what_hangs():
    """Prints where the programs of this test wait, and kills them: the test then fails at once."""
    children = []
    for task in pathlib.Path("/proc/self/task").iterdir():  # Each thread has its own.
        children += (task / "children").read_text(encoding="ascii").split()
    try:
        for child in children:
            print("hangs:", pathlib.Path(f"/proc/{child}/cmdline").read_text(encoding="utf-8").replace("\0", " "), flush=True)
            if shutil.which("gdb"):
                subprocess.run(["gdb", "-p", child, "-batch", "-ex", "thread apply all bt"], check=False, stderr=subprocess.STDOUT, timeout=60)
    finally:
        for child in children:
            with contextlib.suppress(ProcessLookupError):
                os.kill(int(child), signal.SIGKILL)


def stop(process):
    """Ends a program, by force where it does not end by itself."""
    process.terminate()
    try:
        process.wait(timeout=10)
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()


def record(environment, recorder, seconds, ports, connection=None, freely=True):
    """Records the ports with our recorder, and gives their samples by channel. Freely: no clock counts meanwhile. The connection is a pair of ports that it makes first."""
    with tempfile.NamedTemporaryFile() as file:
        command = [recorder, file.name, str(seconds), *(["freely"] if freely else []), *([">".join(connection)] if connection else []), *ports]
        done = subprocess.run(command, env=environment, check=False, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        if done.returncode != 0:
            raise RuntimeError(done.stderr.strip())
        samples = array.array("f", file.read())
    length = len(samples) // len(ports)
    return [list(samples[k * length:(k + 1) * length]) for k in range(len(ports))]


def read_wave(path):
    """The channels of a WAV file, as lists of numbers: 24-bit integers or 32-bit floats, with the plain or the extensible header."""
    with open(path, "rb") as file:
        data = file.read()
    position, channels, bits, samples = 12, 0, 0, b""
    while position + 8 <= len(data):
        name, size = data[position:position + 4], int.from_bytes(data[position + 4:position + 8], "little")
        body = data[position + 8:position + 8 + size]
        if name == b"fmt ":
            channels, bits = int.from_bytes(body[2:4], "little"), int.from_bytes(body[14:16], "little")
        elif name == b"data":
            samples = body
        position += 8 + size + size % 2
    if bits == 32:
        values = array.array("f", samples[:len(samples) // 4 * 4])
    else:
        values = [int.from_bytes(samples[i:i + 3], "little", signed=True) / 2**23 for i in range(0, len(samples) - 2, 3)]
    return [list(values[channel::channels]) for channel in range(channels)]
