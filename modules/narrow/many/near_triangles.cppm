// SPDX-License-Identifier: Apache-2.0
// The triangles of a surface near a convex shape, four at a time, and which of them it overlaps.
export module abut.narrow.many.near_triangles;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.math.four_vec3;
import abut.narrow.convex;
import abut.narrow.many.leaving;
import abut.narrow.many.leaving_four;
import abut.narrow.many.quick_axes;
import abut.narrow.many.triangle_contacts;
import abut.narrow.many.triangle_source;

export namespace abut {

// Four triangles near a shape, one per lane.
struct NearFour : FourFaces {
  // Of those that are overlapped: how far the shape reaches behind the plane, and in front of it.
  Lanes behind, before;
  Lanes bounds;              // of the length of a translation, while one is looked for
  std::uint64_t present;     // a bit for each lane with a triangle
  std::uint64_t one_sided;   // those with a front only
  std::uint64_t overlapped;  // those that count as overlapped at the start
  bool has_planes;           // whether normals and heights are known
};

// A triangle near a shape.
struct NearPlace {
  std::size_t four, lane;
};

// A triangle that is overlapped, touched or within the margin.
struct NearTriangle {
  NearPlace at;
  TriangleSeparation found;
  Real gap;  // negative where it is overlapped
  bool is_overlapped;
};

template <Convex B>
class NearTriangles {
 public:
  // Looks for all triangles within `margin`. `has_fronts`: whether fronts let through what comes from behind.
  NearTriangles(const TriangleSource& surface, const B& b, const Pose& ab, const QuerySettings& settings, Real margin,
                bool has_fronts)
      : surface_(surface),
        b_(b),
        ab_(ab),
        settings_(settings),
        size_(b.extent() + b.radius()),
        box_(b.aabb(ab)),
        has_fronts_(has_fronts) {
    gather(margin);
  }

  [[nodiscard]] std::span<const NearTriangle> near() const [[clang::lifetimebound]] { return near_.span(); }
  // Of fours that have triangles that are overlapped, planes are known.
  [[nodiscard]] std::span<const NearFour> fours() const [[clang::lifetimebound]] { return fours_.span(); }
  const NearFour& find_planes(std::size_t place) [[clang::lifetimebound]] {
    NearFour& four = fours_[place];
    if (!four.has_planes) {
      set_planes(four);
    }
    return four;
  }
  [[nodiscard]] Triangle triangle_at(const NearPlace& at) const { return triangle_of(fours_[at.four], at.lane); }
  [[nodiscard]] bool is_overlapped() const { return count_ > 0; }
  // Lengths below it are rounding, or less than the bound of the searches that are asked.
  [[nodiscard]] Real tolerance() const { return tolerance_; }
  // No translation that ends the overlap is shorter.
  [[nodiscard]] Real least() const { return least_; }

 protected:
  // Triangles that the box of b reaches on the way.
  void cover(const Aabb& box) {
    if (minimum(box.low, covered_.low) == covered_.low && maximum(box.high, covered_.high) == covered_.high) {
      return;
    }
    // As far to all sides: shorter translations along other directions mostly follow.
    const Vec3 beyond = maximum(maximum(box_.low - box.low, box.high - box_.high), Vec3{0, 0, 0});
    Aabb wider = box_.inflated(largest_magnitude(beyond) + gather_share * size_);
    wider.include(covered_);
    wider.include(box);
    const Aabb before = std::exchange(covered_, wider);
    surface_.visit(covered_, [&](const FourTriangles& four, std::uint64_t present) {
      take(four, present & ~four.overlapping(before));
    });
    add_taken();
  }

  const TriangleSource& surface_;
  const B& b_;
  const Pose& ab_;
  const QuerySettings& settings_;
  Real size_;  // of b
  Real tolerance_ = 0;
  SmallVector<NearFour, 48> fours_;
  SmallVector<NearTriangle, 32> near_;
  Real least_ = 0;
  Vec3 deepest_way_{0, 0, 1};  // out of the triangle that is the deepest by itself

 private:
  static constexpr Real gather_share = 0.04;  // of the size of b, around its box

  [[nodiscard]] static Triangle triangle_of(const NearFour& four, std::size_t lane) {
    return {four.triangles[lane], four.triangles.numbers[lane], (four.one_sided >> lane & 1u) != 0};
  }

  void gather(Real margin) {
    const Real wanted = std::max(margin, Real{0}) + edge_slack(b_, ab_);
    covered_ = box_.inflated(wanted + gather_share * size_);
    surface_.visit(covered_, [this](const FourTriangles& four, std::uint64_t present) { take(four, present); });
    add_taken();
    const QuickAxes<B> axes(b_, ab_);
    const Real limit = margin + b_.radius() + edge_slack(b_, ab_);
    Aabb query = box_.inflated(wanted);
    for (std::size_t i = 0; i < fours_.size(); ++i) {
      const FourTriangles& four = fours_[i].triangles;
      std::uint64_t asked = fours_[i].present & four.overlapping(query);
      asked = asked == 0 ? 0 : asked & axes.near(four, std::max(limit, touching_ + b_.radius()));
      for (; asked != 0; asked &= asked - 1) {
        look_at({i, static_cast<std::size_t>(std::countr_zero(asked))}, margin);
      }
    }
  }

