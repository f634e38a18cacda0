// SPDX-License-Identifier: Apache-2.0
using System;
using System.Runtime.ExceptionServices;
using System.Runtime.InteropServices;

namespace Abut
{
    /// <summary>A space in which parts meet. One thread at a time may change it.</summary>
    public sealed class Universe : SafeHandle
    {
        // The library keeps the function, so nobody may collect it.
        private Filter filter;
        private Exception failure;

        /// <param name="threads">Of a step; 0 is as many as there may be.</param>
        /// <param name="welds">Whether static geometries that lie side by side have contacts as one shape.</param>
        public Universe(uint threads = 1, bool welds = false) : base(IntPtr.Zero, true)
        {
            Native.abut_universe_options_init(
                out UniverseOptions options, (uint)Marshal.SizeOf(typeof(UniverseOptions)));
            options.Threads = threads;
            options.Flags = welds ? UniverseFlags.Welds : 0;
            Native.Check(Native.abut_universe_create(new[] { options }, out IntPtr universe));
            SetHandle(universe);
        }

        public override bool IsInvalid => handle == IntPtr.Zero;

        protected override bool ReleaseHandle()
        {
            Native.abut_universe_destroy(handle);
            return true;
        }

        /// <summary>Creates a part, which has no geometry yet.</summary>
        public PartId AddPart(Pose pose, Motion motion = Motion.Dynamic)
        {
            Native.abut_part_options_init(out PartOptions options, (uint)Marshal.SizeOf(typeof(PartOptions)));
            options.Pose = pose;
            options.Motion = motion;
            Native.Check(Native.abut_part_create(this, new[] { options }, out PartId part));
            return part;
        }

        /// <summary>Destroys a part with its geometries.</summary>
        public void RemovePart(PartId part) => Native.Check(Native.abut_part_destroy(this, part));

        /// <summary>Places a part; takes effect for contacts at the next step.</summary>
        public void SetPose(PartId part, Pose pose) => Native.Check(Native.abut_part_set_pose(this, part, ref pose));

        /// <summary>Puts a shape on a part. The universe keeps the shape alive.</summary>
        public GeometryId AddGeometry(PartId part, Shape shape)
        {
            Native.Check(Native.abut_geometry_create(this, part, shape, null, out GeometryId geometry));
            return geometry;
        }

        /// <summary>The same with options; begin with GeometryOptions.Default.</summary>
        public GeometryId AddGeometry(PartId part, Shape shape, GeometryOptions options)
        {
            Native.Check(Native.abut_geometry_create(this, part, shape, new[] { options }, out GeometryId geometry));
            return geometry;
        }

        /// <summary>Destroys a geometry.</summary>
        public void RemoveGeometry(GeometryId geometry) => Native.Check(Native.abut_geometry_destroy(this, geometry));

        /// <summary>Where a part is.</summary>
        public Pose Pose(PartId part)
        {
            Native.Check(Native.abut_part_pose(this, part, out Pose pose));
            return pose;
        }

        /// <summary>Places parts, all or none.</summary>
        public void SetPoses(PartId[] parts, Pose[] poses)
        {
            Pair.ExpectAsMany("parts", parts, "poses", poses);
            Native.Check(Native.abut_parts_set_poses(this, parts, poses, (UIntPtr)(uint)parts.Length));
        }

        /// <summary>Makes queries see the present poses, without looking for contacts. A step does that as well.</summary>
        public void Refresh() => Native.Check(Native.abut_universe_refresh(this));

        /// <summary>Parks a geometry, or brings it back. A filter may do that, too.</summary>
        public void Park(GeometryId geometry, Parking parking)
        {
            Native.Check(Native.abut_geometry_park(this, geometry, parking));
        }

        /// <summary>Why two geometries are not examined; None where they are, so that the distance of their shapes
        /// decides.</summary>
        public ApartReasons WhyApart(GeometryId a, GeometryId b)
        {
            Native.Check(Native.abut_universe_why_apart(this, a, b, out ApartReasons reasons));
            return reasons;
        }

        /// <summary>Geometries that a shape touches, or has within a margin, ordered by slot.</summary>
        public GeometryId[] Overlaps(Shape shape, Pose pose, double margin = 0)
        {
            return Native.Filled<GeometryId>(8, (GeometryId[] place, UIntPtr capacity, out UIntPtr count) =>
                Native.abut_universe_overlaps(this, shape, ref pose, null, margin, place, capacity, out count));
        }

