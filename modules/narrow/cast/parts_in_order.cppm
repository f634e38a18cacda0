// SPDX-License-Identifier: Apache-2.0
// The parts of a shape in the order in which something that moves meets their boxes.
export module abut.narrow.cast.parts_in_order;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.narrow.cast.linear_cast;

export namespace abut {

template <class S>
inline constexpr bool has_parts = Surface<S> || Scattered<S>;

// A part and the way after which its box is met.
template <class Part>
struct PartMet {
  Real enter;
  std::uint32_t index;
  Vec3 place;  // of a particle
  Part part;
};

template <class Part>
[[nodiscard]] inline bool is_met_before(const PartMet<Part>& a, const PartMet<Part>& b) {
  return a.enter != b.enter ? a.enter < b.enter : a.index < b.index;
}

template <class S>
using PartVisitor = std::function<void(const PartMet<typename S::Part>& met)>;

// Calls visit(met) in order for the parts whose boxes a moving box meets before `limit`. The call may shrink the limit.
// The way goes in stretches, so that the box around each is not much larger than the moving one. Once for each kind of
// shape: a cast against a part takes far longer than a call of a function.
template <class S>
void visit_in_order(const S& shape, const Aabb& moving, const LinearMotion& motion, Real slack, const Real& limit,
                    const PartVisitor<S>& visit) {
  constexpr Real most_stretches = 64;
  const std::optional<Passage> whole = passage_of(shape.aabb(Pose::identity()).inflated(slack), moving, motion);
  if (!whole) {
    return;
  }
  const Real span = whole->leave - whole->enter, own = largest_magnitude(moving.high - moving.low);
  const Real count = span > own ? std::min(std::ceil(span / std::max(own, span / most_stretches)), most_stretches) : 1;
  std::vector<PartMet<typename S::Part>> met;
  for (Real stretch = 0; stretch < count; ++stretch) {
    const Real begin = whole->enter + stretch / count * span;
    const Real end = stretch + 1 < count ? whole->enter + (stretch + 1) / count * span : whole->leave;
    if (begin > limit) {
      return;
    }
    met.clear();
    // A part belongs to the stretch in which it is met.
    const auto add = [&](const typename S::Part& part, const Vec3& place, std::uint32_t index) {
      const auto passage = passage_of(part.aabb({Rotation::identity(), place}).inflated(slack), moving, motion);
      if (passage && (passage->enter > begin || stretch == 0) && (passage->enter <= end || stretch + 1 == count)) {
        met.push_back({passage->enter, index, place, part});
      }
    };
    Aabb box = swept(moving, motion, begin, end).inflated(slack);
    if constexpr (Surface<S>) {
      shape.visit_parts(box, [&](const typename S::Part& part, std::uint32_t index) { add(part, {0, 0, 0}, index); });
    } else {
      shape.visit_places(box, [&](const Vec3& place, std::uint32_t index) { add(shape.part(index), place, index); });
    }
    std::ranges::sort(met, is_met_before<typename S::Part>);
    for (const auto& each : met) {
      if (each.enter > limit) {
        break;
      }
      visit(each);
    }
  }
}

}  // namespace abut
