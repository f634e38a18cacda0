// SPDX-License-Identifier: Apache-2.0
// The shortest translation found after which a convex shape overlaps nothing of a surface: the ways that it may go.
export module abut.narrow.surface.separating_translation;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.math.four_vec3;
import abut.math.tolerance;
import abut.narrow.convex;
import abut.narrow.ways.leaving;
import abut.narrow.ways.leaving_four;
export import abut.narrow.surface.near_triangles;
import abut.narrow.triangle.quick_axes;
import abut.narrow.parts.places_of_body;
export import abut.narrow.ways.translation_search;
import abut.narrow.triangle.triangle_contacts;
import abut.narrow.surface.triangle_source;

export namespace abut {

template <Convex B>
class SurfaceSearch : public NearTriangles<B>, public Obstacles {
 public:
  using Near = NearTriangles<B>;
  using Near::Near;
  using Near::find_planes, Near::number_at, Near::triangle_at;

  // Whether the shape overlaps a triangle, or is in a solid.
  [[nodiscard]] bool is_met() const { return this->is_overlapped() || place_inside({0, 0, 0}).has_value(); }

  // To be called where it is.
  [[nodiscard]] SeparatingTranslation find() {
    if constexpr (PointCored<B>) {
      if (b_.radius() == 0 && !this->is_overlapped()) {
        return way_of_point();
      }
    }
    return find_translation(*this, begin());
  }
  // What is known before the search.
  [[nodiscard]] TranslationSearch begin() {
    if (place_inside({0, 0, 0})) {
      begin_inside();
    }
    // A triangle may slide out along itself.
    constexpr Real far = leaves_by_axes<B> && !is_box<B> ? 1 : 1.25;
    constexpr Real of_start = 2;
    // Curved shapes come nearer step by step.
    constexpr int most_polishes = Curved<B> ? 24 : 3;
    constexpr int most_around = 128;
    // A first way that leads down into a solid may be long: others are tried before it.
    constexpr Real of_first = 4;
    const Real first = sides_ == StoppingSides::solid ? of_first * (size_ + least_) : infinity;
    return {size_, tolerance_, least_, deepest_way_, infinity, first, of_start, far, most_around, true, most_polishes};
  }
  [[nodiscard]] SurfaceExit exit_along(const Vec3& direction, Real enough) override {
    return exit_along(direction, 0, enough);
  }
  // No earlier than at `from`.
  [[nodiscard]] SurfaceExit exit_along(const Vec3& direction, Real from, Real enough) {
    SurfaceExit exit;
    exit.length = from;
    const Real lowest = lowest_point_along(b_, ab_, direction);
    if (is_blocked_again(direction, lowest, enough, exit)) {
      return exit;
    }
    set_bounds(direction, lowest);
    // Each round passes something; so many only where rounding leads on and on.
    constexpr int most_rounds = 4096;
    bool has_end = false;
    for (int round = 0; round < most_rounds && !has_end; ++round) {
      if (!leave_overlapped(direction, enough, exit)) {
        return exit;
      }
      const Real before = exit.length;
      if (!leave_those_ahead(direction, lowest, enough, exit)) {
        return exit;
      }
      has_end = !(exit.length > before) && !leave_inside(direction, enough, exit);
      if (exit.is_stopped) {
        return exit;
      }
    }
    if (!has_end) {
      exit.stop({direction, infinity, {}});
      exit.touches.clear();
      return exit;
    }
    exit.settle(tie(), 4 * tolerance_);
    if (!exit.touches.empty()) {
      last_blocker_ = exit.touches[0].at;
    }
    return exit;
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
    if (std::fabs(dot(touch.normal, triangle.normal())) < one_direction) {
      const Pose after{ab_.rotation, ab_.position + move};
      CoreSeparation core = separate_outside(triangle, b, after, settings_);
      find_points(triangle, b, after, core);
      last = core.point_b - move;
    }
    return last - b.radius() * touch.normal;
  }

