// SPDX-License-Identifier: Apache-2.0
// Some triangles of a surface in a frame, four at a time, under a tree of boxes. Each node has four children, which
// come one after the other. Triangles that a surface hands over one after the other mostly lie side by side.
export module abut.narrow.two_surfaces.placed_triangles;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.math.four_vec3;
import abut.narrow.ways.leaving_four;
import abut.narrow.triangle.quick_axes;
import abut.narrow.surface.triangle_source;

export namespace abut {

struct PlacedFour : FourFaces {
  std::uint64_t present;    // a bit for each lane with a triangle
  std::uint64_t one_sided;  // those with a front only
};

struct PlacedTriangle {
  TriangleCorners corners;
  std::uint32_t number;
  bool is_one_sided;

  [[nodiscard]] Triangle part() const { return {corners, number, is_one_sided}; }
};
[[nodiscard]] inline PlacedTriangle placed_triangle(const PlacedFour& four, std::size_t lane) {
  return {four.triangles[lane], std::span(four.triangles.numbers)[lane], (four.one_sided >> lane & 1u) != 0};
}

// Of four children of a node; those that lack are nowhere.
struct FourBoxes {
  Columns low, high;

  [[nodiscard]] inline Aabb operator[](std::size_t lane) const { return {low[lane], high[lane]}; }
  // A bit for each box that overlaps another one.
  [[nodiscard]] [[gnu::always_inline]] inline std::uint64_t overlapping(const Aabb& box) const {
    const auto apart = [](Lanes from, Lanes to, Real least, Real most) {
      return (to < all_lanes(least)) | (from > all_lanes(most));
    };
    return ~bits_of(apart(low.x, high.x, box.low.x, box.high.x) | apart(low.y, high.y, box.low.y, box.high.y) |
                    apart(low.z, high.z, box.low.z, box.high.z)) &
           15u;
  }
};

class PlacedTriangles {
 public:
  // Those whose boxes overlap one in the frame.
  void gather(const TriangleSource& surface, const Pose& pose, const Aabb& box);

  [[nodiscard]] inline std::span<const PlacedFour> fours() const [[clang::lifetimebound]] { return fours_.span(); }
  [[nodiscard]] inline bool is_empty() const { return fours_.empty(); }
  // Around all.
  [[nodiscard]] inline const Aabb& box() const [[clang::lifetimebound]] { return box_; }
  // The largest magnitude of a coordinate.
  [[nodiscard]] Real size() const { return largest_magnitude(maximum(absolute(box_.low), absolute(box_.high))); }

  // The lowest level has the fours themselves, the highest one node.
  [[nodiscard]] inline std::size_t level_count() const { return levels_.size(); }
  [[nodiscard]] inline const FourBoxes& children(std::size_t level, std::size_t node) const [[clang::lifetimebound]] {
    return nodes_[levels_[level] + node];
  }
  [[nodiscard]] inline Aabb box_of(std::size_t level, std::size_t node) const {
    return level + 1 < levels_.size() ? children(level + 1, node / 4)[node % 4] : box_;
  }
  // How far nodes reach along a direction.
  void set_reaches(const Vec3& direction);
  // Of the children of a node.
  [[nodiscard]] inline const Lanes& reaches(std::size_t level, std::size_t node) const [[clang::lifetimebound]] {
    return reaches_[levels_[level] + node];
  }

