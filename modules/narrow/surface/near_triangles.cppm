// SPDX-License-Identifier: Apache-2.0
// The triangles of a surface near a convex shape, four at a time, and which of them it overlaps.
export module abut.narrow.surface.near_triangles;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.math.four_vec3;
import abut.narrow.convex;
import abut.narrow.ways.leaving;
import abut.narrow.ways.leaving_four;
import abut.narrow.triangle.quick_axes;
import abut.narrow.ways.translation_search;
import abut.narrow.triangle.triangle_contacts;
import abut.narrow.surface.triangle_source;

export namespace abut {

// Four triangles near a shape, one per lane.
struct NearFour : FourFaces {
  std::uint64_t present;     // a bit for each lane with a triangle
  std::uint64_t one_sided;   // those with a front only
  std::uint64_t holding;     // those that hold what is behind them
  std::uint64_t overlapped;  // those that count as overlapped at the start
  bool has_planes;           // whether normals and heights are known
};

// A triangle that is overlapped, touched or within the margin.
struct NearTriangle {
  NearPlace at;
  TriangleSeparation found;
  Real gap;  // negative where it is overlapped
  bool is_overlapped;
  Real behind, before;  // of what is overlapped: how far the shape reaches behind the plane, and in front of it
};

// Four triangles that are overlapped at the start.
struct OverlappedFour : FourFaces {
  Lanes behind, before;
  Lanes bounds;       // of the length of a translation, while one is looked for
  std::size_t count;  // of lanes with a triangle
  std::uint64_t one_sided;
  std::array<NearPlace, 4> places;
};

template <Convex B>
class [[gsl::Pointer]] NearTriangles {
 public:
  // Looks for all triangles within `margin`. `sides`: fronts let through what comes from behind.
  NearTriangles(const TriangleSource& surface, const B& b, const Pose& ab, const QuerySettings& settings, Real margin,
                StoppingSides sides)
      : surface_(surface),
        b_(b),
        ab_(ab),
        settings_(settings),
        sides_(sides),
        size_(b.extent() + b.radius()),
        box_(b.aabb(ab)) {
    gather(margin);
  }

