#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 the linelet authors
# SPDX-License-Identifier: BSD-3-Clause
"""Times how fast linelet, lazrs and laszip (PyPI) decode and encode a LAZ file.

    rival_laz.py BENCHMARK_LAZ FILE.laz [ROUNDS]

Each of ROUNDS (10) runs benchmark_laz, on one thread and on two, and then the rivals. On
one thread the least of all times counts for every chunk of 50,000 points, since other
work on the machine only makes it slower; on two threads the fastest run counts. lazrs
decodes from memory to memory; the time of laszip includes laspy's work around it.
Needs laspy, lazrs and laszip.
"""

import io
import json
import subprocess
import sys
import time

import laspy
import lazrs
import numpy


class Rival:
    """The compressed points of a file, as lazrs expects them."""

    def __init__(self, path):
        self.path = path
        with laspy.open(path) as reader:
            header = reader.header
            self.count, self.size = header.point_count, header.point_format.size
            self.record = header.vlrs.get("LasZipVlr")[0].record_data
        with open(path, "rb") as file:
            self.file = file.read()
        self.offset = header.offset_to_point_data
        self.out = numpy.zeros(self.count * self.size, numpy.uint8)

    def pieces(self):
        step = 50000 * self.size
        return [self.out[at : at + step] for at in range(0, len(self.out), step)]

    def decode(self, selection):
        source = io.BytesIO(self.file)
        source.seek(self.offset)
        decoder = lazrs.LasZipDecompressor(
            source, self.record, lazrs.DecompressionSelection(selection)
        )
        return [milliseconds(lambda: decoder.decompress_many(p)) for p in self.pieces()]

    def encode(self):
        target = io.BytesIO()
        encoder = lazrs.LasZipCompressor(target, lazrs.LazVlr(self.record))
        took = [milliseconds(lambda: encoder.compress_many(p)) for p in self.pieces()]
        took.append(milliseconds(encoder.done))
        self.bytes = len(target.getvalue())
        return took

    def laszip(self):
        with laspy.open(self.path, laz_backend=laspy.LazBackend.Laszip) as reader:
            return [milliseconds(lambda: reader.read_points(50000)) for _ in self.pieces()]


def milliseconds(work):
    start = time.perf_counter()
    work()
    return 1000 * (time.perf_counter() - start)


def main():
    program, path = sys.argv[1:3]
    rounds = int(sys.argv[3]) if len(sys.argv) > 3 else 10
    rival = Rival(path)
    some = (
        lazrs.SELECTIVE_DECOMPRESS_XY_RETURNS_CHANNEL
        | lazrs.SELECTIVE_DECOMPRESS_Z
        | lazrs.SELECTIVE_DECOMPRESS_CLASSIFICATION
    )
    times = {}

    def note(name, pieces):
        times[name] = numpy.minimum(pieces, times.get(name, numpy.inf))

    for _ in range(rounds):
        for threads in (1, 2):
            ours = json.loads(subprocess.check_output([program, path, str(threads), "5"]))
            for key in ("all", "some", "encode"):
                note(f"linelet {key} {threads}", [ours[key]])
        for _ in range(5):
            note("lazrs some", rival.decode(some))
            note("lazrs all", rival.decode(lazrs.SELECTIVE_DECOMPRESS_ALL))
            note("lazrs encode", rival.encode())
            note("laszip all", rival.laszip())
    least = {name: float(pieces.sum()) for name, pieces in times.items()}
    for name, value in least.items():
        print(f"{name:<20}{value:9.1f} ms")
    faster = min(least["lazrs all"], least["laszip all"])
    print(f"all fields        {faster / least['linelet all 1']:.2f} times the faster rival")
    print(f"x, y, z, class    {least['lazrs some'] / least['linelet some 1']:.2f} times lazrs")
    print(f"encoding          {least['lazrs encode'] / least['linelet encode 1']:.2f} times lazrs, "
          f"{ours['bytes'] / rival.bytes:.4f} of its bytes")
    for key in ("all", "some", "encode"):
        print(f"two threads, {key:<7} {least[f'linelet {key} 1'] / least[f'linelet {key} 2']:.2f}")


if __name__ == "__main__":
    main()
