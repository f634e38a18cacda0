// SPDX-License-Identifier: Apache-2.0
module abut.detect.pairs.selection;
import abut.broadphase;
import abut.broadphase.kept.pair_order;
import abut.core.standard;
import abut.core.workers;
import abut.core;
import abut.detect.elements;
import abut.detect.pairs.jobs;
import abut.detect.pairs;
import abut.math;
import abut.pairs.two_shapes.runs;
import abut.scene.meetings;
import abut.scene.state.options;
import abut.scene.state.places;
import abut.scene.meetings.policies;
import abut.scene.state.space;

namespace abut {
namespace {

// Below this many pairs a task costs more than it saves.
constexpr std::size_t least_of_task = 2048;

bool is_covered(const Pair& pair, const Scope& scope, const Places& places) {
  switch (scope.coverage) {
    case Coverage::changed:
    case Coverage::everything: return true;
    case Coverage::pairs: return std::ranges::binary_search(scope.pairs, ProxyPair{pair.low, pair.high}, is_before);
    case Coverage::region:
      return places.boxes[pair.low].overlaps(scope.region) && places.boxes[pair.high].overlaps(scope.region);
  }
  return true;
}

// Whether a geometry has moved, or changed where the box of another one reaches.
bool has_changed_for(std::uint32_t place, std::uint32_t other, const Places& places, std::span<const Patch> patches) {
  if (!places.has_happened(place, happened_to_box)) {
    return false;
  }
  const std::uint32_t patch = patches.empty() ? no_patch : places.infos[place].patch;
  return patch == no_patch || patches[patch].compact_box.overlaps(places.boxes[other]);
}

// What a pair is like, after something has changed that it depends on beside poses.
void renew_pair(Pair& pair, bool is_reshaped, const Places& places, const Meetings& meetings, const JobList& jobs) {
  const PlaceInfo &low = places.infos[pair.low], &high = places.infos[pair.high];
  const bool was_admitted = pair.is_admitted;
  pair.is_admitted = meetings.admits(places, pair.low, pair.high);
  pair.is_unasked = false;
  pair.run = static_cast<std::uint16_t>(run_of(pair, low.kind, high.kind));
  pair.is_supported = jobs.is_supported(pair.run);
  pair.is_sensor = low.is_sensor || high.is_sensor;
  assign_policy(pair, places, meetings.policies);
  pair.is_new = pair.is_new || is_reshaped || (pair.is_admitted && !was_admitted);
  pair.is_stale = true;
}

// An admitted pair that is stale and covered: what its policy makes of it.
void choose_detail(Pair& pair, bool is_on_path, const Scope& scope, const Policy& policy) {
  const bool is_seen_as_boxes = policy.detail == Detail::box;
  if (is_seen_as_boxes || !pair.is_supported) {
    pair.is_touching = is_seen_as_boxes;
    pair.contact_count = 0;
    pair.is_stale = pair.is_new = false;
  } else if (pair.is_new || is_on_path || policy.period == 1 || scope.step % policy.period == 0 ||
             scope.coverage == Coverage::everything) {
    pair.job = 0;
    pair.is_stale = pair.is_new = false;
  }
}

void update_pair(Pair& pair, const Scope& scope, const Places& places, std::span<const Patch> patches,
                 const Meetings& meetings, PairStore& pairs, const JobList& jobs, std::vector<Pair>& lost) {
  const unsigned happened = places.happened[pair.low] | places.happened[pair.high];
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
  if (pair.is_unasked || meetings.must_ask_again || (happened & (happened_to_filters | happened_to_shape)) != 0) {
    renew_pair(pair, is_reshaped, places, meetings, jobs);
  }
  if ((happened & (happened_to_shape | happened_to_surface)) != 0 && pair.memory != no_memory) {
    pairs.memories().forget(pair.memory);
  }
  if (!pair.is_admitted) {
    pair.is_touching = false;
    pair.contact_count = 0;
    pair.is_covered = true;
    return;
  }
  pair.is_covered = is_covered(pair, scope, places);
  bool is_followed = (happened & happened_on_path) != 0 && !is_self_pair(pair);
  if (pair.is_by_elements) [[unlikely]] {
    // Vertices that are elsewhere than the box of the other one may have passed it.
    const bool is_fast = follows_vertices(pair, places.infos);
    is_followed = is_fast && scope.dt > 0;
    pair.is_stale = pair.is_stale || (is_fast && (happened & (happened_on_way | happened_to_box)) != 0);
  }
  pair.is_stale = pair.is_stale || (is_followed && !pair.is_by_elements) ||
                  has_changed_for(pair.low, pair.high, places, patches) ||
                  has_changed_for(pair.high, pair.low, places, patches) || scope.coverage == Coverage::everything;
  if (pair.is_stale && pair.is_covered) {
    choose_detail(pair, is_followed, scope, meetings.policies.at(pair.policy));
  }
}

}  // namespace

bool asks_for_elements(const Pair& pair, const Places& places, const PolicyTable& policies) {
  return policies.at(pair.policy).detail == Detail::elements && has_elements(places.infos[pair.low].kind) &&
         has_elements(places.infos[pair.high].kind);
}
void assign_policy(Pair& pair, const Places& places, const PolicyTable& policies) {
  pair.policy = static_cast<std::uint16_t>(policies.number_of(places.infos[pair.low].tag, places.infos[pair.high].tag));
  pair.is_by_elements = asks_for_elements(pair, places, policies);
}

// From the back, so that none is written over before it has gone.
void add_self_pairs(std::span<const std::uint32_t> places, const Space& space, std::vector<ProxyPair>& near) {
  const auto is_shown = [&](std::uint32_t at) { return space.is_shown(at); };
  std::size_t from = near.size();
  std::size_t to = from + static_cast<std::size_t>(std::ranges::count_if(places, is_shown));
  near.resize(to);
  for (std::size_t i = places.size(); i-- > 0;) {
    const std::uint32_t at = places[i];
    if (!is_shown(at)) {
      continue;
    }
    while (from > 0 && is_before({at, at}, near[from - 1])) {
      near[--to] = near[--from];
    }
    near[--to] = {at, at};
  }
}

void Selection::run(const Workers& workers, const Scope& scope, ToleranceMode mode, const Places& places,
                    std::span<const Patch> patches, const Meetings& meetings, PairStore& pairs, JobList& jobs) {
  const std::span<Pair> all = pairs.all();
  const PolicyTable& policies = meetings.policies;
  // Each task looks at all runs, so that it has to have as many pairs. The filter is called on this thread, in order.
  const Cuts cuts = meetings.filter ? Cuts(all.size(), 1)
                                    : workers.cut(all.size(), std::max(least_of_task, policies.size() * job_run_count));
  jobs.start(cuts.tasks(), policies);
  tasks_.resize(std::max(tasks_.size(), cuts.tasks()));
  workers.for_each(cuts.tasks(), [&](std::size_t task) {
    Task& its = tasks_[task];
    its.lost.clear();
    its.without_memory.clear();
    const std::span<std::uint32_t> counts = jobs.counts_of(task);
    for (std::size_t i = cuts.begin(task); i < cuts.end(task); ++i) {
      Pair& pair = all[i];
      update_pair(pair, scope, places, patches, meetings, pairs, jobs, its.lost);
      if (pair.job == no_job) {
        continue;
      }
      ++counts[JobList::run_of_pair(pair)];
      if (pair.memory == no_memory && jobs.gains_from_memory(pair.run)) {
        its.without_memory.push_back(static_cast<std::uint32_t>(i));
      }
    }
  });
  for (const Task& its : std::span(tasks_).first(cuts.tasks())) {
    pairs.lose(its.lost);
    for (const std::uint32_t place : its.without_memory) {
      pairs.give_memory(all[place]);
    }
  }
  jobs.arrange(workers, cuts, all, places.infos, policies, mode);
}

std::size_t Selection::bytes() const {
  std::size_t sum = tasks_.capacity() * sizeof(Task);
  for (const Task& task : tasks_) {
    sum += task.lost.capacity() * sizeof(Pair) + task.without_memory.capacity() * sizeof(std::uint32_t);
  }
  return sum;
}

}  // namespace abut
