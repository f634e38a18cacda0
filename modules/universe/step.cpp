// A detection: from boxes to pairs, and which of them are examined.
module abut.universe;
import abut.broadphase.pair_order;
import abut.broadphase;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.narrow.warm.pair_memory;
import abut.pairs.any_shape;
import abut.universe.checks;
import abut.universe.jobs;
import abut.universe.pairs;
import abut.universe.policies;
import abut.universe.rules;
import abut.universe.stopwatch;

namespace abut {
namespace {

// Fewer pairs are looked at, and fewer flags are taken back, faster than a thread is called.
constexpr std::size_t least_of_task = 2048, least_flags_of_task = 16384;

}  // namespace

// Both geometries are on different parts, one of them dynamic, and not parked, or the broad phase had not found them.
// Layers, masks and exclusion speak of two geometries, not of one that meets itself.
bool Universe::is_admitted(const Pair& pair) const {
  const PlaceInfo &low = infos_[pair.low], &high = infos_[pair.high];
  if (is_self_pair(pair)) {
    return passes_rules_and_filter(pair);
  }
  if ((low.exclusion & high.exclusion) != 0 || (low.layers & high.mask) == 0 || (high.layers & low.mask) == 0) {
    return false;
  }
  return passes_rules_and_filter(pair);
}

bool Universe::passes_rules_and_filter(const Pair& pair) const {
  if (rules_.is_empty() && !filter_) {
    return true;
  }
  const GeometryId a = id_at(pair.low), b = id_at(pair.high);
  if (!rules_.is_empty()) {
    const Geometry &its = geometries_.at(a), &other = geometries_.at(b);
    if (!rules_.allows({a, its.part, its.options.label}, {b, other.part, other.options.label})) {
      return false;
    }
  }
  return !filter_ || filter_(a, b);
}

bool Universe::is_covered(const Pair& pair, const Scope& scope) const {
  switch (scope.coverage) {
    case Coverage::changed:
    case Coverage::everything: return true;
    case Coverage::pairs: return std::ranges::binary_search(scope.pairs, ProxyPair{pair.low, pair.high}, is_before);
    case Coverage::region: return boxes_[pair.low].overlaps(scope.region) && boxes_[pair.high].overlaps(scope.region);
  }
  return true;
}

// Whether a geometry has moved, or changed where the box of another one reaches.
bool Universe::has_changed_for(std::uint32_t place, std::uint32_t other) const {
  if ((happened_[place] & happened_to_box) == 0) {
    return false;
  }
  const std::uint32_t patch = patches_.empty() ? no_patch : infos_[place].patch;
  return patch == no_patch || patches_[patch].compact_box.overlaps(boxes_[other]);
}

// What a pair is like, after something has changed that it depends on beside poses.
void Universe::renew_pair(Pair& pair, bool is_reshaped) {
  const PlaceInfo &low = infos_[pair.low], &high = infos_[pair.high];
  const bool was_admitted = pair.is_admitted;
  pair.is_admitted = is_admitted(pair);
  pair.is_unasked = false;
  pair.run = static_cast<std::uint16_t>(run_of(pair, low.kind, high.kind));
  pair.is_supported = jobs_.is_supported(pair.run);
  pair.is_sensor = low.is_sensor || high.is_sensor;
  pair.policy = static_cast<std::uint16_t>(policies_.number_of(low.tag, high.tag));
  pair.is_new = pair.is_new || is_reshaped || (pair.is_admitted && !was_admitted);
  pair.is_stale = true;
}

void Universe::update_pair(Pair& pair, const Scope& scope, std::vector<Pair>& lost) {
  const unsigned happened = happened_[pair.low] | happened_[pair.high];
  pair.job = no_job;
  pair.first_before = pair.first_contact;
  pair.count_before = pair.contact_count;
  pair.was_touching = pair.is_touching;
  const bool is_reshaped = (happened & happened_to_shape) != 0;
  if (is_reshaped && pair.is_touching) {
    lost.push_back(pair);
    pair.count_before = pair.contact_count = 0;
    pair.is_touching = pair.was_touching = false;
  }
  if (pair.is_unasked || must_refilter_ || (happened & (happened_to_filters | happened_to_shape)) != 0) {
    renew_pair(pair, is_reshaped);
  }
  if ((happened & (happened_to_shape | happened_to_surface)) != 0 && pair.memory != no_memory) {
    pairs_.memories()[pair.memory] = {};
  }
  if (!pair.is_admitted) {
    pair.is_touching = false;
    pair.contact_count = 0;
    pair.is_covered = true;
    return;
  }
  pair.is_covered = is_covered(pair, scope);
  pair.is_stale = pair.is_stale || has_changed_for(pair.low, pair.high) || has_changed_for(pair.high, pair.low) ||
                  scope.coverage == Coverage::everything;
  if (!pair.is_stale || !pair.is_covered) {
    return;
  }
  const Policy& policy = policies_.at(pair.policy);
  if (policy.detail == Detail::box) {
    pair.is_touching = true;
    pair.contact_count = 0;
    pair.is_stale = pair.is_new = false;
  } else if (!pair.is_supported) {
    pair.is_touching = false;
    pair.contact_count = 0;
    pair.is_stale = pair.is_new = false;
  } else if (pair.is_new || policy.period == 1 || step_ % policy.period == 0 ||
             scope.coverage == Coverage::everything) {
    pair.job = 0;
    pair.is_stale = pair.is_new = false;
  }
}

// Among those that the broad phase has found, in order: from the back, so that none is written over before it has gone.
void Universe::add_self_pairs() {
  const auto is_shown = [&](std::uint32_t at) { return presence_[at] == Presence::shown; };
  std::size_t from = near_.size();
  std::size_t to = from + static_cast<std::size_t>(std::ranges::count_if(self_places_, is_shown));
  near_.resize(to);
  for (std::size_t i = self_places_.size(); i-- > 0;) {
    const std::uint32_t at = self_places_[i];
    if (!is_shown(at)) {
      continue;
    }
    while (from > 0 && is_before({at, at}, near_[from - 1])) {
      near_[--to] = near_[--from];
    }
    near_[--to] = {at, at};
  }
}

void Universe::update_pairs(const Scope& scope) {
  if (is_broadphase_changed_) {
    pairs_.merge(workers_, near_, infos_, are_slots_reused_);
    is_broadphase_changed_ = are_slots_reused_ = false;
  }
  if (has_focus_) {
    follow_focus();
  }
  const std::span<Pair> pairs = pairs_.all();
  // Each task looks at all runs, so that it has to have as many pairs. The filter is called on this thread, in order.
  const Cuts cuts = filter_ ? Cuts(pairs.size(), 1)
                            : workers_.cut(pairs.size(), std::max(least_of_task, policies_.size() * run_count));
  jobs_.start(cuts.tasks(), policies_);
  pair_tasks_.resize(std::max(pair_tasks_.size(), cuts.tasks()));
  workers_.for_each(cuts.tasks(), [&](std::size_t task) {
    PairTask& its = pair_tasks_[task];
    its.lost.clear();
    its.without_memory.clear();
    const std::span<std::uint32_t> counts = jobs_.counts_of(task);
    for (std::size_t i = cuts.begin(task); i < cuts.end(task); ++i) {
      Pair& pair = pairs[i];
      update_pair(pair, scope, its.lost);
      if (pair.job == no_job) {
        continue;
      }
      ++counts[JobList::run_of_pair(pair)];
      if (pair.memory == no_memory && jobs_.gains_from_memory(pair.run)) {
        its.without_memory.push_back(static_cast<std::uint32_t>(i));
      }
    }
  });
  for (const PairTask& its : std::span(pair_tasks_).first(cuts.tasks())) {
    pairs_.lose(its.lost);
    for (const std::uint32_t place : its.without_memory) {
      pairs_.give_memory(pairs[place]);
    }
  }
  jobs_.arrange(workers_, cuts, pairs, infos_, policies_, options_.tolerance_mode);
}

void Universe::finish_detection() {
  const Cuts cuts = workers_.cut(fresh_.size(), least_flags_of_task);
  workers_.for_each(cuts.tasks(), [&](std::size_t task) {
    for (const std::uint32_t at : cuts.of(std::span(fresh_), task)) {
      happened_[at] = 0;
    }
  });
  for (const Patch& patch : patches_) {
    infos_[patch.place].patch = no_patch;
  }
  patches_.clear();
  stats_.moved = fresh_.size();
  fresh_.clear();
  must_refilter_ = false;
}

void Universe::count_everything() {
  stats_.parts = parts_.size();
  stats_.geometries = geometries_.size();
  stats_.parked = parked_count_;
  stats_.contacts = contacts_.size();
  stats_.events = events_.size();
  stats_.asleep = sleep_.asleep_count();
  stats_.examined_pairs = jobs_.jobs().size();
  stats_.kept_pairs = stats_.candidate_pairs - stats_.examined_pairs;
  stats_.bytes = bytes();
}

void Universe::detect(const Scope& scope) {
  is_torn_ = is_stepping_ = true;
  try {
    run_stages(scope);
  } catch (...) {
    is_stepping_ = false;
    throw;
  }
  is_stepping_ = false;
  for (const auto& [geometry, parking] : std::exchange(deferred_parking_, {})) {
    if (geometries_.contains(geometry)) {
      settle_parking(geometry, parking);
    }
  }
  is_torn_ = false;
}

void Universe::run_stages(const Scope& scope) {
  Stopwatch watch;
  ++step_;
  pairs_.forget_lost();
  gather_changes();
  update_velocities(scope.dt);
  stats_.refresh_microseconds = watch.lap();
  update_broadphase();
  if (is_broadphase_changed_) {
    std::visit([&](auto& broadphase) { broadphase.find_pairs(workers_, near_); }, broadphase_);
    add_self_pairs();
  }
  stats_.broadphase_microseconds = watch.lap();
  update_pairs(scope);
  stats_.pair_microseconds = watch.lap();
  find_contacts();
  stats_.narrowphase_microseconds = watch.lap();
  collect_contacts();
  if (sleep_.is_used() || follows_islands_) {
    connect_islands();
  }
  if (follows_islands_) {
    number_islands();
  }
  if (sleep_.is_used()) {
    update_sleep(scope.dt);
  }
  collect_events();
  finish_detection();
  stats_.contact_microseconds = watch.lap();
  count_everything();
}

Result<void> Universe::step(Real dt) {
  if (!std::isfinite(dt)) {
    return error_about(Errc::not_finite, "dt", dt, "finite");
  }
  if (dt < 0) {
    return error_about(Errc::out_of_range, "dt", dt, "zero or positive");
  }
  detect({.dt = dt});
  return {};
}

void Universe::detect_all() { detect({.coverage = Coverage::everything}); }

void Universe::detect_changed() { detect({}); }

Result<void> Universe::detect_pairs(std::span<const std::pair<GeometryId, GeometryId>> pairs) {
  std::vector<ProxyPair> wanted;
  wanted.reserve(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto& [a, b] = pairs[i];
    if (!geometries_.contains(a) || !geometries_.contains(b)) {
      return stale(name_at(geometries_.contains(a) ? "b" : "a", i));
    }
    wanted.push_back({std::min(a.slot, b.slot) - 1, std::max(a.slot, b.slot) - 1});
  }
  std::ranges::sort(wanted, is_before);
  detect({.coverage = Coverage::pairs, .pairs = wanted});
  return {};
}

Result<void> Universe::detect_region(const Aabb& region) {
  if (!(region.low.x <= region.high.x && region.low.y <= region.high.y && region.low.z <= region.high.z)) {
    return Error{Errc::invalid_argument, "region has a NaN in it, or its minimum lies above its maximum"};
  }
  detect({.coverage = Coverage::region, .region = compact(region, options_.origin)});
  return {};
}

}  // namespace abut
