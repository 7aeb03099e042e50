#!/usr/bin/env python3
"""Compares what a host has recorded, one file a channel, with a render: compare.py RENDER.wav CHANNEL.wav ..."""
import struct
import sys

TOLERANCE = 1e-6  # of full scale
LEAST_PEAK = 0.01  # silence equals silence, and says nothing


def channels_of(path):
    """The channels of a WAV file of 32-bit floats."""
    with open(path, "rb") as file:
        content = file.read()

    at, count, samples = 12, 0, ()

    while at + 8 <= len(content):
        name, size = content[at : at + 4], struct.unpack_from("<I", content, at + 4)[0]

        if name == b"fmt ":
            count, bits = struct.unpack_from("<H", content, at + 10)[0], struct.unpack_from("<H", content, at + 22)[0]
            assert bits == 32, f"{path} has {bits} bits a sample"
        elif name == b"data":
            size = min(size, len(content) - at - 8)
            samples = struct.unpack_from(f"<{size // 4}f", content, at + 8)

        at += 8 + size + size % 2

    return [samples[k::count] for k in range(count)]


def peak(samples):
    return max(range(len(samples)), key=lambda i: abs(samples[i]))


rendered = channels_of(sys.argv[1])
recorded = [channels_of(path)[0] for path in sys.argv[2:]]
assert len(recorded) == len(rendered), f"{len(recorded)} channels recorded, {len(rendered)} rendered"
# The host says when the note begins: one shift for all channels.
shift = peak(recorded[0]) - peak(rendered[0])
worst = 0

for k, (wanted, heard) in enumerate(zip(rendered, recorded)):
    assert abs(wanted[peak(wanted)]) > LEAST_PEAK, f"channel {k + 1} of the render is silent"
    assert 0 <= shift and shift + len(wanted) <= len(heard), "the recording does not hold the whole event"
    inside = max(abs(a - b) for a, b in zip(wanted, heard[shift:]))
    before = max((abs(a) for a in heard[:shift]), default=0)
    worst = max(worst, inside, before)
    print(f"channel {k + 1}: peak {heard[peak(heard)]:.6f}, largest difference {inside:.3g}, before it {before:.3g}")

print(f"largest difference {worst:.3g} of full scale; allowed: {TOLERANCE:g}; the note began at sample {shift}")
sys.exit(worst > TOLERANCE)
