// SPDX-License-Identifier: Apache-2.0
#include "subject.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace edit_fuzzing {
namespace {

// Meshes and grids of cells: vertices are numbered row by row.
class Sheet : public Subject {
 public:
  explicit Sheet(const Record& first) : is_grid_(first.pick(1, 2) == 1) {
    const auto side = static_cast<std::uint32_t>(2 + first.pick(2, 6));
    for (std::size_t i = 0; i < 3; ++i) {
      across_.at(i) = (i + first.pick(3, 3)) % 3;
    }
    parameters_ = {static_cast<double>(first.pick(4, 2))};
    if (is_grid_) {
      for (const std::size_t axis : {across_[0], across_[1]}) {
        parameters_.push_back(static_cast<double>(axis));
      }
      for (const std::size_t byte : {5U, 6U}) {
        parameters_.push_back(static_cast<double>(first.pick(byte, 9)));
      }
    }
    fill(first, side);
  }

  abut_status change(abut_universe* universe, abut_geometry_id geometry, const Record& record) override {
    switch (record.pick(0, 8)) {
      case 0: return remove(universe, geometry, record);
      case 1: return make_anew(universe, geometry, record);
      case 2:
      case 3: return move_range(universe, geometry, record);
      default: return move_listed(universe, geometry, record);
    }
  }
  [[nodiscard]] Shape made_anew() const override {
    std::vector<std::uint32_t> left;
    for (std::size_t i = 0; i < indices_.size(); i += 3) {
      if (!has_gone(i)) {
        left.insert(left.end(), {indices_[i], indices_[i + 1], indices_[i + 2]});
      }
    }
    return made(is_grid_ ? "uv_grid" : "mesh", parameters_, xyz_, left);
  }
  [[nodiscard]] bool stops_from_the_front_only() const override { return parameters_[0] == 1; }
  [[nodiscard]] std::vector<Triangle> triangles() const override {
    std::vector<Triangle> out;
    for (std::size_t i = 0; i < indices_.size(); i += 3) {
      if (!has_gone(i)) {
        out.push_back({vertex(indices_[i]), vertex(indices_[i + 1]), vertex(indices_[i + 2])});
      }
    }
    return out;
  }

 private:
  [[nodiscard]] bool has_gone(std::size_t i) const {
    return indices_[i] == indices_[i + 1] && indices_[i] == indices_[i + 2];
  }
  [[nodiscard]] Point vertex(std::uint32_t number) const {
    return {xyz_[3 * number], xyz_[3 * number + 1], xyz_[3 * number + 2]};
  }
  void fill(const Record& record, std::uint32_t side) {
    xyz_.clear();
    indices_.clear();
    for (std::uint32_t j = 0; j <= side; ++j) {
      for (std::uint32_t i = 0; i <= side; ++i) {
        Point place{};
        place.at(across_[0]) = 4.0 * i / side - 2;
        place.at(across_[1]) = 4.0 * j / side - 2;
        place.at(across_[2]) = record.number(7 + (3 * i + 5 * j) % 8);
        xyz_.insert(xyz_.end(), place.begin(), place.end());
        const std::uint32_t k = j * (side + 1) + i;
        if (i < side && j < side) {
          indices_.insert(indices_.end(), {k, k + 1, k + side + 2, k, k + side + 2, k + side + 1});
        }
      }
    }
  }
  // A vertex of a grid moves along the third axis only: most records keep to that, and the others are refused.
  [[nodiscard]] Point moved(std::uint32_t number, const Record& record) const {
    Point place = vertex(number);
    place.at(across_[2]) += record.number(8 + number % 8);
    if (!is_grid_ || record.pick(1, 16) == 15) {
      place.at(across_[0]) += record.number(8 + (number + 1) % 8) / 4;
      place.at(across_[1]) += record.number(8 + (number + 2) % 8) / 4;
    }
    return place;
  }
  void place(std::uint32_t number, const Point& place) {
    std::ranges::copy(place, xyz_.begin() + std::ptrdiff_t{3} * number);
  }
  abut_status move_listed(abut_universe* universe, abut_geometry_id geometry, const Record& record) {
    std::vector<std::uint32_t> vertices;
    std::vector<Point> places;
    for (std::size_t i = 0; i <= record.pick(2, 4); ++i) {
      vertices.push_back(static_cast<std::uint32_t>(record.bytes.at(3 + i) % (xyz_.size() / 3)));
      places.push_back(moved(vertices.back(), record));
    }
    const abut_status status =
        abut_geometry_set_vertices_at(universe, geometry, vertices.data(), places.front().data(), vertices.size());
    for (std::size_t i = 0; i < vertices.size() && status == ABUT_OK; ++i) {
      place(vertices[i], places[i]);
    }
    return status;
  }
  abut_status move_range(abut_universe* universe, abut_geometry_id geometry, const Record& record) {
    const std::size_t all = xyz_.size() / 3, first = record.bytes[3] % all;
    const std::size_t count = std::min(all - first, 1 + record.pick(4, 12));
    std::vector<Point> places;
    for (std::size_t i = 0; i < count; ++i) {
      places.push_back(moved(static_cast<std::uint32_t>(first + i), record));
    }
    const abut_status status =
        abut_geometry_set_vertices(universe, geometry, first, places.front().data(), places.size());
    for (std::size_t i = 0; i < count && status == ABUT_OK; ++i) {
      place(static_cast<std::uint32_t>(first + i), places[i]);
    }
    return status;
  }
  abut_status remove(abut_universe* universe, abut_geometry_id geometry, const Record& record) {
    std::vector<std::uint32_t> going;
    for (std::size_t i = 0; i <= record.pick(2, 8); ++i) {
      going.push_back(static_cast<std::uint32_t>(record.bytes.at(3 + i) % (indices_.size() / 3)));
    }
    const abut_status status = abut_geometry_remove_triangles(universe, geometry, going.data(), going.size());
    for (const std::uint32_t triangle : going) {
      if (status == ABUT_OK) {
        const std::size_t corner = std::size_t{3} * triangle;
        indices_[corner + 1] = indices_[corner + 2] = indices_[corner];
      }
    }
    return status;
  }
  abut_status make_anew(abut_universe* universe, abut_geometry_id geometry, const Record& record) {
    fill(record, static_cast<std::uint32_t>(2 + record.pick(2, 6)));
    return abut_geometry_set_mesh(universe, geometry, xyz_.data(), xyz_.size() / 3, indices_.data(),
                                  indices_.size() / 3);
  }

