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
}
