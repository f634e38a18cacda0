// SPDX-License-Identifier: Apache-2.0
// What of element contacts is saved with a universe, and how much memory they take.
module abut.detect.elements;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.pairs.any_shape;
import abut.proximity.body;
import abut.proximity.stencil;
import abut.scene.meetings.policies;
import abut.scene.state.options;
import abut.scene.state.places;

namespace abut {
namespace {

[[nodiscard]] bool are_finite(std::span<const Vec3> vertices) {
  return std::ranges::all_of(vertices, [](const Vec3& vertex) { return is_finite(vertex); });
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

std::vector<ElementStage::SavedBody> ElementStage::saved_bodies() const {
  std::vector<SavedBody> saved;
  for (const auto& [place, body] : bodies_) {
    saved.push_back({place, body.generation, body.was_on_way, body.rest, body.before});
  }
  return saved;
}

// Each with its age, as ages of pairs are of no interest.
std::vector<ElementContact> ElementStage::saved_contacts() const {
  std::vector<ElementContact> saved;
  saved.reserve(contacts_.size());
  visit([&](const ElementContact& its, std::uint32_t age) {
    saved.push_back(its);
    saved.back().begun = age;
  });
  return saved;
}

// Contacts of one pair follow each other. They began before the pair was of age 0, so to speak.
void ElementStage::make_runs() {
  runs_.clear();
  histories_.clear();
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    const GeometryId &a = contacts_[i].geometry_a, &b = contacts_[i].geometry_b;
    if (i == 0 || a != contacts_[i - 1].geometry_a || b != contacts_[i - 1].geometry_b) {
      runs_.push_back({a.slot - 1, b.slot - 1, a.generation, b.generation, i, 0, 0});
    }
    ++runs_.back().count;
    contacts_[i].begun = 0 - contacts_[i].begun;
    histories_.push_back({contacts_[i].id, 0, contacts_[i].begun});
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
                    (histories_.capacity() + histories_before_.capacity()) * sizeof(ContactHistory) + index_.bytes() +
                    (runs_.capacity() + runs_before_.capacity()) * sizeof(Run);
  for (const auto& [place, body] : bodies_) {
    sum += sizeof(Bodies::value_type) +
           (body.rest.capacity() + body.now.capacity() + body.before.capacity() + body.next.capacity()) * sizeof(Vec3) +
           body.triangles.capacity() * sizeof(std::uint32_t) + (body.elements ? body.elements->bytes() : 0);
  }
  return sum;
}

}  // namespace abut
