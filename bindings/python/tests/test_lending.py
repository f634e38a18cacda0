# SPDX-License-Identifier: Apache-2.0
"""Borrowed answers, threads and progress. The tests of arrays need NumPy."""

import contextlib
import gc
import importlib.util
import io
import threading
import unittest
import unittest.mock
import weakref

import abut

needs_numpy = unittest.skipUnless(importlib.util.find_spec("numpy"), "NumPy is not installed")


def touching(count=3, **options):
    """A universe with a row of balls, each of which touches the next."""
    universe, ball = abut.Universe(**options), abut.Shape.sphere(1)
    parts = universe.add_parts([abut.pose(1.5 * i) for i in range(count)])
    universe.add_geometries(parts, ball)
    universe.step()
    return universe


class Lending(unittest.TestCase):
    def setUp(self):
        self.universe = touching()

    def test_records_are_borrowed_until_the_universe_changes(self):
        lent = self.universe.borrow_contacts()
        self.assertEqual([contact.distance for contact in lent], [-0.5, -0.5])
        self.assertEqual([bytes(contact) for contact in lent], [bytes(contact) for contact in self.universe.contacts()])
        self.assertFalse(lent.is_stale)
        kept, one = lent.copy(), lent[0]
        self.universe.step()
        self.assertTrue(lent.is_stale)
        for use in (lambda: lent[0], lambda: len(lent), lambda: list(lent), lambda: lent.copy(), lambda: lent.distance):
            with self.assertRaisesRegex(abut.StaleError, "changed since these 2 records were borrowed"):
                use()
        self.assertIn("stale", repr(lent))
        self.assertEqual((kept[1].distance, one.distance), (-0.5, -0.5))

    def test_every_change_ends_a_loan(self):
        part = self.universe.parts()[0]
        for change in (lambda: self.universe.set_poses([part], [abut.pose()]), self.universe.refresh,
                       self.universe.add_part, self.universe.clear_rules, lambda: self.universe.wake([part])):
            lent = self.universe.borrow_events()
            self.assertEqual(len(lent), 2)
            change()
            self.assertTrue(lent.is_stale)

    @needs_numpy
    def test_an_array_holds_changes_back(self):
        lent = self.universe.borrow_contacts()
        self.assertEqual(lent.distance.ctypes.data, lent.array.ctypes.data + abut.Contact.distance.offset)
        depths = lent.distance[1:]
        for change in (self.universe.step, self.universe.close, lambda: self.universe.add_part()):
            with self.assertRaisesRegex(BufferError, "still looks at borrowed records"):
                change()
        self.assertEqual(depths[0], -0.5)
        self.assertFalse(lent.is_stale)
        del depths
        self.universe.step()
        self.assertEqual(len(self.universe.contacts()), 2)

    @needs_numpy
    def test_an_array_keeps_its_universe_alive(self):
        universe = touching()
        depths, gone = universe.borrow_contacts().distance, weakref.ref(universe)
        del universe
        gc.collect()
        self.assertIsNotNone(gone())
        self.assertEqual(depths.tolist(), [-0.5, -0.5])
        del depths
        gc.collect()
        self.assertIsNone(gone())

    @needs_numpy
    def test_an_array_in_a_cycle_is_collected(self):
        cycle = [self.universe.borrow_contacts().distance]
        cycle.append(cycle)
        del cycle
        self.universe.step()

    def test_a_filter_cannot_borrow_what_its_step_overwrites(self):
        lent = []
        self.universe.set_filter(lambda a, b: lent.append(self.universe.borrow_contacts()[0]))
        with self.assertRaisesRegex(RuntimeError, "a filter cannot borrow"):
            self.universe.step()
        self.assertEqual(lent, [])


