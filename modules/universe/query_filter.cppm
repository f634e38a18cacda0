// What queries have in common: whom they look at, and how they keep what they find.
export module abut.universe.query_filter;
import abut.core;
import abut.core.standard;
import abut.math;
import abut.universe;
import abut.universe.queries;

export namespace abut {

// Ids of what is no longer there are nobody's.
[[nodiscard]] inline bool admits(const QueryFilter& filter, const Universe& universe, std::uint32_t place) {
  const GeometryOptions& options = universe.options_at(place);
  return (options.layers & filter.mask) != 0 && (options.mask & filter.layers) != 0 &&
         !(filter.skips_sensors && options.is_sensor) && universe.part_at(place) != filter.ignored_part &&
         universe.id_at(place) != filter.ignored_geometry;
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
    if (found_.empty() || is_before({way, hit}, found_.front())) {
      found_.assign(1, {way, hit});
    }
    limit_ = mode_ == HitMode::any ? -1 : std::min(limit_, way);
  }

  [[nodiscard]] std::vector<Hit> in_order() {
    std::ranges::sort(found_, is_before);
    std::vector<Hit> hits;
    hits.reserve(found_.size());
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
  std::vector<Entry> found_;
};

}  // namespace abut
