// SPDX-License-Identifier: Apache-2.0
// Made by scripts/interface from the headers in include/abut, where each name is described. Do not edit.
#pragma warning disable 1591
using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;

namespace Abut
{
    /// <summary>Status of a call.</summary>
    public enum Status : int
    {
        Ok = 0, InvalidArgument = 1, NullArgument = 2, NotFinite = 3, OutOfRange = 4, ZeroVector = 5, NotUnit =
        6, IndexOutOfRange = 7, SizeOverflow = 8, Empty = 9, StaleId = 10, WrongStructSize = 11, UnknownValue =
        12, Unsupported = 13, NotConverged = 14, OutOfMemory = 15, Internal = 16, Busy = 17
    }

    /// <summary>What a log hears</summary>
    public enum LogLevel : uint
    {
        None = 0, Error = 1, Warning = 2
    }

    /// <summary>What of a shape takes part in a contact or is hit by a ray.</summary>
    public enum FeatureKind : uint
    {
        Whole = 0, Vertex = 1, Edge = 2, Face = 3, Cell = 4, Particle = 5
    }

    /// <summary>What two shapes can be asked.</summary>
    public enum Query : uint
    {
        Distance = 0, Contacts = 1
    }

    /// <summary>How a triangle mesh is read.</summary>
    public enum Sides : uint
    {
        Both = 0, Front = 1, Solid = 2
    }

    /// <summary>By what volumes the triangles of a mesh are found.</summary>
    public enum MeshTree : uint
    {
        Auto = 0, Aabb = 1, Obb = 2, Sphere = 3
    }

    /// <summary>An axis of the frame of a shape.</summary>
    public enum Axis : uint
    {
        X = 0, Y = 1, Z = 2
    }

    /// <summary>How the cells of a height field are split into triangles</summary>
    public enum Diagonal : uint
    {
        Rising = 0, Falling = 1, Alternating = 2
    }

    /// <summary>What lies below a height field.</summary>
    public enum Below : uint
    {
        Open = 0, Solid = 1
    }

    /// <summary>How values of a distance field follow from its samples.</summary>
    public enum Interpolation : uint
    {
        Linear = 0, Quadratic = 1
    }

    /// <summary>Ends of a cylinder hole that have no wall.</summary>
    [Flags]
    public enum OpenEnds : uint
    {
        None = 0, Top = 1, Bottom = 2
    }

    /// <summary>Faces of a box hole that have no wall.</summary>
    [Flags]
    public enum OpenFaces : uint
    {
        None = 0, XHigh = 1, XLow = 2, YHigh = 4, YLow = 8, ZHigh = 16, ZLow = 32
    }

    public enum Algorithm : uint
    {
        Auto = 0, Analytic = 1, Sat = 2, GjkEpa = 3, LibccdGjk = 4, LibccdMpr = 5, FlatGround = 6,
        SeparatingTranslation = 7, Solid = 8, Field = 9, Hole = 10, Rims = 11
    }

    /// <summary>Bits of the flags of queries.</summary>
    [Flags]
    public enum QueryFlags : uint
    {
        None = 0, Welds = 1
    }

    /// <summary>Bits of the flags of a route.</summary>
    [Flags]
    public enum RouteFlags : uint
    {
        None = 0, Chosen = 1, InTime = 2, InBound = 4
    }

    /// <summary>Bits of the flags of a contact.</summary>
    [Flags]
    public enum ContactFlags : uint
    {
        None = 0, Sensor = 1, Speculative = 2, ReducedAway = 4
    }

    /// <summary>Which closest features abut_elements_closest tells.</summary>
    public enum ClosestMethod : uint
    {
        Features = 0, OfFaces = 1, All = 2, OfVertices = 3, LocalMinima = 4
    }

    /// <summary>Which features a stencil is of.</summary>
    public enum StencilKind : uint
    {
        VertexFace = 0, EdgeEdge = 1, VertexEdge = 2, VertexVertex = 3
    }

    /// <summary>Bits of the flags of abut_elements_options.</summary>
    [Flags]
    public enum ElementsFlags : uint
    {
        None = 0, Only = 1
    }

    /// <summary>Two features whose boxes come near each other.</summary>
    public enum ElementPairKind : uint
    {
        VertexFace = 0, EdgeEdge = 1, FaceVertex = 2
    }

    public enum ImpactState : uint
    {
        Apart = 0, Touches = 1, StartsTogether = 2, Undecided = 3
    }

    public enum Broadphase : uint
    {
        Auto = 0, Brute = 1, Tree = 2, SweepAndPrune = 3, HashGrid = 4
    }

    public enum ToleranceMode : uint
    {
        DeadBand = 0, Margin = 1
    }

    /// <summary>Which events a step writes down.</summary>
    [Flags]
    public enum EventBits : uint
    {
        None = 0, Pairs = 1, Persist = 2, Contacts = 4, Elements = 8
    }

    /// <summary>Bits of the flags of a universe.</summary>
    [Flags]
    public enum UniverseFlags : uint
    {
        None = 0, LocalPoints = 1, Welds = 2
    }

    /// <summary>How a part moves.</summary>
    public enum Motion : uint
    {
        Dynamic = 0, Animated = 1, Static = 2
    }

    /// <summary>Whether a geometry takes part.</summary>
    public enum Parking : uint
    {
        None = 0, ShortTerm = 1, LongTerm = 2
    }

    /// <summary>Bits of the flags of a geometry.</summary>
    [Flags]
    public enum GeometryFlags : uint
    {
        None = 0, Sensor = 1, SelfPairs = 2, Fast = 4, Speculative = 8, KeepsSide = 16
    }

    /// <summary>What a rule speaks of.</summary>
    public enum CollidableKind : uint
    {
        Geometry = 0, Part = 1, Label = 2, Any = 3
    }

    public enum Rule : uint
    {
        None = 0, Enable = 1, Disable = 2
    }

    /// <summary>How much of a pair is found.</summary>
    public enum Detail : uint
    {
        Manifold = 0, Point = 1, Box = 2, Touch = 3, Elements = 4
    }

    public enum EventKind : uint
    {
        Begin = 0, Persist = 1, End = 2
    }

    [Flags]
    public enum EventFlags : uint
    {
        None = 0, Sensor = 1, Contact = 2, Asleep = 4, Elements = 8
    }

    /// <summary>What keeps two geometries from being examined, as bits.</summary>
    [Flags]
    public enum ApartReasons : uint
    {
        None = 0, Part = 1, Motion = 2, Parking = 4, Exclusion = 8, Layers = 16, Rule = 32, Filter = 64, Kinds =
        128, Boxes = 256, Policy = 512, Detection = 1024, Side = 2048
    }

    /// <summary>What will surprise whoever built a scene.</summary>
    public enum FindingCode : uint
    {
        NothingMoves = 0, MeetsNothing = 1, KindsUnsupported = 2, ToleranceTooLarge = 3, FarFromOrigin = 4,
        ExcludedFromAll = 5, RuleDisablesAll = 6, ExclusionInCommon = 7, FilterKeepsNone = 8, AllParked = 9,
        AllOnOnePart = 10, InsideOut = 11, Hollow = 12
    }

    /// <summary>Where the velocity of a part comes from.</summary>
    public enum VelocitySource : uint
    {
        None = 0, Given = 1, FromPoses = 2
    }

    [Flags]
    public enum QueryFilterFlags : uint
    {
        None = 0, Sensors = 1
    }

    /// <summary>What a ray meets that starts inside a solid.</summary>
    public enum RayStart : uint
    {
        FarSide = 0, Solid = 1, Skip = 2
    }

    /// <summary>How many of the geometries that are met are reported.</summary>
    public enum HitMode : uint
    {
        Nearest = 0, Any = 1, All = 2
    }

    /// <summary>How a camera maps space to its picture.</summary>
    public enum Projection : uint
    {
        Perspective = 0, Orthographic = 1
    }

    /// <summary>Along which line near_distance and far_distance of a camera are measured.</summary>
    public enum DepthAxis : uint
    {
        Ray = 0, Axis = 1
    }

    /// <summary>Which depths a projection matrix maps the near and the far plane to.</summary>
    public enum ClipDepth : uint
    {
        Signed = 0, Unsigned = 1
    }

    /// <summary>What the queries of a picker see.</summary>
    [Flags]
    public enum PickerFlags : uint
    {
        None = 0, Sensors = 1, SkipBackFaces = 2
    }

    /// <summary>How similar the rays of a batch are; a hint that changes only the speed.</summary>
    public enum Coherence : uint
    {
        None = 0, Neighbours = 1
    }

    /// <summary>Which geometries a rectangle selects.</summary>
    public enum Selection : uint
    {
        Touching = 0, Inside = 1
    }

    /// <summary>What a cursor may snap to.</summary>
    [Flags]
    public enum SnapKinds : uint
    {
        None = 0, Vertex = 1, Midpoint = 2, Edge = 4
    }

    /// <summary>How a contact problem is solved.</summary>
    public enum Solver : uint
    {
        Newton = 0, Sweeps = 1
    }

    /// <summary>Bits of the flags of a response.</summary>
    [Flags]
    public enum ResponseFlags : uint
    {
        None = 0, Impacts = 1
    }

    /// <summary>How a body goes from one step to the next.</summary>
    public enum Integrator : uint
    {
        Static = 0, Euler = 1, Rk4 = 2, Midpoint = 3, Implicit = 4
    }

    /// <summary>What a side of a rule speaks of.</summary>
    public enum ResponseSideKind : uint
    {
        Any = 0, Geometry = 1, Part = 2, Label = 3, Tag = 4, Material = 5
    }

    /// <summary>What a contact does.</summary>
    public enum ContactState : uint
    {
        Open = 0, Sticking = 1, Sliding = 2, Bonded = 3
    }

    /// <summary>What became of an object in the last step.</summary>
    public enum ResponseEvent : uint
    {
        Begin = 0, Persist = 1, End = 2
    }

