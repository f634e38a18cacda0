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

// Those of some numbers, as one body.
class [[gsl::Pointer]] AllBodies final : public Obstacles {
 public:
  AllBodies(const BodiesOnSurface& bodies, std::span<const std::size_t> numbers)
      : bodies_(bodies), numbers_(numbers.begin(), numbers.end()), terms_(at(0).begin()) {
    for (std::size_t i = 0; i < size(); ++i) {
      const TranslationSearch own = at(i).begin();
      order_.push_back(i);
      centres_.push_back(at(i).centre());
      least_.push_back(own.least);
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

  // In turn, each from where the others have come, up to the one that was last to go on. The one that stood in the way
  // lately comes first: it mostly does again. Then those that mostly leave first: they let later ones in.
  SurfaceExit exit_along(const Vec3& direction, Real enough) override {
    constexpr int most_rounds = 256;
    SurfaceExit all;
    std::size_t last = size();
    raisers_.clear();
    sort_along(direction);
    for (int round = 0; round < most_rounds; ++round) {
      const Real before = all.length;
      for (const std::size_t i : order_) {
        if (i == last) {
          break;
        }
        SurfaceExit own = at(i).exit_along(direction, all.length, enough);
        for (SurfaceTouch& touch : own.touches.span()) {
          touch.at = place_of(touch.at, i);
        }
        if (own.is_stopped) {
          first_ = i;
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
        if (all.length > so_far + terms_.tolerance) {
          last = i;
          raisers_.push_back(numbers_[i]);
        }
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
    for (const std::size_t number : numbers_) {
      bodies_[number]->obstacles().visit_planes(take);
    }
  }
  void visit_single_ways(const TakeStart& take) const override {
    for (const std::size_t number : numbers_) {
      bodies_[number]->obstacles().visit_single_ways(take);
    }
  }
  Real least_by(const SeparatingTranslation& translation) override {
    return translation.touches.empty() ? 0 : body_of(translation).obstacles().least_by(own_part(translation));
  }
  void visit_own_directions(bool are_few, std::span<const TranslationStart> starts,
                            const TakeStart& take) const override {
    for (const std::size_t number : numbers_) {
      bodies_[number]->obstacles().visit_own_directions(are_few, starts, take);
    }
  }

  // The numbers of those that the last question found further than the ones before.
  [[nodiscard]] std::span<const std::size_t> raisers() const [[clang::lifetimebound]] { return raisers_; }
  // The numbers of those that are deepest by themselves.
  [[nodiscard]] std::vector<std::size_t> deepest(std::size_t most) const {
    std::vector<std::size_t> places(size());
    std::iota(places.begin(), places.end(), std::size_t{0});
    std::ranges::sort(places, {}, [&](std::size_t i) { return std::pair(-least_[i], i); });
    std::vector<std::size_t> found;
    for (const std::size_t place : std::span(places).first(std::min(most, size()))) {
      found.push_back(numbers_[place]);
    }
    return found;
  }

  [[nodiscard]] Vec3 last_point(const SeparatingTranslation& translation) const {
    return body_of(translation).last_point(own_part(translation));
  }

 private:
  void sort_along(const Vec3& direction) {
    along_.clear();
    for (const Vec3& centre : centres_) {
      along_.push_back(dot(centre, direction));
    }
    along_[first_] = infinity;
    std::ranges::sort(order_, {}, [&](std::size_t i) { return std::pair(-along_[i], i); });
  }
  [[nodiscard]] std::size_t size() const { return numbers_.size(); }
  [[nodiscard]] BodyOnSurface& at(std::size_t place) const { return *bodies_[numbers_[place]]; }
  [[nodiscard]] BodyOnSurface& body_of(const SeparatingTranslation& translation) const {
    return at(body_at(last_touch(translation).at));
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
  std::vector<std::size_t> numbers_;
  TranslationSearch terms_;
  std::vector<Vec3> centres_;
  std::vector<Real> least_, along_;
  std::vector<std::size_t> order_, raisers_;
  std::size_t first_ = 0;
};

struct FoundTogether {
  SeparatingTranslation translation;
  Real tolerance;
  Vec3 last_point;
};
// A search asks each body for each direction. So of many it looks at few, then asks all along what it has found, and
// takes in those that stand in the way.
std::optional<FoundTogether> find_together(const BodiesOnSurface& bodies) {
  constexpr std::size_t few = 24;
  constexpr int most_rounds = 12;
  std::vector<std::size_t> numbers(bodies.size());
  std::iota(numbers.begin(), numbers.end(), std::size_t{0});
  AllBodies all(bodies, numbers);
  const Real tolerance = all.terms().tolerance;
  if (bodies.size() <= few) {
    SeparatingTranslation found = find_translation(all, all.terms());
    if (found.touches.empty()) {
      return std::nullopt;
    }
    return FoundTogether{found, tolerance, all.last_point(found)};
  }
  numbers = all.deepest(few);
  for (int round = 0;; ++round) {
    AllBodies some(bodies, numbers);
    SeparatingTranslation found = find_translation(some, some.terms());
    if (found.touches.empty()) {
      return std::nullopt;
    }
    const SurfaceExit whole = all.exit_along(found.direction, infinity);
    const std::size_t before = numbers.size();
    for (const std::size_t number : all.raisers()) {
      if (std::ranges::find(numbers, number) == numbers.end()) {
        numbers.push_back(number);
      }
    }
    if (whole.length <= found.length + tolerance || numbers.size() == before || round == most_rounds) {
      if (whole.is_stopped || whole.touches.empty()) {
        return std::nullopt;
      }
      found.length = whole.length;
      found.touches = whole.touches;
      return FoundTogether{found, tolerance, all.last_point(found)};
    }
  }
}

}  // namespace

bool depth_of_bodies(const BodiesOnSurface& bodies, StoppingSides sides, Distance& out) {
  if (std::ranges::none_of(bodies, [](const auto& body) { return body->is_met(); })) {
    return false;
  }
  const auto together = find_together(bodies);
  if (!together) {
    return false;
  }
  const SeparatingTranslation& found = together->translation;
  out = no_distance();
  out.distance = -found.length;
  out.lower = -found.length - together->tolerance;
  out.upper = -std::min(found.least, found.length) + together->tolerance;
  out.normal = found.direction;
  out.point_b = together->last_point;
  out.point_a = out.point_b + found.length * found.direction;
  out.algorithm = sides == StoppingSides::solid ? Algorithm::solid : Algorithm::separating_translation;
  out.iterations = 1;
  return true;
}

}  // namespace abut
