// SPDX-License-Identifier: Apache-2.0
using System;
using System.Runtime.InteropServices;

namespace Abut
{
    /// <summary>What went wrong; include/abut/abut.h describes each.</summary>
    public enum Status
    {
        InvalidArgument = 1, NullArgument, NotFinite, OutOfRange, ZeroVector, NotUnit, IndexOutOfRange, SizeOverflow, Empty,
        StaleId, WrongStructSize, UnknownValue, Unsupported, NotConverged, OutOfMemory, Internal, Busy
    }

    /// <summary>A call that failed, and changed nothing. The message names the argument and the value.</summary>
    public sealed class AbutException : Exception
    {
        public Status Status { get; }

        internal AbutException(Status status, string message) : base(message)
        {
            Status = status;
        }
    }

    /// <summary>x, y, z.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct Vector
    {
        public double X, Y, Z;

        public Vector(double x, double y, double z)
        {
            X = x;
            Y = y;
            Z = z;
        }

        public override string ToString() => $"({X}, {Y}, {Z})";
    }

    /// <summary>Unit quaternion, scalar first.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct Quaternion
    {
        public double W, X, Y, Z;
    }

    /// <summary>Maps local points p to Orientation * p + Position.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct Pose
    {
        public Vector Position;
        public Quaternion Orientation;

        /// <summary>At a place, not turned.</summary>
        public Pose(double x, double y, double z)
        {
            Position = new Vector(x, y, z);
            Orientation = new Quaternion { W = 1 };
        }
    }

    /// <summary>Names a part: a body with a pose. When the part is gone, calls throw Status.StaleId.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct PartId
    {
        public uint Slot, Generation;
    }

    /// <summary>Names a geometry: a shape on a part. Zeros name none.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct GeometryId
    {
        public uint Slot, Generation;
    }

    /// <summary>What of a shape touches or is hit: kind as in abut.h, and the shape's own number.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct Feature
    {
        public uint Kind, Index;
    }

    /// <summary>Signed distance of two shapes, negative where they overlap; the true one lies in [Lower, Upper].</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct Distance
    {
        public double Value, Lower, Upper;
        public Vector PointA, PointB, Normal;
        public uint Algorithm, Iterations;
    }

    /// <summary>One contact point of two shapes. The normal is unit and points from a to b.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct Contact
    {
        public GeometryId GeometryA, GeometryB;
        public ulong Id;
        public Feature FeatureA, FeatureB;
        public uint ChildA, ChildB;
        public Vector PointA, PointB, Normal;
        public double Distance, Toi;
        public uint Flags, Age;
        public ulong UserData;
        public uint MaterialA, MaterialB;
        public Vector Tangent;
        private readonly ulong reserved;
    }

    public enum EventKind : uint { Begin, Persist, End }

    /// <summary>A pair that began to touch, still touches or ended.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct Event
    {
        public EventKind Kind;
        public uint Flags;
        public GeometryId GeometryA, GeometryB;
        public ulong ContactId;
        public uint FirstContact, ContactCount;
    }

    [StructLayout(LayoutKind.Sequential)]
    public struct Ray
    {
        public Vector Origin, Direction;
        public double MaxDistance;
    }

    /// <summary>Where a ray meets a geometry.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct Hit
    {
        public GeometryId Geometry;
        public Feature Feature;
        public uint Child;
        private readonly uint reserved;
        public double Distance;
        public Vector Point, Normal;
    }

    /// <summary>Where a moving shape first touches another.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct CastHit
    {
        /// <summary>What is met; null for two shapes alone.</summary>
        public GeometryId Geometry;
        /// <summary>Of the displacement.</summary>
        public double Fraction;
        public Distance Contact;
        public Feature FeatureA, FeatureB;
        public uint ChildA, ChildB;
    }

    /// <summary>What keeps two geometries from being examined: all reasons that hold.</summary>
    [Flags]
    public enum ApartReasons : uint
    {
        None = 0, Part = 1, Motion = 2, Parking = 4, Exclusion = 8, Layers = 16, Rule = 32, Filter = 64, Kinds = 128,
        Boxes = 256, Policy = 512, Detection = 1024, Side = 2048
    }

    /// <summary>How a part moves. Pairs of parts of which neither is dynamic are never examined.</summary>
    public enum Motion : uint { Dynamic, Animated, Static }

    /// <summary>Whether a geometry takes part.</summary>
    public enum Parking : uint { None, ShortTerm, LongTerm }
}
