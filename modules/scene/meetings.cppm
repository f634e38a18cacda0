// SPDX-License-Identifier: Apache-2.0
// Who meets whom, and how.
export module abut.scene.meetings;
import abut.core.standard;
import abut.scene.options;
import abut.scene.places;
import abut.scene.policies;
import abut.scene.rules;

export namespace abut {

// Answers of the filter since it was set, or since it is asked about all pairs again.
struct FilterCounts {
  std::uint64_t asked = 0, kept = 0;
};

struct Meetings {
  using Filter = std::function<bool(GeometryId, GeometryId)>;

  Rules rules;
  Filter filter;                       // of the caller; may be empty
  mutable FilterCounts filter_counts;  // the thread that steps calls the filter and counts, no other
  PolicyTable policies;
  bool must_ask_again = false;  // set where one of these changes, cleared at the end of a detection

  // Of places that the broad phase has found, or of one that meets itself: of different parts, one of them dynamic, and
  // not parked. Layers, masks and exclusion speak of two geometries, not of one that meets itself.
  [[nodiscard]] bool admits(const Places& places, std::uint32_t low, std::uint32_t high) const {
    const PlaceInfo &a = places.infos[low], &b = places.infos[high];
    const bool are_kept_apart =
        low != high && ((a.exclusion & b.exclusion) != 0 || (a.layers & b.mask) == 0 || (b.layers & a.mask) == 0);
    if (are_kept_apart) {
      return false;
    }
    const GeometryId first = places.id_at(low), second = places.id_at(high);
    return (rules.is_empty() || rules.allows({first, a.part, a.label}, {second, b.part, b.label})) &&
           (!filter || ask_filter(first, second));
  }
  [[nodiscard]] std::size_t bytes() const { return rules.bytes() + policies.bytes(); }

 private:
  [[nodiscard]] bool ask_filter(GeometryId first, GeometryId second) const {
    const bool is_kept = filter(first, second);
    ++filter_counts.asked;
    filter_counts.kept += is_kept ? 1 : 0;
    return is_kept;
  }
};

}  // namespace abut
