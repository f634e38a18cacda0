// SPDX-License-Identifier: Apache-2.0
using System;
using System.Runtime.InteropServices;

namespace Abut
{
    /// <summary>Calls of the C interface; include/abut/abut.h describes each.</summary>
    internal static class Native
    {
        private const string Library = "abut";

        // The library is that of 0.2; another one of 0.x has other structs.
        private const uint Major = 0, Minor = 2;

        static Native()
        {
            Check(abut_check_version(Major, Minor));
        }

        /// <summary>Throws what a status stands for. The message belongs to this thread and this moment.</summary>
        internal static void Check(int status)
        {
            if (status != 0)
            {
                throw new AbutException((Status)status, Text(abut_last_error_message()));
            }
        }

        internal delegate int Fill<T>(T[] place, UIntPtr capacity, out UIntPtr count);

        /// <summary>The whole answer of a call that fills arrays of unknown length.</summary>
        internal static T[] Filled<T>(int room, Fill<T> fill)
        {
            var values = new T[room];
            while (true)
            {
                Check(fill(values, (UIntPtr)(uint)values.Length, out UIntPtr count));
                bool isComplete = (ulong)count <= (ulong)values.Length;
                Array.Resize(ref values, (int)count);
                if (isComplete)
                {
                    return values;
                }
            }
        }

        internal static string Text(IntPtr text)
        {
            return Marshal.PtrToStringAnsi(text);
        }

        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate uint Filter(IntPtr context, IntPtr universe, GeometryId a, GeometryId b);

        [StructLayout(LayoutKind.Sequential)]
        internal struct PartOptions
        {
            public uint StructSize;
            public Motion Motion;
            public Pose Pose;
            public ulong UserData;
        }

        [StructLayout(LayoutKind.Sequential)]
        internal struct UniverseOptions
        {
            public uint StructSize, Broadphase, ToleranceMode, MaxContacts;
            public Vector Origin;
            public uint Threads, Events, Flags, MaxPairContacts;
        }

        [StructLayout(LayoutKind.Sequential)]
        internal struct ShapeDesc
        {
            public uint StructSize, Kind;
            public IntPtr Parameters;
            public ulong ParameterCount;
            public IntPtr Reals;
            public ulong RealCount;
            public IntPtr Indices;
            public ulong IndexCount;
        }

        [StructLayout(LayoutKind.Sequential)]
        internal struct QueryOptions
        {
            public uint StructSize, Algorithm;
            public double ErrorBound, Margin;
            public uint MaxContacts, MaxPairContacts, Threads, Reserved;
        }

        [StructLayout(LayoutKind.Sequential)]
        internal struct LayoutEntry
        {
            public IntPtr Type, Field;
            public ulong Offset, Size;
        }

        [DllImport(Library)] internal static extern int abut_check_version(uint major, uint minor);
        [DllImport(Library)] internal static extern IntPtr abut_last_error_message();
        [DllImport(Library)] internal static extern UIntPtr abut_layout_count();
        [DllImport(Library)] internal static extern int abut_layout_at(UIntPtr index, out LayoutEntry entry);

        [DllImport(Library)] internal static extern int abut_sphere_create(double radius, out IntPtr shape);
        [DllImport(Library)] internal static extern int abut_box_create(double x, double y, double z, out IntPtr shape);
        [DllImport(Library)] internal static extern int abut_capsule_create(double radius, double halfHeight, out IntPtr shape);
        [DllImport(Library)] internal static extern int abut_plane_create(ref Vector normal, double offset, out IntPtr shape);
        [DllImport(Library)] internal static extern int abut_hull_create(Vector[] points, UIntPtr count, out IntPtr shape);
        [DllImport(Library)] internal static extern int abut_mesh_create(
            Vector[] vertices, UIntPtr vertexCount, uint[] triangles, UIntPtr triangleCount, IntPtr options, out IntPtr shape);
        [DllImport(Library)] internal static extern void abut_shape_desc_init(out ShapeDesc desc, uint size);
        [DllImport(Library)] internal static extern int abut_shape_create(ref ShapeDesc desc, out IntPtr shape);
        [DllImport(Library)] internal static extern void abut_shape_release(IntPtr shape);
        [DllImport(Library)] internal static extern uint abut_shape_kind_by_name(string name);
        [DllImport(Library)] internal static extern IntPtr abut_shape_kind_name(uint kind);
        [DllImport(Library)] internal static extern uint abut_shape_kind_of(Shape shape);

