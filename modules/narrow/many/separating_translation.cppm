// SPDX-License-Identifier: Apache-2.0
// The shortest translation found after which a convex shape overlaps nothing of a surface.
//
// The length of a translation along a direction depends on the surface as a set of points only: it ends where the shape
// overlaps no triangle, whether it did at the start or not. So the answer does not depend on how a surface is cut into
// triangles, and is never too short. Starts are normals of what is overlapped; from each the search goes on along the
// shortest translation that leaves all planes touched so far (after Je et al., "PolyDepth: real-time penetration depth
// computation using iterative contact-space projection", 2012).
export module abut.narrow.many.separating_translation;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.math.four_vec3;
import abut.narrow.convex;
import abut.narrow.many.least_translation;
import abut.narrow.many.leaving;
import abut.narrow.many.leaving_four;
export import abut.narrow.many.near_triangles;
import abut.narrow.many.quick_axes;
import abut.narrow.many.search_starts;
import abut.narrow.many.triangle_contacts;

export namespace abut {

// What a shape touches after a translation.
struct SurfaceTouch {
  Vec3 normal;  // unit, from the surface
  Real length;  // of the translation
  NearPlace at;
};

struct SeparatingTranslation {
  Real length = infinity;
  Vec3 direction{0, 0, 1};
  SmallVector<SurfaceTouch, 8> touches;
};

[[nodiscard]] inline const SurfaceTouch& last_touch(const SeparatingTranslation& translation [[clang::lifetimebound]]) {
  return *std::ranges::min_element(translation.touches.span(), {},
                                   [](const SurfaceTouch& touch) { return -touch.length; });
}

template <Convex B>
class SurfaceSearch : public NearTriangles<B> {
 public:
  using Near = NearTriangles<B>;
  using Near::Near;
  using Near::find_planes, Near::number_at, Near::triangle_at;

  // To be called where something is overlapped.
  [[nodiscard]] const SeparatingTranslation& find() [[clang::lifetimebound]] {
    improve(deepest_way_, infinity);
    if (!is_settled()) {
      try_starts();
    }
    // Curved shapes come nearer step by step.
    constexpr int most_polishes = Curved<B> ? 24 : 3;
    for (int i = 0; i < most_polishes && best_.length < infinity && !is_settled(); ++i) {
      const Real before = best_.length;
      improve(best_.direction, 1.5);
      if (!(best_.length < before * (1 - 1e-12))) {
        break;
      }
    }
    if (!(best_.length < infinity)) {
      // No way ends in front of all: what is jammed between fronts is told the shortest way that ends behind one.
      allows_back_ = true;
      improve(deepest_way_, infinity);
      try_starts();
    }
    return best_;
  }

  // The same translation for a rod that is thinner than the one that was searched for, by less than the tie.
  [[nodiscard]] SeparatingTranslation of_thinner(const SeparatingTranslation& translation, const B& rod)
    requires SegmentCored<B>
  {
    SeparatingTranslation exact = translation;
    exact.length = 0;
    for (std::size_t i = 0; i < fours_.size(); ++i) {
      const FourStretches found = stretches_of(find_planes(i), rod, ab_, translation.direction);
      const Lanes most = all_lanes(translation.length + tolerance_);
      const LaneNumbers counts = (found.begin < most) & (found.end <= most);
      for (std::uint64_t left = fours_[i].present & bits_of(counts); left != 0; left &= left - 1) {
        exact.length = std::max(exact.length, found.end[static_cast<std::size_t>(std::countr_zero(left))]);
      }
    }
    // Past a corner the rod itself may miss all.
    const Real thickness = b_.radius() - rod.radius();
    if (exact.length < translation.length - tie() - 4 * thickness) {
      exact.length = translation.length - thickness;
    }
    for (SurfaceTouch& touch : exact.touches.span()) {
      touch.length = std::min(touch.length, exact.length);
    }
    return exact;
  }
  // The point of b, where it is, that is last to leave the surface. b may be thinner than what was searched for.
  [[nodiscard]] Vec3 last_point(const SeparatingTranslation& translation, const B& b) const {
    const SurfaceTouch& touch = last_touch(translation);
    const Triangle triangle = triangle_at(touch.at);
    const Vec3 move = translation.length * translation.direction;
    Vec3 last = placed_support(b, place(b, ab_), -touch.normal).point;
    if (std::fabs(dot(touch.normal, triangle.normal())) < 1 - 1e-12) {
      const Pose after{ab_.rotation, ab_.position + move};
      CoreSeparation core = separate_outside(triangle, b, after, settings_);
      find_points(triangle, b, after, core);
      last = core.point_b - move;
    }
    return last - b.radius() * touch.normal;
  }

