// SPDX-License-Identifier: Apache-2.0
#include "csv.hpp"

#include <array>
#include <charconv>
#include <concepts>
#include <fstream>
#include <string>
#include <string_view>

namespace demo {
namespace {

// Builds rows and writes them to a file. Throws Failure when the file cannot be written.
class Table {
 public:
  explicit Table(const std::filesystem::path& path) : path_(path), out_(path, std::ios::binary) {
    if (!out_) {
      throw Failure("cannot write " + path_.string());
    }
  }

  Table& text(std::string_view value) {
    separate();
    row_ += value;
    return *this;
  }

  Table& integer(std::uint64_t value) {
    separate();
    row_ += std::to_string(value);
    return *this;
  }

  Table& real(double value, int decimals) {
    separate();
    std::array<char, 64> digits{};
    const auto result =
        std::to_chars(digits.data(), std::to_address(digits.end()), value, std::chars_format::fixed, decimals);
    if (result.ec == std::errc{}) {
      row_.append(digits.data(), result.ptr);
    }
    return *this;
  }

  Table& vector(const Vec3& value, int decimals) {
    return real(value.x, decimals).real(value.y, decimals).real(value.z, decimals);
  }

  void end_row() {
    out_ << row_ << '\n';
    row_.clear();
    first_ = true;
  }

  void close() {
    out_.close();
    if (!out_) {
      throw Failure("cannot write all of " + path_.string());
    }
  }

 private:
  void separate() {
    if (!first_) {
      row_ += ',';
    }
    first_ = false;
  }

  std::filesystem::path path_;
  std::ofstream out_;
  std::string row_;
  bool first_ = true;
};

std::string_view name_of_feature(abut_feature_kind kind) {
  constexpr std::array<std::string_view, 4> names{"whole", "vertex", "edge", "face"};
  return kind < names.size() ? names[kind] : "unknown";
}

void add_side(Table& table, const Owner& owner, const abut_feature& feature) {
  table.integer(owner.body).text(name_of(owner.kind)).integer(owner.piece);
  table.text(name_of_feature(feature.kind)).integer(feature.index);
}

}  // namespace

void write_contacts(const std::filesystem::path& path, std::uint32_t step, std::span<const abut_contact> contacts,
                    const Scene& scene) {
  constexpr int micrometres = 6;
  constexpr int direction_decimals = 9;
  Table table(path);
  table.text("step,body_a,kind_a,piece_a,feature_a,feature_index_a,body_b,kind_b,piece_b,feature_b,feature_index_b")
      .text("contact_id,point_a_x_m,point_a_y_m,point_a_z_m,point_b_x_m,point_b_y_m,point_b_z_m")
      .text("normal_x,normal_y,normal_z,distance_m")
      .end_row();
  for (const abut_contact& contact : contacts) {
    table.integer(step);
    add_side(table, scene.owner(contact.geometry_a), contact.feature_a);
    add_side(table, scene.owner(contact.geometry_b), contact.feature_b);
    table.integer(contact.id).vector(contact.point_a, micrometres).vector(contact.point_b, micrometres);
    table.vector(contact.normal, direction_decimals).real(contact.distance, micrometres);
    table.end_row();
  }
  table.close();
}

void write_cloth(const std::filesystem::path& path, const Cloth& cloth) {
  constexpr int micrometres = 6;
  constexpr int direction_decimals = 9;
  constexpr std::array<std::string_view, 4> kinds{"vertex_face", "edge_edge", "vertex_edge", "vertex_vertex"};
  Table table(path);
  table.text("other,kind,element_a,element_b,contact_id,x_m,y_m,z_m,normal_x,normal_y,normal_z,distance_m,gap_m")
      .end_row();
  for (const abut_element_contact& contact : cloth.contacts()) {
    const abut_stencil& its = contact.stencil;
    table.text(cloth.is_on_bunny(contact) ? name_of(Kind::statue) : name_of(Kind::cloth));
    table.text(kinds.at(its.kind)).integer(its.element_a).integer(its.element_b).integer(contact.id);
    table.vector(cloth.middle_of(contact), micrometres).vector(its.normal, direction_decimals);
    table.real(its.distance, micrometres).real(contact.gap, micrometres).end_row();
  }
  table.close();
}

void write_steps(const std::filesystem::path& path, std::span<const abut_step_stats> steps) {
  Table table(path);
  table.text("step,time_s,geometries,moved,candidate_pairs,touching_pairs,contacts,unsupported_pairs").end_row();
  std::uint64_t number = 0;
  for (const abut_step_stats& stats : steps) {
    ++number;
    table.integer(number).real(step_seconds * static_cast<double>(number), 2).integer(stats.geometries);
    table.integer(stats.moved).integer(stats.candidate_pairs).integer(stats.touching_pairs);
    table.integer(stats.contacts).integer(stats.unsupported_pairs).end_row();
  }
  table.close();
}

}  // namespace demo
