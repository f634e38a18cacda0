// SPDX-License-Identifier: Apache-2.0
// Tests of the C# wrapper: a program of its own, since test frameworks are not in every distribution.
using System;
using System.Collections.Generic;
using System.Linq;
using System.Runtime.InteropServices;

namespace Abut
{
    internal static class Test
    {
        private static readonly Pose Here = new Pose(0, 0, 0);

        private static void Equal<T>(T expected, T found)
        {
            if (!Equals(expected, found))
            {
                throw new Exception($"found {found}; expected {expected}");
            }
        }

        private static E Throws<E>(string words, Action action) where E : Exception
        {
            try
            {
                action();
            }
            catch (E thrown)
            {
                if (!thrown.Message.Contains(words))
                {
                    throw new Exception($"'{thrown.Message}' lacks '{words}'");
                }
                return thrown;
            }
            throw new Exception($"nothing was thrown about '{words}'");
        }

        // A universe with a row of balls of radius 1, each 1.5 from the next.
        private static Universe Row(int count, out PartId[] parts, out GeometryId[] geometries)
        {
            var universe = new Universe();
            using (Shape ball = Shape.Sphere(1))
            {
                parts = Enumerable.Range(0, count).Select(i => universe.AddPart(new Pose(1.5 * i, 0, 0))).ToArray();
                geometries = parts.Select(part => universe.AddGeometry(part, ball)).ToArray();
            }
            return universe;
        }

        private static int ContactsOfAStep(Universe universe)
        {
            universe.Step(0.01);
            return universe.Contacts().Length;
        }

        private static void StructsAreThoseOfTheLibrary()
        {
            var sizes = new Dictionary<string, ulong>();
            for (uint i = 0; i < (uint)Native.abut_layout_count(); ++i)
            {
                Native.Check(Native.abut_layout_at((UIntPtr)i, out LayoutEntry entry));
                string field = Native.Text(entry.Field);
                sizes[Native.Text(entry.Type) + "." + field] = field == "" ? entry.Size : entry.Offset;
            }
            foreach (var each in Native.Sizes)
            {
                Equal(each.Value, Marshal.SizeOf(each.Key));
            }
            Equal(sizes["abut_contact.normal"], (ulong)Marshal.OffsetOf(typeof(Contact), "Normal"));
            Equal(sizes["abut_contact.tangent"], (ulong)Marshal.OffsetOf(typeof(Contact), "Tangent"));
            Equal(sizes["abut_query_hit.normal"], (ulong)Marshal.OffsetOf(typeof(Hit), "Normal"));
            Equal(sizes["abut_universe_options.threads"], (ulong)Marshal.OffsetOf(typeof(UniverseOptions), "Threads"));
        }

        private static void EveryKindCanBeMade()
        {
            var square = new[] { new Vector(-1, -1, 0), new Vector(1, -1, 0), new Vector(1, 1, 0), new Vector(-1, 1, 0) };
            Equal("box", Shape.Box(1, 2, 3).Kind);
            Equal("capsule", Shape.Capsule(0.5, 2).Kind);
            Equal("plane", Shape.Plane(new Vector(0, 0, 2), 0).Kind);
            Equal("hull", Shape.Hull(square).Kind);
            Equal("mesh", Shape.Mesh(square, new uint[] { 0, 1, 2, 0, 2, 3 }).Kind);
            Equal("cylinder", Shape.Cylinder(0.5, 2).Kind);
            Equal("height_field", Shape.HeightField(2, 2, 1, 1, new double[4]).Kind);
            Equal("particles", Shape.Particles(square, 0.1).Kind);
            Shape ball = Shape.Sphere(1);
            Equal("composite", Shape.Composite(new[] { ball, ball }, new[] { Here, Here }).Kind);
            Throws<ArgumentException>("heights has 3", () => Shape.HeightField(2, 2, 1, 1, new double[3]));
            Throws<ArgumentException>("poses has 0", () => Shape.Composite(new[] { ball }, new Pose[0]));
            Equal("cone", Shape.OfKind("cone", 1, 2).Kind);
        }

        private static void BadInputIsNamed()
        {
            Equal(Status.OutOfRange, Throws<AbutException>("radius is -1", () => Shape.Sphere(-1)).Status);
            Equal(Status.NotFinite, Throws<AbutException>("radius", () => Shape.Sphere(double.NaN)).Status);
            Throws<AbutException>("kind", () => Shape.OfKind("blob"));
            Throws<ArgumentException>("triangles has 2 indices", () => Shape.Mesh(new Vector[3], new uint[2]));
            Shape ball = Shape.Sphere(1);
            Throws<ArgumentException>("posesB has 0", () => Pair.Distances(ball, new[] { Here }, ball, new Pose[0]));
            ball.Dispose();
            Throws<ObjectDisposedException>("", () => Pair.Distance(ball, Here, ball, Here));
            using (Universe universe = Row(1, out PartId[] parts, out _))
            {
                universe.RemovePart(parts[0]);
                Throws<AbutException>("part", () => universe.SetPose(parts[0], Here));
            }
        }

