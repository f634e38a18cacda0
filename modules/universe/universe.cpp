// SPDX-License-Identifier: Apache-2.0
// A detection: one stage after the other.
module abut.universe;
import abut.broadphase.kept.pair_order;
import abut.broadphase;
import abut.core.memory.spare_blocks;
import abut.core.standard;
import abut.core.workers;
import abut.core;
import abut.detect.backend;
import abut.detect.lists.contacts;
import abut.detect.continuous;
import abut.detect.elements;
import abut.detect.lists.events;
import abut.detect.lists.hash;
import abut.detect.pairs.jobs;
import abut.detect.pairs.manifolds;
import abut.detect.pairs;
import abut.detect.pairs.refresh;
import abut.detect.lists.seams;
import abut.detect.pairs.selection;
import abut.detect.pairs.sides;
import abut.detect.lists.sleep;
import abut.detect.pairs.stopwatch;
import abut.detect.paths;
import abut.math;
import abut.pairs.any_shape.shape_edit;
import abut.scene.state.changes;
import abut.scene.meetings.checks;
import abut.scene.meetings;
import abut.scene.state.places;
import abut.scene.meetings.policies;
import abut.scene.state.space;

namespace abut {

Universe::Universe(const UniverseOptions& options, std::uint32_t number)
    : Scene(options, number), workers_(options.threads), contacts_(options.keeps_local_points) {}

void Universe::follow_islands(bool are_followed) {
  follows_islands_ = are_followed;
  if (!are_followed) {
    islands_.clear();
  }
}

void Universe::set_backend(Backend backend) {
  backend_.set(std::move(backend));
  meetings_.must_ask_again = true;
}

BoxFrame Universe::box_frame() const {
  return {options_.tolerance_mode, meetings_.policies.largest_tolerance(), options_.origin};
}

namespace {

// A pair that overlaps depends on what lies on its way out as well, as far as its deepest contact is deep.
void note_ways_out(std::span<const Contact> contacts, const Places& places, std::span<const Patch> patches,
                   std::span<Pair> pairs) {
  if (patches.empty()) {
    return;
  }
  for (Pair& pair : pairs) {
    const Real depth = pair.contact_count > 0 ? -contacts[pair.first_contact].point.distance : 0;
    if (!(depth > 0)) {
      continue;
    }
    const auto changes_for = [&](std::uint32_t place, std::uint32_t other) {
      const std::uint32_t patch = places.infos[place].patch;
      CompactAabb reached = places.boxes[other];
      for (std::size_t axis = 0; axis < 3; ++axis) {
        reached.low[axis] -= static_cast<float>(depth);
        reached.high[axis] += static_cast<float>(depth);
      }
      return patch != no_patch && places.has_happened(place, happened_to_box) &&
             patches[patch].compact_box.overlaps(reached);
    };
    pair.is_stale = pair.is_stale || changes_for(pair.low, pair.high) || changes_for(pair.high, pair.low);
  }
}

}  // namespace

void Universe::refresh_places() { refresh_.run(workers_, box_frame(), space_, parts_, geometries_, changes_, places_); }

void Universe::update_space() {
  space_.update(workers_, places_, options_.broadphase, changes_.rejoining, refresh_.queue());
  changes_.rejoining.clear();
}

void Universe::refresh() {
  is_torn_ = true;
  refresh_places();
  update_space();
  is_torn_ = false;
}

// From boxes that overlap to pairs that are kept, where any of that has changed.
void Universe::find_pairs() {
  if (space_.has_changed()) {
    space_.find_pairs(workers_, near_);
    add_self_pairs(self_places_, space_, near_);
  }
}

// Pairs are merged anew where others are on the way.
void Universe::sweep(Real dt) {
  if (sweeps_.run(workers_, paths(dt), box_frame(), space_, swept_places_, places_)) {
    space_.set_changed(true);
  }
}

// Whom geometries with a sweeping may meet within dt; nobody without time.
void Universe::find_paths(Real dt) {
  if (dt > 0 && !swept_places_.empty()) {
    sweep(dt);
    had_paths_ = true;
  } else if (std::exchange(had_paths_, false)) {
    sweeps_.clear();
    space_.set_changed(true);
    for (const std::uint32_t at : swept_places_) {
      places_.note(at, happened_on_path);
    }
  }
}

// Pairs are merged anew where others may touch on the ways of vertices.
void Universe::follow_elements(Real dt) {
  if (elements_.follow(box_frame(), meetings_.policies, space_, changes_.fresh, lent_, dt > 0, places_)) {
    space_.set_changed(true);
  }
}

// At once, whatever the period: what the other policy has found may be less than this one asks for.
void Universe::follow_focus() {
  focus_.follow(changes_.fresh, space_, places_);
  if (!focus_.has_switched()) {
    return;
  }
  for (Pair& pair : pairs_.all()) {
    if (places_.has_happened(pair.low, happened_to_tag) || places_.has_happened(pair.high, happened_to_tag)) {
      assign_policy(pair, places_, meetings_.policies);
      pair.is_stale = pair.is_new = true;
    }
  }
  focus_.forget_switched(places_);
}

void Universe::update_islands(Real dt) {
  if (sleep_.is_used() || follows_islands_) {
    connect_islands(pairs_.all(), places_.infos, parts_.slot_count(), island_links_);
  }
  if (follows_islands_) {
    dynamic_parts_.clear();
    parts_.for_each([&](PartId id, const Part& part) {
      if (part.motion == MotionKind::dynamic) {
        dynamic_parts_.push_back(id);
      }
    });
    islands_.number(dynamic_parts_, island_links_);
  }
  if (sleep_.is_used()) {
    update_sleep(dt, parts_, places_.infos, island_links_, pairs_, sleep_);
  }
}

// What has happened is known to all now.
void Universe::finish_detection() {
  // Below this many flags a task costs more than it saves.
  constexpr std::size_t least_of_task = 16384;
  const std::span<const std::uint32_t> fresh(changes_.fresh);
  const Cuts cuts = workers_.cut(fresh.size(), least_of_task);
  workers_.for_each(cuts.tasks(), [&](std::size_t task) {
    for (const std::uint32_t at : cuts.of(fresh, task)) {
      places_.happened[at] = 0;
    }
  });
  for (const Patch& patch : changes_.patches) {
    places_.infos[patch.place].patch = no_patch;
  }
  changes_.patches.clear();
  for (const std::uint32_t at : swept_places_) {
    places_.happened[at] &= ~unsigned{happened_on_path};
  }
  stats_.moved = changes_.fresh.size();
  changes_.fresh.clear();
  meetings_.must_ask_again = false;
}

void Universe::count_everything(const ContactCounts& counts) {
  stats_.parts = parts_.size();
  stats_.geometries = geometries_.size();
  stats_.parked = parked_count_;
  stats_.candidate_pairs = counts.candidates;
  stats_.filtered_pairs = counts.filtered;
  stats_.unsupported_pairs = counts.unsupported;
  stats_.touching_pairs = counts.touching;
  stats_.contacts = contacts().size();
  stats_.events = events().size();
  stats_.asleep = sleep_.asleep_count();
  stats_.examined_pairs = jobs_.jobs().size();
  stats_.kept_pairs = stats_.candidate_pairs - stats_.examined_pairs;
}

void Universe::detect(Scope scope) {
  {
    const SpareBlocks::Use use(spare_, workers_.threads());
    scope.step = ++step_;
    is_torn_ = true;
    begin_detection();
    try {
      run_stages(scope);
    } catch (...) {
      end_detection();
      throw;
    }
    end_detection();
    apply_deferred_parking();
    is_torn_ = false;
  }
  stats_.bytes = bytes();  // with what is spare now
}

void Universe::run_stages(const Scope& scope) {
  const bool is_timed = are_pairs_timed_.load(std::memory_order_relaxed);
  Stopwatch watch;
  pairs_.forget_lost();
  refresh_places();
  if (scope.dt > 0) {
    velocities_.update(scope.dt, [&](PartId part) { return parts_.at(part).placement; });
  }
  stats_.refresh_microseconds = watch.lap();
  update_space();
  find_pairs();
  find_paths(scope.dt);
  follow_elements(scope.dt);
  stats_.broadphase_microseconds = watch.lap();
  if (space_.has_changed()) {
    pairs_.merge(workers_, sweeps_.with(elements_.with(near_)), places_.infos, changes_.are_slots_reused);
    changes_.are_slots_reused = false;
    space_.set_changed(false);
  }
  if (focus_.is_on()) {
    follow_focus();
  }
  const Paths its_paths = paths(scope.dt);
  impacts_.start(sweeps_.numbers(), its_paths, places_, pairs_.all());
  note_ways_out(contacts_.all(), places_, changes_.patches, pairs_.all());
  selection_.run(workers_, scope, options_.tolerance_mode, places_, changes_.patches, meetings_, pairs_, jobs_);
  stats_.pair_microseconds = watch.lap();
  sides_.start(side_keeper_count_ > 0, places_, jobs_);
  backend_.run(places_, pairs_.all(), sides_, jobs_);
  find_manifolds(workers_, options_, meetings_.policies, places_, contacts_.histories(), is_timed, pairs_, backend_,
                 sides_, jobs_);
  sides_.settle(places_, pairs_.all());
  elements_.run(workers_, meetings_.policies, places_, pairs_.all(), jobs_);
  seams_.run({options_, meetings_.policies, places_, contacts_.histories(), pairs_.all()}, jobs_);
  impacts_.run(workers_, {options_, meetings_.policies, places_, its_paths, sweeps_, contacts_.histories()},
               pairs_.all(), jobs_);
  stats_.narrowphase_microseconds = watch.lap();
  const ContactCounts counts = contacts_.collect(workers_, places_, is_timed, jobs_, pairs_.all());
  impacts_.mark(pairs_.all(), contacts_);
  update_islands(scope.dt);
  events_.collect(workers_, options_.events, pairs_, places_.infos, contacts_, elements_, sleep_);
  finish_detection();
  if (scope.dt > 0) {
    velocities_.settle([&](PartId part) { return parts_.at(part).placement; });
  }
  stats_.contact_microseconds = watch.lap();
  count_everything(counts);
}

std::uint64_t Universe::hash() const {
  return elements_.hash_after(hash_of(contacts(), local_points(), events(), sleep_.changes()));
}

std::size_t Universe::bytes() const {
  return sizeof(Universe) + Scene::bytes() + spare_.bytes() + refresh_.bytes() + near_.capacity() * sizeof(ProxyPair) +
         pairs_.bytes() + selection_.bytes() + jobs_.bytes() + sides_.bytes() + backend_.bytes() + seams_.bytes() +
         elements_.bytes() + sweeps_.bytes() + impacts_.bytes() + contacts_.bytes() + events_.bytes() +
         island_links_.bytes() + islands_.bytes() + dynamic_parts_.capacity() * sizeof(PartId);
}

Fault Universe::check_time(Real dt) const {
  if (!std::isfinite(dt)) {
    return error_about(Errc::not_finite, "dt", dt, "finite");
  }
  if (dt < 0) {
    return error_about(Errc::out_of_range, "dt", dt, "zero or positive");
  }
  if (Fault fault = dt > 0 ? check_lent_vertices() : std::nullopt) {
    return fault;
  }
  return swept_places_.empty() ? std::nullopt : velocities_.check_motions(dt);
}

// A step with time looks at those of fast geometries.
Fault Universe::check_lent_vertices() const {
  Fault fault;
  lent_.visit([&](std::uint32_t place, std::span<const Vec3> vertices) {
    if (!fault && places_.infos[place].sweeping == Sweeping::impacts) {
      fault = check_next_vertices(shape_at(place), vertices);
      if (fault) {
        fault->message = "the vertices that the geometry of slot " + std::to_string(place + 1) +
                         " has lent are wrong: " + fault->message;
      }
    }
  });
  return fault;
}

Result<void> Universe::step(Real dt) {
  if (Fault fault = check_time(dt)) {
    return *fault;
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