 private:
  using Near::ab_, Near::b_, Near::deepest_way_, Near::fours_, Near::least_, Near::near_;
  using Near::overlapped_, Near::settings_, Near::size_, Near::tolerance_;

  struct Back {
    Vec3 normal;
    Real length;
  };
  struct Exit {
    Real length = 0;
    bool is_stopped = false;
    SmallVector<SurfaceTouch, 8> touches;
    SmallVector<Back, 4> backs;  // fronts that are left last, and through their backs
  };
  // Planes that are left within it of each other are touched together: else rounding would tell which of them counts.
  [[nodiscard]] Real tie() const {
    constexpr Real near_share = 1e-7;
    return std::max(4 * tolerance_, near_share * size_);
  }
  [[nodiscard]] bool is_settled() const { return best_.length <= least_ * (1 + 1e-12) + tolerance_; }

  // Looks no further than `enough`.
  [[nodiscard]] Exit exit_along(const Vec3& direction, Real enough) {
    Exit exit;
    const Real lowest = lowest_point_along(b_, ab_, direction);
    if (is_blocked_again(direction, lowest, enough, exit)) {
      return exit;
    }
    set_bounds(direction, lowest);
    constexpr int most_rounds = 64;
    for (int round = 0; round < most_rounds; ++round) {
      if (!leave_overlapped(direction, enough, exit)) {
        return exit;
      }
      const Real before = exit.length;
      if (!leave_those_ahead(direction, lowest, enough, exit)) {
        return exit;
      }
      if (!(exit.length > before)) {
        break;
      }
    }
    settle(exit);
    if (!exit.touches.empty()) {
      last_blocker_ = exit.touches[0].at;
    }
    return exit;
  }

  [[nodiscard]] static Real reach_of(const NearFour& four, std::size_t lane, const Vec3& direction) {
    return -least_along(four.triangles[lane], -direction);
  }
  // What stood in the way lately mostly does again.
  [[nodiscard]] bool is_blocked_again(const Vec3& direction, Real lowest, Real enough, Exit& exit) {
    if (!last_blocker_ || !(enough < infinity)) {
      return false;
    }
    const Real bound = reach_of(fours_[last_blocker_->four], last_blocker_->lane, direction) - lowest;
    if (!(bound >= enough - tolerance_)) {
      return false;
    }
    const bool is_met = (fours_[last_blocker_->four].overlapped >> last_blocker_->lane & 1u) != 0;
    if (!is_met) {
      return false;
    }
    const Leaving found = leave_one(*last_blocker_, direction, {.bound = bound, .enough = enough});
    return found.length >= enough - tolerance_ && stop(*last_blocker_, found, exit);
  }
  [[nodiscard]] Leaving leave_one(const NearPlace& at, const Vec3& direction, const LeavingBounds& bounds) {
    if constexpr (leaves_in_fours<B>) {
      if (takes_closed_forms(settings_.algorithm)) {
        const FourStretches found = stretches_of(find_planes(at.four), b_, ab_, direction);
        if (found.end[at.lane] > -infinity) {
          return leaving_of(fours_[at.four], at.lane, at, found, direction);
        }
      }
    }
    return leave(triangle_at(at), b_, ab_, direction, settings_, bounds, tolerance_);
  }
  [[nodiscard]] Leaving leaving_of(const FourFaces& four, std::size_t lane, const NearPlace& at,
                                   const FourStretches& found, const Vec3& direction) const {
    const Real length = found.end[lane];
    if constexpr (is_box<B>) {
      return {length, normal_at_end(four, lane, ab_, direction, found.axis[lane])};
    } else {
      const Pose after{ab_.rotation, ab_.position + length * direction};
      return {length, separate_outside(triangle_at(at), b_, after, settings_).normal};
    }
  }
  [[nodiscard]] bool stop(const NearPlace& at, const Leaving& found, Exit& exit) {
    exit.length = found.length;
    exit.is_stopped = true;
    exit.touches.clear();
    exit.backs.clear();
    exit.touches.push_back({found.normal, found.length, at});
    last_blocker_ = at;
    return true;
  }

