// SPDX-License-Identifier: Apache-2.0
// What queries have in common: whom they look at, and how they keep what they find.
export module abut.queries.filter;
import abut.core;
import abut.core.standard;
import abut.math;
import abut.scene;
import abut.scene.state.places;
import abut.queries;

export namespace abut {

// Ids of what is no longer there are nobody's.
[[nodiscard]] inline bool admits(const QueryFilter& filter, const Scene& scene, std::uint32_t place) {
  const PlaceInfo& info = scene.info_at(place);
  return (info.layers & filter.mask) != 0 && (info.mask & filter.layers) != 0 &&
         !(filter.skips_sensors && info.is_sensor) && info.part != filter.ignored_part &&
         scene.id_at(place) != filter.ignored_geometry;
}

// Hits by the way at which they are met. Visitors of a sweep answer with limit(), below which all else is left out.
template <class Hit>
class Hits {
 public:
  Hits(HitMode mode, Real most) : mode_(mode), limit_(most) {}

  [[nodiscard]] Real limit() const { return limit_; }

  void add(const Hit& hit, Real way) {
    if (mode_ == HitMode::all) {
      found_.push_back({way, hit});
      return;
    }
    if (!first_ || is_before({way, hit}, *first_)) {
      first_ = {way, hit};
    }
    limit_ = mode_ == HitMode::any ? -1 : std::min(limit_, way);
  }

  // Where not all are wanted.
  [[nodiscard]] std::optional<Hit> first() const { return first_ ? std::optional(first_->hit) : std::nullopt; }
  [[nodiscard]] std::vector<Hit> in_order() {
    std::vector<Hit> hits;
    if (first_) {
      hits.push_back(first_->hit);
    }
    std::ranges::sort(found_, is_before);
    hits.reserve(hits.size() + found_.size());
    for (const Entry& entry : found_) {
      hits.push_back(entry.hit);
    }
    return hits;
  }

 private:
  struct Entry {
    Real way;
    Hit hit;
  };
  [[nodiscard]] static bool is_before(const Entry& a, const Entry& b) {
    return std::tuple(a.way, a.hit.geometry.slot) < std::tuple(b.way, b.hit.geometry.slot);
  }

  HitMode mode_;
  Real limit_;
  std::optional<Entry> first_;  // of a mode that wants one
  std::vector<Entry> found_;    // of one that wants all
};

}  // namespace abut
