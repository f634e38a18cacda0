// SPDX-License-Identifier: Apache-2.0
// Who meets whom, and how.
//
// The reason why two geometries do not collide comes from the same data as detection: these filters, the kept pairs and
// the boxes. The filter of the caller is not called, since it may have side effects; its last answer counts.
export module abut.scene.meetings;
import abut.core.standard;
import abut.scene.state.options;
import abut.scene.state.places;
import abut.scene.meetings.policies;
import abut.scene.meetings.rules;

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
    if (low != high && (are_excluded(a, b) || are_of_strange_layers(a, b))) {
      return false;
    }
    return rules.allows(side_of(places, low), side_of(places, high)) &&
           (!filter || ask_filter(places.id_at(low), places.id_at(high)));
  }
  // Why two places are not admitted, as bits of ApartReason; the filter is not asked.
  [[nodiscard]] std::uint32_t reasons(const Places& places, std::uint32_t low, std::uint32_t high) const {
    const PlaceInfo &a = places.infos[low], &b = places.infos[high];
    const auto bit_if = [](bool is_one, ApartReason bit) { return is_one ? std::uint32_t{bit} : 0; };
    std::uint32_t bits = bit_if(!rules.allows(side_of(places, low), side_of(places, high)), apart_by_rule);
    if (low == high) {
      return bits | bit_if(!a.has_self_pairs, apart_by_part);
    }
    bits |= bit_if(a.part == b.part, apart_by_part) | bit_if(!a.is_dynamic && !b.is_dynamic, apart_by_motion);
    return bits | bit_if(are_excluded(a, b), apart_by_exclusion) | bit_if(are_of_strange_layers(a, b), apart_by_layers);
  }
  [[nodiscard]] static RuleSide side_of(const Places& places, std::uint32_t place) {
    return {places.id_at(place), places.infos[place].part, places.infos[place].label};
  }
  [[nodiscard]] std::size_t bytes() const { return rules.bytes() + policies.bytes(); }

 private:
  [[nodiscard]] static bool are_excluded(const PlaceInfo& a, const PlaceInfo& b) {
    return (a.exclusion & b.exclusion) != 0;
  }
  [[nodiscard]] static bool are_of_strange_layers(const PlaceInfo& a, const PlaceInfo& b) {
    return (a.layers & b.mask) == 0 || (b.layers & a.mask) == 0;
  }
  [[nodiscard]] bool ask_filter(GeometryId first, GeometryId second) const {
    const bool is_kept = filter(first, second);
    ++filter_counts.asked;
    filter_counts.kept += is_kept ? 1 : 0;
    return is_kept;
  }
};

}  // namespace abut