  // No triangle that is overlapped is left later than it ends along the direction, nor than its plane is.
  void set_bounds(const Vec3& direction, Real lowest) {
    const Columns along = Columns::all(direction);
    const Lanes far = all_lanes(infinity);
    for (OverlappedFour& four : overlapped_.span()) {
      const FourTriangles& t = four.triangles;
      const Lanes ends = maximum(maximum(dot(along, t.a), dot(along, t.b)), dot(along, t.c)) - lowest;
      const Lanes slope = dot(four.normals, along);
      const Lanes of_plane = slope > all_lanes(1e-9)    ? four.behind / slope
                             : slope < all_lanes(-1e-9) ? four.before / -slope
                                                        : far;
      four.bounds = minimum(ends, of_plane);
      for (std::size_t lane = four.count; lane < 4; ++lane) {
        four.bounds[lane] = -infinity;
      }
    }
  }

  // What touches within a tie of the end of a way counts as touched, what is last comes first. It is left through its
  // back only if it is last.
  void settle(Exit& exit) const {
    const auto touches = exit.touches;
    exit.touches.clear();
    for (const SurfaceTouch& touch : touches.span()) {
      exit.touches.push_back_if(touch, touch.length >= exit.length - tie());
    }
    std::ranges::sort(exit.touches.span(), [this](const SurfaceTouch& a, const SurfaceTouch& b) {
      return a.length != b.length ? a.length > b.length : number_at(a.at) < number_at(b.at);
    });
    const auto backs = exit.backs;
    exit.backs.clear();
    for (const Back& back : backs.span()) {
      exit.backs.push_back_if(back, back.length >= exit.length - 4 * tolerance_);
    }
  }

  [[nodiscard]] bool is_one_sided(const NearPlace& at) const {
    return (fours_[at.four].one_sided >> at.lane & 1u) != 0;
  }
  // Takes what is left at a length into account.
  void note(const NearPlace& at, const Leaving& found, const Vec3& direction, Exit& exit) {
    const Real tie = this->tie();
    if (found.length < exit.length - tie) {
      return;
    }
    if (found.length > exit.length + tie) {
      exit.touches.clear();
      exit.backs.clear();
    }
    bool is_known = false;
    for (SurfaceTouch& touch : exit.touches.span()) {
      if (dot(touch.normal, found.normal) > 1 - 1e-9) {
        touch = found.length > touch.length ? SurfaceTouch{found.normal, found.length, at} : touch;
        is_known = true;
      }
    }
    if (!is_known && exit.touches.size() < 8) {
      exit.touches.push_back({found.normal, found.length, at});
    }
    if (is_one_sided(at)) {
      const Vec3 normal = find_planes(at.four).normals[at.lane];
      if (dot(normal, direction) < -1e-9) {
        exit.backs.push_back({normal, found.length});
      }
    }
    exit.length = std::max(exit.length, found.length);
  }

  // Leaves what is overlapped at the start, what may be left last first. False where that is no nearer than `enough`.
  [[nodiscard]] bool leave_overlapped(const Vec3& direction, Real enough, Exit& exit) {
    for (;;) {
      Real top = exit.length + tolerance_ - tie();
      OverlappedFour* last = nullptr;
      std::size_t last_lane = 0;
      for (OverlappedFour& four : overlapped_.span()) {
        if (bits_of(four.bounds > all_lanes(top)) != 0) {
          for (std::size_t lane = 0; lane < 4; ++lane) {
            if (four.bounds[lane] > top) {
              top = four.bounds[lane];
              last = &four;
              last_lane = lane;
            }
          }
        }
      }
      if (last == nullptr) {
        return true;
      }
      if constexpr (leaves_in_fours<B>) {
        if (takes_closed_forms(settings_.algorithm)) {
          if (!leave_four(*last, direction, enough, exit)) {
            return false;
          }
          continue;
        }
      }
      last->bounds[last_lane] = -infinity;
      const NearPlace& at = last->places[last_lane];
      const Leaving found =
          leave_one(at, direction, {.bound = top, .least = exit.length - 2 * tie(), .enough = enough});
      if (found.length > 0) {
        if (found.length >= enough - tolerance_) {
          static_cast<void>(stop(at, found, exit));
          return false;
        }
        note(at, found, direction, exit);
      }
    }
  }
  // All of four at once that are overlapped at the start.
  [[nodiscard]] bool leave_four(OverlappedFour& four, const Vec3& direction, Real enough, Exit& exit) {
    const FourStretches found = stretches_of(four, b_, ab_, direction);
    const Lanes ends = four.bounds > all_lanes(-infinity) ? found.end : four.bounds;
    const Real last = std::max(exit.length, std::max(std::max(ends[0], ends[1]), std::max(ends[2], ends[3])));
    std::uint64_t left = bits_of((ends > all_lanes(0)) & (ends >= all_lanes(last - tie())));
    four.bounds = all_lanes(-infinity);
    for (; left != 0; left &= left - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(left));
      const Leaving one = leaving_of(four, lane, four.places[lane], found, direction);
      if (one.length >= enough - tolerance_) {
        static_cast<void>(stop(four.places[lane], one, exit));
        return false;
      }
      note(four.places[lane], one, direction, exit);
    }
    return true;
  }

