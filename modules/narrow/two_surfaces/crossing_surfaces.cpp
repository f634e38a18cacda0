// SPDX-License-Identifier: Apache-2.0
module abut.narrow.two_surfaces.crossing_surfaces;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.math.four_vec3;
import abut.math.tolerance;
import abut.narrow.convex;
import abut.narrow.ways.leaving_four;
import abut.narrow.two_surfaces.leaving_pairs;
import abut.narrow.two_surfaces.placed_triangles;
import abut.narrow.triangle.quick_axes;
import abut.narrow.ways.translation_search;
import abut.narrow.triangle.triangle_contacts;
import abut.narrow.surface.triangle_source;

namespace abut {
namespace {

constexpr Real gather_share = 0.04;  // of the size, around the boxes

// The same one in all lanes.
PlacedFour in_all(const PlacedFour& four, std::size_t lane) {
  [[clang::uninitialized]] PlacedFour all;
  all.triangles = FourTriangles::all(four.triangles[lane]);
  all.triangles.numbers.fill(std::span(four.triangles.numbers)[lane]);
  all.normals = Columns::all(four.normals[lane]);
  all.heights = all_lanes(four.heights[lane]);
  all.present = 15;
  all.one_sided = (four.one_sided >> lane & 1u) != 0 ? 15 : 0;
  return all;
}
void put(PlacedFour& four, std::size_t lane, const PlacedFour& from, std::size_t from_lane) {
  four.triangles.put(lane, FourTriangles::all(from.triangles[from_lane]));
  std::span(four.triangles.numbers)[lane] = std::span(from.triangles.numbers)[from_lane];
  four.normals.put(lane, from.normals[from_lane]);
  four.heights[lane] = from.heights[from_lane];
  const std::uint64_t bit = std::uint64_t{1} << lane;
  four.present |= bit;
  four.one_sided = (four.one_sided & ~bit) | (from.one_sided >> from_lane & 1u) << lane;
}
std::uint64_t bit(std::size_t lane) { return std::uint64_t{1} << lane; }

Lanes highest_along(const FourTriangles& t, const Columns& direction) {
  return maximum(maximum(dot(direction, t.a), dot(direction, t.b)), dot(direction, t.c));
}
Lanes lowest_along(const FourTriangles& t, const Columns& direction) {
  return minimum(minimum(dot(direction, t.a), dot(direction, t.b)), dot(direction, t.c));
}

}  // namespace

bool is_moved_first(const SurfaceSource& a, const SurfaceSource& b, const Pose& ab) {
  const Aabb box_a = a.box(), box_b = b.box();
  const Vec3 &from_a = ab.position, from_b = ab.inverse().position;
  const auto key = [](const Aabb& box, const Vec3& other) {
    return std::tuple(box.low.x, box.low.y, box.low.z, box.high.x, box.high.y, box.high.z, other.x, other.y, other.z);
  };
  return key(box_b, from_b) < key(box_a, from_a);
}

CrossingSurfaces::CrossingSurfaces(const SurfaceSource& a, const SurfaceSource& b, const Pose& ab,
                                   const QuerySettings& settings, Real margin)
    : source_a_(a), source_b_(b), ab_(ab), box_a_(a.box()), box_b_(transformed(b.box(), ab)) {
  const auto half = [](const Aabb& box) { return 0.5 * largest_magnitude(box.high - box.low); };
  size_ = std::min(half(box_a_), half(box_b_));
  gather(std::max(margin, Real{0}) + gather_share * size_);
  const bool are_near = !a_.is_empty() && !b_.is_empty();
  if (!are_near && !(has_solid() && do_boxes_overlap({0, 0, 0}))) {
    return;
  }
  const auto size_of = [](const Aabb& box) {
    return largest_magnitude(maximum(absolute(box.low), absolute(box.high)));
  };
  const Real size = 4 * size_ + 2 * (are_near ? a_.size() + b_.size() : size_of(box_a_) + size_of(box_b_));
  touching_ = noise_of(size);
  tolerance_ = std::max(touching_, 2 * (usual_error * 2 * size_ + touching_));
  if (are_near) {
    look_for_pairs(settings, margin);
    pack_crossing();
  }
  if (has_solid() && !is_overlapped() && do_boxes_overlap({0, 0, 0})) {
    look_inside();
  }
}

Real CrossingSurfaces::tie() const { return tie_of(tolerance_, size_); }

void CrossingSurfaces::gather(Real reach) {
  reach_ = reach;
  const Real around = reach + noise_of(largest_magnitude(ab_.position) + 2 * size_);
  a_.gather(source_a_, Pose::identity(), box_b_.inflated(around));
  b_.gather(source_b_, ab_, a_.is_empty() ? Aabb::empty() : a_.box().inflated(around));
}

void CrossingSurfaces::set_reaches(const Vec3& direction) {
  a_.set_reaches(direction);
  b_.set_reaches(-direction);
}

void CrossingSurfaces::look_for_pairs(const QuerySettings& settings, Real margin) {
  // Within an endless reach there would also be the children that nodes lack.
  const Real reach = std::min(std::max(margin, Real{0}) + touching_, std::numeric_limits<Real>::max());
  set_reaches({0, 0, 0});
  const Real none = 0;
  visit_near(a_, b_, {{0, 0, 0}, none}, reach, [&](const PlacedTriangle& of_a, const PlacedTriangle& of_b) {
    look_at(of_a, of_b, settings, margin);
    return true;
  });
  // The form of the trees does not matter.
  std::ranges::sort(near_.span(), {}, [](const NearPair& pair) { return std::tuple(pair.a.number, pair.b.number); });
  for (const NearPair& pair : near_.span()) {
    if (pair.is_overlapped) {
      ++count_;
      if (-pair.gap > least_) {
        least_ = -pair.gap;
        deepest_way_ = pair.found.core.normal;
      }
    }
  }
}

void CrossingSurfaces::look_at(const PlacedTriangle& of_a, const PlacedTriangle& of_b, const QuerySettings& settings,
                               Real margin) {
  const Triangle a = of_a.part(), b = of_b.part();
  const Pose here = Pose::identity();
  const TriangleSeparation found =
      begin_separation(a, b, here, settings, margin > 0 ? std::max(margin, touching_) : margin);
  const CoreSeparation& core = found.core;
  if (core.beyond || core.distance > std::max(margin, touching_)) {
    return;
  }
  const bool is_overlapped = core.distance < -touching_;
  if (!is_overlapped && !abut::Fronts<Triangle>(a, b, here).allows(core.normal)) {
    return;
  }
  near_.push_back({of_a, of_b, found, core.distance, is_overlapped});
}

void CrossingSurfaces::pack_crossing() {
  std::size_t packed = 0;
  for (const NearPair& pair : near_.span()) {
    if (!pair.is_overlapped) {
      continue;
    }
    const FourTriangles of_a = FourTriangles::all(pair.a.corners), of_b = FourTriangles::all(pair.b.corners);
    const std::size_t lane = packed % 4;
    if (lane == 0) {
      crossing_.push_back({});
    }
    CrossingFour& four = crossing_[crossing_.size() - 1];
    // The last one stands in for those that lack.
    for (std::size_t i = lane; i < 4; ++i) {
      four.a.triangles.put(i, of_a);
      four.b.triangles.put(i, of_b);
      four.a.triangles.numbers[i] = pair.a.number;
      four.b.triangles.numbers[i] = pair.b.number;
    }
    four.a.present = four.b.present = four.a.present | bit(lane);
    four.a.one_sided |= pair.a.is_one_sided ? bit(lane) : 0;
    four.b.one_sided |= pair.b.is_one_sided ? bit(lane) : 0;
    ++packed;
  }
  for (CrossingFour& four : crossing_.span()) {
    PlacedFour &a = four.a, &b = four.b;
    a.set_planes(a.present);
    b.set_planes(b.present);
    four.behind_a = a.heights - lowest_along(b.triangles, a.normals);
    four.before_a = highest_along(b.triangles, a.normals) - a.heights;
    // b moves against its own normal until all of a is in front of it.
    four.behind_b = b.heights - lowest_along(a.triangles, b.normals);
    four.before_b = highest_along(a.triangles, b.normals) - b.heights;
  }
}

SeparatingTranslation CrossingSurfaces::find() {
  // The margin has no say in the search.
  if (const Real usual = gather_share * size_; reach_ != usual) {
    gather(usual);
  }
  // Directions all around are tried where a way along each costs little. Of many triangles the first starts are good.
  constexpr std::size_t few = 1024;  // pairs
  const auto count_of = [](const PlacedTriangles& triangles) {
    std::size_t count = 0;
    for (const PlacedFour& four : triangles.fours()) {
      for (std::uint64_t left = four.present; left != 0; left &= left - 1) {
        ++count;
      }
    }
    return count;
  };
  const bool are_few = count_of(a_) * count_of(b_) <= few;
  return find_translation(*this, {.size = size_,
                                  .tolerance = tolerance_,
                                  .least = least_,
                                  .deepest_way = deepest_way_,
                                  .most = length_until_boxes_part(),
                                  .first = 2 * least_,
                                  .of_start = are_few ? 2 : 1.25,
                                  .far = are_few ? 1.25 : infinity,
                                  .most_around = 48,
                                  .trusts_ground = false,
                                  .most_polishes = 3});
}
Real CrossingSurfaces::length_until_boxes_part() const {
  const Vec3 ahead = box_a_.high - box_b_.low, behind = box_b_.high - box_a_.low, least = minimum(ahead, behind);
  return std::min({least.x, least.y, least.z}) + 4 * tolerance_;
}

SurfaceExit CrossingSurfaces::exit_along(const Vec3& direction, Real enough) {
  SurfaceExit exit;
  if (!leave_blocking(direction, enough, exit)) {
    return exit;
  }
  set_bounds(direction);
  if (!leave_crossing(direction, enough, exit)) {
    return exit;
  }
  // A way that leads from wall to wall for longer is given up, so that no scene is searched without end.
  constexpr int most_walls = 64;
  int walls = 0;
  do {
    if (exit.is_stopped || !leave_those_ahead(direction, enough, exit)) {
      return exit;
    }
    if (++walls > most_walls) {
      exit.stop({direction, infinity, {}});
      return exit;
    }
  } while (leave_inside(direction, enough, exit));
  exit.settle(tie(), 4 * tolerance_);
  // The order of triangles has no say in which of them count.
  std::ranges::sort(exit.touches.span(), {}, [](const SurfaceTouch& touch) {
    return std::tuple(touch.normal.x, touch.normal.y, touch.normal.z);
  });
  return exit;
}

bool CrossingSurfaces::leave_blocking(const Vec3& direction, Real enough, SurfaceExit& exit) const {
  [[clang::uninitialized]] std::array<PairStretches, 2> found;
  const std::size_t fours = std::min((blocking_count_ + 3) / 4, blocking_.size());
  for (std::size_t i = 0; i < fours; ++i) {
    found[i] = stretches_of(blocking_[i].a, blocking_[i].b, {direction, infinity, 0, touching_});
  }
  for (bool is_longer = true; is_longer;) {
    is_longer = false;
    for (std::size_t i = 0; i < fours; ++i) {
      const std::uint64_t met = blocking_[i].a.present & bits_of((found[i].begin < all_lanes(exit.length)) &
                                                                 (found[i].last > all_lanes(exit.length + tolerance_)) &
                                                                 (found[i].end > all_lanes(0)));
      if (met != 0) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(met));
        note(blocking_[i].a, blocking_[i].b, lane, found[i], infinity, direction, exit);
        is_longer = true;
      }
    }
    if (exit.length >= enough - tolerance_) {
      exit.is_stopped = true;
      return false;
    }
  }
  return true;
}