 private:
  using Near::ab_, Near::b_, Near::deepest_way_, Near::fours_, Near::least_, Near::near_;
  using Near::overlapped_, Near::settings_, Near::sides_, Near::size_, Near::surface_, Near::tolerance_;

  // A place of b in the solid after a move, if there is one: its centre, or a corner of what is thin, which may cross
  // the surface where triangles meet and overlap none of them.
  [[nodiscard]] std::optional<Vec3> place_inside(const Vec3& move) const {
    if (sides_ != StoppingSides::solid) {
      return std::nullopt;
    }
    const Vec3 centre = placed_centre(b_, ab_) + move;
    if (surface_.contains(centre)) {
      return centre;
    }
    const auto corners = corners_of_thin(b_, ab_);
    for (const Vec3& corner : corners.span()) {
      if (const Vec3 place = corner + move; surface_.contains(place)) {
        return place;
      }
    }
    return std::nullopt;
  }
  // A ball in b does not leave before its own way out ends.
  void begin_inside() {
    const BallInside ball = ball_inside(b_);
    const Vec3 middle = ab_ * ball.centre;
    const PointOnSurface nearest = surface_.nearest(middle);
    const Real depth = ball.radius + (surface_.contains(middle) ? nearest.distance : -nearest.distance);
    const auto way = UnitVec3::make(nearest.point - middle);
    if (way && depth >= nearest.distance && depth > least_) {
      least_ = depth;
      deepest_way_ = *way;
    }
  }
  // A point is out as soon as it is on the surface. Behind an edge that bends inward it would be in again.
  [[nodiscard]] SeparatingTranslation way_of_point()
    requires PointCored<B>
  {
    const Vec3 point = placed_centre(b_, ab_);
    const PointOnSurface nearest = surface_.nearest(point);
    const Triangle part = surface_.part(nearest.part);
    const Vec3 outward = part.is_one_sided() ? part.normal() : -part.normal();
    SeparatingTranslation found;
    found.length = found.least = nearest.distance;
    found.direction = nearest.distance > tolerance_ ? (1 / nearest.distance) * (nearest.point - point) : outward;
    if (const auto at = near_place(nearest.part, nearest.point)) {
      found.touches.push_back({found.direction, found.length, *at});
    }
    return found;
  }
  // Points of b that lie deep tell that nothing is shorter: around each there is a ball in b.
  [[nodiscard]] Real least_by(const SeparatingTranslation& translation) override {
    if (sides_ != StoppingSides::solid) {
      return 0;
    }
    const BallInside ball = ball_inside(b_);
    const Vec3 middle = ab_ * ball.centre;
    const Vec3 lowest = placed_support(b_, place(b_, ab_), -translation.direction).point;
    Real least = 0;
    for (const Real share : {1.0, 0.75, 0.5, 0.25}) {
      const Vec3 point = middle + share * (lowest - middle);
      const Real radius = ball.radius + share * (b_.radius() - ball.radius), gap = surface_.nearest(point).distance;
      least = std::max(least, radius + (surface_.contains(point) ? gap : -gap));
    }
    // Where the shape touches in the end, it was deepest before.
    const Vec3 last = last_point(translation, b_);
    return surface_.contains(last) ? std::max(least, surface_.nearest(last).distance) : least;
  }

  [[nodiscard]] Real tie() const { return tie_of(tolerance_, size_); }