 private:
  SmallVector<PlacedFour, 48> fours_;
  SmallVector<FourBoxes, 72> nodes_;
  SmallVector<Lanes, 72> reaches_;       // of each node
  SmallVector<std::size_t, 16> levels_;  // the first node of each
  Aabb box_ = Aabb::empty();
};

// A way of the second one of two surfaces, as far as it is gone, which may grow.
struct [[gsl::Pointer]] SurfaceWay {
  Vec3 direction;
  const Real& length;
};

// Calls visit(four of a, four of b) for fours that may overlap after a way, or are left within `slack` of its end: what
// may be left last mostly comes first. The reaches of both are those along the way.
template <class Visit>
void visit_fours(const PlacedTriangles& a, const PlacedTriangles& b, const SurfaceWay& way, Real slack,
                 const Visit& visit) {
  struct NodePair {
    std::uint32_t level_a, node_a, level_b, node_b;
    Real reach_a, reach_b;
  };
  if (a.is_empty() || b.is_empty()) {
    return;
  }
  [[clang::uninitialized]] SmallVector<NodePair, 64> waiting;
  const auto top = [](const PlacedTriangles& of) { return static_cast<std::uint32_t>(of.level_count() - 1); };
  waiting.push_back({top(a), 0, top(b), 0, infinity, infinity});
  // Those that reach further come last, and are next.
  const auto open = [](Lanes reaches, std::uint64_t some, const auto& add) {
    std::array<std::uint32_t, 4> lanes{};
    std::size_t count = 0;
    for (; some != 0; some &= some - 1) {
      const auto lane = static_cast<std::uint32_t>(std::countr_zero(some));
      std::size_t place = count++;
      for (; place > 0 && reaches[lanes[place - 1]] > reaches[lane]; --place) {
        lanes[place] = lanes[place - 1];
      }
      lanes[place] = lane;
    }
    for (const std::uint32_t lane : std::span(lanes).first(count)) {
      add(lane);
    }
  };
  while (!waiting.empty()) {
    const auto [level_a, node_a, level_b, node_b, reach_a, reach_b] = waiting[waiting.size() - 1];
    waiting.pop_back();
    const Real least = way.length - slack;
    if (!(reach_a + reach_b > least)) {
      continue;
    }
    const Vec3 move = way.length * way.direction;
    if (level_a == 0 && level_b == 0) {
      visit(node_a, node_b);
    } else if (level_a > level_b) {
      const Aabb box = b.box_of(level_b, node_b), ahead{box.low + move, box.high + move};
      const Lanes reaches = a.reaches(level_a, node_a);
      const std::uint64_t some = bits_of(reaches + reach_b > all_lanes(least));
      open(reaches, some == 0 ? 0 : some & a.children(level_a, node_a).overlapping(ahead.inflated(slack)),
           [&](std::uint32_t lane) {
             waiting.push_back({level_a - 1, 4 * node_a + lane, level_b, node_b, reaches[lane], reach_b});
           });
    } else {
      const Aabb box = a.box_of(level_a, node_a), ahead{box.low - move, box.high - move};
      const Lanes reaches = b.reaches(level_b, node_b);
      const std::uint64_t some = bits_of(reaches + reach_a > all_lanes(least));
      open(reaches, some == 0 ? 0 : some & b.children(level_b, node_b).overlapping(ahead.inflated(slack)),
           [&](std::uint32_t lane) {
             waiting.push_back({level_a, node_a, level_b - 1, 4 * node_b + lane, reach_a, reaches[lane]});
           });
    }
  }
}

// Calls take(triangle of a, triangle of b), which returns whether to go on, for triangles that are within `slack` of
// each other after a way. The reaches of both are those along it.
template <class Take>
void visit_near(const PlacedTriangles& a, const PlacedTriangles& b, const SurfaceWay& way, Real slack,
                const Take& take) {
  const Vec3 move = way.length * way.direction;
  bool goes_on = true;
  visit_fours(a, b, way, slack, [&](std::size_t of_a, std::size_t of_b) {
    const PlacedFour &four_a = a.fours()[of_a], &four_b = b.fours()[of_b];
    for (std::uint64_t left = goes_on ? four_a.present : 0; left != 0; left &= left - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(left));
      const Aabb at = a.children(0, of_a)[lane];
      std::uint64_t near =
          four_b.present & b.children(0, of_b).overlapping(Aabb{at.low - move, at.high - move}.inflated(slack));
      if (near == 0) {
        continue;
      }
      const PlacedTriangle one = placed_triangle(four_a, lane);
      const auto& [p, q, r] = one.corners;
      near &= QuickAxes<Triangle>::near(FourTriangles::all({p - move, q - move, r - move}), four_b.triangles, slack);
      for (; near != 0 && goes_on; near &= near - 1) {
        goes_on = take(one, placed_triangle(four_b, static_cast<std::size_t>(std::countr_zero(near))));
      }
    }
  });
}

}  // namespace abut