// Many that block are the same for like directions: each is kept once.
void CrossingSurfaces::keep_blocking(const PlacedFour& a, const PlacedFour& b, std::size_t lane) {
  const auto number = [](const PlacedFour& four, std::size_t at) { return std::span(four.triangles.numbers)[at]; };
  const std::size_t most = 4 * blocking_.size();
  for (std::size_t i = 0; i < std::min(blocking_count_, most); ++i) {
    const BlockingFour& four = blocking_[i / 4];
    if (number(four.a, i % 4) == number(a, lane) && number(four.b, i % 4) == number(b, lane)) {
      return;
    }
  }
  const std::size_t place = blocking_count_++ % most;
  put(blocking_[place / 4].a, place % 4, a, lane);
  put(blocking_[place / 4].b, place % 4, b, lane);
}

// No pair is left later than it ends along the direction, nor than one of its planes is.
void CrossingSurfaces::set_bounds(const Vec3& direction) {
  const Columns along = Columns::all(direction);
  const auto until = [](Lanes slope, Lanes behind, Lanes before) {
    return slope > all_lanes(least_plane_slope)    ? behind / slope
           : slope < all_lanes(-least_plane_slope) ? before / -slope
                                                   : all_lanes(infinity);
  };
  for (CrossingFour& four : crossing_.span()) {
    const PlacedFour &a = four.a, &b = four.b;
    const Lanes ends = highest_along(a.triangles, along) - lowest_along(b.triangles, along);
    const Lanes of_a = until(dot(a.normals, along), four.behind_a, four.before_a),
                of_b = until(-dot(b.normals, along), four.behind_b, four.before_b);
    four.bounds = minimum(ends, minimum(of_a, of_b));
    for (std::size_t lane = 0; lane < 4; ++lane) {
      four.bounds[lane] = (a.present & bit(lane)) != 0 ? four.bounds[lane] : -infinity;
    }
  }
}