  [[nodiscard]] static Real reach_of(const NearFour& four, std::size_t lane, const Vec3& direction) {
    return -least_along(four.triangles[lane], -direction);
  }
  // What stood in the way lately mostly does again.
  [[nodiscard]] bool is_blocked_again(const Vec3& direction, Real lowest, Real enough, SurfaceExit& exit) {
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
    if (!(found.length >= enough - tolerance_)) {
      return false;
    }
    stop(*last_blocker_, found, exit);
    return true;
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
  void stop(const NearPlace& at, const Leaving& found, SurfaceExit& exit) {
    exit.stop({found.normal, found.length, at});
    last_blocker_ = at;
  }

  // No triangle that is overlapped is left later than it ends along the direction, nor than its plane is.
  void set_bounds(const Vec3& direction, Real lowest) {
    const Columns along = Columns::all(direction);
    const Lanes far = all_lanes(infinity);
    for (OverlappedFour& four : overlapped_.span()) {
      const FourTriangles& t = four.triangles;
      const Lanes ends = maximum(maximum(dot(along, t.a), dot(along, t.b)), dot(along, t.c)) - lowest;
      const Lanes slope = dot(four.normals, along);
      const Lanes of_plane = slope > all_lanes(least_plane_slope)    ? four.behind / slope
                             : slope < all_lanes(-least_plane_slope) ? four.before / -slope
                                                                     : far;
      four.bounds = minimum(ends, of_plane);
      for (std::size_t lane = four.count; lane < 4; ++lane) {
        four.bounds[lane] = -infinity;
      }
    }
  }

  void note(const NearPlace& at, const Leaving& found, const Vec3& direction, SurfaceExit& exit) {
    if (!exit.note({found.normal, found.length, at}, tie())) {
      return;
    }
    if (sides_ != StoppingSides::solid && (fours_[at.four].one_sided >> at.lane & 1u) != 0) {
      const Vec3 normal = find_planes(at.four).normals[at.lane];
      if (dot(normal, direction) < -least_plane_slope) {
        exit.backs.push_back({normal, found.length});
      }
    }
  }

  // Leaves what is overlapped at the start, what may be left last first. False where that is no nearer than `enough`.
  [[nodiscard]] bool leave_overlapped(const Vec3& direction, Real enough, SurfaceExit& exit) {
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
          stop(at, found, exit);
          return false;
        }
        note(at, found, direction, exit);
      }
    }
  }
  // All of four at once that are overlapped at the start.
  [[nodiscard]] bool leave_four(OverlappedFour& four, const Vec3& direction, Real enough, SurfaceExit& exit) {
    const FourStretches found = stretches_of(four, b_, ab_, direction);
    const Lanes ends = four.bounds > all_lanes(-infinity) ? found.end : four.bounds;
    const Real last = std::max(exit.length, std::max(std::max(ends[0], ends[1]), std::max(ends[2], ends[3])));
    std::uint64_t left = bits_of((ends > all_lanes(0)) & (ends >= all_lanes(last - tie())));
    four.bounds = all_lanes(-infinity);
    for (; left != 0; left &= left - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(left));
      const Leaving one = leaving_of(four, lane, four.places[lane], found, direction);
      if (one.length >= enough - tolerance_) {
        stop(four.places[lane], one, exit);
        return false;
      }
      note(four.places[lane], one, direction, exit);
    }
    return true;
  }

  // Leaves what is not overlapped at the start, but after the translation so far. False as above.
  [[nodiscard]] bool leave_those_ahead(const Vec3& direction, Real lowest, Real enough, SurfaceExit& exit) {
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
          stop(place, found, exit);
          return false;
        }
        note(place, found, direction, exit);
      }
    }
    return true;
  }
  // On to the surface of a solid, where b is inside and overlaps no triangle. False where it is outside.
  [[nodiscard]] bool leave_inside(const Vec3& direction, Real enough, SurfaceExit& exit) {
    // Not just at the surface: there rounding tells.
    const Real further = exit.length + 2 * tolerance_;
    const std::optional<Vec3> place = place_inside(further * direction);
    if (!place) {
      return false;
    }
    const auto way = surface_.way_to_surface(*place, direction);
    // What is further off is not looked at: the floor of a field may be as far as its border.
    const std::optional<NearPlace> at =
        way && further + way->length < enough ? near_place(way->part, *place + way->length * direction) : std::nullopt;
    if (at) {
      static_cast<void>(exit.note({way->normal, further + way->length, *at}, tie()));
    } else {
      exit.stop({direction, infinity, {}});
      exit.touches.clear();
    }
    return true;
  }
  // Where a triangle that has a point is kept.
  [[nodiscard]] std::optional<NearPlace> near_place(std::uint32_t number, const Vec3& point) {
    // The point is off the triangle by rounding, and a triangle along two axes has a box without width.
    const Aabb its = surface_.part(number).box();
    const Vec3 furthest = maximum(maximum(absolute(its.low), absolute(its.high)), absolute(point));
    this->cover(Aabb{point, point}.inflated(noise_of(largest_magnitude(furthest))));
    for (std::size_t i = 0; i < fours_.size(); ++i) {
      for (std::uint64_t left = fours_[i].present; left != 0; left &= left - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(left));
        if (fours_[i].triangles.numbers[lane] == number) {
          return NearPlace{i, lane};
        }
      }
    }
    return std::nullopt;
  }
  // Whether the triangle counts as overlapped there, by more than what ends a search.
  [[nodiscard]] bool is_overlapped_at(const NearPlace& place, const Pose& at) const {
    const Triangle triangle = triangle_at(place);
    const CoreSeparation core = begin_separation(triangle, b_, at, settings_, b_.radius()).core;
    return !core.beyond && core.distance - b_.radius() < -2 * tolerance_ &&
           ((fours_[place.four].holding >> place.lane & 1u) != 0 || Fronts<B>(triangle, b_, at).allows(core.normal) ||
            counts_from_behind(triangle, b_, at, core));
  }

  void visit_planes(const TakePlane& take) const override {
    for (const OverlappedFour& four : overlapped_.span()) {
      for (std::size_t lane = 0; lane < four.count; ++lane) {
        const TriangleCorners corners = four.triangles[lane];
        const Real area = 0.5 * norm(cross(corners[1] - corners[0], corners[2] - corners[0]));
        // No more than b can reach.
        take({four.normals[lane], four.behind[lane], four.before[lane], std::min(area, size_ * size_),
              (four.one_sided >> lane & 1u) != 0});
      }
    }
  }
  void visit_single_ways(const TakeStart& take) const override {
    for (const NearTriangle& near : near_.span()) {
      if (near.is_overlapped) {
        take(near.found.core.normal, near.gap);
      }
    }
  }
  // Normals of the faces of b, and what is across its axis. They come last.
  void visit_own_directions(bool are_few, std::span<const TranslationStart> starts,
                            const TakeStart& take) const override {
    const Real last = are_few ? 10 * size_ : Real{0};
    if (sides_ == StoppingSides::solid) {
      add_ways_out(take, last);
    }
    if constexpr (leaves_by_axes<B>) {
      for (const Vec3& face : b_.face_normals()) {
        if (squared_norm(face) > 0) {
          take(ab_.rotation * face, last);
          take(-(ab_.rotation * face), last);
        }
      }
      for (const Vec3& edge : b_.edge_directions()) {
        if (const auto along = UnitVec3::make(ab_.rotation * edge)) {
          take(*along, last);
          take(-*along, last);
        }
      }
    } else if constexpr (SegmentCored<B> || Rimmed<B>) {
      constexpr Real least_across = 0.05;
      const Vec3& axis = ab_.rotation.z;
      for (const auto& [direction, estimate] : starts) {
        const Vec3 across = direction - dot(direction, axis) * axis;
        if (norm(across) > least_across) {
          take(*UnitVec3::make(across), are_few ? estimate + size_ : 0.1 * estimate);
        }
      }
      if constexpr (Rimmed<B>) {
        take(axis, last);
        take(-axis, last);
      }
    }
  }

  // Toward the nearest surface from inside, away from it from outside, and along the axes.
  void add_ways_out(const TakeStart& take, Real last) const {
    const Vec3 middle = ab_ * ball_inside(b_).centre, nearest = surface_.nearest(middle).point;
    const Vec3 outward = surface_.contains(middle) ? nearest - middle : middle - nearest;
    if (const auto way = UnitVec3::make(outward)) {
      take(*way, -infinity);
    }
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3 along{axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0};
      take(along, last);
      take(-along, last);
    }
  }

  std::optional<NearPlace> last_blocker_;
};

}  // namespace abut
