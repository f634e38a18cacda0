// SPDX-License-Identifier: Apache-2.0
module abut.detect.elements;
import abut.broadphase.kept.pair_order;
import abut.broadphase;
import abut.capability;
import abut.core.standard;
import abut.core.workers;
import abut.deforming;
import abut.detect.pairs.jobs;
import abut.detect.pairs;
import abut.detect.pairs.refresh;
import abut.math;
import abut.pairs.any_shape;
import abut.proximity.body;
import abut.proximity.closest;
import abut.proximity.first_touches;
import abut.proximity.stencil;
import abut.scene;
import abut.scene.state.lent_vertices;
import abut.scene.state.options;
import abut.scene.state.places;
import abut.scene.meetings.policies;
import abut.scene.state.space;

namespace abut {
namespace {

constexpr Real farthest_vertex = 1e50;
// Of first touches with a separation.
constexpr Real touch_tolerance = 1e-9;

[[nodiscard]] Aabb box_around(std::span<const Vec3> vertices) {
  Aabb box = Aabb::empty();
  for (const Vec3& vertex : vertices) {
    box.include(vertex);
  }
  return box;
}

[[nodiscard]] bool are_same(std::span<const std::uint32_t> a, std::span<const std::uint32_t> b) {
  std::size_t i = 0;
  while (i < a.size() && i < b.size() && a[i] == b[i]) {
    ++i;
  }
  return i == a.size() && i == b.size();
}

[[nodiscard]] bool are_too_far(std::span<const Vec3> vertices) {
  return std::ranges::any_of(vertices,
                             [](const Vec3& vertex) { return !(largest_magnitude(vertex) <= farthest_vertex); });
}

[[nodiscard]] bool is_fast(std::uint32_t place, const Places& places) {
  return places.infos[place].sweeping == Sweeping::impacts;
}

void place_in_world(std::span<const Vec3> vertices, const Pose& world, std::vector<Vec3>& out) {
  out.resize(vertices.size());
  std::transform(vertices.begin(), vertices.end(), out.begin(), [&](const Vec3& vertex) { return world * vertex; });
}

// The kinds of the two features of a stencil.
struct FeatureKinds {
  FeatureKind a, b;
};
[[nodiscard]] FeatureKinds kinds_of(const Stencil& its) {
  switch (its.kind) {
    case StencilKind::edge_edge: return {FeatureKind::edge, FeatureKind::edge};
    case StencilKind::vertex_vertex: return {FeatureKind::vertex, FeatureKind::vertex};
    case StencilKind::vertex_face:
    case StencilKind::vertex_edge: break;
  }
  const FeatureKind other = its.kind == StencilKind::vertex_face ? FeatureKind::face : FeatureKind::edge;
  return its.of_a == 1 ? FeatureKinds{FeatureKind::vertex, other} : FeatureKinds{other, FeatureKind::vertex};
}

[[nodiscard]] std::uint64_t id_of(const Stencil& its) {
  const auto [a, b] = kinds_of(its);
  return contact_id({a, its.element_a}, {b, its.element_b});
}

[[nodiscard]] ClosestOptions closest_options(const ElementRule& rule, Real reach) {
  return {static_cast<ClosestMethod>(rule.method),
          rule.kinds,
          reach,
          rule.rest_distance,
          {rule.cone_angle, rule.cone_factor, rule.is_front_only}};
}

}  // namespace

bool has_elements(std::size_t kind) { return has_triangles(kind); }

bool ElementStage::is_of(const Run& run, const Pair& pair) {
  return std::tie(run.low, run.high, run.generation_low, run.generation_high) ==
         std::tie(pair.low, pair.high, pair.generation_low, pair.generation_high);
}

bool ElementStage::may_have_pairs(std::uint32_t place, const Places& places) const {
  return !places.shapes[place].same_as(places.vacant) && has_elements(places.infos[place].kind) &&
         (tags_ >> places.infos[place].tag & 1u) != 0;
}

void ElementStage::read(std::uint32_t place, const Places& places, Body& body) {
  Triangles made;
  HeldTriangles surface = held_triangles(*places.shapes[place]);
  if (surface.vertices.empty()) {
    made = triangles_of(*places.shapes[place]).value_or(Triangles{});
    surface = {made.vertices, made.indices};
  }
  const bool is_new = places.has_happened(place, happened_to_shape) || body.rest.size() != surface.vertices.size();
  if (is_new || !are_same(body.triangles, surface.indices)) {
    body.elements.reset();
    body.triangles.assign(surface.indices.begin(), surface.indices.end());
  }
  place_in_world(surface.vertices, places.worlds[place], body.now);
  if (is_new) {
    body.rest = body.now;
    body.before.clear();
  }
  body.goes_ahead = false;
  body.has_moved = !body.before.empty() && body.now != body.before;
  body.is_laid = false;
  body.is_too_far = are_too_far(body.now);
}

// For one step: the way leads to other vertices than those that are there.
void ElementStage::look_ahead(std::span<const Vec3> next, const Pose& world, Body& body) {
  place_in_world(next, world, body.next);
  body.goes_ahead = true;
  body.has_moved = body.next != body.now;
  body.is_laid = false;
}

void ElementStage::look_back(Body& body) {
  if (std::exchange(body.goes_ahead, false)) {
    body.has_moved = !body.before.empty() && body.now != body.before;
    body.is_laid = false;
  }
}

ElementStage::Body& ElementStage::body_at(std::uint32_t place, const Places& places) {
  const auto [at, is_new] = bodies_.try_emplace(place);
  Body& body = at->second;
  if (is_new) {
    body.generation = places.infos[place].generation;
  }
  if (body.now.empty()) {
    read(place, places, body);
  }
  return body;
}

void ElementStage::read_fresh(const PolicyTable& policies, const Space& space, std::span<const std::uint32_t> fresh,
                              const Places& places) {
  const bool has_other_tags = std::exchange(tags_, policies.tags_of_elements()) != policies.tags_of_elements();
  std::erase_if(bodies_, [&](const auto& its) {
    return !may_have_pairs(its.first, places) || its.second.generation != places.infos[its.first].generation;
  });
  for (auto& [place, body] : bodies_) {
    body.is_shown = space.is_shown(place);
    if (!body.is_shown) {
      body.before.clear();
    }
  }
  for (const std::uint32_t place : fresh) {
    if (!may_have_pairs(place, places) || !space.is_shown(place)) {
      continue;
    }
    if (const auto found = bodies_.find(place); found != bodies_.end()) {
      read(place, places, found->second);
    } else {
      body_at(place, places);
    }
  }
  for (std::uint32_t place = 0; has_other_tags && place < places.infos.size(); ++place) {
    if (may_have_pairs(place, places) && space.is_shown(place)) {
      body_at(place, places);
    }
  }
}

bool ElementStage::follow(const BoxFrame& frame, const PolicyTable& policies, const Space& space,
                          std::span<const std::uint32_t> fresh, const LentVertices& lent, bool has_time,
                          Places& places) {
  if (policies.tags_of_elements() == 0 && tags_ == 0 && bodies_.empty() && pairs_.empty()) {
    return false;
  }
  read_fresh(policies, space, fresh, places);
  for (auto& [place, body] : bodies_) {
    const std::span<const Vec3> next = lent.of(place);
    if (has_time && body.is_shown && is_fast(place, places) && !next.empty()) {
      look_ahead(next, places.worlds[place], body);
    } else {
      look_back(body);
    }
  }
  const bool is_other_mode = std::exchange(had_time_, has_time) != has_time;
  for (const auto& [place, body] : bodies_) {
    if (is_other_mode || (has_time && (body.has_moved || body.was_on_way))) {
      places.note(place, happened_on_way);
    }
  }
  pairs_before_.swap(pairs_);
  pairs_.clear();
  if (has_time) {
    find_ways(frame, policies, space, places);
  }
  return pairs_ != pairs_before_;
}

// The box around it.
void ElementStage::find_way(const BoxFrame& frame, std::uint32_t place, const Places& places, Body& body) {
  body.way = places.boxes[place];
  if (body.has_moved) {
    Aabb box = box_around(body.start());
    box.include(box_around(body.end()));
    body.way = compact(box.inflated(reach_of(places.infos[place], frame.mode, frame.largest_tolerance)), frame.origin);
  }
}

void ElementStage::find_ways(const BoxFrame& frame, const PolicyTable& policies, const Space& space,
                             const Places& places) {
  if (std::ranges::none_of(bodies_, [](const auto& its) { return its.second.has_moved; }) ||
      std::ranges::none_of(bodies_, [&](const auto& its) { return is_fast(its.first, places); })) {
    return;
  }
  for (auto& [place, body] : bodies_) {
    find_way(frame, place, places, body);
  }
  const auto may_meet = [&](std::uint32_t a, std::uint32_t b) {
    const PlaceInfo &info_a = places.infos[a], &info_b = places.infos[b];
    return info_a.part != info_b.part && (info_a.is_dynamic || info_b.is_dynamic) && space.is_shown(a) &&
           space.is_shown(b) && policies.of(info_a.tag, info_b.tag).detail == Detail::elements;
  };
  for (const auto& [fast, body] : bodies_) {
    if (!is_fast(fast, places)) {
      continue;
    }
    for (const auto& [place, other] : bodies_) {
      const bool is_taken = place == fast || (place < fast && is_fast(place, places));
      if (!is_taken && (body.has_moved || other.has_moved) && body.way.overlaps(other.way) && may_meet(fast, place)) {
        pairs_.push_back({std::min(fast, place), std::max(fast, place)});
      }
    }
  }
  std::ranges::sort(pairs_, is_before);
}

std::optional<ElementStage::FirstTouch> ElementStage::first_touch(
    const Workers& workers, const BoxFrame& frame, const PolicyTable& policies, const Space& space,
    std::span<const std::uint32_t> fresh, const LentVertices& lent, const Places& places,
    const std::function<Pose(std::uint32_t)>& end_of,
    const std::function<bool(std::uint32_t, std::uint32_t)>& holds_up) {
  std::vector<std::uint32_t> leading;  // places on the way to lent vertices
  read_fresh(policies, space, fresh, places);
  for (auto& [place, body] : bodies_) {
    if (!body.is_shown) {
      continue;
    }
    const std::span<const Vec3> next = lent.of(place);
    const bool leads = is_fast(place, places) && !next.empty();
    Triangles made;
    std::span<const Vec3> present = held_triangles(*places.shapes[place]).vertices;
    if (present.empty()) {
      made = triangles_of(*places.shapes[place]).value_or(Triangles{});
      present = made.vertices;
    }
    look_ahead(leads ? next : present, end_of(place), body);
    find_way(frame, place, places, body);
    if (leads) {
      leading.push_back(place);
    }
  }
  std::optional<FirstTouch> first;
  const auto look_at = [&](std::uint32_t low, std::uint32_t high) {
    const PlaceInfo &a = places.infos[low], &b = places.infos[high];
    const Policy& policy = policies.of(a.tag, b.tag);
    Body &of_low = bodies_.at(low), &of_high = bodies_.at(high);
    if (policy.detail != Detail::elements || !of_low.way.overlaps(of_high.way) || !holds_up(low, high)) {
      return;
    }
    find(workers, policy, std::max<Real>(margin_of(frame.mode, policy, a, b), 0), true, of_low, of_high);
    for (const Stencil& its : stencils_) {
      if (its.toi > 0 && (!first || its.toi < first->toi)) {
        first = {low, high, its.toi};
      }
    }
  };
  for (const std::uint32_t place : leading) {
    for (const auto& [other, body] : bodies_) {
      const PlaceInfo &its = places.infos[place], &of_other = places.infos[other];
      const bool is_taken = other < place && std::ranges::binary_search(leading, other);
      const bool may_meet =
          other == place ? its.has_self_pairs : its.part != of_other.part && (its.is_dynamic || of_other.is_dynamic);
      if (body.is_shown && may_meet && !is_taken) {
        look_at(std::min(place, other), std::max(place, other));
      }
    }
  }
  for (auto& [place, body] : bodies_) {
    look_back(body);
  }
  return first;
}

std::span<const ProxyPair> ElementStage::with(std::span<const ProxyPair> near) {
  if (pairs_.empty()) {
    return near;
  }
  joined_.assign(near.begin(), near.end());
  for (const ProxyPair& pair : pairs_) {
    if (!std::binary_search(near.begin(), near.end(), pair, is_before)) {
      joined_.push_back(pair);
    }
  }
  std::ranges::sort(joined_, is_before);
  return joined_;
}

namespace {

[[nodiscard]] bool is_reshaped(const Pair& pair, const Places& places) {
  return places.has_happened(pair.low, happened_to_shape) || places.has_happened(pair.high, happened_to_shape);
}

}  // namespace

bool ElementStage::keeps_all(std::span<const Pair> pairs, const Places& places) const {
  std::size_t at = 0;
  for (const Pair& pair : pairs) {
    if (pair.is_by_elements && pair.is_admitted) {
      if (pair.job != no_job || at == runs_.size() || !is_of(runs_[at], pair) || is_reshaped(pair, places)) {
        return false;
      }
      ++at;
    }
  }
  return at == runs_.size();
}

// All contacts become older, at no cost of theirs.
void ElementStage::keep_all(std::span<const Pair> pairs) {
  std::size_t at = 0;
  for (const Pair& pair : pairs) {
    if (pair.is_by_elements && pair.is_admitted) {
      runs_[at++].age += pair.is_covered ? 1 : 0;
    }
  }
}

// The elements of a body with its vertices where they are, or on their way there.
ElementBody& ElementStage::laid(Body& body, bool on_way, const Workers& workers) {
  if (!body.elements) {
    body.elements = std::make_unique<ElementBody>(body.rest, body.triangles, workers);
    body.is_laid = false;
  }
  const bool lies_on_way = on_way && body.has_moved;
  if (!body.is_laid || body.lies_on_way != lies_on_way) {
    const std::span<const Vec3> now(body.now);
    body.elements->move(lies_on_way ? body.start() : now, lies_on_way ? body.end() : now.first(0));
    body.is_laid = true;
    body.lies_on_way = lies_on_way;
  }
  return *body.elements;
}

void ElementStage::find(const Workers& workers, const Policy& policy, Real reach, bool on_way, Body& low, Body& high) {
  stencils_.clear();
  const auto starts_or_ends_too_far = [](const Body& body) {
    return are_too_far(body.start()) || are_too_far(body.end());
  };
  if (low.is_too_far || high.is_too_far || (on_way && (starts_or_ends_too_far(low) || starts_or_ends_too_far(high)))) {
    return;
  }
  ElementBody &a = laid(low, on_way, workers), &b = laid(high, on_way, workers);
  const ElementRule& rule = policy.elements;
  if (!on_way) {
    closest_.find(a, b, closest_options(rule, reach), workers, stencils_);
    return;
  }
  constexpr std::uint32_t kinds_on_way = bit(StencilKind::vertex_face) | bit(StencilKind::edge_edge);
  if (rule.kinds == 0 || (rule.kinds & kinds_on_way) != 0) {
    const TouchSettings touch{std::min(rule.contact_distance, reach), touch_tolerance};
    first_touches_.find(a, b, {rule.kinds & kinds_on_way, touch, rule.rest_distance}, workers, stencils_);
  }
}

void ElementStage::append(const Policy& policy, const Pair& pair, std::span<const ContactHistory> before,
                          std::uint32_t age) {
  index_.look_at(before);
  for (const Stencil& its : stencils_) {
    const std::uint64_t id = id_of(its);
    const std::uint32_t same = index_.place_of(id, before);
    const std::uint32_t begun = same == no_index ? age : before[same].age;
    contacts_.push_back({.geometry_a = {pair.low + 1, pair.generation_low},
                         .geometry_b = {pair.high + 1, pair.generation_high},
                         .stencil = its,
                         .gap = its.distance - policy.elements.contact_distance,
                         .id = id,
                         .begun = begun});
    histories_.push_back({id, 0, begun});
  }
}

void ElementStage::run(const Workers& workers, const PolicyTable& policies, Places& places, std::span<const Pair> pairs,
                       JobList& jobs) {
  if (tags_ == 0 && bodies_.empty() && runs_.empty()) {
    has_kept_all_ = true;
    return;
  }
  has_kept_all_ = keeps_all(pairs, places);
  if (has_kept_all_) {
    keep_all(pairs);
  } else {
    answer_pairs(workers, policies, places, pairs, jobs);
  }
  end_ways(places);
}

void ElementStage::answer_pairs(const Workers& workers, const PolicyTable& policies, const Places& places,
                                std::span<const Pair> pairs, JobList& jobs) {
  contacts_before_.swap(contacts_);
  histories_before_.swap(histories_);
  runs_before_.swap(runs_);
  contacts_.clear();
  histories_.clear();
  runs_.clear();
  std::size_t at = 0;
  for (const Pair& pair : pairs) {
    if (!pair.is_by_elements || !pair.is_admitted) {
      continue;
    }
    const auto is_before_pair = [&](const Run& run) {
      return std::tie(run.low, run.high) < std::tie(pair.low, pair.high);
    };
    while (at < runs_before_.size() && is_before_pair(runs_before_[at])) {
      ++at;
    }
    Run run{pair.low, pair.high, pair.generation_low, pair.generation_high, contacts_.size(), 0, 0};
    run.is_reshaped = is_reshaped(pair, places);
    const bool has_before = at < runs_before_.size() && is_of(runs_before_[at], pair) && !run.is_reshaped;
    const Run before = has_before ? runs_before_[at] : Run{};
    run.age = has_before ? before.age + (pair.is_covered ? 1 : 0) : 0;
    if (pair.job != no_job) {
      const Policy& policy = policies.at(pair.policy);
      const bool on_way = had_time_ && follows_vertices(pair, places.infos);
      find(workers, policy, std::max<Real>(jobs.jobs()[pair.job].margin, 0), on_way, body_at(pair.low, places),
           body_at(pair.high, places));
      append(policy, pair, histories_before(before), run.age);
      jobs.result(pair.job).is_touching = !stencils_.empty();
    } else {
      const auto kept = std::span(contacts_before_).subspan(before.first, before.count);
      contacts_.insert(contacts_.end(), kept.begin(), kept.end());
      const auto known = histories_before(before);
      histories_.insert(histories_.end(), known.begin(), known.end());
    }
    run.count = contacts_.size() - run.first;
    runs_.push_back(run);
  }
}

std::span<const ContactHistory> ElementStage::histories_before(const Run& run) const {
  return std::span(histories_before_).subspan(run.first, run.count);
}

const ElementStage::Run* ElementStage::find_run(std::span<const Run> runs, const Pair& pair) {
  const auto found = std::lower_bound(runs.begin(), runs.end(), pair, [](const Run& run, const Pair& its) {
    return std::tie(run.low, run.high) < std::tie(its.low, its.high);
  });
  return found == runs.end() || !is_of(*found, pair) ? nullptr : &*found;
}

std::span<const ContactHistory> ElementStage::histories_of(const Pair& pair) const {
  const Run* const run = find_run(runs_, pair);
  return run == nullptr ? std::span<const ContactHistory>() : std::span(histories_).subspan(run->first, run->count);
}

std::size_t ElementStage::first_of(const Pair& pair) const {
  const Run* const run = find_run(runs_, pair);
  return run == nullptr ? 0 : run->first;
}

std::span<const ContactHistory> ElementStage::histories_before_of(const Pair& pair, bool is_lost) const {
  if (has_kept_all_) {
    return is_lost ? std::span<const ContactHistory>() : histories_of(pair);
  }
  const Run* const run = is_lost ? nullptr : find_run(runs_, pair);
  const Run* const before = find_run(runs_before_, pair);
  const bool has_none = before == nullptr || (run != nullptr && run->is_reshaped);
  return has_none ? std::span<const ContactHistory>() : histories_before(*before);
}

void ElementStage::end_ways(Places& places) {
  for (auto& [place, body] : bodies_) {
    places.happened[place] &= static_cast<std::uint8_t>(~unsigned{happened_on_way});
    if (!had_time_) {
      continue;
    }
    body.was_on_way = body.has_moved;
    if (std::exchange(body.has_moved, false) || (body.is_shown && body.before.empty())) {
      body.before = body.now;
    }
  }
}

std::uint64_t ElementStage::hash_after(std::uint64_t hash) const {
  const auto add = [&](std::uint64_t word) { hash = scrambled(hash ^ word); };
  visit([&](const ElementContact& its, std::uint32_t age) {
    add(std::uint64_t{its.geometry_b.slot} << 32 | its.geometry_a.slot);
    add(its.id);
    add(age);
    add(std::bit_cast<std::uint64_t>(its.gap));
    for (std::size_t i = 0; i < its.stencil.vertices.size(); ++i) {
      add(its.stencil.vertices.at(i));
      add(std::bit_cast<std::uint64_t>(its.stencil.weights.at(i)));
    }
    for (const Real number :
         {its.stencil.normal.x, its.stencil.normal.y, its.stencil.normal.z, its.stencil.distance, its.stencil.toi}) {
      add(std::bit_cast<std::uint64_t>(number));
    }
  });
  return hash;
}

}  // namespace abut