  void take(const FourTriangles& four, std::uint64_t present) {
    for (std::uint64_t left = present; left != 0; left &= left - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(left));
      const std::uint64_t place = taken_.size();
      order_.push_back(std::uint64_t{four.numbers[lane]} << 32 | place);
      taken_.push_back(four[lane]);
    }
  }
  // In the order of their numbers, so that the form of a tree does not matter.
  void add_taken() {
    std::ranges::sort(order_.span());
    const std::span<const std::uint64_t> order = order_.span();
    for (std::size_t first = 0; first < order.size(); first += 4) {
      // The last one stands in for those that lack.
      const auto at = [&](std::size_t lane) { return order[std::min(first + lane, order.size() - 1)]; };
      const auto corners = [&](std::size_t lane) -> const TriangleCorners& { return taken_[at(lane) & 0xffffffff]; };
      const auto number = [&](std::size_t lane) { return static_cast<std::uint32_t>(at(lane) >> 32); };
      const std::size_t count = std::min<std::size_t>(4, order.size() - first);
      add(FourTriangles::of(corners(0), corners(1), corners(2), corners(3),
                            {number(0), number(1), number(2), number(3)}),
          (std::uint64_t{1} << count) - 1);
    }
    order_.clear();
    taken_.clear();
  }
  void add(const FourTriangles& four, std::uint64_t present) {
    [[clang::uninitialized]] NearFour near;
    near.triangles = four;
    near.present = present;
    near.one_sided = has_fronts_ ? surface_.one_sided(four) : 0;
    near.overlapped = 0;
    near.has_planes = false;
    near.behind = near.before = all_lanes(0);
    near.bounds = all_lanes(-infinity);
    const Real size = 4 * size_ + largest_magnitude(ab_.position) + 2 * largest(four.size());
    touching_ = std::max(touching_, touching_within<B>(size, settings_));
    constexpr Real usual = Curved<B> ? usual_error_of_curves : usual_error;
    tolerance_ = std::max(touching_, 2 * (usual * 2 * size_ + noise_of(size)));
    fours_.push_back(near);
  }
  // Normals of slivers are told by their triangle.
  static void set_planes(NearFour& near) {
    constexpr Real sliver_square = 1e-6;
    const FourTriangles& t = near.triangles;
    const Columns ab = t.b - t.a, ac = t.c - t.a, n = cross(ab, ac);
    const Lanes square = dot(n, n);
    near.normals = (1 / __builtin_elementwise_sqrt(square)) * n;
    const LaneNumbers is_wide = (square > sliver_square * dot(ab, ab) * dot(ac, ac)) & (square > all_lanes(1e-200)) &
                                (square < all_lanes(1e200));
    for (std::uint64_t left = near.present & ~bits_of(is_wide); left != 0; left &= left - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(left));
      near.normals.put(lane, triangle_of(near, lane).normal());
    }
    near.heights = dot(near.normals, t.a);
    near.has_planes = true;
  }

  void look_at(const NearPlace& at, Real margin) {
    NearFour& four = fours_[at.four];
    const Triangle triangle = triangle_of(four, at.lane);
    const Real touching = touching_within<B>(core_size(triangle, b_, ab_), settings_);
    const Real limit = std::max(margin, touching) + b_.radius() + edge_slack(b_, ab_);
    const TriangleSeparation found =
        begin_separation(triangle, b_, ab_, settings_, margin > 0 ? limit : margin + b_.radius() + edge_slack(b_, ab_));
    const CoreSeparation& core = found.core;
    const Real gap = core.distance - b_.radius();
    if (core.beyond || gap > std::max(margin, touching)) {
      return;
    }
    const bool is_in_front = Fronts<B>(triangle, b_, ab_).allows(core.normal);
    if (!is_in_front && !counts_from_behind(triangle, b_, ab_, core)) {
      return;
    }
    const bool is_overlapped = gap < -touching;
    near_.push_back({at, found, gap, is_overlapped});
    if (!is_overlapped) {
      return;
    }
    four.overlapped |= std::uint64_t{1} << at.lane;
    ++count_;
    find_planes(at.four);
    set_reaches(at);
    const Real depth = Curved<B> ? b_.radius() - core.upper : -gap;
    if (depth > least_) {
      least_ = depth;
      deepest_way_ = core.normal;
    }
  }
  void set_reaches(const NearPlace& at) {
    NearFour& four = fours_[at.four];
    const Vec3 normal = four.normals[at.lane];
    four.behind[at.lane] = four.heights[at.lane] - lowest_point_along(b_, ab_, normal);
    four.before[at.lane] = -lowest_point_along(b_, ab_, -normal) - four.heights[at.lane];
  }

  Aabb box_, covered_;
  bool has_fronts_;
  Real touching_ = 0;
  SmallVector<std::uint64_t, 160> order_;
  SmallVector<TriangleCorners, 160> taken_;
  std::size_t count_ = 0;  // of triangles that are overlapped
};

}  // namespace abut
