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

[[nodiscard]] bool are_too_far(std::span<const Vec3> vertices) {
  return std::ranges::any_of(vertices,
                             [](const Vec3& vertex) { return !(largest_magnitude(vertex) <= farthest_vertex); });
}

[[nodiscard]] bool are_finite(std::span<const Vec3> vertices) {
  return std::ranges::all_of(vertices, [](const Vec3& vertex) { return is_finite(vertex); });
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

// Whether what was read is what a detection may have found.
[[nodiscard]] bool is_right(const ElementContact& its) {
  constexpr Real slack = 1e-6;
  const Stencil& stencil = its.stencil;
  return stencil.kind <= StencilKind::vertex_vertex && stencil.of_a >= 1 && stencil.of_a <= 3 &&
         std::fabs(squared_norm(stencil.normal) - 1) <= slack && stencil.distance >= 0 &&
         std::isfinite(stencil.distance) && stencil.toi >= 0 && stencil.toi <= 1 && std::isfinite(its.gap) &&
         std::ranges::all_of(stencil.weights, [](Real weight) { return std::isfinite(weight); });
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
  Triangles surface = triangles_of(*places.shapes[place]).value_or(Triangles{});
  for (Vec3& vertex : surface.vertices) {
    vertex = places.worlds[place] * vertex;
  }
  const bool is_new = places.has_happened(place, happened_to_shape) || body.rest.size() != surface.vertices.size();
  if (is_new || body.triangles != surface.indices) {
    body.elements.reset();
    body.triangles = std::move(surface.indices);
  }
  if (is_new) {
    body.rest = surface.vertices;
    body.before.clear();
  }
  body.now = std::move(surface.vertices);
  body.has_moved = !body.before.empty() && body.now != body.before;
  body.is_laid = false;
  body.is_too_far = are_too_far(body.now);
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

bool ElementStage::follow(const BoxFrame& frame, const PolicyTable& policies, const Space& space,
                          std::span<const std::uint32_t> fresh, bool has_time, Places& places) {
  const bool has_other_tags = std::exchange(tags_, policies.tags_of_elements()) != policies.tags_of_elements();
  if (tags_ == 0 && bodies_.empty() && pairs_.empty()) {
    return false;
  }
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

void ElementStage::find_ways(const BoxFrame& frame, const PolicyTable& policies, const Space& space,
                             const Places& places) {
  const auto is_fast = [&](std::uint32_t place) { return places.infos[place].sweeping == Sweeping::impacts; };
  if (std::ranges::none_of(bodies_, [](const auto& its) { return its.second.has_moved; }) ||
      std::ranges::none_of(bodies_, [&](const auto& its) { return is_fast(its.first); })) {
    return;
  }
  for (auto& [place, body] : bodies_) {
    body.way = places.boxes[place];
    if (body.has_moved) {
      Aabb box = box_around(body.now);
      box.include(box_around(body.before));
      body.way =
          compact(box.inflated(reach_of(places.infos[place], frame.mode, frame.largest_tolerance)), frame.origin);
    }
  }
  const auto may_meet = [&](std::uint32_t a, std::uint32_t b) {
    const PlaceInfo &info_a = places.infos[a], &info_b = places.infos[b];
    return info_a.part != info_b.part && (info_a.is_dynamic || info_b.is_dynamic) && space.is_shown(a) &&
           space.is_shown(b) && policies.of(info_a.tag, info_b.tag).detail == Detail::elements;
  };
  for (const auto& [fast, body] : bodies_) {
    if (!is_fast(fast)) {
      continue;
    }
    for (const auto& [place, other] : bodies_) {
      const bool is_taken = place == fast || (place < fast && is_fast(place));
      if (!is_taken && (body.has_moved || other.has_moved) && body.way.overlaps(other.way) && may_meet(fast, place)) {
        pairs_.push_back({std::min(fast, place), std::max(fast, place)});
      }
    }
  }
  std::ranges::sort(pairs_, is_before);
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

bool ElementStage::keeps_all(std::span<const Pair> pairs) const {
  std::size_t at = 0;
  for (const Pair& pair : pairs) {
    if (pair.is_by_elements && pair.is_admitted) {
      if (pair.job != no_job || at == runs_.size() || !is_of(runs_[at], pair)) {
        return false;
      }
      ++at;
    }
  }
  return at == runs_.size();
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
    body.elements->move(lies_on_way ? std::span<const Vec3>(body.before) : now, lies_on_way ? now : now.first(0));
    body.is_laid = true;
    body.lies_on_way = lies_on_way;
  }
  return *body.elements;
}

void ElementStage::find(const Workers& workers, const Policy& policy, Real reach, const Pair& pair,
                        const Places& places) {
  stencils_.clear();
  Body &low = body_at(pair.low, places), &high = body_at(pair.high, places);
  const bool on_way = had_time_ && follows_vertices(pair, places.infos);
  if (low.is_too_far || high.is_too_far || (on_way && (are_too_far(low.before) || are_too_far(high.before)))) {
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

void ElementStage::append(const Policy& policy, const Pair& pair) {
  for (const Stencil& its : stencils_) {
    contacts_.push_back({.geometry_a = {pair.low + 1, pair.generation_low},
                         .geometry_b = {pair.high + 1, pair.generation_high},
                         .stencil = its,
                         .gap = its.distance - policy.elements.contact_distance,
                         .id = id_of(its)});
  }
}

void ElementStage::run(const Workers& workers, const PolicyTable& policies, Places& places, std::span<const Pair> pairs,
                       JobList& jobs) {
  if (tags_ == 0 && bodies_.empty() && runs_.empty()) {
    return;
  }
  if (!keeps_all(pairs)) {
    contacts_before_.swap(contacts_);
    runs_before_.swap(runs_);
    contacts_.clear();
    runs_.clear();
    std::size_t before = 0;
    for (const Pair& pair : pairs) {
      if (!pair.is_by_elements || !pair.is_admitted) {
        continue;
      }
      const std::size_t first = contacts_.size();
      while (before < runs_before_.size() &&
             std::tie(runs_before_[before].low, runs_before_[before].high) < std::tie(pair.low, pair.high)) {
        ++before;
      }
      if (pair.job != no_job) {
        const Policy& policy = policies.at(pair.policy);
        find(workers, policy, std::max<Real>(jobs.jobs()[pair.job].margin, 0), pair, places);
        append(policy, pair);
        jobs.result(pair.job).is_touching = !stencils_.empty();
      } else if (before < runs_before_.size() && is_of(runs_before_[before], pair)) {
        const auto kept = std::span(contacts_before_).subspan(runs_before_[before].first, runs_before_[before].count);
        contacts_.insert(contacts_.end(), kept.begin(), kept.end());
      }
      runs_.push_back(
          {pair.low, pair.high, pair.generation_low, pair.generation_high, first, contacts_.size() - first});
    }
  }
  end_ways(places);
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
  for (const ElementContact& its : contacts_) {
    add(std::uint64_t{its.geometry_b.slot} << 32 | its.geometry_a.slot);
    add(its.id);
    add(std::bit_cast<std::uint64_t>(its.gap));
    for (std::size_t i = 0; i < its.stencil.vertices.size(); ++i) {
      add(its.stencil.vertices.at(i));
      add(std::bit_cast<std::uint64_t>(its.stencil.weights.at(i)));
    }
    for (const Real number :
         {its.stencil.normal.x, its.stencil.normal.y, its.stencil.normal.z, its.stencil.distance, its.stencil.toi}) {
      add(std::bit_cast<std::uint64_t>(number));
    }
  }
  return hash;
}

std::vector<ElementStage::SavedBody> ElementStage::saved_bodies() const {
  std::vector<SavedBody> saved;
  for (const auto& [place, body] : bodies_) {
    saved.push_back({place, body.generation, body.was_on_way, body.rest, body.before});
  }
  return saved;
}

// Contacts of one pair follow each other.
void ElementStage::make_runs() {
  runs_.clear();
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    const GeometryId &a = contacts_[i].geometry_a, &b = contacts_[i].geometry_b;
    if (i == 0 || a != contacts_[i - 1].geometry_a || b != contacts_[i - 1].geometry_b) {
      runs_.push_back({a.slot - 1, b.slot - 1, a.generation, b.generation, i, 0});
    }
    ++runs_.back().count;
  }
}

// A body whose shape is another one since, or that has gone, waits for the next detection.
bool ElementStage::restore(const Places& places, const PolicyTable& policies) {
  tags_ = policies.tags_of_elements();
  const std::size_t count = places.infos.size();
  for (SavedBody& its : std::exchange(saved_, {})) {
    const bool is_body = its.place < count && (its.before.empty() || its.before.size() == its.rest.size());
    if (!is_body || !are_finite(its.rest) || !are_finite(its.before)) {
      return false;
    }
    Body& body = bodies_[its.place];
    body.generation = its.generation;
    body.was_on_way = its.was_on_way;
    body.rest = std::move(its.rest);
    body.before = std::move(its.before);
    const std::optional<Triangles> surface = triangles_of(*places.shapes[its.place]);
    const bool is_same =
        surface && surface->vertices.size() == body.rest.size() && !places.has_happened(its.place, happened_to_shape);
    if (is_same && may_have_pairs(its.place, places)) {
      read(its.place, places, body);
    }
  }
  for (const ElementContact& its : contacts_) {
    const bool is_there =
        its.geometry_a.slot >= 1 && its.geometry_a.slot <= its.geometry_b.slot && its.geometry_b.slot <= count;
    if (!is_there || !is_right(its)) {
      return false;
    }
  }
  make_runs();
  return std::ranges::is_sorted(
      runs_, [](const Run& a, const Run& b) { return std::tie(a.low, a.high) < std::tie(b.low, b.high); });
}

std::size_t ElementStage::bytes() const {
  std::size_t sum = (pairs_.capacity() + pairs_before_.capacity() + joined_.capacity()) * sizeof(ProxyPair) +
                    stencils_.capacity() * sizeof(Stencil) + closest_.bytes() + first_touches_.bytes() +
                    (contacts_.capacity() + contacts_before_.capacity()) * sizeof(ElementContact) +
                    (runs_.capacity() + runs_before_.capacity()) * sizeof(Run);
  for (const auto& [place, body] : bodies_) {
    sum += sizeof(Bodies::value_type) +
           (body.rest.capacity() + body.now.capacity() + body.before.capacity()) * sizeof(Vec3) +
           body.triangles.capacity() * sizeof(std::uint32_t) + (body.elements ? body.elements->bytes() : 0);
  }
  return sum;
}

}  // namespace abut