        /// <summary>Says which pairs that come near are kept; null keeps all. What it throws keeps the pair, and comes out
        /// of the step.</summary>
        public void SetFilter(Func<GeometryId, GeometryId, bool> keeps)
        {
            Filter asked = null;
            if (keeps != null)
            {
                asked = (context, universe, a, b) => Ask(keeps, a, b);
            }
            Native.Check(Native.abut_universe_set_filter(this, asked, IntPtr.Zero));
            filter = asked;
        }

        // No exception may pass through C.
        private uint Ask(Func<GeometryId, GeometryId, bool> keeps, GeometryId a, GeometryId b)
        {
            try
            {
                return failure != null || keeps(a, b) ? 1u : 0u;
            }
            catch (Exception thrown)
            {
                failure = thrown;
                return 1;
            }
        }

        /// <summary>Finds what touches at the present poses; dt is the time since the step before. It moves nothing.</summary>
        public void Step(double dt)
        {
            Status status = Native.abut_universe_step(this, dt);
            GC.KeepAlive(filter);
            Exception thrown = failure;
            failure = null;
            if (thrown != null)
            {
                ExceptionDispatchInfo.Capture(thrown).Throw();
            }
            Native.Check(status);
        }

        /// <summary>Contacts of the last step, copied, ordered by the slots of the two geometries.</summary>
        public Contact[] Contacts()
        {
            Native.Check(Native.abut_universe_contacts(this, out IntPtr first, out UIntPtr count));
            return Copied<Contact>(first, count);
        }

        /// <summary>Events of the last step, copied.</summary>
        public Event[] Events()
        {
            Native.Check(Native.abut_universe_events(this, out IntPtr first, out UIntPtr count));
            return Copied<Event>(first, count);
        }

        private T[] Copied<T>(IntPtr first, UIntPtr count) where T : struct
        {
            var values = new T[(int)count];
            int size = Marshal.SizeOf(typeof(T));
            for (int i = 0; i < values.Length; ++i)
            {
                values[i] = (T)Marshal.PtrToStructure(IntPtr.Add(first, i * size), typeof(T));
            }
            GC.KeepAlive(this);
            return values;
        }

        /// <summary>The first geometry that a ray meets; null for none. It sees poses as of the last step.</summary>
        public Hit? CastRay(
            Vector origin, Vector direction, double maxDistance = double.PositiveInfinity, QueryFilter? filter = null)
        {
            return CastRays(
                new[] { new Ray { Origin = origin, Direction = direction, MaxDistance = maxDistance } }, filter)[0];
        }

        /// <summary>The first geometry that each of many rays meets.</summary>
        public Hit?[] CastRays(Ray[] rays, QueryFilter? filter = null)
        {
            var hits = new Hit[rays.Length];
            Native.Check(Native.abut_universe_cast_rays(this, rays, (UIntPtr)(uint)rays.Length, Given(filter), hits));
            return Array.ConvertAll(hits, hit => hit.Geometry.Slot != 0 ? hit : (Hit?)null);
        }

        /// <summary>The first geometry that a shape meets while it moves by a displacement; null for none.</summary>
        public CastHit? CastShape(Shape shape, Pose pose, Vector displacement, QueryFilter? filter = null)
        {
            var hits = new CastHit[1];
            Native.Check(Native.abut_universe_cast_shape(this, shape, ref pose, ref displacement, Given(filter),
                HitMode.Nearest, hits, (UIntPtr)1u, out UIntPtr count));
            return (ulong)count > 0 ? hits[0] : (CastHit?)null;
        }

        /// <summary>The geometry nearest to a shape; null where none is as near as the distance.</summary>
        public Closest? Closest(
            Shape shape, Pose pose, double maxDistance = double.PositiveInfinity, QueryFilter? filter = null)
        {
            Native.Check(Native.abut_universe_closest(
                this, shape, ref pose, maxDistance, Given(filter), out Closest closest, out uint found));
            return found == 1 ? closest : (Closest?)null;
        }

        private static QueryFilter[] Given(QueryFilter? filter) => filter.HasValue ? new[] { filter.Value } : null;
    }
}