  // Leaves what is not overlapped at the start, but after the translation so far. False as above.
  [[nodiscard]] bool leave_those_ahead(const Vec3& direction, Real lowest, Real enough, Exit& exit) {
    const Real begin = exit.length;
    const Pose at{ab_.rotation, ab_.position + begin * direction};
    const Aabb box = b_.aabb(at);
    this->cover(box);
    const QuickAxes<B> axes(b_, at);
    SmallVector<NearPlace, 128> ahead;
    const Columns along = Columns::all(direction);
    const Lanes least = all_lanes(lowest + exit.length + 2 * tolerance_);
    for (std::uint32_t i = 0; i < fours_.size(); ++i) {
      const NearFour& four = fours_[i];
      const FourTriangles& t = four.triangles;
      const Lanes reach = maximum(maximum(dot(along, t.a), dot(along, t.b)), dot(along, t.c));
      std::uint64_t left = four.present & ~four.overlapped & bits_of(reach > least);
      left = left == 0 ? 0 : left & t.overlapping(box);
      left = left == 0 ? 0 : left & axes.near(t, b_.radius());
      if constexpr (leaves_in_fours<B>) {
        if (left != 0 && takes_closed_forms(settings_.algorithm)) {
          const FourStretches found = stretches_of(find_planes(i), b_, ab_, direction);
          left &= bits_of((found.begin < all_lanes(exit.length)) & (found.end > all_lanes(exit.length + tolerance_)));
        }
      }
      for (; left != 0; left &= left - 1) {
        ahead.push_back({i, static_cast<std::uint32_t>(std::countr_zero(left))});
      }
    }
    this->sort_by_number(ahead.span());
    for (const NearPlace& place : ahead.span()) {
      const Real bound = reach_of(fours_[place.four], place.lane, direction) - lowest;
      if (!(bound > exit.length + 2 * tolerance_) || !is_overlapped_at(place, at)) {
        continue;
      }
      const Leaving found = leave_one(
          place, direction, {.bound = bound, .inside = begin, .least = exit.length - 2 * tie(), .enough = enough});
      if (found.length > exit.length + tolerance_) {
        if (found.length >= enough - tolerance_) {
          static_cast<void>(stop(place, found, exit));
          return false;
        }
        note(place, found, direction, exit);
      }
    }
    return true;
  }
  // Whether the triangle counts as overlapped there, by more than what ends a search.
  [[nodiscard]] bool is_overlapped_at(const NearPlace& place, const Pose& at) const {
    const Triangle triangle = triangle_at(place);
    const CoreSeparation core = begin_separation(triangle, b_, at, settings_, b_.radius()).core;
    return !core.beyond && core.distance - b_.radius() < -2 * tolerance_ &&
           (Fronts<B>(triangle, b_, at).allows(core.normal) || counts_from_behind(triangle, b_, at, core));
  }