// What may be left last comes first.
bool CrossingSurfaces::leave_crossing(const Vec3& direction, Real enough, SurfaceExit& exit) {
  for (;;) {
    Real top = exit.length + tolerance_ - tie();
    std::optional<std::size_t> last;
    for (std::size_t i = 0; i < crossing_.size(); ++i) {
      if (const Real bound = largest(crossing_[i].bounds); bound > top) {
        top = bound;
        last = i;
      }
    }
    if (!last) {
      return true;
    }
    CrossingFour& four = crossing_[*last];
    const Real least = std::max(exit.length - tie(), Real{0});
    const PairStretches found = stretches_of(four.a, four.b, {direction, infinity, least, touching_});
    std::uint64_t left =
        four.a.present & bits_of(four.bounds > all_lanes(-infinity)) & bits_of(found.end > all_lanes(least));
    four.bounds = all_lanes(-infinity);
    for (; left != 0; left &= left - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(left));
      const bool is_longer = found.end[lane] > exit.length;
      note(four.a, four.b, lane, found, infinity, direction, exit);
      if (is_longer && exit.length >= enough - tolerance_) {
        keep_blocking(four.a, four.b, lane);
        exit.is_stopped = true;
        return false;
      }
    }
  }
}

template <class Take>
void CrossingSurfaces::visit_ahead(const Vec3& direction, const Real& length, const Take& take) {
  bool goes_on = true;
  const Real slack = tie() + touching_;
  Vec3 move = length * direction;
  visit_fours(a_, b_, {direction, length}, slack, [&](std::size_t of_a, std::size_t of_b) {
    const PlacedFour &four_a = a_.fours()[of_a], &four_b = b_.fours()[of_b];
    const Lanes reach_a = a_.reaches(0, of_a), reach_b = b_.reaches(0, of_b);
    for (std::uint64_t left = goes_on ? four_a.present : 0; left != 0; left &= left - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(left));
      std::uint64_t near = four_b.present & bits_of(reach_a[lane] + reach_b > all_lanes(length - slack));
      if (near == 0) {
        continue;
      }
      const Aabb at = a_.children(0, of_a)[lane];
      near &= b_.children(0, of_b).overlapping(Aabb{at.low - move, at.high - move}.inflated(slack));
      if (near == 0) {
        continue;
      }
      const PlacedFour one = in_all(four_a, lane);
      const PairStretches found = stretches_of(one, four_b, {direction, length, length - tie(), touching_});
      const std::uint64_t met = near & bits_of(found.end > all_lanes(-infinity));
      if (met != 0) {
        goes_on = take(one, four_b, found, met);
        move = length * direction;
        if (!goes_on) {
          return;
        }
      }
    }
  });
}