        private static void TwoShapes()
        {
            using (Shape box = Shape.Box(1, 1, 1))
            {
                Equal(1.5, Pair.Distance(box, Here, box, new Pose(3.5, 0, 0)).Value);
                Equal(false, Pair.Overlaps(box, Here, box, new Pose(3.5, 0, 0)));
                Equal(true, Pair.Overlaps(box, Here, box, new Pose(3.5, 0, 0), 2));
                Distance[] many = Pair.Distances(box, new[] { Here, Here }, box, new[] { new Pose(3, 0, 0), new Pose(4, 0, 0) });
                Equal("1 2", string.Join(" ", many.Select(each => each.Value)));
                Contact[] contacts = Pair.Contacts(box, Here, box, new Pose(0, 0, 1.75));
                Equal(4, contacts.Length);
                Equal(-0.25, contacts[3].Distance);
                Equal(new Vector(0, 0, 1), contacts[3].Normal);
            }
        }

        private static void BatchesAreThoseOfEachPair()
        {
            using (Shape box = Shape.Box(1, 1, 1))
            {
                var here = new[] { Here, Here, Here };
                var there = new[] { new Pose(0, 0, 1.75), new Pose(9, 0, 0), new Pose(1.5, 0, 0) };
                Contact[][] lists = Pair.ContactLists(box, here, box, there);
                Equal("4 0 4", string.Join(" ", lists.Select(each => each.Length)));
                Equal(Pair.Contacts(box, Here, box, there[2])[3], lists[2][3]);
                Equal(0, Pair.ContactLists(box, new Pose[0], box, new Pose[0]).Length);
                var still = new Vector[3];
                var ways = new[] { new Vector(0, 0, 4), new Vector(0, 0, 4), new Vector(0, 4, 0) };
                CastHit?[] hits = Pair.Casts(box, here, ways, box, new[] { there[1], there[1], new Pose(0, 4, 0) }, still);
                Equal("none none 0.5", string.Join(" ", hits.Select(
                    hit => hit.HasValue ? Math.Round(hit.Value.Fraction, 9).ToString() : "none")));
                Throws<ArgumentException>("displacementsB has 0",
                    () => Pair.Casts(box, here, ways, box, there, new Vector[0]));
                Equal(Status.Unsupported, Throws<AbutException>("pair 0: there is no algorithm for plane and plane", () =>
                {
                    Shape floor = Shape.Plane(new Vector(0, 0, 1), 0);
                    Pair.ContactLists(floor, here, floor, here);
                }).Status);
            }
        }

        private static void TheUniverseTellsWhyTwoAreApart()
        {
            using (Universe universe = Row(3, out PartId[] parts, out GeometryId[] geometries))
            {
                Equal(ApartReasons.Detection, universe.WhyApart(geometries[0], geometries[1]));
                universe.Step(0.01);
                Equal(ApartReasons.None, universe.WhyApart(geometries[0], geometries[1]));
                Equal(ApartReasons.Boxes, universe.WhyApart(geometries[0], geometries[2]));
                universe.Park(geometries[0], Parking.ShortTerm);
                Equal(ApartReasons.Parking, universe.WhyApart(geometries[0], geometries[1]));
                using (Shape probe = Shape.Sphere(0.1))
                {
                    Equal("2", string.Join(" ", universe.Overlaps(probe, new Pose(0.7, 0, 0)).Select(each => each.Slot)));
                    Equal(2, universe.Overlaps(probe, new Pose(2.25, 0, 0), 0.5).Length);
                }
                universe.RemovePart(parts[2]);
                Throws<AbutException>("geometry_b", () => universe.WhyApart(geometries[0], geometries[2]));
            }
        }

        private static void QueriesSeeTheUniverse()
        {
            // Balls of radius 1, each 1.5 from the next.
            using (Universe universe = Row(3, out PartId[] parts, out GeometryId[] geometries))
            {
                universe.Refresh();
                Shape ball = Shape.Sphere(1);
                Vector from = new Vector(-9, 0, 0), along = new Vector(1, 0, 0);
                Equal(geometries[0], universe.CastRay(from, along).Value.Geometry);
                Equal(false, universe.CastRay(from, along, 2).HasValue);
                QueryFilter filter = QueryFilter.All;
                filter.IgnorePart = parts[0];
                Equal(geometries[1], universe.CastRay(from, along, filter: filter).Value.Geometry);
                Pose at = Here;
                at.Position = new Vector(-6, 0, 0);
                Equal(0.5, universe.CastShape(ball, at, new Vector(8, 0, 0)).Value.Fraction);
                Equal(4.0, universe.Closest(ball, at).Value.Distance.Value);
                Equal(false, universe.Closest(ball, at, 1).HasValue);
                Throws<AbutException>("max_distance is", () => universe.Closest(ball, at, -1));
                GeometryOptions options = GeometryOptions.Default;
                options.Tolerance = -1;
                Throws<AbutException>("tolerance is -1", () => universe.AddGeometry(parts[0], ball, options));
                universe.SetPoses(parts, new[] { at, at, at });
                Equal(-6.0, universe.Pose(parts[2]).Position.X);
                Throws<ArgumentException>("poses has 0", () => universe.SetPoses(parts, new Pose[0]));
                universe.RemoveGeometry(geometries[0]);
            }
        }

