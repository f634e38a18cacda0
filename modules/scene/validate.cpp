// SPDX-License-Identifier: Apache-2.0
// What is odd about a scene.
module abut.scene;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.pairs.any_shape;
import abut.scene.meetings;
import abut.scene.meetings.rules;

namespace abut {
namespace {

// Boxes are in single precision: where their rounding is this share of a shape, pairs are found that are far from
// touching.
constexpr Real coarse_share = 0.01;
constexpr Real float_epsilon = 0x1p-24;

std::string named(GeometryId id) { return "geometry " + std::to_string(id.slot); }

Real smallest_side(const Aabb& box) {
  const Vec3 sides = box.high - box.low;
  return std::min({sides.x, sides.y, sides.z});
}
Real largest_side(const Aabb& box) {
  const Vec3 sides = box.high - box.low;
  return std::max({sides.x, sides.y, sides.z});
}

// Of a kind the first geometry that moves, or else the first, and another one.
struct SeenKind {
  GeometryId first, second;
  bool is_moving = false;
};
using SeenKinds = std::array<SeenKind, shape_kind_count>;

void find_unsupported(const SeenKinds& seen, std::vector<Finding>& findings) {
  for (std::size_t row = 0; row < shape_kind_count; ++row) {
    for (std::size_t column = row; column < shape_kind_count; ++column) {
      const GeometryId a = seen[row].first, b = row == column ? seen[row].second : seen[column].first;
      const bool can_meet = !a.is_null() && !b.is_null() && (seen[row].is_moving || seen[column].is_moving);
      if (can_meet && !is_supported(row, column)) {
        findings.push_back({FindingCode::kinds_unsupported, a, b,
                            named(a) + " and " + named(b) + " are of the kinds " + std::string(kind_name(row)) +
                                " and " + std::string(kind_name(column)) +
                                ", which have no algorithm together, by declaration"});
      }
    }
  }
}

}  // namespace

// What leaves no pair of the scene at all. One geometry alone is no scene.
void Scene::find_what_hides_all(std::vector<Finding>& findings) const {
  const auto report = [&](FindingCode code, std::string message) {
    findings.push_back({code, {}, {}, std::move(message)});
  };
  const FilterCounts& filter = meetings_.filter_counts;
  if (meetings_.filter && filter.asked > 0 && filter.kept == 0) {
    report(FindingCode::filter_keeps_none,
           "the filter was asked about pairs " + std::to_string(filter.asked) + " times and has kept none");
  }
  if (geometries_.size() < 2) {
    return;
  }
  bool is_any_dynamic = false;
  parts_.for_each(
      [&](PartId, const Part& part) { is_any_dynamic = is_any_dynamic || part.motion == MotionKind::dynamic; });
  if (!is_any_dynamic) {
    report(FindingCode::nothing_moves, "no part is dynamic, so no pair is ever examined");
  }
  std::uint64_t common_exclusion = ~std::uint64_t{0};
  std::uint32_t first_part = 0;
  bool are_on_one_part = true;
  geometries_.for_each([&](GeometryId, const Geometry& geometry) {
    common_exclusion &= geometry.options.exclusion;
    first_part = first_part == 0 ? geometry.part.slot : first_part;
    are_on_one_part = are_on_one_part && geometry.part.slot == first_part;
  });
  if (common_exclusion != 0) {
    report(FindingCode::exclusion_in_common, "all geometries have the exclusion bit " +
                                                 std::to_string(std::countr_zero(common_exclusion)) +
                                                 " in common, so none meets another one");
  }
  if (are_on_one_part) {
    report(FindingCode::all_on_one_part,
           "all geometries are on part " + std::to_string(first_part) + "; those of one part never meet each other");
  }
  if (meetings_.rules.disable_all()) {
    report(FindingCode::rule_disables_all, "a rule disables any with any, and no rule enables a pair");
  }
  if (parked_count_ == geometries_.size()) {
    report(FindingCode::all_parked, "all geometries are parked, so none is in a contact or found by a query");
  }
}

std::vector<Finding> Scene::validate() const {
  std::vector<Finding> findings;
  const auto report = [&](FindingCode code, GeometryId geometry, GeometryId other, std::string message) {
    findings.push_back({code, geometry, other, std::move(message)});
  };
  find_what_hides_all(findings);

  SeenKinds seen{};
  std::uint64_t all_layers = 0, all_masks = 0;
  geometries_.for_each([&](GeometryId id, const Geometry& geometry) {
    const bool is_dynamic = parts_.at(geometry.part).motion == MotionKind::dynamic;
    SeenKind& its = seen[places_.infos[id.slot - 1].kind];
    const bool comes_first = its.first.is_null() || (is_dynamic && !its.is_moving);
    its.second = comes_first ? its.first : its.second.is_null() ? id : its.second;
    its.first = comes_first ? id : its.first;
    its.is_moving = its.is_moving || is_dynamic;
    all_layers |= geometry.options.layers;
    all_masks |= geometry.options.mask;
  });
  geometries_.for_each([&](GeometryId id, const Geometry& geometry) {
    const GeometryOptions& options = geometry.options;
    if (options.layers == 0 || options.mask == 0) {
      report(FindingCode::meets_nothing, id, {},
             named(id) + " has no " + (options.layers == 0 ? "layers" : "mask") + ", so it meets nothing");
    } else if ((options.layers & all_masks) == 0 || (options.mask & all_layers) == 0) {
      report(FindingCode::excluded_from_all, id, {},
             named(id) + " meets no layer that any geometry has, or none meets its own");
    }
    const Aabb local = aabb_of(*places_.shapes[id.slot - 1], Pose::identity());
    if (!local.is_bounded()) {
      return;
    }
    if (options.tolerance > smallest_side(local) && smallest_side(local) > 0) {
      report(FindingCode::tolerance_too_large, id, {},
             named(id) + " has a tolerance of " + to_text(options.tolerance) + ", more than its smallest side of " +
                 to_text(smallest_side(local)));
    }
    const Vec3 position = world_of(geometry).position - options_.origin;
    if (norm(position) * float_epsilon > coarse_share * largest_side(local) && largest_side(local) > 0) {
      report(FindingCode::far_from_origin, id, {},
             named(id) + " lies " + to_text(norm(position)) +
                 " from the origin of the universe, where boxes are coarser than a hundredth of it");
    }
  });
  find_unsupported(seen, findings);
  find_odd_meshes(findings);
  std::ranges::sort(findings, {},
                    [](const Finding& its) { return std::tuple(its.code, its.geometry.slot, its.other.slot); });
  return findings;
}

}  // namespace abut