  bool is_grid_;
  std::array<std::size_t, 3> across_{};
  std::vector<double> parameters_, xyz_;
  std::vector<std::uint32_t> indices_;
};

class Heights : public Subject {
 public:
  explicit Heights(const Record& first)
      : columns_(2 + first.pick(1, 7)), rows_(2 + first.pick(2, 7)), diagonal_(first.pick(3, 3)) {
    for (std::size_t i = 0; i < columns_ * rows_; ++i) {
      heights_.push_back(first.number(8 + i % 8));
    }
  }
  abut_status change(abut_universe* universe, abut_geometry_id geometry, const Record& record) override {
    const std::size_t column = record.pick(1, columns_), row = record.pick(2, rows_);
    const std::size_t columns = std::min(columns_ - column, 1 + record.pick(3, 4)),
                      rows = std::min(rows_ - row, 1 + record.pick(4, 4));
    std::vector<double> values, wanted = heights_;
    for (std::size_t j = 0; j < rows; ++j) {
      for (std::size_t i = 0; i < columns; ++i) {
        const std::size_t byte = 5 + (3 * i + j) % 11;
        values.push_back(record.bytes.at(byte) % 16 == 15 ? std::numeric_limits<double>::quiet_NaN()
                                                          : record.number(byte));
        wanted[(row + j) * columns_ + column + i] = values.back();
      }
    }
    const abut_status status = abut_geometry_set_heights(
        universe, geometry, static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(row),
        static_cast<std::uint32_t>(columns), static_cast<std::uint32_t>(rows), values.data());
    heights_ = status == ABUT_OK ? wanted : heights_;
    return status;
  }
  [[nodiscard]] Shape made_anew() const override {
    return made(
        "height_field",
        {static_cast<double>(columns_), static_cast<double>(rows_), spacing, spacing, static_cast<double>(diagonal_)},
        heights_, {});
  }
  [[nodiscard]] std::vector<Triangle> triangles() const override {
    std::vector<Triangle> out;
    const auto add = [&](const Point& a, const Point& b, const Point& c) {
      if (!std::isnan(a[2] + b[2] + c[2])) {
        out.push_back({a, b, c});
      }
    };
    for (std::size_t j = 0; j + 1 < rows_; ++j) {
      for (std::size_t i = 0; i + 1 < columns_; ++i) {
        const Point a = sample(i, j), b = sample(i + 1, j), c = sample(i + 1, j + 1), d = sample(i, j + 1);
        const bool is_rising = diagonal_ == 0 || (diagonal_ == 2 && (i + j) % 2 == 0);
        add(a, b, is_rising ? c : d);
        add(is_rising ? a : b, c, d);
      }
    }
    return out;
  }

 private:
  static constexpr double spacing = 0.5;
  [[nodiscard]] Point sample(std::size_t i, std::size_t j) const {
    return {spacing * static_cast<double>(i), spacing * static_cast<double>(j), heights_[j * columns_ + i]};
  }

