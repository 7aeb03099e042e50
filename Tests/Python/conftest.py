"""What tests of the package share: the program `antinode`, and folders of files that are compared byte by byte."""

import os
import pathlib
import re
import struct
import subprocess

import numpy as np
import pytest


@pytest.fixture(scope="session")
def program():
    """Runs the program `antinode`; gives what it printed."""
    binary = os.environ["ANTINODE_PROGRAM"]

    def run(*arguments, fails=False):
        done = subprocess.run([binary, *map(str, arguments)], capture_output=True, text=True)
        assert (done.returncode != 0) == fails, done.stderr
        return done.stderr if fails else done.stdout

    return run


def contents(folder):
    """The bytes of each file, without the one number in them that differs from run to run: how long a solver took, of
    a certificate in JSON and in the report."""
    return {
        file.name: re.sub(rb'"time_ms": [0-9.e+-]+|(?<=iterations, )[0-9.e+-]+ ms', b"", file.read_bytes())
        for file in pathlib.Path(folder).iterdir()
    }


def write_wave(file, samples, rate):
    """A WAV file of 32-bit floating point, one channel per row."""
    channels, values = len(samples), np.asarray(samples).astype("<f4").T.tobytes()
    head = struct.pack("<HHIIHH", 3, channels, rate, rate * 4 * channels, 4 * channels, 32)
    body = b"fmt " + struct.pack("<I", len(head)) + head + b"data" + struct.pack("<I", len(values)) + values
    file.write_bytes(b"RIFF" + struct.pack("<I", 4 + len(body)) + b"WAVE" + body)


@pytest.fixture
def same_files():
    """Compares two folders."""

    def compare(wanted, made, names):
        ours, theirs = contents(made), contents(wanted)
        assert sorted(theirs) == sorted(names)
        assert sorted(ours) == sorted(theirs)
        for name in theirs:
            assert ours[name] == theirs[name], name

    return compare