class Threads(unittest.TestCase):
    def test_calls_release_the_lock_of_the_interpreter(self):
        # The flag of ctypes for functions that keep the lock, FUNCFLAG_PYTHONAPI, is 4.
        self.assertEqual(abut.library.abut_universe_step._flags_ & 4, 0)

    def test_two_universes_step_at_the_same_time(self):
        meeting = threading.Barrier(2, timeout=60)
        failures = []

        def run():
            universe, met = touching(), []
            universe.set_filter(lambda a, b: met or met.append(meeting.wait()) or True)
            try:
                universe.step()
            except BaseException as failure:  # pylint: disable=broad-except - told below
                failures.append(failure)

        threads = [threading.Thread(target=run) for _ in range(2)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(failures, [])

    def test_another_thread_is_refused_during_a_detection(self):
        universe, refused = touching(), []

        def use():
            for call in (universe.contacts, universe.step, universe.close):
                try:
                    call()
                except RuntimeError as failure:
                    refused.append(str(failure))

        def keeps(a, b):
            if not refused:
                thread = threading.Thread(target=use)
                thread.start()
                thread.join()
            return True

        universe.set_filter(keeps)
        universe.step()
        self.assertEqual(len(refused), 3)
        self.assertEqual(refused[0], "another thread changes this universe; wait for it before you use the universe")
        self.assertEqual(refused[1], "another thread changes this universe; wait for it before you change the universe")
        self.assertEqual(len(universe.contacts()), 2)

    def test_a_change_is_refused_while_another_thread_reads(self):
        universe, reads, is_over = touching(), threading.Event(), threading.Event()
        count = universe.change_count

        def read(_pointer):
            reads.set()
            is_over.wait(60)

        thread = threading.Thread(target=lambda: universe._read(read))
        thread.start()
        reads.wait(60)
        for call in (universe.step, universe.add_part, universe.close):
            with self.assertRaisesRegex(RuntimeError, "another thread reads this universe; wait for it"):
                call()
        self.assertEqual((len(universe.contacts()), universe.change_count), (2, count))
        is_over.set()
        thread.join()
        universe.step()

    def test_a_filter_cannot_step_or_close_its_universe(self):
        universe, refused = touching(), []

        def keeps(a, b):
            for call in (universe.step, universe.close):
                try:
                    call()
                except (abut.Error, RuntimeError) as failure:
                    refused.append(str(failure))
            return len(universe.contacts()) == 2

        universe.set_filter(keeps)
        universe.step()
        self.assertIn("ABUT_BUSY", refused[0])
        self.assertEqual(refused[1], "a filter cannot close the universe that asks it")
        self.assertEqual(len(universe.contacts()), 2)

    def test_any_number_of_threads_gives_the_same_bits(self):
        if abut.has_feature("threads"):
            self.assertEqual(touching(50, threads=2).hash(), touching(50).hash())
        else:
            with self.assertRaisesRegex(abut.Error, "ABUT_UNSUPPORTED"):
                abut.Universe(threads=2)


class Progress(unittest.TestCase):
    def test_batches_tell_how_far_they_are(self):
        ball, told = abut.Shape.sphere(1), []
        count = 2 * (1 << 15) + 5
        poses = (abut.Pose * count)(*[abut.pose(3)] * count)
        found = abut.pairs_distance(ball, abut.pose(), ball, poses, progress=lambda *now: told.append(now))
        self.assertEqual(told, [(1 << 15, count), (1 << 16, count), (count, count)])
        self.assertEqual((found[0].distance, found[count - 1].distance), (1, 1))
        with self.assertRaisesRegex(TypeError, "progress is of type str"):
            abut.pairs_distance(ball, abut.pose(), ball, poses, progress="yes")

    def test_chunks_of_contacts_are_joined(self):
        ball, poses, told = abut.Shape.sphere(1), [abut.pose(i / 8) for i in range(30)], []
        with unittest.mock.patch("abut.progress.CHUNK", 7):
            found = abut.pairs_contacts(ball, abut.pose(), ball, poses, progress=lambda *now: told.append(now))
        self.assertEqual(told[-2:], [(28, 30), (30, 30)])
        self.assertEqual([len(contacts) for contacts in found], [1] * 17 + [0] * 13)
        self.assertEqual([contacts[0].distance for contacts in found if contacts], [i / 8 - 2 for i in range(17)])

    def test_true_writes_to_stderr(self):
        ball, written = abut.Shape.sphere(1), io.StringIO()
        with contextlib.redirect_stderr(written):
            abut.pairs_cast(ball, [abut.pose()] * 3, (1, 0, 0), ball, abut.pose(9), progress=True)
        self.assertEqual(written.getvalue(), "\r100 %  3 of 3\n")

    def test_what_progress_raises_ends_the_batch(self):
        ball = abut.Shape.sphere(1)

        def stop(done, count):
            raise KeyboardInterrupt

        with self.assertRaises(KeyboardInterrupt):
            abut.pairs_distance(ball, abut.pose(), ball, abut.pose(), progress=stop)


if __name__ == "__main__":
    unittest.main()
