# SPDX-License-Identifier: Apache-2.0
"""Poses of an arm over the workers of a local Dask cluster: the same bits as in one process, though a worker is killed.

usage: cluster.py EXAMPLE
Skipped with 77 where NumPy or distributed is not installed.
"""

import contextlib
import importlib.util
import io
import os
import pathlib
import signal
import sys
import time
import unittest

POSES = 10_000


class Cluster(unittest.TestCase):
    example: pathlib.Path

    def setUp(self):
        # Workers import the example by its name.
        folder = str(self.example.parent)
        sys.path.insert(0, folder)
        self.addCleanup(sys.path.remove, folder)
        before = os.environ.get("PYTHONPATH", "")
        os.environ["PYTHONPATH"] = os.pathsep.join([folder, before])
        self.addCleanup(os.environ.__setitem__, "PYTHONPATH", before)
        self.arm = importlib.import_module(self.example.stem)

    def test_the_same_bits_though_a_worker_dies(self):
        import distributed

        expected = self.arm.in_one_process(POSES)
        self.assertGreater((expected > 0).sum(), POSES // 20)
        self.assertGreater((expected < 0).sum(), POSES // 20)
        with distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster, \
                distributed.Client(cluster) as client:
            shown = io.StringIO()
            with contextlib.redirect_stdout(shown):
                self.assertEqual(self.arm.on_workers(client, POSES).tobytes(), expected.tobytes())
            self.assertRegex(shown.getvalue(), "100% Completed")

            links, obstacles = self.arm.arm()
            before = set(client.run(os.getpid).values())
            self.assertEqual(len(before), 2)
            size = POSES // 20
            tasks = [client.submit(self.arm.clearances, first, links, obstacles, size, key=f"again-{first}")
                     for first in range(0, POSES, size)]
            while not any(task.done() for task in tasks):
                time.sleep(0.001)
            self.assertFalse(all(task.done() for task in tasks), "nothing is left to lose")
            killed = min(before)
            os.kill(killed, signal.SIGKILL)
            found = b"".join(part.tobytes() for part in client.gather(tasks))
            self.assertEqual(found, expected.tobytes())
            self.assertNotIn(killed, set(client.run(os.getpid).values()))


def main():
    for name in ("numpy", "distributed"):
        if not importlib.util.find_spec(name):
            print(f"skipped: {name} is not installed; scripts/setup installs it")
            return 77
    Cluster.example = pathlib.Path(sys.argv[1]).resolve()
    tests = unittest.defaultTestLoader.loadTestsFromTestCase(Cluster)
    return int(not unittest.TextTestRunner().run(tests).wasSuccessful())


if __name__ == "__main__":
    sys.exit(main())
