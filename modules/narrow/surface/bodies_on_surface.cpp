// SPDX-License-Identifier: Apache-2.0
module abut.narrow.surface.bodies_on_surface;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.narrow.parts.nearest_of_parts;
import abut.narrow.triangle.stopping_sides;
import abut.narrow.ways.translation_search;

namespace abut {
namespace {

// The places of a body are kept apart from those of others by their lanes.
NearPlace place_of(const NearPlace& at, std::size_t body) { return {at.four, 4 * body + at.lane}; }
std::size_t body_at(const NearPlace& at) { return at.lane / 4; }

class AllBodies final : public Obstacles {
 public:
  explicit AllBodies(const BodiesOnSurface& bodies) : bodies_(bodies), terms_(bodies[0]->begin()) {
    for (std::size_t i = 1; i < bodies.size(); ++i) {
      const TranslationSearch own = bodies[i]->begin();
      terms_.deepest_way = own.least > terms_.least ? own.deepest_way : terms_.deepest_way;
      terms_.least = std::max(terms_.least, own.least);
      terms_.size = std::max(terms_.size, own.size);
      terms_.tolerance = std::max(terms_.tolerance, own.tolerance);
      terms_.first = std::max(terms_.first, own.first);
      terms_.far = std::max(terms_.far, own.far);
      terms_.most_polishes = std::max(terms_.most_polishes, own.most_polishes);
    }
  }

  [[nodiscard]] const TranslationSearch& terms() const { return terms_; }

  // In turn, each from where the others have come, up to the one that was last to go on.
  SurfaceExit exit_along(const Vec3& direction, Real enough) override {
    constexpr int most_rounds = 256;
    SurfaceExit all;
    std::size_t last = bodies_.size();
    for (int round = 0; round < most_rounds; ++round) {
      const Real before = all.length;
      for (std::size_t i = 0; i < bodies_.size() && i != last; ++i) {
        SurfaceExit own = bodies_[i]->exit_along(direction, all.length, enough);
        for (SurfaceTouch& touch : own.touches.span()) {
          touch.at = place_of(touch.at, i);
        }
        if (own.is_stopped) {
          return own;
        }
        const Real so_far = all.length;
        for (const SurfaceTouch& touch : own.touches.span()) {
          static_cast<void>(all.note(touch, tie_of(terms_.tolerance, terms_.size)));
        }
        for (const SurfaceExit::Back& back : own.backs.span()) {
          all.backs.push_back_if(back, all.backs.size() < 4);
        }
        all.length = std::max(all.length, own.length);
        last = all.length > so_far + terms_.tolerance ? i : last;
      }
      if (!(all.length > before + terms_.tolerance)) {
        all.settle(tie_of(terms_.tolerance, terms_.size), 4 * terms_.tolerance);
        return all;
      }
    }
    all.stop({direction, infinity, {}});
    all.touches.clear();
    return all;
  }
  void visit_planes(const TakePlane& take) const override {
    for (const auto& body : bodies_) {
      body->obstacles().visit_planes(take);
    }
  }
  void visit_single_ways(const TakeStart& take) const override {
    for (const auto& body : bodies_) {
      body->obstacles().visit_single_ways(take);
    }
  }
  Real least_by(const SeparatingTranslation& translation) override {
    return translation.touches.empty() ? 0 : body_of(translation).obstacles().least_by(own_part(translation));
  }
  void visit_own_directions(bool are_few, std::span<const TranslationStart> starts,
                            const TakeStart& take) const override {
    for (const auto& body : bodies_) {
      body->obstacles().visit_own_directions(are_few, starts, take);
    }
  }

  [[nodiscard]] Vec3 last_point(const SeparatingTranslation& translation) const {
    return body_of(translation).last_point(own_part(translation));
  }

 private:
  [[nodiscard]] BodyOnSurface& body_of(const SeparatingTranslation& translation) const {
    return *bodies_[body_at(last_touch(translation).at)];
  }
  // What the body that is last to leave touches, as it knows it.
  [[nodiscard]] static SeparatingTranslation own_part(const SeparatingTranslation& translation) {
    const std::size_t body = body_at(last_touch(translation).at);
    SeparatingTranslation own = translation;
    own.touches.clear();
    for (SurfaceTouch touch : translation.touches.span()) {
      if (body_at(touch.at) == body) {
        touch.at.lane %= 4;
        own.touches.push_back(touch);
      }
    }
    return own;
  }

  const BodiesOnSurface& bodies_;
  TranslationSearch terms_;
};

}  // namespace

bool depth_of_bodies(const BodiesOnSurface& bodies, StoppingSides sides, Distance& out) {
  if (std::ranges::none_of(bodies, [](const auto& body) { return body->is_met(); })) {
    return false;
  }
  AllBodies all(bodies);
  const SeparatingTranslation found = find_translation(all, all.terms());
  if (found.touches.empty()) {
    return false;
  }
  out = no_distance();
  out.distance = -found.length;
  out.lower = -found.length - all.terms().tolerance;
  out.upper = -std::min(found.least, found.length) + all.terms().tolerance;
  out.normal = found.direction;
  out.point_b = all.last_point(found);
  out.point_a = out.point_b + found.length * found.direction;
  out.algorithm = sides == StoppingSides::solid ? Algorithm::solid : Algorithm::separating_translation;
  out.iterations = 1;
  return true;
}

}  // namespace abut
