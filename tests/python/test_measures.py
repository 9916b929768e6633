"""What a call costs beside its work, and what it leaves behind."""

import resource
import time

import numpy as np

import seamount as sm

FRAME = sm.Frame(4, 4, 10)


def seconds(call, count=400):
    """Of the fastest of several rounds: others use this machine too."""
    rounds = []
    for _ in range(8):
        begin = time.perf_counter()
        for _ in range(count):
            call()
        rounds.append((time.perf_counter() - begin) / count)
    return min(rounds)


def test_a_call_costs_less_than_50_microseconds():
    terrain = sm.terrain.noise(domain=FRAME)
    array = terrain.array
    assert seconds(lambda: sm.terrain.smooth(terrain)) < 50e-6
    assert seconds(lambda: sm.terrain.noise(domain=FRAME, octaves=1, seed=3)) < 50e-6
    assert seconds(lambda: sm.terrain.blend(terrain, sm.Terrain(array, FRAME), mode="max")) < 50e-6


def test_ten_thousand_calls_do_not_grow():
    terrain = sm.Terrain(np.zeros((200, 200), np.float32), cell_m=10)

    def call(i):
        made = sm.terrain.noise(domain=terrain.frame, octaves=1, seed=i) if i % 100 == 0 else sm.terrain.blend(
            sm.Terrain(terrain.array, terrain.frame), terrain, mode="max")
        assert made.array.shape == (200, 200)
        try:
            sm.terrain.noise(octaves=99)
        except sm.InvalidArgument:
            pass

    for i in range(500):
        call(i)
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    for i in range(10000):
        call(i)
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before < 4096  # KiB; one result a call would be 1.6 GB
