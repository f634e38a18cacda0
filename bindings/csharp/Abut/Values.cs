// SPDX-License-Identifier: Apache-2.0
using System;

namespace Abut
{
    /// <summary>A call that failed, and changed nothing. The message names the argument and the value.</summary>
    public sealed class AbutException : Exception
    {
        public Status Status { get; }

        internal AbutException(Status status, string message) : base(message)
        {
            Status = status;
        }
    }

    public partial struct Vector
    {
        public Vector(double x, double y, double z)
        {
            X = x;
            Y = y;
            Z = z;
        }

        public override string ToString() => $"({X}, {Y}, {Z})";
    }

    public partial struct Pose
    {
        /// <summary>At a place, not turned.</summary>
        public Pose(double x, double y, double z)
        {
            Position = new Vector(x, y, z);
            Orientation = new Quaternion { W = 1 };
        }
    }

    public partial struct GeometryOptions
    {
        /// <summary>What a geometry has where nothing else is said.</summary>
        public static GeometryOptions Default
        {
            get
            {
                Native.abut_geometry_options_init(
                    out GeometryOptions options, (uint)System.Runtime.InteropServices.Marshal.SizeOf(typeof(GeometryOptions)));
                return options;
            }
        }
    }

    public partial struct QueryFilter
    {
        /// <summary>A filter that keeps all.</summary>
        public static QueryFilter All
        {
            get
            {
                Native.abut_query_filter_init(
                    out QueryFilter filter, (uint)System.Runtime.InteropServices.Marshal.SizeOf(typeof(QueryFilter)));
                return filter;
            }
        }
    }
}
