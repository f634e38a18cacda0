// SPDX-License-Identifier: Apache-2.0
// The side of a surface from which a body came, triangle by triangle.
//
// A triangle tells nothing of how a body came to where it is. So a pair may remember it. A triangle that is met anew
// takes its side from a neighbour across an edge, which the winding of both tells; else from its contact, or from where
// the centre of the body is.
export module abut.narrow.sides.kept_side;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.narrow.warm.side_memory;

export namespace abut {

// A triangle and how the body lies to it.
struct TouchedPart {
  Triangle triangle;
  Vec3 normal;       // of the separation of this triangle alone, toward the body
  bool is_in_front;  // the centre of the body is
};

// The sides of some triangles of a surface, of which edges connect neighbours.
class SidesOfParts {
 public:
  // Of the triangles at these places of a list. The list may hold one triangle twice.
  explicit SidesOfParts(std::span<const TriangleCorners> corners);

  [[nodiscard]] bool is_known(std::size_t at) const { return states_[at] != State::unknown; }
  [[nodiscard]] bool is_front(std::size_t at) const { return states_[at] == State::front; }
  void set(std::size_t at, bool is_front) { states_[at] = is_front ? State::front : State::back; }
  // From those that are known to all that edges connect with them.
  void spread();
  // From one alone, whatever the others were thought to be.
  void spread_from(std::size_t at, bool is_front);

 private:
  enum class State : std::uint8_t { unknown, front, back };
  struct Edge {
    std::array<Real, 6> ends;  // the lower one first
    std::uint32_t part;
    bool is_forward;
    std::uint32_t group = 0;
  };
  // From the open ones to all unknown ones.
  void spread(std::vector<std::uint32_t> open, std::vector<State>& states) const;

  std::vector<State> states_;
  std::vector<Edge> edges_;                  // sorted, those of one place next to each other
  std::vector<std::uint32_t> group_starts_;  // in the edges
  std::vector<std::uint32_t> edge_of_part_;  // three for each triangle
};

// Of cosines between normals that searches find.
inline constexpr Real normal_slack = 1e-6;

// Whether a normal is that of a face, or its opposite, but for the rounding of searches.
[[nodiscard]] inline bool is_of_face(Real along) { return std::fabs(along) > 1 - normal_slack; }

// The sides of the triangles that a body touches, from what the pair remembers and from the contacts that it would have
// without a memory. `corners_of` answers for a triangle by its number, if it is there. A deepest contact that goes
// around takes the body to the other side.
template <class CornersOf>
[[nodiscard]] SidesOfParts sides_of(std::span<const TouchedPart> touched, std::span<const ContactPoint> contacts,
                                    const SideMemory& before, const CornersOf& corners_of);

// `along`: of the normal, along that of its triangle to the side of the body. At the rim of a surface a contact goes
// around, on from the one before.
[[nodiscard]] inline bool goes_around(const ContactPoint& contact, Real along, const SideMemory& before) {
  return along < -normal_slack && !is_of_face(along) && dot(contact.normal, before.normal) > 0;
}
// Samples of a height field may have gone.
[[nodiscard]] inline bool are_finite(const TriangleCorners& corners) {
  return is_finite(corners[0]) && is_finite(corners[1]) && is_finite(corners[2]);
}

// The place of a triangle among those that are touched, which are in order.
[[nodiscard]] std::optional<std::size_t> find_part(std::span<const TouchedPart> touched, std::uint32_t part);

// The sides of triangles and of all that edges connect with them, from those that are known. Both are in order.
[[nodiscard]] std::vector<SideOfPart> sides_around(std::span<const Triangle> triangles,
                                                   std::span<const SideOfPart> known);

template <class CornersOf>
SidesOfParts sides_of(std::span<const TouchedPart> touched, std::span<const ContactPoint> contacts,
                      const SideMemory& before, const CornersOf& corners_of) {
  // Those that are touched come first, then those that were and are no more.
  std::vector<TriangleCorners> corners;
  std::vector<std::pair<std::size_t, bool>> known;
  for (const TouchedPart& its : touched) {
    corners.push_back(its.triangle.corners());
  }
  for (const SideOfPart& its : before.parts) {
    if (const auto at = find_part(touched, its.part)) {
      known.emplace_back(*at, its.is_front);
    } else if (const std::optional<TriangleCorners> there = corners_of(its.part); there && are_finite(*there)) {
      known.emplace_back(corners.size(), its.is_front);
      corners.push_back(*there);
    }
  }
  SidesOfParts sides(corners);
  for (const auto& [at, is_front] : known) {
    sides.set(at, is_front);
  }
  sides.spread();
  // The deepest contact first: it tells about more triangles than others.
  std::vector<const ContactPoint*> order;
  for (const ContactPoint& contact : contacts) {
    order.push_back(&contact);
  }
  std::ranges::sort(order, {}, [](const ContactPoint* its) { return std::pair(its->distance, its->feature_a.index); });
  for (const ContactPoint* contact : order) {
    const auto at = find_part(touched, contact->feature_a.index);
    if (!at || !touched[*at].triangle.has_area()) {
      continue;
    }
    const Real along = dot(contact->normal, touched[*at].triangle.normal());
    if (!sides.is_known(*at)) {
      sides.set(*at, along >= 0);
      sides.spread();
    } else if (contact == order.front() && goes_around(*contact, sides.is_front(*at) ? along : -along, before)) {
      sides.spread_from(*at, along >= 0);
    }
  }
  for (std::size_t at = 0; at < touched.size(); ++at) {
    if (!sides.is_known(at)) {
      sides.set(at, touched[at].is_in_front);
      sides.spread();
    }
  }
  return sides;
}

}  // namespace abut
