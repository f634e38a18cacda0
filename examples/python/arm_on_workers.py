# SPDX-License-Identifier: Apache-2.0
"""A six-link arm among obstacles: how near it comes to them and to itself at many poses, spread over workers by Dask.

usage: arm_on_workers.py [POSES [WORKERS]]
POSES is 10,000 unless it is given; a million take a minute or two on two workers. Needs NumPy and distributed.
"""

import math
import sys

import numpy

import abut

CHUNK = 2500  # poses of one task: a fraction of a second, so that a worker that dies loses little
LINKS = [(0.09, 0.30), (0.08, 0.40), (0.07, 0.35), (0.06, 0.25), (0.05, 0.15), (0.04, 0.10)]  # radius and length
AXES = "zyyzyz"  # of the joints, in the frame of the link before
REACH = numpy.radians([180, 110, 140, 180, 120, 180])


def arm():
    """The links as capsules along Z, and the obstacles with their poses."""
    links = [abut.Shape.capsule(radius, length / 2) for radius, length in LINKS]
    shelf = abut.Shape.composite([abut.Shape.box(0.4, 0.02, 0.3)] * 2, [abut.pose(y=-0.2), abut.pose(y=0.2)])
    table, lamp = abut.Shape.box(0.6, 0.6, 0.02), abut.Shape.sphere(0.15)
    return links, [(table, abut.pose(z=-0.15)), (shelf, abut.pose(0.8, 0, 0.4)), (lamp, abut.pose(-0.5, 0.3, 0.7))]


def joint_angles(first, count):
    """Poses of the joints, by their numbers: a sequence that fills the range evenly (Roberts 2018)."""
    root = 1.0
    for _ in range(60):
        root = (1 + root) ** (1 / 7)  # the root of x^7 = x + 1, for six dimensions
    steps = root ** -numpy.arange(1.0, 7.0)
    numbers = numpy.arange(first + 1, first + count + 1, dtype="f8")[:, None]
    return (2 * ((0.5 + numbers * steps) % 1) - 1) * REACH


def link_matrices(angles):
    """Where the links are, as (N, 4, 4) matrices of each."""
    place, found = numpy.broadcast_to(numpy.eye(4), (len(angles), 4, 4)), []
    # In a row each: NumPy may take another cosine, of other last digits, for numbers that lie apart in memory.
    rows = numpy.ascontiguousarray(angles.T)
    for angle, axis, (_, length) in zip(rows, AXES, LINKS):
        turn = numpy.tile(numpy.eye(4), (len(angles), 1, 1))
        i, j = {"y": (2, 0), "z": (0, 1)}[axis]
        turn[:, i, i] = turn[:, j, j] = numpy.cos(angle)
        turn[:, j, i] = numpy.sin(angle)
        turn[:, i, j] = -numpy.sin(angle)
        middle, end = numpy.eye(4), numpy.eye(4)
        middle[2, 3], end[2, 3] = length / 2, length
        place = place @ turn
        found.append(place @ middle)
        place = place @ end
    return found


def clearances(first, links, obstacles, count):
    """The least distance of the arm from obstacles and from itself, at `count` poses; negative where it overlaps."""
    places = link_matrices(joint_angles(first, count))
    least = numpy.full(count, math.inf)
    for number, (link, place) in enumerate(zip(links, places)):
        others = obstacles + list(zip(links[:max(number - 1, 0)], places))  # neighbours always touch at their joint
        for other, where in others:
            numpy.minimum(least, abut.pairs_distance(link, place, other, where, threads=1).distance, out=least)
    return least


def on_workers(client, poses):
    """All clearances by the workers of a client, in order, with a bar of the progress."""
    import distributed

    # Shapes are pickled into each task. So no worker has the only copy, and tasks of one that dies start anew.
    links, obstacles = arm()
    tasks = [client.submit(clearances, first, links, obstacles, min(CHUNK, poses - first), key=f"clearances-{first}")
             for first in range(0, poses, CHUNK)]
    distributed.progress(tasks, notebook=False)
    return numpy.concatenate(client.gather(tasks))


def in_one_process(poses):
    return clearances(0, *arm(), poses)


def main(poses=10_000, workers=2):
    import distributed

    with distributed.LocalCluster(n_workers=workers, threads_per_worker=1, dashboard_address=None) as cluster, \
            distributed.Client(cluster) as client:
        found = on_workers(client, poses)
    free = int((found > 0).sum())
    print(f"\n{free} of {poses} poses are free, the tightest by {found[found > 0].min():.1g}")
    same = found[:CHUNK].tobytes() == in_one_process(min(poses, CHUNK)).tobytes()
    print("the same bits as in this process" if same else "other bits than in this process")


if __name__ == "__main__":
    main(*(int(argument) for argument in sys.argv[1:]))