  std::size_t columns_, rows_, diagonal_;
  std::vector<double> heights_;
};

class Cloud : public Subject {
 public:
  explicit Cloud(const Record& first) : count_(1 + first.pick(1, 40)), has_radii_(first.pick(2, 2) == 1) {
    for (std::size_t i = 0; i < count_; ++i) {
      numbers_.push_back({2 * first.number(4 + i % 12), 2 * first.number(4 + (i + i / 12 + 1) % 12),
                          first.number(4 + (i + i / 5) % 12)});
      radii_.push_back(has_radii_ ? 0.1 + 0.05 * static_cast<double>(i % 4) : radius);
    }
  }
  abut_status change(abut_universe* universe, abut_geometry_id geometry, const Record& record) override {
    const std::size_t first = record.bytes[1] % count_, count = std::min(count_ - first, 1 + record.pick(2, 8));
    const bool sets_radii = record.pick(3, 4) == 0;
    std::vector<Point> centres;
    std::vector<double> radii;
    for (std::size_t i = 0; i < count; ++i) {
      centres.push_back({2 * record.number(4 + i % 12), 2 * record.number(5 + i % 11), record.number(6 + i % 10)});
      radii.push_back(0.15 + 0.1 * record.number(7 + i % 9));
    }
    const abut_status status = abut_geometry_set_particles(universe, geometry, first, centres.front().data(),
                                                           sets_radii ? radii.data() : nullptr, count);
    for (std::size_t i = 0; i < count && status == ABUT_OK; ++i) {
      numbers_[first + i] = centres[i];
      radii_[first + i] = sets_radii ? radii[i] : radii_[first + i];
    }
    return status;
  }
  [[nodiscard]] Shape made_anew() const override {
    std::vector<double> reals;
    for (std::size_t i = 0; i < count_; ++i) {
      reals.insert(reals.end(), numbers_[i].begin(), numbers_[i].end());
      if (has_radii_) {
        reals.push_back(radii_[i]);
      }
    }
    return made("particles", {has_radii_ ? 0 : radius}, reals, {});
  }
  [[nodiscard]] std::vector<Ball> balls() const override {
    std::vector<Ball> out;
    for (std::size_t i = 0; i < count_; ++i) {
      out.push_back({numbers_[i], radii_[i]});
    }
    return out;
  }

 private:
  static constexpr double radius = 0.2;
  std::size_t count_;
  bool has_radii_;
  std::vector<Point> numbers_;
  std::vector<double> radii_;
};

// Values near those of a ball.
class Field : public Subject {
 public:
  explicit Field(const Record& first) : is_inside_out_(first.pick(1, 4) == 3) {
    for (std::size_t i = 0; i < samples * samples * samples; ++i) {
      const auto along = [&](std::size_t place) { return spacing * static_cast<double>(place % samples) - 1.5; };
      const double away = std::hypot(along(i), along(i / samples), along(i / samples / samples));
      values_.push_back(away - 1 + 0.1 * first.number(2 + i % 14));
    }
  }
  abut_status change(abut_universe* universe, abut_geometry_id geometry, const Record& record) override {
    std::array<std::size_t, 3> first{}, count{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      first.at(axis) = record.pick(1 + axis, samples);
      count.at(axis) = std::min(samples - first.at(axis), 1 + record.pick(4 + axis, 4));
    }
    std::vector<double> values, wanted = values_;
    for (std::size_t k = 0; k < count[2]; ++k) {
      for (std::size_t j = 0; j < count[1]; ++j) {
        for (std::size_t i = 0; i < count[0]; ++i) {
          const std::size_t at = ((first[2] + k) * samples + first[1] + j) * samples + first[0] + i;
          values.push_back(values_[at] + 0.3 * record.number(7 + (i + 2 * j + 3 * k) % 9));
          wanted[at] = values.back();
        }
      }
    }
    const auto number = [](std::size_t value) { return static_cast<std::uint32_t>(value); };
    const abut_status status =
        abut_geometry_set_field_values(universe, geometry, number(first[0]), number(first[1]), number(first[2]),
                                       number(count[0]), number(count[1]), number(count[2]), values.data());
    values_ = status == ABUT_OK ? wanted : values_;
    return status;
  }
  [[nodiscard]] Shape made_anew() const override {
    constexpr double all = samples;
    return made("distance_field",
                {all, all, all, spacing, spacing, spacing, -1.5, -1.5, -1.5, is_inside_out_ ? 1.0 : 0.0}, values_, {});
  }

 private:
  static constexpr std::size_t samples = 13;
  static constexpr double spacing = 0.25;
  bool is_inside_out_;
  std::vector<double> values_;
};

}  // namespace

Shape made(const char* kind, const std::vector<double>& parameters, const std::vector<double>& reals,
           const std::vector<std::uint32_t>& indices) {
  abut_shape_desc desc;
  abut_shape_desc_init(&desc, sizeof desc);
  desc.kind = abut_shape_kind_by_name(kind);
  desc.parameters = parameters.data();
  desc.parameter_count = parameters.size();
  desc.reals = reals.data();
  desc.real_count = reals.size();
  desc.indices = indices.data();
  desc.index_count = indices.size();
  abut_shape* out = nullptr;
  if (abut_shape_create(&desc, &out) != ABUT_OK) {
    throw std::runtime_error(std::string(kind) + " cannot be made anew: " + abut_last_error_message());
  }
  return Shape(out);
}

std::unique_ptr<Subject> subject_of(const Record& first) {
  switch (first.pick(0, 6)) {
    case 0: return std::make_unique<Heights>(first);
    case 1: return std::make_unique<Cloud>(first);
    case 2: return std::make_unique<Field>(first);
    default: return std::make_unique<Sheet>(first);
  }
}

}  // namespace edit_fuzzing
