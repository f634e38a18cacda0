// SPDX-License-Identifier: Apache-2.0
using System;
using System.Runtime.InteropServices;

namespace Abut
{
    /// <summary>A shape. It never changes, so threads and geometries may share it.</summary>
    public sealed class Shape : SafeHandle
    {
        private Shape(IntPtr pointer) : base(IntPtr.Zero, true)
        {
            SetHandle(pointer);
        }

        public override bool IsInvalid => handle == IntPtr.Zero;

        protected override bool ReleaseHandle()
        {
            Native.abut_shape_release(handle);
            return true;
        }

        private static Shape Made(Status status, IntPtr pointer)
        {
            Native.Check(status);
            return new Shape(pointer);
        }

        /// <summary>A solid ball, centred.</summary>
        public static Shape Sphere(double radius)
        {
            return Made(Native.abut_sphere_create(radius, out IntPtr shape), shape);
        }

        /// <summary>A solid box, centred, from half extents.</summary>
        public static Shape Box(double x, double y, double z)
        {
            return Made(Native.abut_box_create(x, y, z, out IntPtr shape), shape);
        }

        /// <summary>All points within a radius of a segment along local Z.</summary>
        public static Shape Capsule(double radius, double halfHeight)
        {
            return Made(Native.abut_capsule_create(radius, halfHeight, out IntPtr shape), shape);
        }

        /// <summary>A solid cylinder along local Z with flat ends.</summary>
        public static Shape Cylinder(double radius, double halfHeight)
        {
            return Made(Native.abut_cylinder_create(radius, halfHeight, out IntPtr shape), shape);
        }

        /// <summary>Terrain: columns * rows heights, X fastest.</summary>
        public static Shape HeightField(uint columns, uint rows, double spacingX, double spacingY, double[] heights)
        {
            if (heights == null || (ulong)heights.Length != (ulong)columns * rows)
            {
                throw new ArgumentException(
                    $"heights has {heights?.Length} numbers; expected columns * rows, which is {(ulong)columns * rows}");
            }
            Native.abut_height_field_desc_init(out HeightFieldDesc desc, (uint)Marshal.SizeOf(typeof(HeightFieldDesc)));
            GCHandle pinned = GCHandle.Alloc(heights, GCHandleType.Pinned);
            try
            {
                desc.Columns = columns;
                desc.Rows = rows;
                desc.SpacingX = spacingX;
                desc.SpacingY = spacingY;
                desc.Heights = pinned.AddrOfPinnedObject();
                return Made(Native.abut_height_field_create(ref desc, out IntPtr shape), shape);
            }
            finally
            {
                pinned.Free();
            }
        }

        /// <summary>Small balls of one radius.</summary>
        public static Shape Particles(Vector[] centres, double radius)
        {
            return Made(Native.abut_particles_create(Numbers(centres), Count(centres), radius, out IntPtr shape), shape);
        }

        /// <summary>One shape of several, each with a pose in its frame. It keeps its children alive.</summary>
        public static Shape Composite(Shape[] children, Pose[] poses)
        {
            Pair.ExpectAsMany("children", children, "poses", poses);
            IntPtr[] pointers = Array.ConvertAll(children, child => child.handle);
            Status status = Native.abut_composite_create(pointers, poses, Count(children), out IntPtr shape);
            GC.KeepAlive(children);
            return Made(status, shape);
        }

        /// <summary>The half-space of the points p with dot(normal, p) at most the offset.</summary>
        public static Shape Plane(Vector normal, double offset)
        {
            return Made(Native.abut_plane_create(ref normal, offset, out IntPtr shape), shape);
        }

        /// <summary>The convex hull of points.</summary>
        public static Shape Hull(Vector[] points)
        {
            return Made(Native.abut_hull_create(Numbers(points), Count(points), out IntPtr shape), shape);
        }

        /// <summary>A surface of triangles, each three indices, counter-clockwise seen from the front.</summary>
        public static Shape Mesh(Vector[] vertices, uint[] triangles)
        {
            if (triangles.Length % 3 != 0)
            {
                throw new ArgumentException($"triangles has {triangles.Length} indices, which is not a multiple of 3");
            }
            var count = (UIntPtr)(uint)(triangles.Length / 3);
            return Made(Native.abut_mesh_create(
                Numbers(vertices), Count(vertices), triangles, count, null, out IntPtr shape), shape);
        }

        /// <summary>Any kind that numbers describe, such as "cone" from radius and half height.</summary>
        public static Shape OfKind(string kind, params double[] parameters)
        {
            Native.abut_shape_desc_init(out ShapeDesc desc, (uint)Marshal.SizeOf(typeof(ShapeDesc)));
            GCHandle pinned = GCHandle.Alloc(parameters, GCHandleType.Pinned);
            try
            {
                desc.Kind = Native.abut_shape_kind_by_name(kind);
                desc.Parameters = pinned.AddrOfPinnedObject();
                desc.ParameterCount = (ulong)parameters.Length;
                return Made(Native.abut_shape_create(ref desc, out IntPtr shape), shape);
            }
            finally
            {
                pinned.Free();
            }
        }