bool CrossingSurfaces::leave_those_ahead(const Vec3& direction, Real enough, SurfaceExit& exit) {
  set_reaches(direction);
  for (bool is_longer = true; is_longer;) {
    if (const Real far = largest_magnitude(exit.length * direction); far > reach_) {
      gather(1.5 * far);
      set_reaches(direction);
    }
    is_longer = false;
    visit_ahead(direction, exit.length,
                [&](const PlacedFour& a, const PlacedFour& b, const PairStretches& found, std::uint64_t met) {
                  for (; met != 0; met &= met - 1) {
                    const auto lane = static_cast<std::size_t>(std::countr_zero(met));
                    // What overlaps by no more than a touch is no obstacle, however long that lasts.
                    const bool is_obstacle = found.last[lane] > exit.length + tolerance_;
                    is_longer = is_longer || is_obstacle;
                    // Of those that end together the last one tells where, in any order.
                    const bool counts = is_obstacle || found.end[lane] <= exit.length + tolerance_;
                    note(a, b, lane, found, counts ? infinity : exit.length, direction, exit);
                    if (is_obstacle) {
                      keep_blocking(a, b, lane);
                    }
                    if (exit.length >= enough - tolerance_) {
                      exit.is_stopped = true;
                      return false;
                    }
                  }
                  return true;
                });
    if (exit.is_stopped) {
      return false;
    }
  }
  return true;
}