    /// <summary>What will surprise whoever built a response.</summary>
    public enum ResponseFindingCode : uint
    {
        DeadBand = 0, NoTolerance = 1, NotDynamic = 2, Asleep = 3, NotFast = 4, Speculative = 5, NoImpacts = 6,
        NoStiffness = 7, Unused = 8, Unreachable = 9, Gone = 10, SlowSweeps = 11, NoFunction = 12
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct Vector
    {
        public double X;
        public double Y;
        public double Z;
    }

    /// <summary>Unit quaternion, scalar first.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct Quaternion
    {
        public double W;
        public double X;
        public double Y;
        public double Z;
    }

    /// <summary>Maps local points p to orientation * p + position.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct Pose
    {
        public Vector Position;
        public Quaternion Orientation;
    }

    /// <summary>Axis-aligned box.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct Aabb
    {
        public Vector Minimum;
        public Vector Maximum;
    }

    /// <summary>A part of a universe</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct PartId
    {
        public uint Slot;
        public uint Generation;
    }

    /// <summary>A collision geometry</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct GeometryId
    {
        public uint Slot;
        public uint Generation;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct Feature
    {
        public FeatureKind Kind;
        public uint Index;
    }

    /// <summary>What a hull has left of its points.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct HullReport
    {
        public uint StructSize;
        public uint Dimension;
        public ulong PointCount;
        public ulong VertexCount;
        public ulong EdgeCount;
        public ulong FaceCount;
        public double Error;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct MeshOptions
    {
        public uint StructSize;
        public Sides Sides;
        public uint Corners;
        public uint MergesVertices;
        public double MergeDistance;
        public MeshTree Tree;
        private readonly uint reserved;
    }

    /// <summary>What is unusual about triangles, in numbers.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct MeshReport
    {
        public uint StructSize;
        private readonly uint reserved;
        public ulong Triangles;
        public ulong Vertices;
        public ulong MergedVertices;
        public ulong CollapsedTriangles;
        public ulong DuplicateVertices;
        public ulong DuplicateTriangles;
        public ulong Slivers;
        public ulong OpenEdges;
        public ulong NonManifoldEdges;
        public ulong ReversedTriangles;
        public ulong TwistedPatches;
        public ulong Components;
        public double MergeError;
        public double Volume;
    }

    /// <summary>The sides of a mesh, and the grid of cells by which its tree is made.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct UvGridOptions
    {
        public uint StructSize;
        public Sides Sides;
        public Axis AxisU;
        public Axis AxisV;
        public uint CellsU;
        public uint CellsV;
        public uint Corners;
        public uint MergesVertices;
        public double MergeDistance;
    }

    /// <summary>Terrain over a regular grid.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct HeightFieldDesc
    {
        public uint StructSize;
        public Diagonal Diagonal;
        public uint Columns;
        public uint Rows;
        public double SpacingX;
        public double SpacingY;
        public IntPtr Heights;
        public Below Below;
        private readonly uint reserved;
    }

    /// <summary>A solid given by its signed distance on a regular grid, negative inside.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct DistanceFieldDesc
    {
        public uint StructSize;
        public uint IsInsideOut;
        public uint Columns;
        public uint Rows;
        public uint Layers;
        public Interpolation Interpolation;
        public Vector Spacing;
        public Vector Origin;
        public IntPtr Values;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct DistanceFieldOptions
    {
        public uint StructSize;
        public uint IsInsideOut;
        public double Spacing;
        public double Band;
        public Interpolation Interpolation;
        private readonly uint reserved;
    }

    /// <summary>What is known of a distance field as a whole.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct DistanceFieldReport
    {
        public uint StructSize;
        public Interpolation Interpolation;
        public ulong BlockCount;
        public ulong HeldBlockCount;
        public double Error;
        public double FarError;
        public double LeastStretch;
        public double MostStretch;
    }

    /// <summary>A child of a composite.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct CompositeChild
    {
        public Pose Pose;
        public uint Material;
        public uint IsHole;
        public uint CutBegin;
        public uint CutEnd;
    }

    /// <summary>The generic door</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct ShapeDesc
    {
        public uint StructSize;
        public uint Kind;
        public IntPtr Parameters;
        public ulong ParameterCount;
        public IntPtr Reals;
        public ulong RealCount;
        public IntPtr Indices;
        public ulong IndexCount;
    }

    /// <summary>A ray.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct Ray
    {
        public Vector Origin;
        public Vector Direction;
        public double MaxDistance;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct RayHit
    {
        public double Distance;
        public Vector Point;
        public Vector Normal;
        public Feature Feature;
        public uint Child;
        private readonly uint reserved;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct QueryOptions
    {
        public uint StructSize;
        public Algorithm Algorithm;
        public double ErrorBound;
        public double Margin;
        public uint MaxContacts;
        public uint MaxPairContacts;
        public uint Threads;
        public QueryFlags Flags;
        public double TimeBudget;
    }

    /// <summary>A way to ask two kinds of shape, as it was measured over ordinary pairs of them.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct Route
    {
        public Algorithm Algorithm;
        public RouteFlags Flags;
        public double ErrorBound;
        public double Seconds;
        public double WorstError;
    }

    /// <summary>Signed distance of two shapes.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct Distance
    {
        public double Value;
        public double Lower;
        public double Upper;
        public Vector PointA;
        public Vector PointB;
        public Vector Normal;
        public Algorithm Algorithm;
        public uint Iterations;
    }

    /// <summary>One contact point, 192 bytes.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct Contact
    {
        public GeometryId GeometryA;
        public GeometryId GeometryB;
        public ulong Id;
        public Feature FeatureA;
        public Feature FeatureB;
        public uint ChildA;
        public uint ChildB;
        public Vector PointA;
        public Vector PointB;
        public Vector Normal;
        public double Distance;
        public double Toi;
        public ContactFlags Flags;
        public uint Age;
        public ulong UserData;
        public uint MaterialA;
        public uint MaterialB;
        public Vector Tangent;
        private readonly ulong reserved;
    }

    /// <summary>What queries remember of a pair of shapes, 64 bytes of the caller</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct PairMemory
    {
        [MarshalAs(UnmanagedType.ByValArray, SizeConst = 8)] public ulong[] Opaque;
    }

    /// <summary>When two features whose vertices move on straight lines first touch.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct FirstTouch
    {
        public uint Touches;
        private readonly uint reserved;
        public double Lower;
        public double Upper;
    }

    /// <summary>How many elements there are.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct ElementCounts
    {
        public ulong Vertices;
        public ulong Edges;
        public ulong Triangles;
        public ulong Faces;
    }

    /// <summary>What a search of elements looks for.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct ElementsOptions
    {
        public uint StructSize;
        public ClosestMethod Method;
        public uint Kinds;
        public ElementsFlags Flags;
        public uint Threads;
        private readonly uint reserved;
        public double Reach;
        public double Tolerance;
        public double RestDistance;
        public double ConeAngle;
        public double ConeFactor;
    }

    /// <summary>Up to four vertices of two features that are near each other, 104 bytes.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct Stencil
    {
        public StencilKind Kind;
        public uint OfA;
        public uint ElementA;
        public uint ElementB;
        [MarshalAs(UnmanagedType.ByValArray, SizeConst = 4)] public uint[] Vertices;
        [MarshalAs(UnmanagedType.ByValArray, SizeConst = 4)] public double[] Weights;
        public Vector Normal;
        public double Distance;
        public double Toi;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct ElementPair
    {
        public ElementPairKind Kind;
        public uint A;
        public uint B;
    }

    /// <summary>An edge that passes a face.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct Crossing
    {
        public uint Edge;
        public uint Face;
        public uint EdgeIsOfB;
        private readonly uint reserved;
        public double Share;
        public Vector Point;
    }

    /// <summary>How a body moves, in the world, by the unit of time.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct Movement
    {
        public Vector Velocity;
        public Vector AngularVelocity;
        public Vector Acceleration;
        public Vector AngularAcceleration;
        public Vector Centre;
    }

    /// <summary>Options of times of impact.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct ImpactOptions
    {
        public uint StructSize;
        public uint MostRounds;
        public double Tolerance;
        public double Margin;
        public uint Threads;
        private readonly uint reserved;
    }

    /// <summary>When two shapes first touch.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct Impact
    {
        public ImpactState State;
        public uint Rounds;
        public double Lower;
        public double Upper;
        public Distance Contact;
        public uint ChildA;
        public uint ChildB;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct UniverseOptions
    {
        public uint StructSize;
        public Broadphase Broadphase;
        public ToleranceMode ToleranceMode;
        public uint MaxContacts;
        public Vector Origin;
        public uint Threads;
        public EventBits Events;
        public UniverseFlags Flags;
        public uint MaxPairContacts;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct PartOptions
    {
        public uint StructSize;
        public Motion Motion;
        public Pose Pose;
        public ulong UserData;
    }

    /// <summary>When a part has come to rest.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct Sleep
    {
        public uint StructSize;
        public uint Steps;
        public double LinearSpeed;
        public double LinearAcceleration;
        public double AngularSpeed;
        public double AngularAcceleration;
    }

    /// <summary>Two geometries are examined when all of this holds, in this order</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct GeometryOptions
    {
        public uint StructSize;
        public GeometryFlags Flags;
        public Pose Pose;
        public double Tolerance;
        public ulong UserData;
        public ulong Layers;
        public ulong Mask;
        public ulong Exclusion;
        public uint Label;
        public uint Tag;
        public uint Material;
        public Parking Parking;
    }

    /// <summary>What a geometry is and where.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct GeometryInfo
    {
        public uint StructSize;
        public uint Kind;
        public PartId Part;
        public IntPtr Shape;
        public Pose Pose;
        public Pose Local;
        public double Tolerance;
        public ulong UserData;
        public ulong Layers;
        public ulong Mask;
        public ulong Exclusion;
        public uint Label;
        public uint Tag;
        public uint Material;
        public Parking Parking;
        public GeometryFlags Flags;
        private readonly uint reserved;
    }

    /// <summary>Counters that tell tools what changed since they last looked.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct Revision
    {
        public ulong Geometries;
        public ulong Poses;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct Collidable
    {
        public CollidableKind Kind;
        public uint Slot;
        public uint Generation;
    }

    /// <summary>How the pairs of two tags are treated</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct Policy
    {
        public uint StructSize;
        public Algorithm Algorithm;
        public Detail Detail;
        public uint Period;
        public double Tolerance;
        public double ErrorBound;
        public ClosestMethod Method;
        public uint Kinds;
        public ElementsFlags Flags;
        private readonly uint reserved;
        public double ContactDistance;
        public double RestDistance;
        public double ConeAngle;
        public double ConeFactor;
        public double TimeBudget;
    }

    /// <summary>Two tags that follow the distance of geometries from centres, such as those of a camera and of what is held</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct Focus
    {
        public uint StructSize;
        public uint NearTag;
        public uint FarTag;
        private readonly uint reserved;
        public double NearDistance;
        public double FarDistance;
    }

    /// <summary>What the contacts of two materials are like</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct ContactMaterial
    {
        public uint StructSize;
        private readonly uint reserved;
        public double FrictionPrimary;
        public double FrictionSecondary;
        public double FrictionSpin;
        public double FrictionRoll;
        public double StaticScale;
        public double Slip;
        public double Compliance;
        public double Damping;
        public double Restitution;
        public double RestitutionThreshold;
        public double AdhesiveForce;
    }

    /// <summary>A pair of geometries that a back end is asked about</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct BackendPair
    {
        public GeometryId GeometryA;
        public GeometryId GeometryB;
        public IntPtr ShapeA;
        public IntPtr ShapeB;
        public Pose PoseA;
        public Pose PoseB;
        public double Margin;
    }

    /// <summary>A contact that a back end has found.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct BackendContact
    {
        public Vector PointA;
        public Vector PointB;
        public Vector Normal;
        public Feature FeatureA;
        public Feature FeatureB;
        public uint ChildA;
        public uint ChildB;
        public ulong Id;
    }

    /// <summary>A pair, or one of its contacts, that began to touch, still touches or ended.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct Event
    {
        public EventKind Kind;
        public EventFlags Flags;
        public GeometryId GeometryA;
        public GeometryId GeometryB;
        public ulong ContactId;
        public uint FirstContact;
        public uint ContactCount;
    }

    /// <summary>A part that fell asleep or woke.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct SleepChange
    {
        public PartId Part;
        public uint IsAsleep;
        private readonly uint reserved;
    }

    /// <summary>The points of one contact in the frames of its two geometries, as these lay when it was found.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct LocalPoints
    {
        public Vector A;
        public Vector B;
    }

    /// <summary>What the last step did.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct StepStats
    {
        public uint StructSize;
        private readonly uint reserved;
        public ulong Parts;
        public ulong Geometries;
        public ulong Parked;
        public ulong Moved;
        public ulong CandidatePairs;
        public ulong FilteredPairs;
        public ulong ExaminedPairs;
        public ulong KeptPairs;
        public ulong TouchingPairs;
        public ulong Contacts;
        public ulong UnsupportedPairs;
        public ulong Events;
        public ulong Bytes;
        public double RefreshMicroseconds;
        public double BroadphaseMicroseconds;
        public double PairMicroseconds;
        public double NarrowphaseMicroseconds;
        public double ContactMicroseconds;
        public ulong Asleep;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct Finding
    {
        public FindingCode Code;
        private readonly uint reserved;
        public GeometryId Geometry;
        public GeometryId Other;
        [MarshalAs(UnmanagedType.ByValArray, SizeConst = 168)] public byte[] Message;
    }

    /// <summary>Dynamic parts that touch each other, directly or through others.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct Island
    {
        public ulong Id;
        public uint FirstPart;
        public uint PartCount;
    }

    /// <summary>In the world frame.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct Velocity
    {
        public Vector Linear;
        public Vector Angular;
    }

    /// <summary>How the velocity of a part changes within a step, in the world frame.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct Acceleration
    {
        public Vector Linear;
        public Vector Angular;
    }

    /// <summary>A touch of two geometries on their paths through a step.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct StepImpact
    {
        public GeometryId GeometryA;
        public GeometryId GeometryB;
        public double Lower;
        public double Upper;
        public uint FirstContact;
        public uint ContactCount;
        public uint IsUndecided;
        private readonly uint reserved;
    }

    /// <summary>A vertex, edge or face of one geometry near one of another, or of the same geometry.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct ElementContact
    {
        public GeometryId GeometryA;
        public GeometryId GeometryB;
        public Stencil Stencil;
        public double Gap;
        public ulong Id;
        public uint Age;
        private readonly uint reserved;
    }

    /// <summary>Which geometries a query looks at</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct QueryFilter
    {
        public uint StructSize;
        public QueryFilterFlags Flags;
        public ulong Layers;
        public ulong Mask;
        public PartId IgnorePart;
        public GeometryId IgnoreGeometry;
        public RayStart RayStart;
        private readonly uint reserved;
    }

    /// <summary>Where a ray meets a geometry; the same fields as abut_query_hit.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct Hit
    {
        public GeometryId Geometry;
        public Feature Feature;
        public uint Child;
        private readonly uint reserved;
        public double Distance;
        public Vector Point;
        public Vector Normal;
    }

    /// <summary>Where a moving shape (a) first touches another (b).</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct CastHit
    {
        public GeometryId Geometry;
        public double Fraction;
        public Distance Contact;
        public Feature FeatureA;
        public Feature FeatureB;
        public uint ChildA;
        public uint ChildB;
    }

    /// <summary>What a shape meets that moves and turns (a)</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct ImpactHit
    {
        public GeometryId Geometry;
        public Impact Impact;
    }

    /// <summary>What is closest to a shape.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct Closest
    {
        public GeometryId Geometry;
        public Distance Distance;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct LayoutEntry
    {
        public IntPtr Type;
        public IntPtr Field;
        public ulong Offset;
        public ulong Size;
    }

    /// <summary>A camera that looks along its local -Z, with local +Y up.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct Camera
    {
        public uint StructSize;
        public uint Width;
        public uint Height;
        public Projection Projection;
        public Pose Pose;
        public double VerticalFov;
        public double NearDistance;
        public double FarDistance;
        public double VerticalExtent;
        public double PixelAspect;
        public double ShiftX;
        public double ShiftY;
        public DepthAxis DepthAxis;
        private readonly uint reserved;
    }

    /// <summary>Keeps the points p with dot(normal, p) &gt;= offset, and cuts all others away.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct ClipPlane
    {
        public Vector Normal;
        public double Offset;
    }

    /// <summary>A vertex, or a point of an edge.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct Snap
    {
        public GeometryId Geometry;
        public SnapKinds Kind;
        [MarshalAs(UnmanagedType.ByValArray, SizeConst = 2)] public uint[] Vertices;
        private readonly uint reserved;
        public double Parameter;
        public double Pixels;
        public double Distance;
        public Vector Point;
    }

    /// <summary>A point of a triangle, as weights of its corners, which add up to 1.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct Barycentric
    {
        public uint Triangle;
        [MarshalAs(UnmanagedType.ByValArray, SizeConst = 3)] public uint[] Vertices;
        [MarshalAs(UnmanagedType.ByValArray, SizeConst = 3)] public double[] Weights;
    }

    /// <summary>Bodies and the contacts between them, at one moment.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct ContactProblem
    {
        public uint StructSize;
        public uint BodyCount;
        public uint ContactCount;
        private readonly uint reserved;
        public IntPtr Masses;
        public IntPtr Inertias;
        public IntPtr Centres;
        public IntPtr FreeVelocities;
        public IntPtr Bodies;
        public IntPtr Points;
        public IntPtr Normals;
        public IntPtr Tangents;
        public IntPtr Frictions;
        public IntPtr Compliances;
        public IntPtr Offsets;
        public IntPtr SurfaceVelocities;
        public IntPtr FirstVelocities;
        public IntPtr FirstImpulses;
    }

    /// <summary>How the solver works, and when it ends.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct SolverOptions
    {
        public uint StructSize;
        public uint MostRounds;
        public double Tolerance;
        public double Speed;
        public Solver Solver;
        private readonly uint reserved;
    }

    /// <summary>How far velocities and impulses are from the law.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct Residuals
    {
        public double Contact;
        public double Motion;
        public double Dissipation;
        public double Speed;
        public uint Rounds;
        public uint NewtonSteps;
        public uint IsConverged;
        private readonly uint reserved;
    }

    /// <summary>Mass of a solid, in the frame that is named where it is used.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct MassProperties
    {
        public double Mass;
        public Vector Centre;
        [MarshalAs(UnmanagedType.ByValArray, SizeConst = 9)] public double[] Inertia;
    }

    /// <summary>How bodies move.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct ResponseOptions
    {
        public uint StructSize;
        public uint MostRounds;
        public Vector Gravity;
        public double Tolerance;
        public double Slop;
        public ResponseFlags Flags;
        public Solver Solver;
        public uint Threads;
        private readonly uint reserved;
    }

    /// <summary>What a body weighs, and how it moves.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct BodyOptions
    {
        public uint StructSize;
        public Integrator Integrator;
        public double Density;
        public MassProperties Mass;
    }

    /// <summary>The material of tetrahedra.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct ElasticOptions
    {
        public uint StructSize;
        private readonly uint reserved;
        public double Young;
        public double Poisson;
        public double Damping;
    }

    /// <summary>A contact between two geometries, as a kind of your own makes it.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct ContactLaw
    {
        public double FrictionPrimary;
        public double FrictionSecondary;
        public double Compliance;
        public double Offset;
        public double Pull;
        public Vector SurfaceVelocity;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct ResponseSide
    {
        public ResponseSideKind Kind;
        public uint Slot;
        public uint Generation;
    }

    /// <summary>A spring, a bond or a mouse between points of two parts, or of a part and the world.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct LinkOptions
    {
        public uint StructSize;
        private readonly uint reserved;
        public PartId A;
        public PartId B;
        public Vector PointA;
        public Vector PointB;
        public double Stiffness;
        public double Damping;
        public double MostForce;
        public double BreakForce;
    }

    /// <summary>A contact of the last step.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct ResponseContact
    {
        public GeometryId GeometryA;
        public GeometryId GeometryB;
        public ulong Id;
        public Vector Point;
        public Vector Normal;
        public Vector Impulse;
        public Vector Force;
        public double Distance;
        public double NormalVelocity;
        public ContactState State;
        public uint Island;
        public uint Kind;
        private readonly uint reserved;
    }

    /// <summary>Two geometries that have contacts or bonds.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct ResponseObject
    {
        public GeometryId GeometryA;
        public GeometryId GeometryB;
        public uint Kind;
        public ResponseEvent Event;
        public uint ContactCount;
        public uint BondCount;
        public uint Age;
        private readonly uint reserved;
        public Vector Impulse;
        public Vector Force;
    }

    /// <summary>Bodies that touch each other, and how well they were solved.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct ResponseIsland
    {
        public uint BodyCount;
        public uint ContactCount;
        public Integrator Integrator;
        private readonly uint reserved;
        public Residuals Residuals;
    }

    /// <summary>Sums over all bodies, as they are now.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct Energy
    {
        public double Kinetic;
        public double Potential;
        public Vector LinearMomentum;
        public Vector AngularMomentum;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct ResponseFinding
    {
        public ResponseFindingCode Code;
        public uint Rule;
        public PartId Part;
        public GeometryId Geometry;
        [MarshalAs(UnmanagedType.ByValArray, SizeConst = 168)] public byte[] Message;
    }

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    internal delegate void Log(IntPtr context, LogLevel level, IntPtr message);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    internal delegate IntPtr Allocate(IntPtr context, UIntPtr size, UIntPtr alignment);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    internal delegate void Release(IntPtr context, IntPtr memory, UIntPtr size, UIntPtr alignment);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    internal delegate uint Filter(IntPtr context, IntPtr universe, GeometryId geometryA, GeometryId geometryB);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    internal delegate uint PointerFilter(IntPtr context, IntPtr universe, IntPtr geometryA, IntPtr geometryB);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    internal delegate uint BackendAccepts(IntPtr context, uint kindA, uint kindB);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    internal delegate void BackendFind(IntPtr context, IntPtr universe, IntPtr pairs, UIntPtr count);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    internal delegate void ForceCallback(IntPtr context, PartId part, IntPtr pose, IntPtr velocity, double time, IntPtr force, IntPtr torque);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    internal delegate uint ContactCallback(IntPtr context, IntPtr contact, IntPtr material);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    internal delegate uint ContactLawCallback(IntPtr context, IntPtr contact, IntPtr velocity, double dt, IntPtr law);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    internal delegate void ResponseListener(IntPtr context, IntPtr @object);

    internal static partial class Native
    {
        internal const uint Major = 0;
        internal const uint Minor = 2;

        [DllImport("abut")] internal static extern Status abut_set_last_error(Status status, string message);
        [DllImport("abut")] internal static extern IntPtr abut_status_name(Status status);
        [DllImport("abut")] internal static extern IntPtr abut_last_error_message();
        [DllImport("abut")] internal static extern Status abut_set_log(Log log, IntPtr context, LogLevel most);
        [DllImport("abut")] internal static extern IntPtr abut_version_string();
        [DllImport("abut")] internal static extern Status abut_check_version(uint major, uint minor);
        [DllImport("abut")] internal static extern uint abut_has_feature(string name);
        [DllImport("abut")] internal static extern Status abut_set_allocator(Allocate allocate, Release release, IntPtr context);
        [DllImport("abut")] internal static extern Status abut_memory_in_use(out ulong bytes, out ulong blocks);
        [DllImport("abut")] internal static extern IntPtr abut_memory_allocate(UIntPtr size, UIntPtr alignment);
        [DllImport("abut")] internal static extern void abut_memory_release([Out] byte[] memory, UIntPtr size, UIntPtr alignment);
        [DllImport("abut")] internal static extern UIntPtr abut_shape_kind_count();
        [DllImport("abut")] internal static extern uint abut_shape_kind_at(UIntPtr index);
        [DllImport("abut")] internal static extern uint abut_shape_kind_by_name(string name);
        [DllImport("abut")] internal static extern IntPtr abut_shape_kind_name(uint kind);
        [DllImport("abut")] internal static extern UIntPtr abut_shape_kind_parameter_count(uint kind);
        [DllImport("abut")] internal static extern IntPtr abut_shape_kind_parameter_name(uint kind, UIntPtr index);
        [DllImport("abut")] internal static extern Status abut_pair_support(uint kindA, uint kindB, Query query, out uint @out);
        [DllImport("abut")] internal static extern Status abut_sphere_create(double radius, out IntPtr @out);
        [DllImport("abut")] internal static extern Status abut_box_create(double halfX, double halfY, double halfZ, out IntPtr @out);
        [DllImport("abut")] internal static extern Status abut_capsule_create(double radius, double halfHeight, out IntPtr @out);
        [DllImport("abut")] internal static extern Status abut_cylinder_create(double radius, double halfHeight, out IntPtr @out);
        [DllImport("abut")] internal static extern Status abut_cone_create(double radius, double halfHeight, out IntPtr @out);
        [DllImport("abut")] internal static extern Status abut_ellipsoid_create(double radiusX, double radiusY, double radiusZ, out IntPtr @out);
        [DllImport("abut")] internal static extern Status abut_point_create(out IntPtr @out);
        [DllImport("abut")] internal static extern Status abut_segment_create(double halfLength, out IntPtr @out);
        [DllImport("abut")] internal static extern Status abut_triangle_create(ref Vector a, ref Vector b, ref Vector c, out IntPtr @out);
        [DllImport("abut")] internal static extern Status abut_plane_create(ref Vector normal, double offset, out IntPtr @out);
        [DllImport("abut")] internal static extern Status abut_hull_create(double[] xyz, UIntPtr pointCount, out IntPtr @out);
        [DllImport("abut")] internal static extern void abut_hull_report_init(out HullReport report, uint structSize);
        [DllImport("abut")] internal static extern Status abut_hull_describe(Shape shape, ref HullReport @out);
        [DllImport("abut")] internal static extern void abut_mesh_options_init(out MeshOptions options, uint structSize);
        [DllImport("abut")] internal static extern Status abut_mesh_create(double[] xyz, UIntPtr vertexCount, uint[] triangles, UIntPtr triangleCount, MeshOptions[] options, out IntPtr @out);
        [DllImport("abut")] internal static extern void abut_mesh_report_init(out MeshReport report, uint structSize);
        [DllImport("abut")] internal static extern Status abut_mesh_describe(double[] xyz, UIntPtr vertexCount, uint[] triangles, UIntPtr triangleCount, MeshOptions[] options, ref MeshReport @out);
        [DllImport("abut")] internal static extern void abut_uv_grid_options_init(out UvGridOptions options, uint structSize);
        [DllImport("abut")] internal static extern Status abut_uv_grid_create(double[] xyz, UIntPtr vertexCount, uint[] triangles, UIntPtr triangleCount, UvGridOptions[] options, out IntPtr @out);
        [DllImport("abut")] internal static extern void abut_height_field_desc_init(out HeightFieldDesc desc, uint structSize);
        [DllImport("abut")] internal static extern Status abut_height_field_create(ref HeightFieldDesc desc, out IntPtr @out);
        [DllImport("abut")] internal static extern void abut_distance_field_desc_init(out DistanceFieldDesc desc, uint structSize);
        [DllImport("abut")] internal static extern Status abut_distance_field_create(ref DistanceFieldDesc desc, out IntPtr @out);
        [DllImport("abut")] internal static extern void abut_distance_field_options_init(out DistanceFieldOptions options, uint structSize);
        [DllImport("abut")] internal static extern Status abut_distance_field_from_mesh(double[] xyz, UIntPtr vertexCount, uint[] triangles, UIntPtr triangleCount, DistanceFieldOptions[] options, out IntPtr @out);
        [DllImport("abut")] internal static extern void abut_distance_field_report_init(out DistanceFieldReport report, uint structSize);
        [DllImport("abut")] internal static extern Status abut_distance_field_describe(Shape shape, ref DistanceFieldReport @out);
        [DllImport("abut")] internal static extern Status abut_particles_create(double[] xyz, UIntPtr count, double radius, out IntPtr @out);
        [DllImport("abut")] internal static extern Status abut_particles_create_with_radii(double[] xyz, double[] radii, UIntPtr count, out IntPtr @out);
        [DllImport("abut")] internal static extern Status abut_composite_create(IntPtr[] children, Pose[] poses, UIntPtr count, out IntPtr @out);
        [DllImport("abut")] internal static extern Status abut_composite_create_with_materials(IntPtr[] children, Pose[] poses, uint[] materials, UIntPtr count, out IntPtr @out);
        [DllImport("abut")] internal static extern Status abut_composite_children(Shape shape, [Out] CompositeChild[] children, UIntPtr capacity, out UIntPtr count);
        [DllImport("abut")] internal static extern Status abut_composite_child_shape(Shape shape, uint child, out IntPtr @out);
        [DllImport("abut")] internal static extern Status abut_sphere_hole_create(double radius, out IntPtr @out);
        [DllImport("abut")] internal static extern Status abut_cylinder_hole_create(double radius, double halfHeight, OpenEnds openEnds, out IntPtr @out);
        [DllImport("abut")] internal static extern Status abut_box_hole_create(double halfX, double halfY, double halfZ, OpenFaces openFaces, out IntPtr @out);
        [DllImport("abut")] internal static extern void abut_shape_desc_init(out ShapeDesc desc, uint structSize);
        [DllImport("abut")] internal static extern Status abut_shape_create(ref ShapeDesc desc, out IntPtr @out);
        [DllImport("abut")] internal static extern void abut_shape_retain(IntPtr shape);
        [DllImport("abut")] internal static extern void abut_shape_release(IntPtr shape);
        [DllImport("abut")] internal static extern uint abut_shape_kind_of(Shape shape);
        [DllImport("abut")] internal static extern Status abut_shape_parameters(Shape shape, [Out] double[] parameters, UIntPtr capacity, out UIntPtr count);
        [DllImport("abut")] internal static extern Status abut_shape_aabb(Shape shape, ref Pose pose, out Aabb @out);
        [DllImport("abut")] internal static extern Status abut_shape_triangles(Shape shape, [Out] double[] xyz, UIntPtr vertexCapacity, out UIntPtr vertexCount, [Out] uint[] triangles, UIntPtr triangleCapacity, out UIntPtr triangleCount);
        [DllImport("abut")] internal static extern Status abut_shape_prepare(Shape shape, uint threads);
        [DllImport("abut")] internal static extern Status abut_shape_cast_ray(Shape shape, ref Pose pose, ref Ray ray, out RayHit hit, out uint found);
        [DllImport("abut")] internal static extern void abut_query_options_init(out QueryOptions options, uint structSize);
        [DllImport("abut")] internal static extern Status abut_pair_routes(uint kindA, uint kindB, Query query, QueryOptions[] options, [Out] Route[] routes, UIntPtr capacity, out UIntPtr count);
        [DllImport("abut")] internal static extern Status abut_routes_load(string text);
        [DllImport("abut")] internal static extern Status abut_contact_validate(ref Contact contact);
        [DllImport("abut")] internal static extern Status abut_pair_distance(Shape a, ref Pose poseA, Shape b, ref Pose poseB, QueryOptions[] options, out Distance @out);
        [DllImport("abut")] internal static extern Status abut_pairs_distance(Shape a, Pose[] posesA, Shape b, Pose[] posesB, UIntPtr count, QueryOptions[] options, [Out] Distance[] @out);
        [DllImport("abut")] internal static extern Status abut_pair_contacts(Shape a, ref Pose poseA, Shape b, ref Pose poseB, QueryOptions[] options, [Out] Contact[] contacts, UIntPtr capacity, out UIntPtr count);
        [DllImport("abut")] internal static extern Status abut_pair_distance_with_memory(Shape a, ref Pose poseA, Shape b, ref Pose poseB, QueryOptions[] options, ref PairMemory memory, out Distance @out);
        [DllImport("abut")] internal static extern Status abut_pairs_distance_with_memories(Shape a, Pose[] posesA, Shape b, Pose[] posesB, UIntPtr count, QueryOptions[] options, [Out] PairMemory[] memories, [Out] Distance[] @out);
        [DllImport("abut")] internal static extern Status abut_pairs_contacts(Shape a, Pose[] posesA, Shape b, Pose[] posesB, UIntPtr pairCount, QueryOptions[] options, [Out] ulong[] offsets, [Out] Contact[] contacts, UIntPtr capacity, out UIntPtr count);
        [DllImport("abut")] internal static extern Status abut_pair_contacts_with_memory(Shape a, ref Pose poseA, Shape b, ref Pose poseB, QueryOptions[] options, ref PairMemory memory, [Out] Contact[] contacts, UIntPtr capacity, out UIntPtr count);
        [DllImport("abut")] internal static extern Status abut_pairs_contacts_with_memories(Shape a, Pose[] posesA, Shape b, Pose[] posesB, UIntPtr pairCount, QueryOptions[] options, [Out] PairMemory[] memories, [Out] ulong[] offsets, [Out] Contact[] contacts, UIntPtr capacity, out UIntPtr count);
        [DllImport("abut")] internal static extern Status abut_pair_overlaps(Shape a, ref Pose poseA, Shape b, ref Pose poseB, QueryOptions[] options, out uint @out);
        [DllImport("abut")] internal static extern Status abut_pairs_overlap(IntPtr[] shapesA, Pose[] posesA, IntPtr[] shapesB, Pose[] posesB, UIntPtr count, QueryOptions[] options, [Out] uint[] @out);
        [DllImport("abut")] internal static extern Status abut_vertices_touch_faces(double[] start, double[] end, UIntPtr count, double separation, double tolerance, [Out] FirstTouch[] @out);
        [DllImport("abut")] internal static extern Status abut_edges_touch_edges(double[] start, double[] end, UIntPtr count, double separation, double tolerance, [Out] FirstTouch[] @out);
        [DllImport("abut")] internal static extern Status abut_elements_create(Shape shape, out IntPtr @out);
        [DllImport("abut")] internal static extern void abut_elements_destroy(IntPtr elements);
        [DllImport("abut")] internal static extern Status abut_elements_count(IntPtr elements, out ElementCounts @out);
        [DllImport("abut")] internal static extern Status abut_elements_edges(IntPtr elements, [Out] uint[] vertices, UIntPtr capacity, out UIntPtr count);
        [DllImport("abut")] internal static extern Status abut_elements_set_vertices(IntPtr elements, double[] start, double[] end, UIntPtr vertexCount);
        [DllImport("abut")] internal static extern void abut_elements_options_init(out ElementsOptions options, uint structSize);
        [DllImport("abut")] internal static extern Status abut_elements_candidates(IntPtr a, IntPtr b, ElementsOptions[] options, [Out] ElementPair[] pairs, UIntPtr capacity, out UIntPtr count);
        [DllImport("abut")] internal static extern Status abut_elements_closest(IntPtr a, IntPtr b, ElementsOptions[] options, [Out] Stencil[] stencils, UIntPtr capacity, out UIntPtr count);
        [DllImport("abut")] internal static extern Status abut_elements_first_touches(IntPtr a, IntPtr b, ElementsOptions[] options, [Out] Stencil[] stencils, UIntPtr capacity, out UIntPtr count);
        [DllImport("abut")] internal static extern Status abut_elements_crossings(IntPtr a, IntPtr b, ElementsOptions[] options, [Out] Crossing[] crossings, UIntPtr capacity, out UIntPtr count);
        [DllImport("abut")] internal static extern Status abut_movement_between(ref Pose start, ref Pose end, ref Vector centre, double duration, out Movement @out);
        [DllImport("abut")] internal static extern void abut_impact_options_init(out ImpactOptions options, uint structSize);
        [DllImport("abut")] internal static extern Status abut_pair_time_of_impact(Shape a, ref Pose poseA, ref Movement movementA, Shape b, ref Pose poseB, ref Movement movementB, double duration, ImpactOptions[] options, out Impact @out);
        [DllImport("abut")] internal static extern Status abut_pairs_time_of_impact(Shape a, Pose[] posesA, Movement[] movementsA, Shape b, Pose[] posesB, Movement[] movementsB, UIntPtr count, double duration, ImpactOptions[] options, [Out] Impact[] @out);
        [DllImport("abut")] internal static extern void abut_universe_options_init(out UniverseOptions options, uint structSize);
        [DllImport("abut")] internal static extern Status abut_universe_create(UniverseOptions[] options, out IntPtr @out);
        [DllImport("abut")] internal static extern void abut_universe_destroy(IntPtr universe);
        [DllImport("abut")] internal static extern Status abut_universe_save(Universe universe, [Out] byte[] bytes, UIntPtr capacity, out UIntPtr size);
        [DllImport("abut")] internal static extern Status abut_universe_load(byte[] bytes, UIntPtr size, out IntPtr @out);
        [DllImport("abut")] internal static extern void abut_part_options_init(out PartOptions options, uint structSize);
        [DllImport("abut")] internal static extern Status abut_part_create(Universe universe, PartOptions[] options, out PartId @out);
        [DllImport("abut")] internal static extern Status abut_parts_create(Universe universe, PartOptions[] options, UIntPtr count, [Out] PartId[] @out);
        [DllImport("abut")] internal static extern Status abut_part_destroy(Universe universe, PartId part);
        [DllImport("abut")] internal static extern Status abut_parts_destroy(Universe universe, PartId[] parts, UIntPtr count);
        [DllImport("abut")] internal static extern Status abut_part_set_pose(Universe universe, PartId part, ref Pose pose);
        [DllImport("abut")] internal static extern Status abut_parts_set_poses(Universe universe, PartId[] parts, Pose[] poses, UIntPtr count);
        [DllImport("abut")] internal static extern Status abut_part_pose(Universe universe, PartId part, out Pose @out);
        [DllImport("abut")] internal static extern Status abut_parts_poses(Universe universe, PartId[] parts, UIntPtr count, [Out] Pose[] @out);
        [DllImport("abut")] internal static extern Status abut_part_set_motion(Universe universe, PartId part, Motion motion);
        [DllImport("abut")] internal static extern Status abut_parts_set_motions(Universe universe, PartId[] parts, Motion[] motions, UIntPtr count);
        [DllImport("abut")] internal static extern Status abut_part_motion(Universe universe, PartId part, out Motion @out);
        [DllImport("abut")] internal static extern Status abut_part_user_data(Universe universe, PartId part, out ulong @out);
        [DllImport("abut")] internal static extern Status abut_part_set_user_data(Universe universe, PartId part, ulong userData);
        [DllImport("abut")] internal static extern Status abut_parts_set_user_data(Universe universe, PartId[] parts, ulong[] userData, UIntPtr count);
        [DllImport("abut")] internal static extern Status abut_part_geometries(Universe universe, PartId part, [Out] GeometryId[] geometries, UIntPtr capacity, out UIntPtr count);
        [DllImport("abut")] internal static extern void abut_sleep_init(out Sleep sleep, uint structSize);
        [DllImport("abut")] internal static extern Status abut_part_set_sleep(Universe universe, PartId part, Sleep[] sleep);
        [DllImport("abut")] internal static extern Status abut_parts_set_sleep(Universe universe, PartId[] parts, Sleep[] sleeps, UIntPtr count);
        [DllImport("abut")] internal static extern Status abut_part_is_asleep(Universe universe, PartId part, out uint @out);
        [DllImport("abut")] internal static extern Status abut_part_wake(Universe universe, PartId part);
        [DllImport("abut")] internal static extern Status abut_parts_wake(Universe universe, PartId[] parts, UIntPtr count);
        [DllImport("abut")] internal static extern void abut_geometry_options_init(out GeometryOptions options, uint structSize);
        [DllImport("abut")] internal static extern Status abut_geometry_create(Universe universe, PartId part, Shape shape, GeometryOptions[] options, out GeometryId @out);
        [DllImport("abut")] internal static extern Status abut_geometries_create(Universe universe, PartId[] parts, IntPtr[] shapes, GeometryOptions[] options, UIntPtr count, [Out] GeometryId[] @out);
        [DllImport("abut")] internal static extern Status abut_geometry_destroy(Universe universe, GeometryId geometry);
        [DllImport("abut")] internal static extern Status abut_geometries_destroy(Universe universe, GeometryId[] geometries, UIntPtr count);
        [DllImport("abut")] internal static extern Status abut_geometry_set_options(Universe universe, GeometryId geometry, ref GeometryOptions options);
        [DllImport("abut")] internal static extern Status abut_geometries_set_options(Universe universe, GeometryId[] geometries, GeometryOptions[] options, UIntPtr count);
        [DllImport("abut")] internal static extern Status abut_geometry_set_user_data(Universe universe, GeometryId geometry, ulong userData);
        [DllImport("abut")] internal static extern Status abut_geometries_set_user_data(Universe universe, GeometryId[] geometries, ulong[] userData, UIntPtr count);
        [DllImport("abut")] internal static extern Status abut_geometry_set_shape(Universe universe, GeometryId geometry, Shape shape);
        [DllImport("abut")] internal static extern Status abut_geometries_set_shapes(Universe universe, GeometryId[] geometries, IntPtr[] shapes, UIntPtr count);
        [DllImport("abut")] internal static extern Status abut_geometry_set_parameters(Universe universe, GeometryId geometry, double[] parameters, UIntPtr parameterCount);
        [DllImport("abut")] internal static extern Status abut_geometries_set_parameters(Universe universe, GeometryId[] geometries, double[] parameters, UIntPtr parameterCount, UIntPtr count);
        [DllImport("abut")] internal static extern Status abut_geometry_set_heights(Universe universe, GeometryId geometry, uint column, uint row, uint columns, uint rows, double[] heights);
        [DllImport("abut")] internal static extern Status abut_geometry_set_field_values(Universe universe, GeometryId geometry, uint column, uint row, uint layer, uint columns, uint rows, uint layers, double[] values);
        [DllImport("abut")] internal static extern Status abut_geometry_set_field_lattice(Universe universe, GeometryId geometry, uint columns, uint rows, uint layers, double[] xyz);
        [DllImport("abut")] internal static extern Status abut_geometry_set_particles(Universe universe, GeometryId geometry, UIntPtr first, double[] xyz, double[] radii, UIntPtr count);
        [DllImport("abut")] internal static extern Status abut_geometry_set_vertices(Universe universe, GeometryId geometry, UIntPtr first, double[] xyz, UIntPtr count);
        [DllImport("abut")] internal static extern Status abut_geometry_set_vertices_at(Universe universe, GeometryId geometry, uint[] vertices, double[] xyz, UIntPtr count);
        [DllImport("abut")] internal static extern Status abut_geometry_vertices(Universe universe, GeometryId geometry, out IntPtr xyz, out UIntPtr count);
        [DllImport("abut")] internal static extern Status abut_geometry_next_vertices(Universe universe, GeometryId geometry, out IntPtr xyz, out UIntPtr count);
        [DllImport("abut")] internal static extern Status abut_geometry_advance(Universe universe, GeometryId geometry);
        [DllImport("abut")] internal static extern Status abut_geometries_advance(Universe universe, GeometryId[] geometries, UIntPtr count);
        [DllImport("abut")] internal static extern Status abut_geometry_remove_triangles(Universe universe, GeometryId geometry, uint[] triangles, UIntPtr count);
        [DllImport("abut")] internal static extern Status abut_geometry_set_mesh(Universe universe, GeometryId geometry, double[] xyz, UIntPtr vertexCount, uint[] triangles, UIntPtr triangleCount);
        [DllImport("abut")] internal static extern Status abut_geometry_shape(Universe universe, GeometryId geometry, out IntPtr @out);
        [DllImport("abut")] internal static extern Status abut_geometry_park(Universe universe, GeometryId geometry, Parking parking);
        [DllImport("abut")] internal static extern Status abut_geometries_park(Universe universe, GeometryId[] geometries, UIntPtr count, Parking parking);
        [DllImport("abut")] internal static extern void abut_geometry_info_init(out GeometryInfo info, uint structSize);
        [DllImport("abut")] internal static extern Status abut_geometry_describe(Universe universe, GeometryId geometry, ref GeometryInfo @out);
        [DllImport("abut")] internal static extern Status abut_geometries_poses(Universe universe, GeometryId[] geometries, UIntPtr count, [Out] Pose[] @out);
        [DllImport("abut")] internal static extern Status abut_universe_parts(Universe universe, [Out] PartId[] parts, UIntPtr capacity, out UIntPtr count);
        [DllImport("abut")] internal static extern Status abut_universe_geometries(Universe universe, [Out] GeometryId[] geometries, UIntPtr capacity, out UIntPtr count);
        [DllImport("abut")] internal static extern Status abut_universe_revision(Universe universe, out Revision @out);
        [DllImport("abut")] internal static extern Status abut_universe_counters(Universe universe, out IntPtr geometries, out IntPtr poses);
        [DllImport("abut")] internal static extern Status abut_universe_changes(Universe universe, ref Revision since, [Out] GeometryId[] geometries, UIntPtr capacity, out UIntPtr count, out uint isKnown);
        [DllImport("abut")] internal static extern Status abut_rule_set(Universe universe, ref Collidable a, ref Collidable b, Rule rule);
        [DllImport("abut")] internal static extern Status abut_rules_clear(Universe universe);
        [DllImport("abut")] internal static extern Status abut_rule_between(Universe universe, GeometryId geometryA, GeometryId geometryB, out Rule rule, out Collidable a, out Collidable b);
        [DllImport("abut")] internal static extern Status abut_universe_set_filter(Universe universe, Filter filter, IntPtr context);
        [DllImport("abut")] internal static extern Status abut_universe_set_pointer_filter(Universe universe, PointerFilter filter, IntPtr context);
        [DllImport("abut")] internal static extern Status abut_universe_refilter(Universe universe);
        [DllImport("abut")] internal static extern void abut_policy_init(out Policy policy, uint structSize);
        [DllImport("abut")] internal static extern Status abut_policy_set(Universe universe, uint tagA, uint tagB, Policy[] policy);
        [DllImport("abut")] internal static extern Status abut_policy_get(Universe universe, uint tagA, uint tagB, ref Policy @out);
        [DllImport("abut")] internal static extern void abut_focus_init(out Focus focus, uint structSize);
        [DllImport("abut")] internal static extern Status abut_universe_set_focus(Universe universe, Focus[] focus, Vector[] centres, UIntPtr count);
        [DllImport("abut")] internal static extern void abut_contact_material_init(out ContactMaterial material, uint structSize);
        [DllImport("abut")] internal static extern Status abut_material_pair_set(Universe universe, uint materialA, uint materialB, ContactMaterial[] row);
        [DllImport("abut")] internal static extern Status abut_material_pair_get(Universe universe, uint materialA, uint materialB, ref ContactMaterial @out);
        [DllImport("abut")] internal static extern Status abut_backend_set(Universe universe, BackendAccepts accepts, BackendFind find, IntPtr context);
        [DllImport("abut")] internal static extern Status abut_backend_answer(Universe universe, UIntPtr pair, BackendContact[] contacts, UIntPtr count);
        [DllImport("abut")] internal static extern Status abut_universe_step(Universe universe, double dt);
        [DllImport("abut")] internal static extern Status abut_universe_detect_all(Universe universe);
        [DllImport("abut")] internal static extern Status abut_universe_detect_changed(Universe universe);
        [DllImport("abut")] internal static extern Status abut_universe_detect_pairs(Universe universe, GeometryId[] a, GeometryId[] b, UIntPtr count);
        [DllImport("abut")] internal static extern Status abut_universe_detect_region(Universe universe, ref Aabb region);
        [DllImport("abut")] internal static extern Status abut_universe_refresh(Universe universe);
        [DllImport("abut")] internal static extern Status abut_universe_events(Universe universe, out IntPtr events, out UIntPtr count);
        [DllImport("abut")] internal static extern Status abut_universe_sleep_changes(Universe universe, out IntPtr changes, out UIntPtr count);
        [DllImport("abut")] internal static extern Status abut_universe_hash(Universe universe, out ulong @out);
        [DllImport("abut")] internal static extern Status abut_universe_contacts(Universe universe, out IntPtr contacts, out UIntPtr count);
        [DllImport("abut")] internal static extern Status abut_universe_local_points(Universe universe, out IntPtr points, out UIntPtr count);
        [DllImport("abut")] internal static extern Status abut_contacts_set_user_data(Universe universe, ulong[] userData, UIntPtr count);
        [DllImport("abut")] internal static extern void abut_step_stats_init(out StepStats stats, uint structSize);
        [DllImport("abut")] internal static extern Status abut_universe_stats(Universe universe, ref StepStats @out);
        [DllImport("abut")] internal static extern Status abut_universe_explain(Universe universe, [Out] byte[] text, UIntPtr capacity, out UIntPtr needed);
        [DllImport("abut")] internal static extern Status abut_universe_explain_json(Universe universe, [Out] byte[] text, UIntPtr capacity, out UIntPtr needed);
        [DllImport("abut")] internal static extern Status abut_universe_why_apart(Universe universe, GeometryId geometryA, GeometryId geometryB, out ApartReasons @out);
        [DllImport("abut")] internal static extern Status abut_universe_validate(Universe universe, [Out] Finding[] findings, UIntPtr capacity, out UIntPtr count);
        [DllImport("abut")] internal static extern Status abut_universe_follow_islands(Universe universe, uint areFollowed);
        [DllImport("abut")] internal static extern Status abut_universe_islands(Universe universe, out IntPtr islands, out UIntPtr count);
        [DllImport("abut")] internal static extern Status abut_universe_island_parts(Universe universe, out IntPtr parts, out UIntPtr count);
        [DllImport("abut")] internal static extern Status abut_part_island(Universe universe, PartId part, out Island @out);
        [DllImport("abut")] internal static extern Status abut_part_set_velocity(Universe universe, PartId part, Velocity[] velocity);
        [DllImport("abut")] internal static extern Status abut_parts_set_velocities(Universe universe, PartId[] parts, Velocity[] velocities, UIntPtr count);
        [DllImport("abut")] internal static extern Status abut_part_measure_velocity(Universe universe, PartId part);
        [DllImport("abut")] internal static extern Status abut_parts_measure_velocities(Universe universe, PartId[] parts, UIntPtr count);
        [DllImport("abut")] internal static extern Status abut_part_velocity(Universe universe, PartId part, out Velocity @out, [Out] VelocitySource[] source);
        [DllImport("abut")] internal static extern Status abut_parts_velocities(Universe universe, PartId[] parts, UIntPtr count, [Out] Velocity[] @out);
        [DllImport("abut")] internal static extern Status abut_part_set_acceleration(Universe universe, PartId part, Acceleration[] acceleration);
        [DllImport("abut")] internal static extern Status abut_parts_set_accelerations(Universe universe, PartId[] parts, Acceleration[] accelerations, UIntPtr count);
        [DllImport("abut")] internal static extern Status abut_parts_accelerations(Universe universe, PartId[] parts, UIntPtr count, [Out] Acceleration[] @out);
        [DllImport("abut")] internal static extern Status abut_universe_impacts(Universe universe, out IntPtr impacts, out UIntPtr count);
        [DllImport("abut")] internal static extern Status abut_universe_advance_to_first_impact(Universe universe, double dt, out StepImpact @out);
        [DllImport("abut")] internal static extern Status abut_universe_element_contacts(Universe universe, out IntPtr contacts, out UIntPtr count);
        [DllImport("abut")] internal static extern Status abut_universe_attach(Universe universe, string name);
        [DllImport("abut")] internal static extern Status abut_universe_detach(Universe universe, string name);
        [DllImport("abut")] internal static extern void abut_query_filter_init(out QueryFilter filter, uint structSize);
        [DllImport("abut")] internal static extern Status abut_universe_cast_ray(Universe universe, ref Ray ray, QueryFilter[] filter, HitMode mode, [Out] Hit[] hits, UIntPtr capacity, out UIntPtr count);
        [DllImport("abut")] internal static extern Status abut_universe_cast_rays(Universe universe, Ray[] rays, UIntPtr count, QueryFilter[] filter, [Out] Hit[] hits);
        [DllImport("abut")] internal static extern Status abut_universe_cast_shape(Universe universe, Shape shape, ref Pose pose, ref Vector displacement, QueryFilter[] filter, HitMode mode, [Out] CastHit[] hits, UIntPtr capacity, out UIntPtr count);
        [DllImport("abut")] internal static extern Status abut_universe_cast_shapes(Universe universe, IntPtr[] shapes, Pose[] poses, Vector[] displacements, UIntPtr count, QueryFilter[] filter, [Out] CastHit[] hits);
        [DllImport("abut")] internal static extern Status abut_universe_cast_movement(Universe universe, Shape shape, ref Pose pose, ref Movement movement, double duration, ImpactOptions[] options, QueryFilter[] filter, HitMode mode, [Out] ImpactHit[] hits, UIntPtr capacity, out UIntPtr count);
        [DllImport("abut")] internal static extern Status abut_universe_cast_movements(Universe universe, IntPtr[] shapes, Pose[] poses, Movement[] movements, UIntPtr count, double duration, ImpactOptions[] options, QueryFilter[] filter, [Out] ImpactHit[] hits);
        [DllImport("abut")] internal static extern Status abut_universe_overlaps(Universe universe, Shape shape, ref Pose pose, QueryFilter[] filter, double margin, [Out] GeometryId[] geometries, UIntPtr capacity, out UIntPtr count);
        [DllImport("abut")] internal static extern Status abut_universe_overlaps_of_each(Universe universe, IntPtr[] shapes, Pose[] poses, UIntPtr queryCount, QueryFilter[] filter, double margin, [Out] ulong[] offsets, [Out] GeometryId[] geometries, UIntPtr capacity, out UIntPtr count);
        [DllImport("abut")] internal static extern Status abut_universe_at_point(Universe universe, ref Vector position, QueryFilter[] filter, [Out] GeometryId[] geometries, UIntPtr capacity, out UIntPtr count);
        [DllImport("abut")] internal static extern Status abut_universe_at_points(Universe universe, Vector[] positions, UIntPtr queryCount, QueryFilter[] filter, [Out] ulong[] offsets, [Out] GeometryId[] geometries, UIntPtr capacity, out UIntPtr count);
        [DllImport("abut")] internal static extern Status abut_universe_closest(Universe universe, Shape shape, ref Pose pose, double maxDistance, QueryFilter[] filter, out Closest @out, out uint found);
        [DllImport("abut")] internal static extern Status abut_universe_closest_to_each(Universe universe, IntPtr[] shapes, Pose[] poses, UIntPtr count, double maxDistance, QueryFilter[] filter, [Out] Closest[] @out);
        [DllImport("abut")] internal static extern Status abut_pair_cast(Shape a, ref Pose poseA, ref Vector displacementA, Shape b, ref Pose poseB, ref Vector displacementB, QueryOptions[] options, out CastHit hit, out uint found);
        [DllImport("abut")] internal static extern Status abut_pairs_cast(Shape a, Pose[] posesA, Vector[] displacementsA, Shape b, Pose[] posesB, Vector[] displacementsB, UIntPtr count, QueryOptions[] options, [Out] CastHit[] hits);
        [DllImport("abut")] internal static extern UIntPtr abut_layout_count();
        [DllImport("abut")] internal static extern Status abut_layout_at(UIntPtr index, out LayoutEntry @out);
        [DllImport("abut_picking")] internal static extern void abut_camera_init(out Camera camera, uint structSize);
        [DllImport("abut_picking")] internal static extern Status abut_camera_look_at(ref Camera camera, ref Vector eye, ref Vector target, ref Vector up);
        [DllImport("abut_picking")] internal static extern Status abut_camera_set_projection(ref Camera camera, double[] matrix, ClipDepth depth);
        [DllImport("abut_picking")] internal static extern Status abut_camera_ray(ref Camera camera, double x, double y, out Ray @out);
        [DllImport("abut_picking")] internal static extern Status abut_picker_create(Universe universe, out IntPtr @out);
        [DllImport("abut_picking")] internal static extern void abut_picker_destroy(IntPtr picker);
        [DllImport("abut_picking")] internal static extern Status abut_picker_update(Picker picker);
        [DllImport("abut_picking")] internal static extern Status abut_picker_set_flags(Picker picker, PickerFlags flags);
        [DllImport("abut_picking")] internal static extern Status abut_picker_set_clip_planes(Picker picker, ClipPlane[] planes, UIntPtr count);
        [DllImport("abut_picking")] internal static extern Status abut_picker_cast_ray(Picker picker, ref Ray ray, QueryFilter[] filter, out Hit @out);
        [DllImport("abut_picking")] internal static extern Status abut_picker_cast_rays(Picker picker, Ray[] rays, UIntPtr count, Coherence coherence, QueryFilter[] filter, [Out] Hit[] @out);
        [DllImport("abut_picking")] internal static extern Status abut_picker_ray_hits(Picker picker, ref Ray ray, QueryFilter[] filter, out uint @out);
        [DllImport("abut_picking")] internal static extern Status abut_picker_rays_hit(Picker picker, Ray[] rays, UIntPtr count, Coherence coherence, QueryFilter[] filter, [Out] uint[] @out);
        [DllImport("abut_picking")] internal static extern Status abut_picker_cast_ray_all(Picker picker, ref Ray ray, QueryFilter[] filter, [Out] Hit[] picks, UIntPtr capacity, out UIntPtr count);
        [DllImport("abut_picking")] internal static extern Status abut_picker_pick_pixel(Picker picker, ref Camera camera, double x, double y, double radius, QueryFilter[] filter, out Hit @out);
        [DllImport("abut_picking")] internal static extern Status abut_picker_render(Picker picker, ref Camera camera, QueryFilter[] filter, [Out] Hit[] @out, UIntPtr capacity);
        [DllImport("abut_picking")] internal static extern Status abut_picker_select_rectangle(Picker picker, ref Camera camera, double x0, double y0, double x1, double y1, Selection selection, QueryFilter[] filter, [Out] GeometryId[] geometries, UIntPtr capacity, out UIntPtr count);
        [DllImport("abut_picking")] internal static extern Status abut_picker_snap(Picker picker, ref Camera camera, double x, double y, double radius, SnapKinds kinds, QueryFilter[] filter, out Snap @out);
        [DllImport("abut_picking")] internal static extern Status abut_picker_barycentric(Picker picker, GeometryId geometry, uint face, ref Vector point, out Barycentric @out);
        [DllImport("abut_response")] internal static extern void abut_contact_problem_init(out ContactProblem problem, uint structSize);
        [DllImport("abut_response")] internal static extern void abut_solver_options_init(out SolverOptions options, uint structSize);
        [DllImport("abut_response")] internal static extern Status abut_contact_problem_solve(ref ContactProblem problem, SolverOptions[] options, [Out] double[] velocities, [Out] double[] impulses, out Residuals @out);
        [DllImport("abut_response")] internal static extern Status abut_shape_mass_properties(Shape shape, double density, out MassProperties @out);
        [DllImport("abut_response")] internal static extern void abut_response_options_init(out ResponseOptions options, uint structSize);
        [DllImport("abut_response")] internal static extern Status abut_response_create(Universe universe, ResponseOptions[] options, out IntPtr @out);
        [DllImport("abut_response")] internal static extern void abut_response_destroy(IntPtr response);
        [DllImport("abut_response")] internal static extern Status abut_response_set_options(IntPtr response, ref ResponseOptions options);
        [DllImport("abut_response")] internal static extern void abut_body_options_init(out BodyOptions options, uint structSize);
        [DllImport("abut_response")] internal static extern Status abut_response_add_bodies(IntPtr response, PartId[] parts, UIntPtr count, BodyOptions[] options);
        [DllImport("abut_response")] internal static extern Status abut_response_remove_body(IntPtr response, PartId part);
        [DllImport("abut_response")] internal static extern Status abut_response_body(IntPtr response, PartId part, out MassProperties @out);
        [DllImport("abut_response")] internal static extern Status abut_response_apply_force(IntPtr response, PartId part, ref Vector force, Vector[] at);
        [DllImport("abut_response")] internal static extern Status abut_response_apply_torque(IntPtr response, PartId part, ref Vector torque);
        [DllImport("abut_response")] internal static extern Status abut_response_set_force_callback(IntPtr response, ForceCallback callback, IntPtr context);
        [DllImport("abut_response")] internal static extern Status abut_response_add_particles(IntPtr response, GeometryId geometry, double[] masses, double[] xyz, double[] velocities, UIntPtr count);
        [DllImport("abut_response")] internal static extern Status abut_response_add_springs(IntPtr response, GeometryId geometry, uint[] pairs, double[] stiffnesses, double[] dampings, double[] restLengths, UIntPtr count);
        [DllImport("abut_response")] internal static extern void abut_elastic_options_init(out ElasticOptions options, uint structSize);
        [DllImport("abut_response")] internal static extern Status abut_response_add_tetrahedra(IntPtr response, GeometryId geometry, uint[] tetrahedra, UIntPtr count, ElasticOptions[] options);
        [DllImport("abut_response")] internal static extern Status abut_response_map_vertices(IntPtr response, GeometryId surface, GeometryId carrier, uint[] numbers, double[] weights, UIntPtr count);
        [DllImport("abut_response")] internal static extern Status abut_response_remove_particles(IntPtr response, GeometryId geometry);
        [DllImport("abut_response")] internal static extern Status abut_response_particles(IntPtr response, GeometryId geometry, out IntPtr xyz, out IntPtr velocities, out UIntPtr count);
        [DllImport("abut_response")] internal static extern Status abut_response_set_contact_callback(IntPtr response, ContactCallback callback, IntPtr context);
        [DllImport("abut_response")] internal static extern Status abut_response_add_kind(IntPtr response, string name, ContactLawCallback law, IntPtr context);
        [DllImport("abut_response")] internal static extern Status abut_response_kinds(IntPtr response, [Out] IntPtr[] names, UIntPtr capacity, out UIntPtr count);
        [DllImport("abut_response")] internal static extern Status abut_response_add_rule(IntPtr response, ResponseSide[] a, ResponseSide[] b, string kind, string parameters, [Out] uint[] @out);
        [DllImport("abut_response")] internal static extern Status abut_response_set_rule_parameters(IntPtr response, uint rule, string parameters);
        [DllImport("abut_response")] internal static extern Status abut_response_clear_rules(IntPtr response);
        [DllImport("abut_response")] internal static extern Status abut_response_set_variable(IntPtr response, string name, string value);
        [DllImport("abut_response")] internal static extern Status abut_response_set_geometry_kind(IntPtr response, GeometryId geometry, string kind, string parameters);
        [DllImport("abut_response")] internal static extern Status abut_response_rule_between(IntPtr response, GeometryId a, GeometryId b, [Out] byte[] text, UIntPtr capacity, out UIntPtr needed);
        [DllImport("abut_response")] internal static extern void abut_link_options_init(out LinkOptions options, uint structSize);
        [DllImport("abut_response")] internal static extern Status abut_response_add_link(IntPtr response, ref LinkOptions options, out ulong @out);
        [DllImport("abut_response")] internal static extern Status abut_response_move_link(IntPtr response, ulong link, ref Vector pointA);
        [DllImport("abut_response")] internal static extern Status abut_response_link_force(IntPtr response, ulong link, out Vector @out);
        [DllImport("abut_response")] internal static extern Status abut_response_remove_link(IntPtr response, ulong link);
        [DllImport("abut_response")] internal static extern Status abut_response_release(IntPtr response, GeometryId a, GeometryId b);
        [DllImport("abut_response")] internal static extern Status abut_response_step(IntPtr response, double dt);
        [DllImport("abut_response")] internal static extern Status abut_response_contacts(IntPtr response, out IntPtr contacts, out UIntPtr count);
        [DllImport("abut_response")] internal static extern Status abut_response_objects(IntPtr response, out IntPtr objects, out UIntPtr count);
        [DllImport("abut_response")] internal static extern Status abut_response_set_listener(IntPtr response, ResponseListener listener, IntPtr context);
        [DllImport("abut_response")] internal static extern Status abut_response_islands(IntPtr response, out IntPtr islands, out UIntPtr count);
        [DllImport("abut_response")] internal static extern Status abut_response_energy(IntPtr response, out Energy @out);
        [DllImport("abut_response")] internal static extern Status abut_response_validate(IntPtr response, [Out] ResponseFinding[] findings, UIntPtr capacity, out UIntPtr count);
        [DllImport("abut_response")] internal static extern Status abut_response_explain(IntPtr response, [Out] byte[] text, UIntPtr capacity, out UIntPtr needed);
        [DllImport("abut_response")] internal static extern Status abut_response_explain_json(IntPtr response, [Out] byte[] text, UIntPtr capacity, out UIntPtr needed);
        [DllImport("abut_response")] internal static extern Status abut_response_save(IntPtr response, [Out] byte[] bytes, UIntPtr capacity, out UIntPtr size);
        [DllImport("abut_response")] internal static extern Status abut_response_load(Universe universe, byte[] bytes, UIntPtr size, out IntPtr @out);
        [DllImport("abut_response")] internal static extern Status abut_response_hash(IntPtr response, out ulong @out);

        /// <summary>Sizes of the structs in C.</summary>
        internal static readonly Dictionary<Type, int> Sizes = new Dictionary<Type, int>
        {
            { typeof(Vector), 24 },
            { typeof(Quaternion), 32 },
            { typeof(Pose), 56 },
            { typeof(Aabb), 48 },
            { typeof(PartId), 8 },
            { typeof(GeometryId), 8 },
            { typeof(Feature), 8 },
            { typeof(HullReport), 48 },
            { typeof(MeshOptions), 32 },
            { typeof(MeshReport), 120 },
            { typeof(UvGridOptions), 40 },
            { typeof(HeightFieldDesc), 48 },
            { typeof(DistanceFieldDesc), 80 },
            { typeof(DistanceFieldOptions), 32 },
            { typeof(DistanceFieldReport), 56 },
            { typeof(CompositeChild), 72 },
            { typeof(ShapeDesc), 56 },
            { typeof(Ray), 56 },
            { typeof(RayHit), 72 },
            { typeof(QueryOptions), 48 },
            { typeof(Route), 32 },
            { typeof(Distance), 104 },
            { typeof(Contact), 192 },
            { typeof(PairMemory), 64 },
            { typeof(FirstTouch), 24 },
            { typeof(ElementCounts), 32 },
            { typeof(ElementsOptions), 64 },
            { typeof(Stencil), 104 },
            { typeof(ElementPair), 12 },
            { typeof(Crossing), 48 },
            { typeof(Movement), 120 },
            { typeof(ImpactOptions), 32 },
            { typeof(Impact), 136 },
            { typeof(UniverseOptions), 56 },
            { typeof(PartOptions), 72 },
            { typeof(Sleep), 40 },
            { typeof(GeometryOptions), 120 },
            { typeof(GeometryInfo), 200 },
            { typeof(Revision), 16 },
            { typeof(Collidable), 12 },
            { typeof(Policy), 88 },
            { typeof(Focus), 32 },
            { typeof(ContactMaterial), 96 },
            { typeof(BackendPair), 152 },
            { typeof(BackendContact), 104 },
            { typeof(Event), 40 },
            { typeof(SleepChange), 16 },
            { typeof(LocalPoints), 48 },
            { typeof(StepStats), 160 },
            { typeof(Finding), 192 },
            { typeof(Island), 16 },
            { typeof(Velocity), 48 },
            { typeof(Acceleration), 48 },
            { typeof(StepImpact), 48 },
            { typeof(ElementContact), 144 },
            { typeof(QueryFilter), 48 },
            { typeof(Hit), 80 },
            { typeof(CastHit), 144 },
            { typeof(ImpactHit), 144 },
            { typeof(Closest), 112 },
            { typeof(LayoutEntry), 32 },
            { typeof(Camera), 136 },
            { typeof(ClipPlane), 32 },
            { typeof(Snap), 72 },
            { typeof(Barycentric), 40 },
            { typeof(ContactProblem), 128 },
            { typeof(SolverOptions), 32 },
            { typeof(Residuals), 48 },
            { typeof(MassProperties), 104 },
            { typeof(ResponseOptions), 64 },
            { typeof(BodyOptions), 120 },
            { typeof(ElasticOptions), 32 },
            { typeof(ContactLaw), 64 },
            { typeof(ResponseSide), 12 },
            { typeof(LinkOptions), 104 },
            { typeof(ResponseContact), 152 },
            { typeof(ResponseObject), 88 },
            { typeof(ResponseIsland), 64 },
            { typeof(Energy), 64 },
            { typeof(ResponseFinding), 192 },
        };
    }
}