  // Along a direction, then along the shortest translation that leaves all planes touched so far. Goes no further along
  // one than the best so far times `most`.
  void improve(Vec3 direction, Real most) {
    constexpr int most_steps = 8;
    constexpr std::size_t most_planes = 7;
    SmallVector<HalfSpaceToLeave, most_planes> planes;
    for (int step = 0; step < most_steps; ++step) {
      const Exit exit = exit_along(direction, best_.length < infinity ? best_.length * most : infinity);
      const bool is_allowed = exit.backs.empty() || allows_back_;
      if (!exit.is_stopped && is_allowed && exit.length < best_.length) {
        best_.length = exit.length;
        best_.direction = direction;
        best_.touches = exit.touches;
        if (is_settled()) {
          return;
        }
      }
      if (exit.touches.empty() || (exit.is_stopped && most > 1.01)) {
        return;
      }
      // A front is left along its plane at best.
      for (const Back& back : exit.backs.span()) {
        if (!allows_back_) {
          add_plane({back.normal, 0}, planes);
        }
      }
      constexpr std::size_t most_touches = 3;
      for (const SurfaceTouch& touch : exit.touches.span().first(std::min(most_touches, exit.touches.size()))) {
        add_plane({touch.normal, dot(touch.normal, direction) * touch.length}, planes);
      }
      const auto move = least_translation(planes.span());
      if (!move || !(norm(*move) < best_.length - tolerance_)) {
        return;
      }
      const auto next = UnitVec3::make(*move);
      if (!next || dot(*next, direction) > 1 - 1e-14) {
        return;
      }
      direction = *next;
    }
  }
  void try_starts() {
    constexpr std::size_t most_of_many = 8;
    SearchStarts starts;
    const bool are_few = add_planes(overlapped_.span(), allows_back_, starts);
    if (!are_few) {
      starts.clear();
      add_mean_normals(overlapped_.span(), size_, allows_back_, starts);
    }
    add_own_directions(b_, ab_, are_few, starts);
    try_all(starts, are_few ? starts.size() : most_of_many);
    // Where triangles pass through each other, or stand alone, planes tell little.
    // A triangle may slide out along itself.
    constexpr Real far = leaves_by_axes<B> && !is_box<B> ? 1 : 1.25;
    if (best_.length > far * least_ + tolerance_ && !are_ground(overlapped_.span(), best_.direction)) {
      starts.clear();
      add_single_ways(starts);
      try_all(starts, starts.size());
      try_even_directions();
      try_around_best();
    }
  }
  void try_all(SearchStarts& starts, std::size_t most) {
    std::ranges::sort(starts.span(), [](const SearchStart& a, const SearchStart& b) {
      const auto key = [](const SearchStart& s) {
        return std::tuple(s.estimate, s.direction.x, s.direction.y, s.direction.z);
      };
      return key(a) < key(b);
    });
    for (const SearchStart& start : starts.span().first(std::min(most, starts.size()))) {
      if (is_settled()) {
        return;
      }
      improve(start.direction, 2);
    }
  }
  // The ways out of single triangles, deeper ones first.
  void add_single_ways(SearchStarts& starts) {
    constexpr std::size_t most_ways = 16;
    for (const NearTriangle& near : near_.span()) {
      if (near.is_overlapped && starts.size() < most_ways) {
        add_start(near.found.core.normal, near.gap, starts);
      }
    }
  }
  // Points of a spiral around the sphere, about evenly spread.
  void try_even_directions() {
    constexpr int count = 128;
    constexpr Real golden_cosine = -0.7373688780783197, golden_sine = 0.6754902942615238;  // of the golden angle
    Real cosine = 1, sine = 0;
    for (int i = 0; i < count && !is_settled(); ++i) {
      const Real z = 1 - (2 * i + 1) / Real(count), across = std::sqrt(1 - z * z);
      improve({across * cosine, across * sine, z}, 1.5);
      const Real next = golden_cosine * cosine - golden_sine * sine;
      sine = golden_sine * cosine + golden_cosine * sine;
      cosine = next;
    }
  }

  // Beside the best direction so far, nearer and nearer to it, until the planes that are touched hold it.
  void try_around_best() {
    constexpr Real first = 0.2, near = 0.02, last = 1e-8;
    for (Real aside = first; aside > (is_held() ? near : last) && best_.length < infinity && !is_settled();) {
      const Real before = best_.length;
      const Vec3 direction = best_.direction;
      for (const Vec3& axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
        for (const Real step : {-aside, aside}) {
          improve(UnitVec3::make(direction + step * axis).value_or(UnitVec3::from_unit_unchecked(direction)), 1.5);
        }
      }
      aside = best_.length < before * (1 - 1e-6) ? aside : 0.5 * aside;
    }
  }
  // Whether no shorter translation leaves the planes that are touched after the best one.
  [[nodiscard]] bool is_held() const {
    SmallVector<HalfSpaceToLeave, 8> planes;
    for (const SurfaceTouch& touch : best_.touches.span()) {
      planes.push_back({touch.normal, dot(touch.normal, best_.direction) * touch.length});
    }
    const auto move = least_translation(planes.span());
    return move && norm(*move) >= best_.length * (1 - 1e-9);
  }

  bool allows_back_ = false;
  std::optional<NearPlace> last_blocker_;
  SeparatingTranslation best_;
};

}  // namespace abut