        [DllImport(Library)] internal static extern int abut_pair_distance(
            Shape a, ref Pose poseA, Shape b, ref Pose poseB, IntPtr options, out Distance distance);
        [DllImport(Library)] internal static extern void abut_query_options_init(out QueryOptions options, uint size);
        [DllImport(Library)] internal static extern int abut_pair_overlaps(
            Shape a, ref Pose poseA, Shape b, ref Pose poseB, ref QueryOptions options, out uint overlap);
        [DllImport(Library)] internal static extern int abut_pairs_distance(
            Shape a, Pose[] posesA, Shape b, Pose[] posesB, UIntPtr count, IntPtr options, [Out] Distance[] distances);
        [DllImport(Library)] internal static extern int abut_pair_contacts(
            Shape a, ref Pose poseA, Shape b, ref Pose poseB, IntPtr options, [Out] Contact[] contacts, UIntPtr capacity,
            out UIntPtr count);

        [DllImport(Library)] internal static extern int abut_pairs_contacts(
            Shape a, Pose[] posesA, Shape b, Pose[] posesB, UIntPtr pairCount, IntPtr options, [Out] ulong[] offsets,
            [Out] Contact[] contacts, UIntPtr capacity, out UIntPtr count);
        [DllImport(Library)] internal static extern int abut_pairs_cast(
            Shape a, Pose[] posesA, Vector[] displacementsA, Shape b, Pose[] posesB, Vector[] displacementsB, UIntPtr count,
            IntPtr options, [Out] CastHit[] hits);

        [DllImport(Library)] internal static extern void abut_universe_options_init(out UniverseOptions options, uint size);
        [DllImport(Library)] internal static extern int abut_universe_create(ref UniverseOptions options, out IntPtr universe);
        [DllImport(Library)] internal static extern void abut_universe_destroy(IntPtr universe);
        [DllImport(Library)] internal static extern void abut_part_options_init(out PartOptions options, uint size);
        [DllImport(Library)] internal static extern int abut_part_create(
            Universe universe, ref PartOptions options, out PartId part);
        [DllImport(Library)] internal static extern int abut_part_destroy(Universe universe, PartId part);
        [DllImport(Library)] internal static extern int abut_part_set_pose(Universe universe, PartId part, ref Pose pose);
        [DllImport(Library)] internal static extern int abut_geometry_create(
            Universe universe, PartId part, Shape shape, IntPtr options, out GeometryId geometry);
        [DllImport(Library)] internal static extern int abut_geometry_park(
            Universe universe, GeometryId geometry, Parking parking);
        [DllImport(Library)] internal static extern int abut_universe_set_filter(
            Universe universe, Filter filter, IntPtr context);
        [DllImport(Library)] internal static extern int abut_universe_why_apart(
            Universe universe, GeometryId a, GeometryId b, out ApartReasons reasons);
        [DllImport(Library)] internal static extern int abut_universe_overlaps(
            Universe universe, Shape shape, ref Pose pose, IntPtr filter, double margin, [Out] GeometryId[] geometries,
            UIntPtr capacity, out UIntPtr count);
        [DllImport(Library)] internal static extern int abut_universe_step(Universe universe, double dt);
        [DllImport(Library)] internal static extern int abut_universe_contacts(
            Universe universe, out IntPtr contacts, out UIntPtr count);
        [DllImport(Library)] internal static extern int abut_universe_events(
            Universe universe, out IntPtr events, out UIntPtr count);
        [DllImport(Library)] internal static extern int abut_universe_cast_rays(
            Universe universe, ref Ray ray, UIntPtr count, IntPtr filter, out Hit hit);
    }
}
