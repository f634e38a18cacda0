// SPDX-License-Identifier: Apache-2.0
#include "accuracy_file.hpp"

#include <algorithm>
#include <fstream>
#include <stdexcept>
#include <utility>

#include "abut_inputs.hpp"
#include "agreement.hpp"
#include "statistics.hpp"

namespace bench {
namespace {

using Json = RowFile::Json;

Json shape_of(const Solid& solid) {
  Json shape{{"kind", abut_kind_name(solid)}};
  const Point& s = solid.sizes;
  switch (solid.kind) {
    case Kind::point: break;
    case Kind::sphere: shape["radius"] = s[0]; break;
    case Kind::capsule:
    case Kind::cylinder:
    case Kind::cone:
      shape["radius"] = s[0];
      shape["half_height"] = s[1];
      break;
    case Kind::box: shape["half"] = s; break;
    case Kind::ellipsoid: shape["radius"] = s; break;
    case Kind::hull32:
    case Kind::hull200:
    case Kind::hull: shape["points"] = solid.points; break;
    case Kind::mesh:
    case Kind::solid_mesh:
      shape["vertices"] = solid.points;
      shape["triangles"] = solid.triangles;
      shape["sides"] = solid.kind == Kind::solid_mesh ? 2 : 0;
      break;
    case Kind::plane: shape["normal"] = Point{0, 0, 1}; break;
    case Kind::height_field: {
      const auto side = static_cast<std::size_t>(s[0]);
      shape["spacing_x"] = shape["spacing_y"] = s[1];
      for (std::size_t i = 0; i < solid.points.size(); ++i) {
        shape["heights"][i / side].push_back(solid.points[i][2]);
      }
      break;
    }
    case Kind::distance_field: {
      const double half = 0.5 * (s[0] - 1) * s[1];
      shape["columns"] = shape["rows"] = s[0];
      shape["layers"] = field_layers;
      shape["spacing"] = Point{s[1], s[1], s[1]};
      shape["origin"] = Point{-half, -half, -field_depth(solid)};
      shape["is_inside_out"] = false;
      shape["reals"] = abut_reals(solid);
      break;
    }
    case Kind::particles:
      shape["radius"] = s[0];
      shape["centres"] = solid.points;
      break;
    case Kind::composite:
      for (const Point& p : solid.points) {
        shape["children"].push_back({{"shape", {{"kind", "box"}, {"half", s}}}, {"pose", {{"position", p}}}});
      }
      break;
    case Kind::triangle: throw std::runtime_error("no scene is written of a " + std::string(kind_name(solid.kind)));
  }
  return shape;
}

// Scenes of more triangles than that are left to the reader.
constexpr std::size_t most_triangles = 2048;

Json pose_of(const Placement& placement) {
  return {{"position", placement.position}, {"quaternion", placement.orientation}};
}

}  // namespace

std::size_t RowFile::number_of(std::map<std::string, std::size_t>& numbers, Json& list, Json value) {
  const auto [place, is_new] = numbers.try_emplace(value.dump(), list.size());
  if (is_new) {
    list.push_back(std::move(value));
  }
  return place->second;
}

void RowFile::add(const Json& labels, const Row& row, const JudgedCell& cell) {
  Json its{{"question", query_name(row.query)}};
  its.update(labels);
  its["contender"] = entrants()[row.entrant].name;
  its["nanoseconds"] = row.nanoseconds;
  if (!row.errors.empty()) {
    its["median"] = median(row.errors);
    its["p99"] = percentile(row.errors, 99);
    its["worst"] = *std::ranges::max_element(row.errors);
  }
  its["cases"] = row.cases;
  its["failures"] = {{"ended", row.failed.ended},
                     {"none", row.failed.none},
                     {"not_finite", row.failed.not_finite},
                     {"wrong_side", row.failed.wrong_side}};
  if (row.query == Query::contacts) {
    its["points"] = row.points;
  }
  if (row.broken) {
    its["broken"] = {{"outside", row.broken->outside}, {"beyond", row.broken->beyond}, {"wide", row.broken->wide}};
  }
  if (cell.solids_a.front().triangles.size() <= most_triangles) {
    its["worst_pair"] = number_of_pair(row, cell);
  }
  rows_.push_back(std::move(its));
}

std::size_t RowFile::number_of_pair(const Row& row, const JudgedCell& cell) {
  const Case& worst = cell.cases.at(row.worst);
  Json pair{{"a", number_of(shape_numbers_, shapes_, shape_of(cell.solids_a[worst.a]))},
            {"pose_a", pose_of(worst.pose_a)},
            {"b", number_of(shape_numbers_, shapes_, shape_of(cell.solids_b[worst.b]))},
            {"pose_b", pose_of(worst.pose_b)},
            {"truth", static_cast<double>(cell.truths[row.worst])}};
  const bool is_impact = row.query == Query::impact;
  if (row.query == Query::cast || row.query == Query::ray || is_impact) {
    pair["motion"] = worst.motion;
  }
  if (is_impact) {
    pair["turn"] = worst.turn;
  }
  return number_of(pair_numbers_, pairs_, std::move(pair));
}

void RowFile::write(const std::filesystem::path& path, const Json& settings) const {
  Json document = settings;
  document["shapes"] = shapes_;
  document["pairs"] = pairs_;
  document["rows"] = rows_;
  std::ofstream file(path);
  file << document.dump() << '\n';
  if (!file.flush()) {
    throw std::runtime_error(path.string() + " cannot be written");
  }
}

}  // namespace bench
