// SPDX-License-Identifier: Apache-2.0
// What queries on shapes answer with. Frames are those of the query: world at the C border, the
// frame of shape a inside the narrow phase.
export module abut.capability.records;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.math.four_vec3;

export namespace abut {

enum class FeatureKind : std::uint32_t { whole, vertex, edge, face, cell, particle };

struct Feature {
  FeatureKind kind;
  std::uint32_t index;

  friend constexpr bool operator==(const Feature&, const Feature&) = default;
};

inline constexpr std::uint32_t no_index = 0xffffffff;

// A point of a core that lies furthest in a direction.
struct SupportPoint {
  Vec3 point;
  std::uint32_t index;  // of the vertex, or no_index where the core has no vertices
};

// A face, edge or vertex of a core for clipping: three or more points of a plane polygon,
// counter-clockwise seen from outside, two of an edge, or one. Each point carries its vertex and the
// edge that leads from it to the next point.
struct FaceVertex {
  Vec3 point;
  std::uint32_t vertex;
  std::uint32_t edge;
};
struct Face {
  SmallVector<FaceVertex, 16> vertices;
  Vec3 normal{0, 0, 0};  // outward unit normal of a polygon, zero for an edge or a vertex
  std::uint32_t index = no_index;
};

// A face of three or four corners in vector registers, a corner per lane. The last corner of a triangle stands twice.
struct FewCorners {
  Columns at;
  Vec3 normal;  // zero where there is no such face, or none with an area
  std::uint32_t index;
  std::array<std::uint32_t, 4> vertices, edges;
};

[[nodiscard]] inline bool has_few_corners(const Face& face) {
  return face.vertices.size() == 3 || face.vertices.size() == 4;
}
// Of a face that has few. Not inlined: it is large, and rarely called.
[[nodiscard]] [[gnu::noinline]] inline FewCorners few_corners_of(const Face& face) {
  const std::span<const FaceVertex> vertices = face.vertices.span();
  const FaceVertex &first = vertices[0], &second = vertices[1], &third = vertices[2],
                   &fourth = vertices[vertices.size() - 1];
  return {
      Columns::of(lanes_of(first.point), lanes_of(second.point), lanes_of(third.point), lanes_of(fourth.point)),
      face.normal,
      face.index,
      {first.vertex, second.vertex, third.vertex, fourth.vertex},
      {first.edge, second.edge, third.edge, fourth.edge},
  };
}

struct RayHit {
  Real distance;
  Vec3 normal;  // unit, out of the solid; of a sheet: by winding
  Feature feature;
};

// The point of a surface that is nearest to a given one.
struct SurfacePoint {
  Vec3 point;
  Vec3 normal;    // unit, out of the solid
  Real distance;  // signed: negative where the given point lies inside
};

// A surface as triangles, counter-clockwise seen from outside.
struct Triangles {
  std::vector<Vec3> vertices;
  std::vector<std::uint32_t> indices;  // three per triangle
};

// Those after libccd_mpr are told of answers and never asked for.
enum class Algorithm : std::uint32_t {
  automatic,
  analytic,
  sat,
  gjk_epa,
  libccd_gjk,
  libccd_mpr,
  flat_ground,
  separating_translation,
  solid,
  field,
  hole,
  rims
};

// Whether closed forms may answer.
[[nodiscard]] inline constexpr bool takes_closed_forms(Algorithm algorithm) {
  return algorithm == Algorithm::automatic || algorithm == Algorithm::analytic;
}

// Whether a query could be answered at all. `apart`: by an algorithm that can tell that shapes do not
// overlap, but not how far apart they are.
enum class Outcome : std::uint8_t { ok, apart, unsupported, not_converged };

struct QuerySettings {
  Algorithm algorithm = Algorithm::automatic;
  Real error_bound = 0;  // of upper - lower, relative to the size of the shapes; 0: the usual one
  Real margin = 0;       // contacts are wanted up to this distance
  bool welds = false;    // convex children of composites that lie side by side, as it does surfaces
};

// Signed distance: `distance == dot(point_b - point_a, normal)`, normal from a to b, negative when
// the shapes overlap. The true value lies in [lower, upper] up to rounding.
struct Distance {
  Real distance, lower, upper;
  Vec3 point_a, point_b;
  Vec3 normal;
  Algorithm algorithm;
  std::uint32_t iterations;
};

// One point of a manifold, in the same terms.
struct ContactPoint {
  Vec3 point_a, point_b;
  Vec3 normal;
  Real distance;
  Feature feature_a, feature_b;
  std::uint64_t id;
  std::uint32_t child_a = 0, child_b = 0;  // of a composite, depth first, or the particle; else 0
};

// The finaliser of SplitMix64 (Steele et al. 2014).
[[nodiscard]] inline constexpr std::uint64_t scrambled(std::uint64_t value) {
  value += 0x9e3779b97f4a7c15;
  value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9;
  value = (value ^ (value >> 27)) * 0x94d049bb133111eb;
  return value ^ (value >> 31);
}

// A number of so many bits that all bits of a value have a part in: Fibonacci hashing (Knuth, volume 3, section 6.4).
[[nodiscard]] inline constexpr std::uint64_t spread(std::uint64_t value, int bits) {
  return (value * 0x9e3779b97f4a7c15) >> (64 - bits);
}

// The number of a contact depends on the features that touch and on nothing else. It is packed where their indices fit:
//   bit 63: 0, bit 62: 1, bits 59 to 61: kind of a, 31 to 58: index of a, 28 to 30: kind of b, 0 to 27: index of b.
// Else, and where more than the features tells contacts apart, it is hashed, and bit 63 is 1.
inline constexpr std::uint64_t hashed_bit = std::uint64_t{1} << 63, packed_bit = std::uint64_t{1} << 62;
inline constexpr std::uint32_t packed_indices = 1u << 28;

[[nodiscard]] inline constexpr bool is_packed(std::uint64_t id) { return (id & hashed_bit) == 0; }
// A hashed number made from another number.
[[nodiscard]] inline constexpr std::uint64_t mixed(std::uint64_t value) { return scrambled(value) | hashed_bit; }

[[nodiscard]] inline constexpr std::uint64_t contact_id(const Feature& a, const Feature& b) {
  const auto kind_a = static_cast<std::uint64_t>(a.kind), kind_b = static_cast<std::uint64_t>(b.kind);
  if (a.index < packed_indices && b.index < packed_indices) [[likely]] {
    return packed_bit | kind_a << 59 | std::uint64_t{a.index} << 31 | kind_b << 28 | b.index;
  }
  return mixed(mixed(kind_a << 32 | a.index) + (kind_b << 32 | b.index));
}

// The number of a contact with a part: a child of a composite, a triangle, or a particle that its features do not tell.
// Packed numbers differ in few bits, so they are scrambled before the part is added.
[[nodiscard]] inline constexpr std::uint64_t contact_id_of_part(std::uint64_t id, std::uint32_t part) {
  return mixed(scrambled(id) + part);
}

using Manifold = std::vector<ContactPoint>;

// A contact with a ball of many, which was a ball by itself so far.
inline void name_particle_a(ContactPoint& contact, std::uint32_t index) {
  contact.child_a = index;
  contact.feature_a = {FeatureKind::particle, index};
  contact.id =
      is_packed(contact.id) ? contact_id(contact.feature_a, contact.feature_b) : contact_id_of_part(contact.id, index);
}

// The same features may touch twice in one pair, as where an edge crosses a rim. Such contacts get numbers of their
// own, in their order.
inline void number_apart(std::span<ContactPoint> contacts) {
  // A bit for each number, where its bits lead. Mostly all have bits of their own.
  std::uint64_t seen = 0, seen_again = 0;
  for (const ContactPoint& contact : contacts) {
    const std::uint64_t bit = std::uint64_t{1} << spread(contact.id, 6);
    seen_again |= seen & bit;
    seen |= bit;
  }
  for (std::size_t i = 1; seen_again != 0 && i < contacts.size(); ++i) {
    std::uint64_t& id = contacts[i].id;
    const auto has_id = [&](const ContactPoint& other) { return other.id == id; };
    while (std::ranges::any_of(contacts.first(i), has_id)) {
      id = mixed(id);
    }
  }
}

}  // namespace abut
