// SPDX-License-Identifier: Apache-2.0
// Contacts, element contacts, events, and motion of bodies as rows.
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

/// Where the bodies of a scene with a response are after a step, and how fast.
class StateWriter {
 public:
  StateWriter(const std::string& path, Format format);
  void add(const World& world, std::uint64_t step);
  void finish() { table_.finish(); }

 private:
  Table table_;
};

/// Energy and errors of a scene with a response, a row for each step.
class MotionWriter {
 public:
  MotionWriter(const std::string& path, Format format);
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
