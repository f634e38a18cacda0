// SPDX-License-Identifier: Apache-2.0
#include "shapes.hpp"

#include "nearest.hpp"
#include "parameters.hpp"
#include "pose_reader.hpp"
#include "shape_arrays.hpp"

namespace cli {
namespace {

std::vector<std::string> kind_names() {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < abut_shape_kind_count(); ++i) {
    names.emplace_back(abut_shape_kind_name(abut_shape_kind_at(i)));
  }
  return names;
}

bool is_hole(const abut_shape* shape) {
  return std::string_view(abut_shape_kind_name(abut_shape_kind_of(shape))).ends_with("_hole");
}

}  // namespace

void Shapes::read(const std::optional<Node>& node) {
  if (!node) {
    return;
  }
  declarations_ = node;
  for (const auto& [name, shape] : node->entries("shapes by name")) {
    static_cast<void>(named(shape, name));
  }
}

const abut_shape* Shapes::resolve(const Node& node) {
  if (node.is_object()) {
    unnamed_.push_back(make(node));
    return unnamed_.back().get();
  }
  const bool exists = node.is_text() && declarations_ && declarations_->has(node.text());
  if (!exists) {
    std::vector<std::string> known;
    for (const auto& [name, shape] : declarations_ ? declarations_->entries("shapes by name") : NamedNodes{}) {
      known.push_back(name);
    }
    const std::string there = node.is_text() ? what_there_is("named shape", node.text(), known) : "";
    node.refuse("the name of a shape of the scene, or a shape, {\"kind\": ...}" + there);
  }
  if (in_progress_.contains(node.text())) {
    node.refuse("a shape that is not made of itself");
  }
  return named(declarations_->field(node.text()), node.text());
}

const abut_shape* Shapes::named(const Node& declared, const std::string& name) {
  if (const auto found = named_.find(name); found != named_.end()) {
    return found->second.get();
  }
  in_progress_.insert(name);
  ShapeOwner shape = make(declared);
  in_progress_.erase(name);
  return named_.emplace(name, std::move(shape)).first->second.get();
}

ShapeOwner Shapes::make(const Node& node) {
  Fields fields(node);
  const Node kind = fields.need("kind");
  if (abut_shape_kind_by_name(kind.text().c_str()) == 0) {
    const std::vector<std::string> known = kind_names();
    kind.refuse("a kind of shape of this build: " + listing(known) + suggestion(kind.text(), known));
  }
  kinds_.insert(kind.text());
  const bool is_field_of_mesh = kind.text() == "distance_field" && (node.has("file") || node.has("vertices"));
  ShapeOwner shape = kind.text() == "composite" ? make_composite(fields)
                     : is_field_of_mesh         ? make_field_of_mesh(fields)
                                                : make_simple(fields, kind.text());
  fields.done();
  return shape;
}

// A distance field that the library samples from triangles.
ShapeOwner Shapes::make_field_of_mesh(Fields& fields) {
  const ShapeArrays arrays = read_arrays(fields, "mesh", folder_);
  abut_distance_field_options options;
  abut_distance_field_options_init(&options, sizeof options);
  if (const auto spacing = fields.find("spacing")) {
    options.spacing = spacing->positive();
  }
  if (const auto band = fields.find("band")) {
    options.band = band->positive();
  }
  if (const auto interpolation = fields.find("interpolation")) {
    options.interpolation = interpolation->whole32(0, 1);
  }
  if (const auto inside_out = fields.find("is_inside_out")) {
    options.is_inside_out = inside_out->flag() ? 1 : 0;
  }
  fields.done();
  abut_shape* made = nullptr;
  fields.node().check(abut_distance_field_from_mesh(arrays.reals.data(), arrays.reals.size() / 3, arrays.indices.data(),
                                                    arrays.indices.size() / 3, &options, &made));
  return ShapeOwner(made);
}

std::vector<double> Shapes::vertices_of(const Node& file) const { return read_vertices(file, folder_); }

ShapeOwner Shapes::make_composite(Fields& fields) {
  std::vector<const abut_shape*> children;
  std::vector<abut_pose> poses;
  const Node list = fields.need("children");
  for (const Node& element : list.list("children, each with a shape and a pose")) {
    Fields child(element);
    children.push_back(resolve(child.need("shape")));
    poses.push_back(read_pose(child.find("pose")));
    child.done();
  }
  abut_shape* made = nullptr;
  list.check(abut_composite_create(children.data(), poses.data(), children.size(), &made));
  std::vector<Child>& own = children_[made];
  for (std::size_t i = 0; i < children.size(); ++i) {
    own.push_back({children[i], poses[i]});
  }
  return ShapeOwner(made);
}

ShapeOwner Shapes::without_holes(const abut_shape* shape) const {
  const auto found = children_.find(shape);
  if (found == children_.end()) {
    return nullptr;
  }
  std::vector<ShapeOwner> owned;
  std::vector<const abut_shape*> kept;
  std::vector<abut_pose> poses;
  bool had_holes = false;
  for (const Child& child : found->second) {
    if (is_hole(child.shape)) {
      had_holes = true;
      continue;
    }
    owned.push_back(without_holes(child.shape));
    had_holes = had_holes || owned.back() != nullptr;
    kept.push_back(owned.back() ? owned.back().get() : child.shape);
    poses.push_back(child.pose);
  }
  if (!had_holes || kept.empty()) {
    return nullptr;
  }
  abut_shape* made = nullptr;
  check(abut_composite_create(kept.data(), poses.data(), kept.size(), &made), "cannot fill the holes of a composite");
  return ShapeOwner(made);
}

ShapeOwner Shapes::make_simple(Fields& fields, const std::string& kind) {
  const ShapeArrays arrays = read_arrays(fields, kind, folder_);
  const std::vector<double> parameters = read_parameters(fields, kind, arrays);
  // A field that is misspelt is named before the library says what is missing.
  fields.done();
  abut_shape_desc desc;
  abut_shape_desc_init(&desc, sizeof desc);
  desc.kind = abut_shape_kind_by_name(kind.c_str());
  desc.parameters = parameters.data();
  desc.parameter_count = parameters.size();
  desc.reals = arrays.reals.empty() ? nullptr : arrays.reals.data();
  desc.real_count = arrays.reals.size();
  desc.indices = arrays.indices.empty() ? nullptr : arrays.indices.data();
  desc.index_count = arrays.indices.size();
  abut_shape* made = nullptr;
  fields.node().check(abut_shape_create(&desc, &made));
  return ShapeOwner(made);
}

}  // namespace cli
