// SPDX-License-Identifier: Apache-2.0
// The deepest points of a convex core in a sampled field. Where a descent has to begin is found by boxes of space:
// values in a box are bounded from below by the one in its middle.
export module abut.narrow.field.field_descent;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
export import abut.narrow.field.field_core;

export namespace abut {

// A box of space in the frame of a core.
struct SpaceBox {
  Vec3 centre, half;

  [[nodiscard]] Real radius() const { return norm(half); }
  // The middles of its sides, and its corners.
  template <class Visitor>
  void visit_ends(Visitor&& visit) const {
    for (const Vec3& way :
         {Vec3{half.x, 0, 0}, Vec3{0, half.y, 0}, Vec3{0, 0, half.z}, half, Vec3{-half.x, half.y, half.z},
          Vec3{half.x, -half.y, half.z}, Vec3{half.x, half.y, -half.z}}) {
      visit(centre + way);
      visit(centre - way);
    }
  }
  // Its pieces, cut across all but its short sides.
  template <class Visitor>
  void visit_pieces(Visitor&& visit) const {
    constexpr Real short_share = 0.6;
    const Real longest = largest_magnitude(half);
    const auto is_cut = [&](int axis) { return half[axis] >= short_share * longest; };
    const Vec3 pieces{is_cut(0) ? 0.5 * half.x : half.x, is_cut(1) ? 0.5 * half.y : half.y,
                      is_cut(2) ? 0.5 * half.z : half.z};
    for (int bits = 0; bits < 8; ++bits) {
      const auto shift = [&](int axis) {
        return !is_cut(axis) ? 0 : (bits >> axis & 1) != 0 ? pieces[axis] : -pieces[axis];
      };
      if ((is_cut(0) || (bits & 1) == 0) && (is_cut(1) || (bits & 2) == 0) && (is_cut(2) || (bits & 4) == 0)) {
        visit(SpaceBox{centre + Vec3{shift(0), shift(1), shift(2)}, pieces});
      }
    }
  }
};
[[nodiscard]] inline SpaceBox space_of(const Aabb& box) { return {box.centre(), 0.5 * (box.high - box.low)}; }

// The deepest point. Apart, `lower` is a lower bound of the distance of the core from the surface; in overlap one of
// the values in the core.
struct LeastValue {
  FieldPoint point;
  Real lower;
  std::uint32_t boxes;  // that were looked at
};

// Such a bound for all points within a radius of one, from the value there. Ways to the surface differ by no more than
// the radius.
template <SampledSolid F>
[[nodiscard]] Real least_nearby(const F& field, Real value, Real radius) {
  const Real least = field.least_within(value, radius);
  return value <= 0 || least <= 0 ? std::max(least, value > 0 ? field.least_way(value) - radius : least)
                                  : std::max(field.least_way(value) - radius, field.least_way(least));
}

// The points of least value with a value of at most `limit`, each once; of a flat, some. A minimum in a hollow narrower
// than six cells or a quarter of the core may be missed.
template <SampledSolid F, Convex B>
void find_deepest(const F& field, const B& b, const Pose& pose, Real limit, std::vector<FieldPoint>& out) {
  constexpr int most_cuts = 3;
  constexpr Real least_cells = 3, apart_cells = 0.25, like = 1e-6;
  const CoreInField<F, B> core(field, b, pose);
  const auto add = [&](const FieldPoint& found) {
    const Real apart = apart_cells * field.finest();
    const auto is_same = [&](const FieldPoint& other) {
      const bool is_near = squared_norm(other.point - found.point) <= apart * apart;
      const bool is_of_flat = std::fabs(other.field.value - found.field.value) <= like * field.finest() &&
                              squared_norm(other.field.gradient - found.field.gradient) <= like * like;
      return is_near || is_of_flat;
    };
    if (found.field.value <= limit && std::ranges::none_of(out, is_same)) {
      out.push_back(found);
    }
  };
  const auto search = [&](auto&& again, const SpaceBox& box, int cuts) -> void {
    const Real radius = box.radius();
    const std::optional<Vec3> nearest = core.nearest_within(box.centre, radius);
    if (!nearest || least_nearby(field, core.at(box.centre).field.value, radius) > limit) {
      return;
    }
    if (cuts < most_cuts && largest_magnitude(box.half) > least_cells * field.finest()) {
      box.visit_pieces([&](const SpaceBox& piece) { again(again, piece, cuts + 1); });
      return;
    }
    // Whatever lies further down is found from the box where it is.
    const auto is_around = [&](const Vec3& point) {
      return cuts == 0 || Aabb::around(box.centre, 2 * box.half).overlaps({point, point});
    };
    if (const auto found = core.descend_while(*nearest, 0.5 * radius, 0.5 * radius, is_around)) {
      add(*found);
    }
  };
  const SpaceBox whole = space_of(box_of_core(b));
  if constexpr (PointCored<B>) {
    add(core.at(whole.centre));
  } else {
    search(search, whole, 0);
  }
}

template <SampledSolid F, Convex B>
[[nodiscard]] LeastValue least_value(const F& field, const B& b, const Pose& pose) {
  struct Open {
    SpaceBox box;
    Real lower;
  };
  constexpr std::uint32_t most_boxes = 256, boxes_of_descents = 8;
  constexpr Real end_share = 0.01;  // of a cell
  const CoreInField<F, B> core(field, b, pose);
  const SpaceBox whole = space_of(box_of_core(b));
  LeastValue out{core.descend(core.nearest(whole.centre), whole.radius()), 0, 1};
  const auto least_there = [&] { return least_nearby(field, out.point.field.value, 0); };
  if constexpr (PointCored<B>) {
    out.lower = least_there();
    return out;
  }
  const auto descend_from = [&](const Vec3& point, Real stride) {
    if (const FieldPoint found = core.descend(point, stride); found.field.value < out.point.field.value) {
      out.point = found;
    }
  };
  // What sticks out may be deepest, and few boxes lie there. A thin core has one point for several ends.
  SmallVector<Vec3, 16> begun;
  begun.push_back(core.nearest(whole.centre));
  whole.visit_ends([&](const Vec3& end) {
    const Vec3 point = core.nearest(end);
    if (std::ranges::find(begun.span(), point) == begun.span().end()) {
      begun.push_back(point);
      descend_from(point, 0.5 * whole.radius());
    }
  });
  std::vector<Open> open{{whole, least_nearby(field, core.at(whole.centre).field.value, whole.radius())}};
  for (;;) {
    const auto least = open.empty() ? open.end() : std::ranges::min_element(open, {}, &Open::lower);
    if (open.empty() || out.boxes >= most_boxes || least->lower >= out.point.field.value - end_share * field.finest()) {
      out.lower = open.empty() ? out.point.field.value : std::min(least->lower, out.point.field.value);
      return out;
    }
    const Open next = *least;
    std::iter_swap(least, open.end() - 1);
    open.resize(open.size() - 1, next);
    next.box.visit_pieces([&](const SpaceBox& piece) {
      const Real radius = piece.radius();
      ++out.boxes;
      const Real lower = std::max(next.lower, least_nearby(field, core.at(piece.centre).field.value, radius));
      if (lower >= least_there()) {
        return;
      }
      const std::optional<Vec3> nearest = core.nearest_within(piece.centre, radius);
      if (!nearest) {
        return;
      }
      if (out.boxes <= boxes_of_descents || core.at(*nearest).field.value < out.point.field.value) {
        descend_from(*nearest, radius);
      }
      open.push_back({piece, lower});
    });
  }
}

}  // namespace abut
