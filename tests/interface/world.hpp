// SPDX-License-Identifier: Apache-2.0
// Everything that a call of the C interface may be about: a universe with four geometries of each of some kinds, each
// on a part of its own, and what extension libraries put on it.
#pragma once

#include "support.hpp"

#ifdef ABUT_TABLE_HAS_PICKING
#include <abut/picking.h>
#endif
#ifdef ABUT_TABLE_HAS_RESPONSE
#include <abut/response.h>
#endif

namespace abut_test::table {

class World {
 public:
  static constexpr std::size_t of_a_kind = 4;

  World();
  World(const World&) = delete;
  World& operator=(const World&) = delete;
  ~World();

  static std::size_t kinds();
  const abut_shape* shape(std::size_t kind) const { return shapes_.at(kind); }
  abut_part_id part(std::size_t kind, std::size_t index) const { return parts_.at(of_a_kind * kind + index); }
  abut_geometry_id geometry(std::size_t kind, std::size_t index) const {
    return geometries_.at(of_a_kind * kind + index);
  }
  // The object that a parameter of this type names.
  const void* object(std::string_view type, std::size_t kind) const;
  const std::vector<std::uint64_t>& stale(std::string_view type) const {
    return type == "abut_part_id" ? stale_parts_ : stale_geometries_;
  }
  // What a universe or a response was saved as.
  const std::vector<unsigned char>& saved(std::size_t which) const { return saved_.at(which % saved_.size()); }

  abut_universe* universe() const { return universe_; }
  bool is_unchanged() const { return state() == before_; }

 private:
  std::vector<unsigned char> state() const;
  void add_extensions();

  Universe universe_;
  Universe other_;  // with the same slots in use
  std::vector<Shape> shapes_;
  std::vector<abut_part_id> parts_;
  std::vector<abut_geometry_id> geometries_;
  std::vector<std::uint64_t> stale_parts_, stale_geometries_;
  std::vector<std::vector<unsigned char>> saved_;
  std::vector<unsigned char> before_;
  abut_elements* elements_ = nullptr;
#ifdef ABUT_TABLE_HAS_PICKING
  abut_picker* picker_ = nullptr;
#endif
#ifdef ABUT_TABLE_HAS_RESPONSE
  abut_response* response_ = nullptr;
#endif
};

// Takes back what a call has made.
void release(std::string_view type, void* object);

}  // namespace abut_test::table
