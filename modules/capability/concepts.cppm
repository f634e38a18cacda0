// SPDX-License-Identifier: Apache-2.0
// What a shape can do. Every pair of shapes gets an algorithm from these capabilities alone.
export module abut.capability.concepts;
import abut.capability.records;
import abut.capability.cores.rim;
import abut.core.standard;
import abut.core;
import abut.math;

export namespace abut {

// Has a box under any pose. Unbounded shapes answer with infinite sides.
template <class S>
concept Bounded = requires(const S& shape, const Pose& pose) {
  { shape.aabb(pose) } -> std::same_as<Aabb>;
};

// A convex core, rounded by a radius: all points within radius() of the core. Directions need not
// have length one. Everything is in the frame of the shape.
template <class S>
concept Convex = Bounded<S> && requires(const S& shape, const Vec3& direction) {
  { shape.radius() } -> std::convertible_to<Real>;
  { shape.support(direction) } -> std::same_as<SupportPoint>;
  { shape.supporting_face(direction) } -> std::same_as<Face>;
  { shape.centre() } -> std::convertible_to<Vec3>;
  { shape.extent() } -> std::convertible_to<Real>;  // no core point is further from the centre, up to a factor of two
};

// Has a form of its own for support points under a pose, faster than rotating the direction in and
// the point out. `placed` returns a value with `support(direction)`.
template <class S>
concept Placeable = Convex<S> && requires(const S& shape, const Pose& pose, const Vec3& direction) {
  { shape.placed(pose).support(direction) } -> std::same_as<SupportPoint>;
};

// A core with so few face normals and edge directions that trying them all finds the exact depth. One
// that is symmetric about its centre also tells how far it reaches from there in a direction, alone
// and placed.
template <class S>
concept FewFaced = Convex<S> && requires(const S& shape) {
  shape.face_normals().size();
  shape.edge_directions().size();
  { S::is_symmetric } -> std::convertible_to<bool>;  // about its centre
};

// A shape that knows at once whether the face that looks furthest along a direction is such a one.
template <class S>
concept FewCornered = Convex<S> && requires(const S& shape, const Vec3& direction) {
  { shape.few_corners(direction) } -> std::same_as<FewCorners>;
};

// A core that is a box around the origin along the axes of the shape's own frame: a whole one, a segment
// along z (core_axes == 1), or a point.
template <class S>
concept BoxCored = Convex<S> && requires(const S& shape) {
  { shape.half() } -> std::convertible_to<Vec3>;  // extents from the centre
  { S::core_axes } -> std::convertible_to<int>;
};

template <class S>
concept PointCored = BoxCored<S> && S::core_axes == 0;
template <class S>
concept SegmentCored = BoxCored<S> && S::core_axes == 1;

// A core with a curved surface: its support points are no finite set, so that searches end by their bounds. All other
// cores are polytopes, which list their corners: corner_count() and corner(index).
template <class S>
concept Curved = Convex<S> && requires { requires S::is_curved; };

// The convex hull of two discs around Z, either of which may be a point. It tells which of them is the supporting face
// along a direction.
template <class S>
concept Rimmed = Curved<S> && requires(const S& shape, const Vec3& direction) {
  { shape.discs() } -> std::same_as<Discs>;
  { shape.supporting_rim(direction) } -> std::same_as<std::optional<Rim>>;
};

// A polytope of any number of faces. It lists the planes of its faces, four at a time, and its edges with the faces
// on either side.
template <class S>
concept Faceted = Convex<S> && requires(const S& shape) {
  shape.facets().planes;  // x, y, z of unit normals, and reach
  shape.facets().faces;   // the shape's own number of each
  shape.facets().arcs;    // left_x, ..., right_z: of the normals on either side of four edges; from_x, ...
  shape.facets().lines;   // from and along, of each edge
  shape.facets().sides;   // left and right: the faces on either side of it
  shape.facets().points;  // the vertices, the first ones far from each other
  shape.vertex_blocks();  // x, y, z of four vertices
  { shape.facets().middle } -> std::convertible_to<Vec3>;  // of a ball inside
  { shape.facets().inner } -> std::convertible_to<Real>;   // its radius
  { shape.facets().flatness } -> std::convertible_to<Real>;
  { shape.facets().is_closed } -> std::convertible_to<bool>;
};

// A core that knows the point of its surface nearest to any point, outside or inside, in closed form or nearly so.
template <class S>
concept Field = Convex<S> && requires(const S& shape, const Vec3& point) {
  { shape.nearest(point) } -> std::same_as<SurfacePoint>;
};

// Everything behind a plane of the shape's own frame: dot(normal, p) <= offset.
template <class S>
concept HalfSpace = Bounded<S> && requires(const S& shape) {
  { shape.normal() } -> std::convertible_to<Vec3>;
  { shape.offset() } -> std::same_as<Real>;
};

struct AcceptsAnyPart {
  template <class Part>
  void operator()(const Part&, std::uint32_t) const {}
};

struct AcceptsAnyCorners {
  bool operator()(const std::array<Vec3, 3>&) const { return true; }
  template <class Four>
  static std::uint64_t ask(const Four&) {
    return 15;
  }
};

// Made of triangles. visit_parts visits every part whose box overlaps the given one, and whose corners meet a
// condition, if there is one (see wanted_of); the visitor may shrink that box on the way. visit_below visits every part
// that reaches down to a height along a direction, which the visitor may lower; lower ones come first, mostly.
// part_near gives some part close to a point. is_crest is asked about some corners of a part, given by bit: one is a
// vertex, two are an edge. It tells whether the surface around them lies behind the plane through them across a
// direction, up to a height. The direction then is in their cone of normals.
template <class S>
concept Surface =
    Bounded<S> && Convex<typename S::Part> &&
    requires(const S& shape, Aabb& box, const Vec3& point, AcceptsAnyPart visitor, std::uint32_t index, Real height) {
      shape.visit_parts(box, visitor);
      shape.visit_parts(box, AcceptsAnyCorners{}, visitor);
      shape.visit_below(point, height, visitor);
      { shape.corners(index) } -> std::same_as<std::array<Vec3, 3>>;
      { shape.part(index) } -> std::same_as<typename S::Part>;
      { shape.part_near(point) } -> std::same_as<typename S::Part>;
      { shape.is_crest(index, 1u, point, height) } -> std::same_as<bool>;
      { shape.has_fronts() } -> std::same_as<bool>;
    };

// A surface that may be declared solid. What it encloses then is inside; is_turned tells of a part that its front looks
// inside. `pieces` has a vertex of each connected piece.
template <class S>
concept Enclosing = Surface<S> && requires(const S& shape, const Vec3& point, std::uint32_t index) {
  { shape.is_solid() } -> std::same_as<bool>;
  { shape.contains(point) } -> std::same_as<bool>;
  { shape.is_turned(index) } -> std::same_as<bool>;
  { shape.pieces() } -> std::same_as<std::span<const Vec3>>;
};

struct AcceptsAnyPlace {
  void operator()(const Vec3&, std::uint32_t) const {}
};

struct AcceptsAnyTwo {
  void operator()(std::uint32_t, const Vec3&, std::uint32_t, const Vec3&) const {}
};

// Many solids of one kind, none of them turned. visit_places hands over the place of every one whose box
// overlaps the given one, which the visitor may shrink on the way; place_near gives some place close to a point.
// visit_pairs hands over the numbers and places of every two whose gap is below a margin, each two once, the lower
// number first; it may hand over others that are near each other.
template <class S>
concept Scattered = Bounded<S> && Convex<typename S::Part> &&
                    requires(const S& shape, Aabb& box, const Vec3& point, Real margin, AcceptsAnyPlace visitor,
                             AcceptsAnyTwo visit_two) {
                      shape.visit_places(box, visitor);
                      shape.visit_pairs(margin, visit_two);
                      { shape.place_near(point) } -> std::convertible_to<std::uint32_t>;
                      { shape.particle_count() } -> std::convertible_to<std::size_t>;
                      { shape.place(std::uint32_t{}) } -> std::convertible_to<Vec3>;
                      { shape.part(std::uint32_t{}) } -> std::same_as<typename S::Part>;
                    };

// Made of shapes of any kind, each at a pose of its own: answered child by child, by the table of pairs.
template <class S>
concept Assembly = Bounded<S> && requires { requires S::is_assembly; };

template <class S>
concept RayCastable = requires(const S& shape, const Vec3& origin, const UnitVec3& direction, Real max_distance) {
  { shape.cast_ray(origin, direction, max_distance) } -> std::same_as<std::optional<RayHit>>;
};

// Has a surface of plane triangles.
template <class S>
concept Triangulated = requires(const S& shape) {
  { shape.triangles() } -> std::same_as<Triangles>;
};

// Has one height above every point, and so never meets itself.
template <class S>
concept Terrain = requires { requires S::is_terrain; };

// Says its name and parameters, is made from checked numbers, and shows samples of itself that
// tests, benchmarks and fuzz seeds use.
template <class S>
concept Described = requires(const S& shape, std::span<const Real> reals, std::span<const std::uint32_t> indices) {
  { S::name } -> std::convertible_to<std::string_view>;
  { S::parameter_names.size() } -> std::convertible_to<std::size_t>;
  { S::make(reals, reals, indices) } -> std::same_as<Result<S>>;
  { shape.parameters() } -> std::same_as<std::vector<Real>>;
  { S::samples() } -> std::same_as<std::vector<S>>;
};

template <class S>
concept Shape = Bounded<S> && RayCastable<S> && Described<S> && std::copyable<S>;

}  // namespace abut
