// SPDX-License-Identifier: Apache-2.0
// The shapes of a scene, by name, and those that are written where they are used.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "node.hpp"

namespace cli {

class Shapes {
 public:
  explicit Shapes(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Makes all shapes of {"name": {"kind": ..., ...}, ...}.
  void read(const std::optional<Node>& node);

  /// The shape that a node means: the name of one, or one written out. Owned by this object.
  [[nodiscard]] const abut_shape* resolve(const Node& node);

  /// x, y, z of all vertices in a model beside the scene.
  [[nodiscard]] std::vector<double> vertices_of(const Node& file) const;

  /// A copy of a composite from which its holes are left out; none for a shape that has no holes, or nothing else.
  [[nodiscard]] ShapeOwner without_holes(const abut_shape* shape) const;

  /// Lets go of the document; nothing can be resolved from then on.
  void forget_document() { declarations_.reset(); }

  /// Names of the kinds of all shapes, children of composites among them.
  [[nodiscard]] const std::set<std::string, std::less<>>& kinds() const { return kinds_; }

  [[nodiscard]] std::size_t count() const { return named_.size() + unnamed_.size(); }

 private:
  struct Child {
    const abut_shape* shape;
    abut_pose pose;
  };

  ShapeOwner make(const Node& node);
  ShapeOwner make_composite(Fields& fields);
  ShapeOwner make_field_of_mesh(Fields& fields);
  ShapeOwner make_simple(Fields& fields, const std::string& kind);
  const abut_shape* named(const Node& declared, const std::string& name);

  std::filesystem::path folder_;
  std::optional<Node> declarations_;
  std::map<std::string, ShapeOwner> named_;
  std::vector<ShapeOwner> unnamed_;
  std::map<const abut_shape*, std::vector<Child>> children_;  // of composites
  std::set<std::string> in_progress_;
  std::set<std::string, std::less<>> kinds_;
};

}  // namespace cli