        /// <summary>Name of the kind, such as "sphere".</summary>
        public string Kind => Native.Text(Native.abut_shape_kind_name(Native.abut_shape_kind_of(this)));

        private static double[] Numbers(Vector[] vectors)
        {
            var numbers = new double[3 * vectors.Length];
            for (int i = 0; i < vectors.Length; ++i)
            {
                numbers[3 * i] = vectors[i].X;
                numbers[3 * i + 1] = vectors[i].Y;
                numbers[3 * i + 2] = vectors[i].Z;
            }
            return numbers;
        }

        private static UIntPtr Count(Array values) => (UIntPtr)(uint)values.Length;
    }

    /// <summary>Queries on two shapes.</summary>
    public static class Pair
    {
        /// <summary>Their signed distance.</summary>
        public static Distance Distance(Shape a, Pose poseA, Shape b, Pose poseB)
        {
            Native.Check(Native.abut_pair_distance(a, ref poseA, b, ref poseB, null, out Distance distance));
            return distance;
        }

        /// <summary>Whether they are within a margin; of 0, whether they overlap or touch.</summary>
        public static bool Overlaps(Shape a, Pose poseA, Shape b, Pose poseB, double margin = 0)
        {
            Native.abut_query_options_init(
                out QueryOptions options, (uint)Marshal.SizeOf(typeof(QueryOptions)));
            options.Margin = margin;
            Native.Check(Native.abut_pair_overlaps(a, ref poseA, b, ref poseB, new[] { options }, out uint overlap));
            return overlap == 1;
        }

        /// <summary>Signed distances at many pairs of poses, in one call.</summary>
        public static Distance[] Distances(Shape a, Pose[] posesA, Shape b, Pose[] posesB)
        {
            ExpectAsMany("posesA", posesA, "posesB", posesB);
            var distances = new Distance[posesA.Length];
            Native.Check(Native.abut_pairs_distance(
                a, posesA, b, posesB, (UIntPtr)(uint)posesA.Length, null, distances));
            return distances;
        }

        /// <summary>Their contact points, deepest first.</summary>
        public static Contact[] Contacts(Shape a, Pose poseA, Shape b, Pose poseB)
        {
            return Native.Filled<Contact>(8, (Contact[] contacts, UIntPtr capacity, out UIntPtr count) =>
                Native.abut_pair_contacts(a, ref poseA, b, ref poseB, null, contacts, capacity, out count));
        }

        /// <summary>The same for many pairs of poses, in one call: an array for each pair.</summary>
        public static Contact[][] ContactLists(Shape a, Pose[] posesA, Shape b, Pose[] posesB)
        {
            ExpectAsMany("posesA", posesA, "posesB", posesB);
            var offsets = new ulong[posesA.Length + 1];
            var pairs = (UIntPtr)(uint)posesA.Length;
            Contact[] all = Native.Filled<Contact>(
                4 * posesA.Length, (Contact[] contacts, UIntPtr capacity, out UIntPtr count) => Native.abut_pairs_contacts(
                    a, posesA, b, posesB, pairs, null, offsets, contacts, capacity, out count));
            var lists = new Contact[posesA.Length][];
            for (int i = 0; i < lists.Length; ++i)
            {
                lists[i] = new Contact[offsets[i + 1] - offsets[i]];
                Array.Copy(all, (long)offsets[i], lists[i], 0, lists[i].Length);
            }
            return lists;
        }

        /// <summary>When two shapes that move by displacements without turning first touch, for many poses and displacements;
        /// null where they never do.</summary>
        public static CastHit?[] Casts(
            Shape a, Pose[] posesA, Vector[] displacementsA, Shape b, Pose[] posesB, Vector[] displacementsB)
        {
            ExpectAsMany("posesA", posesA, "displacementsA", displacementsA);
            ExpectAsMany("posesA", posesA, "posesB", posesB);
            ExpectAsMany("posesA", posesA, "displacementsB", displacementsB);
            var hits = new CastHit[posesA.Length];
            Native.Check(Native.abut_pairs_cast(
                a, posesA, displacementsA, b, posesB, displacementsB, (UIntPtr)(uint)hits.Length, null, hits));
            return Array.ConvertAll(hits, hit => double.IsInfinity(hit.Fraction) ? (CastHit?)null : hit);
        }

        internal static void ExpectAsMany(string nameA, Array a, string nameB, Array b)
        {
            if (a.Length != b.Length)
            {
                throw new ArgumentException($"{nameA} has {a.Length} elements and {nameB} has {b.Length}; expected as many");
            }
        }
    }
}