        private static void PickersSeeRaysAndPixels()
        {
            Universe universe = Row(1, out PartId[] parts, out GeometryId[] geometries);
            using (var picker = new Picker(universe))
            {
                Vector from = new Vector(-5, 0, 0), along = new Vector(1, 0, 0);
                Equal(geometries[0], picker.CastRay(from, along).Value.Geometry);
                Equal(false, picker.CastRay(from, along, 3).HasValue);
                Equal("4 6", string.Join(" ", picker.CastRayAll(from, along).Select(hit => Math.Round(hit.Distance, 9))));
                var camera = new Camera(16, 8);
                camera.LookAt(from, new Vector(0, 0, 0), new Vector(0, 0, 1));
                Equal(geometries[0], picker.PickPixel(camera, 8, 4).Value.Geometry);
                Equal(false, picker.PickPixel(camera, 0.5, 0.5).HasValue);
                Equal(geometries[0], picker.Select(camera, 0, 0, 16, 8, Selection.Inside).Single());
                Equal(0, picker.Select(camera, 0, 0, 1, 1).Length);
                // Seen from five radii the ball is 3 pixels wide: it covers the centres of the middle four.
                Equal(4, picker.Render(camera).Count(hit => hit.Geometry.Slot != 0));
                universe.SetPose(parts[0], new Pose(0, 9, 0));
                Equal(false, picker.CastRay(from, along).HasValue);
                Equal(Status.ZeroVector, Throws<AbutException>("direction", () => picker.CastRay(from, new Vector())).Status);
                // The picker keeps what it needs of the universe.
                universe.Dispose();
                picker.CastRay(from, along);
            }
        }

        private static void StepsFindContactsAndEvents()
        {
            using (Universe universe = Row(2, out PartId[] parts, out GeometryId[] geometries))
            {
                Equal(1, ContactsOfAStep(universe));
                Equal(-0.5, universe.Contacts()[0].Distance);
                Equal(geometries[1], universe.Contacts()[0].GeometryB);
                Equal(EventKind.Begin, universe.Events()[0].Kind);
                Equal(geometries[0], universe.CastRay(new Vector(-5, 0, 0), new Vector(1, 0, 0)).Value.Geometry);
                Equal(false, universe.CastRay(new Vector(-5, 0, 0), new Vector(-1, 0, 0)).HasValue);
                universe.SetPose(parts[1], new Pose(9, 0, 0));
                Equal(0, ContactsOfAStep(universe));
                Equal(EventKind.End, universe.Events()[0].Kind);
            }
        }

        private static void FiltersAreAskedAndMayParkAndThrow()
        {
            using (Universe universe = Row(3, out _, out GeometryId[] geometries))
            {
                int asked = 0;
                universe.SetFilter((a, b) =>
                {
                    ++asked;
                    universe.Park(geometries[0], Parking.LongTerm);
                    return b.Slot != geometries[2].Slot;
                });
                GC.Collect();
                Equal(1, ContactsOfAStep(universe));
                Equal(2, asked);
                Equal(0, ContactsOfAStep(universe));
                universe.SetFilter((a, b) => throw new InvalidOperationException("no idea"));
                Throws<InvalidOperationException>("no idea", () => universe.Step(0.01));
                universe.SetFilter(null);
                Equal(1, ContactsOfAStep(universe));
            }
        }

        // With an argument the library for picking is there.
        private static void Main(string[] arguments)
        {
            var tests = new List<Action>
            {
                StructsAreThoseOfTheLibrary, EveryKindCanBeMade, BadInputIsNamed, TwoShapes, BatchesAreThoseOfEachPair,
                StepsFindContactsAndEvents, FiltersAreAskedAndMayParkAndThrow, TheUniverseTellsWhyTwoAreApart,
                QueriesSeeTheUniverse,
            };
            if (arguments.Length > 0)
            {
                tests.Add(PickersSeeRaysAndPixels);
            }
            foreach (Action test in tests)
            {
                test();
                Console.WriteLine("passed " + test.Method.Name);
            }
        }
    }
}
