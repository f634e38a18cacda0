// SPDX-License-Identifier: Apache-2.0
module abut.detect.continuous.sweeps;
import abut.broadphase.kept.pair_order;
import abut.broadphase;
import abut.capability;
import abut.core.standard;
import abut.core.workers;
import abut.detect.pairs.refresh;
import abut.detect.paths;
import abut.math;
import abut.pairs.taken_apart.convex_part;
import abut.pairs.any_shape;
import abut.scene;
import abut.scene.state.options;
import abut.scene.state.places;
import abut.scene.state.space;

namespace abut {
namespace {

// Below this many movers a task costs more than it saves.
constexpr std::size_t least_of_task = 8;
// Paths are asked about in pieces of some sizes of the shape, which are halved until they are nearly as short as it.
constexpr Real sizes_of_piece = 4, most_pieces = 16, sizes_of_last = 2;
constexpr int most_halvings = 12;

Real largest_side(const Aabb& box) { return largest_magnitude(box.high - box.low); }

bool may_pair(const PlaceInfo& a, const PlaceInfo& b) { return a.part != b.part && (a.is_dynamic || b.is_dynamic); }

Aabb widened(const CompactAabb& box, const Vec3& origin) {
  const auto widen = [&](const std::array<float, 3>& side) {
    return origin + Vec3{static_cast<Real>(side[0]), static_cast<Real>(side[1]), static_cast<Real>(side[2])};
  };
  return {widen(box.low), widen(box.high)};
}

CompactAabb inflated(const CompactAabb& box, Real by) {
  return by == 0 ? box : compact(widened(box, {0, 0, 0}).inflated(by), {0, 0, 0});
}

// Most are in order already, since little changes from step to step.
void sort_again(std::vector<std::pair<float, std::uint32_t>>& sides) {
  constexpr std::size_t most_moves = 8;
  std::size_t moves = 0;
  for (std::size_t i = 1; i < sides.size(); ++i) {
    const std::pair<float, std::uint32_t> its = sides[i];
    std::size_t at = i;
    for (; at > 0 && its < sides[at - 1]; --at) {
      sides[at] = sides[at - 1];
    }
    sides[at] = its;
    moves += i - at;
    if (moves > most_moves * sides.size()) {
      std::ranges::sort(sides);
      return;
    }
  }
}

// Of what a mover meets in a span of time.
template <class Mover>
Aabb box_within(const Mover& its, const TimeSpan& span, const Places& places) {
  const AnyShape& shape = *places.shapes[its.place];
  const Aabb begin = aabb_of(shape, its.path.at(span.begin)), end = aabb_of(shape, its.path.at(span.end));
  return its.path.swept_box(begin, end, span, its.radius).inflated(its.margin);
}

}  // namespace

void Sweeps::add_mover(const Paths& paths, const BoxFrame& frame, std::uint32_t place, const Places& places) {
  const AnyShape& shape = *places.shapes[place];
  const PlaceInfo& info = places.infos[place];
  const Path path = paths.of(place);
  const Pose end = path.at(1);
  const auto part = ConvexPart::of(shape);
  const Aabb own = aabb_of(shape, Pose::identity()), at_start = aabb_of(shape, path.start());
  const Real margin = reach_of(info, frame.mode, frame.largest_tolerance), radius = path.radius_of(own);
  movers_.push_back({.place = place,
                     .has_sweeping = info.sweeping != Sweeping::none,
                     .path = path,
                     .end = end,
                     .margin = margin,
                     .part = part,
                     .own = own,
                     .reach = path.reach_of(own.inflated(part ? -part->radius() : 0)),
                     .radius = radius,
                     .size = largest_side(at_start),
                     .box = path.swept_box(at_start, aabb_of(shape, end), path.whole(), radius).inflated(margin)});
  mover_at_[place] = static_cast<std::uint32_t>(movers_.size()) - 1;
}

// First those with a sweeping, then the quick ones: those that get further than the mean size of the former. So no
// quick one makes the others ask far around.
void Sweeps::find_candidates(const Paths& paths, const BoxFrame& frame, const Space& space,
                             std::span<const std::uint32_t> swept_places, Places& places) {
  candidates_.clear();
  is_candidate_.assign(places.infos.size(), false);
  const auto way_of = [&](std::uint32_t at) { return paths.farthest(at, widened(places.boxes[at], frame.origin)); };
  const auto add = [&](std::uint32_t at, Real way, bool has_sweeping) {
    candidates_.push_back({at, has_sweeping, false, inflated(places.boxes[at], way)});
    is_candidate_[at] = true;
  };
  Real size = 0;
  for (const std::uint32_t at : swept_places) {
    if (space.is_shown(at)) {
      places.note(at, happened_on_path);
      add(at, way_of(at), true);
      size += largest_side(widened(places.boxes[at], frame.origin));
    }
  }
  swept_ = candidates_.size();
  slow_way_ = 0;
  has_others_ = false;
  const Real most = swept_ == 0 ? 0 : size / static_cast<Real>(swept_);
  for (std::uint32_t at = 0; swept_ > 0 && at < places.infos.size(); ++at) {
    if (is_candidate_[at] || !space.is_shown(at)) {
      continue;
    }
    has_others_ = true;
    if (paths.is_still(at)) {
      continue;
    }
    const Real way = way_of(at);
    if (way <= most) {
      slow_way_ = std::max(slow_way_, way);
    } else {
      add(at, way, false);
    }
  }
}

void Sweeps::pair_candidates(const Places& places) {
  side_boxes_.clear();
  coarse_pairs_.clear();
  if (by_side_.size() != candidates_.size()) {
    by_side_.clear();
    for (std::uint32_t number = 0; number < candidates_.size(); ++number) {
      by_side_.emplace_back(0, number);
    }
  }
  for (auto& [low, number] : by_side_) {
    low = candidates_[number].box.low[0];
  }
  sort_again(by_side_);
  for (const auto& [low, number] : by_side_) {
    side_boxes_.push_back(candidates_[number].box);
  }
  for (std::size_t i = 0; i < by_side_.size(); ++i) {
    const CompactAabb box = side_boxes_[i];
    for (std::size_t j = i + 1; j < by_side_.size() && side_boxes_[j].low[0] <= box.high[0]; ++j) {
      if (!box.overlaps(side_boxes_[j])) {
        continue;
      }
      Candidate &a = candidates_[by_side_[i].second], &b = candidates_[by_side_[j].second];
      if ((a.has_sweeping || b.has_sweeping) && may_pair(places.infos[a.place], places.infos[b.place])) {
        a.is_mover = b.is_mover = true;
        coarse_pairs_.push_back({a.place, b.place});
      }
    }
  }
}

// Those that may meet another candidate, or what is slow.
void Sweeps::find_movers(const Workers& workers, const Paths& paths, const BoxFrame& frame, const Space& space,
                         const Places& places) {
  movers_.clear();
  mover_at_.assign(places.infos.size(), no_index);
  const Cuts cuts = workers.cut(swept_, least_of_task);
  workers.for_each(has_others_ ? cuts.tasks() : 0, [&](std::size_t number) {
    for (std::size_t i = cuts.begin(number); i < cuts.end(number); ++i) {
      Candidate& its = candidates_[i];
      if (!its.is_mover) {
        const PlaceInfo& info = places.infos[its.place];
        space.visit(inflated(its.box, slow_way_), [&](std::uint32_t met) {
          its.is_mover = its.is_mover || (!is_candidate_[met] && may_pair(info, places.infos[met]));
        });
      }
    }
  });
  for (const Candidate& its : candidates_) {
    if (its.is_mover) {
      add_mover(paths, frame, its.place, places);
    }
  }
}

void Sweeps::halve(std::uint32_t number, const TimeSpan& span, std::size_t first, int depth, const BoxFrame& frame,
                   const Places& places, Task& task) const {
  const Mover& its = movers_[number];
  const std::size_t end = task.near.size();
  for (int half = 0; half < 2 && depth > 0 && end > first; ++half) {
    const Real middle = 0.5 * (span.begin + span.end);
    const TimeSpan part = half == 0 ? TimeSpan{span.begin, middle} : TimeSpan{middle, span.end};
    const Aabb box = box_within(its, part, places);
    const CompactAabb compact_box = compact(box, frame.origin);
    for (std::size_t i = first; i < end; ++i) {
      const Near met = task.near[i];
      if (task.seen_by[met.place] != number && compact_box.overlaps(met.box)) {
        task.near.push_back(met);
      }
    }
    const bool is_last = largest_side(box) <= sizes_of_last * its.size;
    halve(number, part, end, is_last ? 0 : depth - 1, frame, places, task);
    task.near.resize(end);
  }
  for (std::size_t i = first; i < end && depth == 0; ++i) {
    const std::uint32_t met = task.near[i].place;
    if (std::exchange(task.seen_by[met], number) != number) {
      task.pairs.push_back({std::min(its.place, met), std::max(its.place, met)});
    }
  }
}

// Those that are no candidates.
void Sweeps::meet_slow(std::uint32_t number, const Paths& paths, const BoxFrame& frame, const Space& space,
                       const Places& places, Task& task) const {
  const Mover& its = movers_[number];
  const PlaceInfo& info = places.infos[its.place];
  const Real way = its.path.largest_speed(its.path.whole(), 0);
  const Real wanted = its.size > 0 && its.size < infinity ? std::ceil(way / (sizes_of_piece * its.size)) : 1;
  const Real pieces = std::clamp(wanted, 1., most_pieces);
  for (Real piece = 0; piece < pieces; ++piece) {
    const TimeSpan span{piece / pieces, (piece + 1) / pieces};
    const Aabb exact = pieces == 1 ? its.box : box_within(its, span, places);
    const CompactAabb box = compact(exact, frame.origin);
    task.near.clear();
    space.visit(inflated(box, slow_way_), [&](std::uint32_t met) {
      if (is_candidate_[met] || task.seen_by[met] == number || !may_pair(info, places.infos[met])) {
        return;
      }
      const CompactAabb& there = places.boxes[met];
      const Near near{met, inflated(there, paths.farthest(met, widened(there, frame.origin)))};
      if (box.overlaps(near.box)) {
        task.near.push_back(near);
      }
    });
    const bool is_last = largest_side(exact) <= sizes_of_last * its.size;
    halve(number, span, 0, is_last ? 0 : most_halvings, frame, places, task);
  }
}

// Whether two movers may come together in a span of time, in which their boxes overlap.
bool Sweeps::may_meet(const Mover& a, const Mover& b, const TimeSpan& span, int depth, const Places& places) const {
  const Aabb box_a = box_within(a, span, places), box_b = box_within(b, span, places);
  if (!box_a.overlaps(box_b)) {
    return false;
  }
  const bool are_short = largest_side(box_a) <= sizes_of_last * a.size && largest_side(box_b) <= sizes_of_last * b.size;
  if (depth == 0 || are_short) {
    return true;
  }
  const Real middle = 0.5 * (span.begin + span.end);
  return may_meet(a, b, {span.begin, middle}, depth - 1, places) ||
         may_meet(a, b, {middle, span.end}, depth - 1, places);
}

void Sweeps::meet_movers(const Places& places) {
  for (const ProxyPair& pair : coarse_pairs_) {
    const Mover &a = movers_[mover_at_[pair.low]], &b = movers_[mover_at_[pair.high]];
    if (a.box.overlaps(b.box) && may_meet(a, b, a.path.whole(), most_halvings, places)) {
      pairs_.push_back({std::min(a.place, b.place), std::max(a.place, b.place)});
    }
  }
}

bool Sweeps::run(const Workers& workers, const Paths& paths, const BoxFrame& frame, const Space& space,
                 std::span<const std::uint32_t> swept_places, Places& places) {
  pairs_before_.swap(pairs_);
  pairs_.clear();
  find_candidates(paths, frame, space, swept_places, places);
  pair_candidates(places);
  find_movers(workers, paths, frame, space, places);
  const auto is_swept = [](const Mover& its) { return its.has_sweeping; };
  const auto swept = static_cast<std::size_t>(std::ranges::count_if(movers_, is_swept));
  const Cuts cuts = workers.cut(swept, least_of_task);
  tasks_.resize(std::max(tasks_.size(), cuts.tasks()));
  workers.for_each(cuts.tasks(), [&](std::size_t number) {
    Task& task = tasks_[number];
    task.pairs.clear();
    task.seen_by.assign(places.infos.size(), no_index);
    for (std::size_t i = cuts.begin(number); i < cuts.end(number); ++i) {
      meet_slow(static_cast<std::uint32_t>(i), paths, frame, space, places, task);
    }
  });
  for (const Task& task : std::span(tasks_).first(cuts.tasks())) {
    pairs_.insert(pairs_.end(), task.pairs.begin(), task.pairs.end());
  }
  meet_movers(places);
  put_in_order(pairs_, scratch_);
  return pairs_ != pairs_before_;
}

std::span<const ProxyPair> Sweeps::with(std::span<const ProxyPair> near) {
  numbers_.clear();
  if (pairs_.empty()) {
    return near;
  }
  joined_.clear();
  joined_.reserve(near.size() + pairs_.size());
  std::size_t at = 0;
  const auto add_until = [&](std::size_t end) {
    const std::span<const ProxyPair> some = near.subspan(at, end - at);
    joined_.insert(joined_.end(), some.begin(), some.end());
    at = end;
  };
  for (const ProxyPair& pair : pairs_) {
    add_until(place_from(at, near, pair));
    numbers_.push_back(static_cast<std::uint32_t>(joined_.size()));
    if (at == near.size() || near[at] != pair) {
      joined_.push_back(pair);
    }
  }
  add_until(near.size());
  return joined_;
}

std::size_t Sweeps::bytes() const {
  std::size_t sum = movers_.capacity() * sizeof(Mover) + candidates_.capacity() * sizeof(Candidate) +
                    side_boxes_.capacity() * sizeof(CompactAabb) + is_candidate_.capacity() / 8 +
                    by_side_.capacity() * sizeof(by_side_[0]) +
                    (mover_at_.capacity() + numbers_.capacity()) * sizeof(std::uint32_t) +
                    tasks_.capacity() * sizeof(Task) +
                    (coarse_pairs_.capacity() + pairs_.capacity() + pairs_before_.capacity() + joined_.capacity() +
                     scratch_.capacity()) *
                        sizeof(ProxyPair);
  for (const Task& task : tasks_) {
    sum += task.pairs.capacity() * sizeof(ProxyPair) + task.near.capacity() * sizeof(Near) +
           task.seen_by.capacity() * sizeof(std::uint32_t);
  }
  return sum;
}

}  // namespace abut
