// SPDX-License-Identifier: Apache-2.0
// What is wrong with ids and placements that a caller hands over, in words.
export module abut.scene.meetings.checks;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.pairs.any_shape;
import abut.scene.state.options;

export namespace abut {

[[nodiscard]] inline std::string name_at(std::string_view array, std::size_t index) {
  return std::string(array) + "[" + std::to_string(index) + "]";
}

[[nodiscard]] inline Error stale(const std::string& name) {
  return {Errc::stale_id, name + " is stale or belongs to another universe"};
}

template <class Map, class Id>
[[nodiscard]] std::optional<Error> check_ids(const Map& map, std::span<const Id> ids, std::string_view array) {
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (!map.contains(ids[i])) {
      return stale(name_at(array, i));
    }
  }
  return std::nullopt;
}

// Marks each value of a batch that is to be erased. The first id that is stale, or named before,
// takes all marks off again.
template <class Map, class Id>
[[nodiscard]] std::optional<Error> mark_all(Map& map, std::span<const Id> ids, std::string_view array) {
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (!map.contains(ids[i]) || map.at(ids[i]).is_marked) {
      for (const Id& id : ids.first(i)) {
        map.at(id).is_marked = false;
      }
      return stale(name_at(array, i));
    }
    map.at(ids[i]).is_marked = true;
  }
  return std::nullopt;
}

[[nodiscard]] inline Fault check_placement(const Placement& placement, std::string_view array, std::size_t index) {
  const auto [w, x, y, z] = placement.orientation;
  const Real square = w * w + x * x + y * y + z * z;
  if (!is_finite(placement.position) || !std::isfinite(square)) {
    return Error{Errc::not_finite, name_at(array, index) + " has a NaN or an infinity in it; it must be finite"};
  }
  // Twice the relative error of a length that is off by 1e-3.
  if (!(std::fabs(square - 1) <= 2.001e-3)) {
    return Error{Errc::not_unit, name_at(array, index) + " has an orientation of length " + to_text(std::sqrt(square)) +
                                     "; it must be 1 within 1e-3"};
  }
  return std::nullopt;
}

[[nodiscard]] inline Fault check_self_pairs(const GeometryOptions& options, std::size_t kind) {
  if (options.has_self_pairs && !meets_itself(kind)) {
    return Error{Errc::unsupported,
                 "flags asks for self pairs, for which a " + std::string(kind_name(kind)) + " has no algorithm"};
  }
  return std::nullopt;
}

[[nodiscard]] inline Fault check_options(const GeometryOptions& options, std::size_t index) {
  if (Fault fault = check_placement(options.local, "options", index)) {
    return fault;
  }
  if (Fault fault = check_not_negative("tolerance", options.tolerance)) {
    return Error{fault->code, name_at("options", index) + "." + fault->message};
  }
  if (options.tag >= tag_count) {
    return error_about(Errc::out_of_range, name_at("options", index) + ".tag", std::uint64_t{options.tag},
                       "below " + std::to_string(tag_count));
  }
  return std::nullopt;
}

}  // namespace abut
