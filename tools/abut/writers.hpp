// SPDX-License-Identifier: Apache-2.0
// Contacts, element contacts and events of steps as rows.
#pragma once

#include <cstdint>
#include <string>

#include "table.hpp"
#include "world.hpp"

namespace cli {

class ContactWriter {
 public:
  ContactWriter(const std::string& path, Format format);
  /// Adds the contacts of the last step of a world.
  void add(const World& world, std::uint64_t step);
  void finish() { table_.finish(); }

 private:
  Table table_;
};

/// Pairs of vertices, edges and faces that are near or touch, with the vertices and weights of their stencils.
class ElementWriter {
 public:
  ElementWriter(const std::string& path, Format format);
  /// Adds the element contacts of the last step of a world.
  void add(const World& world, std::uint64_t step);
  void finish() { table_.finish(); }

 private:
  Table table_;
};

class EventWriter {
 public:
  EventWriter(const std::string& path, Format format);
  /// Adds the events of the last step of a world.
  void add(const World& world, std::uint64_t step);
  void finish() { table_.finish(); }

 private:
  Table table_;
};

}  // namespace cli