void CrossingSurfaces::note(const PlacedFour& a, const PlacedFour& b, std::size_t lane, const PairStretches& found,
                            Real most, const Vec3& direction, SurfaceExit& exit) const {
  constexpr Real least_against = 1e-9;
  const Real length = std::min(found.end[lane], most);
  if (length < exit.length - tie() ||
      !exit.note({normal_at_end(a, b, lane, direction, found.axis[lane]), length, {}}, tie())) {
    return;
  }
  // A few fronts tell enough: those that are left last.
  constexpr std::size_t most_backs = 4;
  const auto pass = [&](const Vec3& front, std::uint64_t one_sided) {
    if ((one_sided >> lane & 1u) == 0 || !(dot(front, direction) < -least_against)) {
      return;
    }
    if (exit.backs.size() < most_backs) {
      exit.backs.push_back({front, length});
      return;
    }
    auto& first = *std::ranges::min_element(exit.backs.span(), {}, &SurfaceExit::Back::length);
    if (length > first.length) {
      first = {front, length};
    }
  };
  if (source_a_.sides() == StoppingSides::front) {
    pass(a.normals[lane], a.one_sided);
  }
  if (source_b_.sides() == StoppingSides::front) {
    pass(-b.normals[lane], b.one_sided);
  }
}

void CrossingSurfaces::visit_touched(const SeparatingTranslation& translation, const TakeTouched& take) {
  const Vec3& direction = translation.direction;
  if (const Real far = largest_magnitude(translation.length * direction); far > reach_) {
    gather(far);
  }
  set_reaches(direction);
  bool are_crossed = false;
  visit_ahead(direction, translation.length,
              [&](const PlacedFour& a, const PlacedFour& b, const PairStretches& found, std::uint64_t met) {
                are_crossed = true;
                for (; met != 0; met &= met - 1) {
                  const auto lane = static_cast<std::size_t>(std::countr_zero(met));
                  take({placed_triangle(a, lane), placed_triangle(b, lane),
                        normal_at_end(a, b, lane, direction, found.axis[lane]), found.end[lane]});
                }
                return true;
              });
  if (!are_crossed) {
    visit_faces_met(translation, take);
  }
}
std::optional<TouchedPair> CrossingSurfaces::last_pair(const SeparatingTranslation& translation) {
  std::optional<TouchedPair> last;
  const auto key = [](const TouchedPair& pair) { return std::tuple(-pair.length, pair.a.number, pair.b.number); };
  visit_touched(translation, [&](const TouchedPair& pair) {
    if (!last || key(pair) < key(*last)) {
      last = pair;
    }
  });
  return last;
}
// Each triangle once: what it overlaps lies together.
void CrossingSurfaces::visit_planes(const TakePlane& take) const {
  struct Seen {
    std::uint32_t number;
    NearPlace at;
  };
  const auto visit = [&](bool is_of_b) {
    SmallVector<Seen, 64> seen;
    for (std::size_t i = 0; i < crossing_.size(); ++i) {
      const FourFaces& faces = is_of_b ? crossing_[i].b : crossing_[i].a;
      for (std::uint64_t left = crossing_[i].a.present; left != 0; left &= left - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(left));
        seen.push_back({std::span(faces.triangles.numbers)[lane], {i, lane}});
      }
    }
    std::ranges::sort(seen.span(), {},
                      [](const Seen& one) { return std::tuple(one.number, one.at.four, one.at.lane); });
    for (std::size_t first = 0, next = 0; first < seen.size(); first = next) {
      Real behind = 0, before = 0;
      for (; next < seen.size() && seen[next].number == seen[first].number; ++next) {
        const auto& [four, lane] = seen[next].at;
        const CrossingFour& its = crossing_[four];
        behind = std::max(behind, (is_of_b ? its.behind_b : its.behind_a)[lane]);
        before = std::max(before, (is_of_b ? its.before_b : its.before_a)[lane]);
      }
      const auto& [four, lane] = seen[first].at;
      const PlacedFour& faces = is_of_b ? crossing_[four].b : crossing_[four].a;
      const TriangleCorners corners = faces.triangles[lane];
      const Real area = 0.5 * norm(cross(corners[1] - corners[0], corners[2] - corners[0]));
      const Vec3 normal = faces.normals[lane];
      take({is_of_b ? -normal : normal, behind, before, std::min(area, size_ * size_),
            (faces.one_sided >> lane & 1u) != 0});
    }
  };
  visit(false);
  visit(true);
}
// Ways out of pairs that are deeper come first.
void CrossingSurfaces::visit_single_ways(const TakeStart& take) const {
  for (const NearPair& pair : near_.span()) {
    if (pair.is_overlapped) {
      take(pair.found.core.normal, pair.gap);
    }
  }
}
// Out of all that crosses together: of closed surfaces that leads away from the middle of what they share. It comes
// first.
void CrossingSurfaces::visit_own_directions(bool, std::span<const TranslationStart>, const TakeStart& take) const {
  if (has_solid()) {
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3 along{axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0};
      take(along, box_a_.high[axis] - box_b_.low[axis]);
      take(-along, box_b_.high[axis] - box_a_.low[axis]);
    }
  }
  Vec3 sum{0, 0, 0};
  visit_planes([&](const OverlappedPlane& plane) { sum += plane.area * plane.normal; });
  if (const auto outward = UnitVec3::make(sum)) {
    take(*outward, -infinity);
  }
}

}  // namespace abut