  [[nodiscard]] std::span<const NearTriangle> near() const [[clang::lifetimebound]] { return near_.span(); }
  // In the order of the tree. Of fours that have triangles that are overlapped, planes are known.
  [[nodiscard]] std::span<const NearFour> fours() const [[clang::lifetimebound]] { return fours_.span(); }
  const NearFour& find_planes(std::size_t place) [[clang::lifetimebound]] {
    NearFour& four = fours_[place];
    if (!four.has_planes) {
      four.set_planes(four.present);
      four.has_planes = true;
    }
    return four;
  }
  [[nodiscard]] std::uint32_t number_at(const NearPlace& at) const {
    return fours_[at.four].triangles.numbers[at.lane];
  }
  [[nodiscard]] Triangle triangle_at(const NearPlace& at) const { return triangle_of(fours_[at.four], at.lane); }
  // Sorts places by the numbers of their triangles, so that the form of a tree does not matter.
  void sort_by_number(std::span<NearPlace> places) const {
    std::ranges::sort(places, {}, [this](const NearPlace& at) { return number_at(at); });
  }
  [[nodiscard]] bool is_overlapped() const { return !overlapped_.empty(); }
  // Lengths below it are rounding, or less than the bound of the searches that are asked.
  [[nodiscard]] Real tolerance() const { return tolerance_; }

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
      add(four, present & ~(surface_.is_placed() ? known_of(four) : four.overlapping(before)));
      return true;
    });
  }
  const TriangleSource& surface_;
  const B& b_;
  const Pose& ab_;
  const QuerySettings& settings_;
  StoppingSides sides_;
  Real size_;  // of b
  Real tolerance_ = 0;
  SmallVector<NearFour, 72> fours_;
  SmallVector<OverlappedFour, 16> overlapped_;
  SmallVector<NearTriangle, 32> near_;  // in the order of their numbers
  Real least_ = 0;                      // no translation that ends the overlap is shorter
  Vec3 deepest_way_{0, 0, 1};           // out of the triangle that is the deepest by itself

 private:
  static constexpr Real gather_share = 0.04;  // of the size of b, around its box

  [[nodiscard]] static Triangle triangle_of(const NearFour& four, std::size_t lane) {
    return {four.triangles[lane], four.triangles.numbers[lane], (four.one_sided >> lane & 1u) != 0};
  }

  void gather(Real margin) {
    const Real wanted = std::max(margin, Real{0}) + edge_slack(b_, ab_);
    covered_ = box_.inflated(wanted + gather_share * size_);
    surface_.visit(covered_, [this](const FourTriangles& four, std::uint64_t present) {
      add(four, present);
      return true;
    });
    const QuickAxes<B> axes(b_, ab_);
    const Real limit = std::max(margin + b_.radius() + edge_slack(b_, ab_), touching_ + b_.radius());
    const Aabb query = box_.inflated(wanted);
    SmallVector<NearPlace, 128> asked;
    for (std::uint32_t i = 0; i < fours_.size(); ++i) {
      const FourTriangles& four = fours_[i].triangles;
      std::uint64_t left = fours_[i].present & four.overlapping(query);
      left = left == 0 ? 0 : left & axes.near(four, limit);
      for (; left != 0; left &= left - 1) {
        asked.push_back({i, static_cast<std::uint32_t>(std::countr_zero(left))});
      }
    }
    sort_by_number(asked.span());
    for (const NearPlace& at : asked.span()) {
      look_at(at, margin);
    }
    for (const NearTriangle& near : near_.span()) {
      if (near.is_overlapped) {
        add_overlapped(near);
      }
    }
  }

  void add(const FourTriangles& four, std::uint64_t present) {
    if (present == 0) {
      return;
    }
    const bool has_fronts = sides_ != StoppingSides::both;
    const std::uint64_t one_sided = has_fronts ? surface_.one_sided(four) : 0,
                        holding = has_fronts ? surface_.holding(four) : 0;
    const Lanes sizes = four.size();
    Real largest_of_them = 0;
    for (std::uint64_t left = present; left != 0; left &= left - 1) {
      largest_of_them = std::max(largest_of_them, sizes[static_cast<std::size_t>(std::countr_zero(left))]);
    }
    const Real size = 4 * size_ + largest_magnitude(ab_.position) + 2 * largest_of_them;
    touching_ = std::max(touching_, touching_within<B>(size, settings_));
    constexpr Real usual = Curved<B> ? usual_error_of_curves : usual_error;
    tolerance_ = std::max({tolerance_, touching_, 2 * (usual * 2 * size_ + noise_of(size))});
    if (present == 15) {
      add_four(four, one_sided, holding);
      return;
    }
    // Those of fours that lack some stand side by side.
    for (std::uint64_t left = present; left != 0; left &= left - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(left));
      if (unfilled_ == fours_.size() || fours_[unfilled_].present == 15) {
        unfilled_ = fours_.size();
        add_four(FourTriangles::all(four[lane]), 0, 0);
        fours_[unfilled_].present = 0;
      }
      NearFour& to = fours_[unfilled_];
      const auto free = static_cast<std::size_t>(std::countr_zero(~to.present));
      put(four, lane, free, to.triangles);
      to.one_sided |= (one_sided >> lane & 1u) << free;
      to.holding |= (holding >> lane & 1u) << free;
      to.present |= std::uint64_t{1} << free;
      to.has_planes = false;
    }
  }
  // A bit for each of four triangles that is there already.
  [[nodiscard]] std::uint64_t known_of(const FourTriangles& four) const {
    std::uint64_t known = 0;
    for (const NearFour& near : fours_.span()) {
      for (std::uint64_t left = near.present; left != 0; left &= left - 1) {
        const auto number = near.triangles.numbers[static_cast<std::size_t>(std::countr_zero(left))];
        for (std::size_t lane = 0; lane < 4; ++lane) {
          known |= std::uint64_t{four.numbers[lane] == number ? 1u : 0u} << lane;
        }
      }
    }
    return known;
  }
  void add_four(const FourTriangles& four, std::uint64_t one_sided, std::uint64_t holding) {
    [[clang::uninitialized]] NearFour near;
    near.triangles = four;
    near.present = 15;
    near.one_sided = one_sided;
    near.holding = holding;
    near.overlapped = 0;
    near.has_planes = false;
    fours_.push_back(near);
  }
  static void put(const FourTriangles& from, std::size_t lane, std::size_t place, FourTriangles& to) {
    to.a.put(place, from.a[lane]);
    to.b.put(place, from.b[lane]);
    to.c.put(place, from.c[lane]);
    to.numbers[place] = from.numbers[lane];
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
    const bool is_in_front = Fronts<B>(triangle, b_, ab_).allows(core.normal), is_overlapped = gap < -touching;
    const bool is_held = is_overlapped && (four.holding >> at.lane & 1u) != 0;
    if (!is_in_front && !is_held && !counts_from_behind(triangle, b_, ab_, core)) {
      return;
    }
    near_.push_back({at, found, gap, is_overlapped, 0, 0});
    if (!is_overlapped) {
      return;
    }
    four.overlapped |= std::uint64_t{1} << at.lane;
    find_planes(at.four);
    const Vec3 normal = four.normals[at.lane];
    NearTriangle& near = near_[near_.size() - 1];
    near.behind = four.heights[at.lane] - lowest_point_along(b_, ab_, normal);
    near.before = -lowest_point_along(b_, ab_, -normal) - four.heights[at.lane];
    const Real depth = Curved<B> ? b_.radius() - core.upper : -gap;
    if (depth > least_) {
      least_ = depth;
      deepest_way_ = is_in_front || !is_held ? core.normal : normal;
    }
  }
  // Side by side, so that a search asks about no others.
  void add_overlapped(const NearTriangle& near) {
    if (overlapped_.empty() || overlapped_[overlapped_.size() - 1].count == 4) {
      [[clang::uninitialized]] OverlappedFour four;
      // The first one stands in for those that lack.
      four.triangles = FourTriangles::all(fours_[near.at.four].triangles[near.at.lane]);
      four.normals = Columns::all({0, 0, 0});
      four.heights = four.behind = four.before = all_lanes(0);
      four.bounds = all_lanes(-infinity);
      four.count = 0;
      four.one_sided = 0;
      four.places.fill(near.at);
      overlapped_.push_back(four);
    }
    OverlappedFour& four = overlapped_[overlapped_.size() - 1];
    const std::size_t lane = four.count++;
    const NearFour& from = fours_[near.at.four];
    put(from.triangles, near.at.lane, lane, four.triangles);
    four.normals.put(lane, from.normals[near.at.lane]);
    four.heights[lane] = from.heights[near.at.lane];
    four.behind[lane] = near.behind;
    four.before[lane] = near.before;
    four.places[lane] = near.at;
    four.one_sided |= (from.one_sided >> near.at.lane & 1u) << lane;
  }

  Aabb box_, covered_;
  Real touching_ = 0;
  std::size_t unfilled_ = 0;  // place of the four that lacks triangles, if any does
};

}  // namespace abut
