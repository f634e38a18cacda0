// SPDX-License-Identifier: Apache-2.0
// A hole takes its whole volume out of a solid that it lies within, and nothing out of one that it lies beside. Where
// it is as wide as a drill through a plate, it takes what lies between the two ends. All else is refused.
#include "response/holes.hpp"

#include "extension_arguments.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

import abut.response;

namespace abut::capi {

namespace {

using response::MassProperties;
using response::Prism;

// Holes count as smaller by this part of their size. So a hole whose wall lies in the surface of a solid is within it.
// The volume of such a layer is below what a mass tells.
constexpr double part_of_size = 1e-9;

// A hole as a solid of its own; what it takes out of one solid.
struct Plug {
  std::size_t number = 0;
  OwnedShape shape;
  abut_pose pose{};
  MassProperties mass;
};

[[nodiscard]] abut_status refuse_hole(std::size_t hole, std::size_t other, const char* words) noexcept {
  std::array<char, 160> message{};
  static_cast<void>(std::snprintf(message.data(), message.size(),
                                  "shape is a composite whose hole, child %zu, %s child %zu; its mass must be given",
                                  hole, words, other));
  return refuse(ABUT_UNSUPPORTED, message.data());
}

[[nodiscard]] abut_status make_ball(double radius, OwnedShape& out) {
  abut_shape* made = nullptr;
  const abut_status status = abut_sphere_create(radius, &made);
  out.reset(made);
  return status;
}

[[nodiscard]] abut_status make_prism(const Prism& prism, OwnedShape& out) {
  const double half_height = (1 - part_of_size) * 0.5 * (prism.high - prism.low), side = 1 - part_of_size;
  abut_shape* made = nullptr;
  const abut_status status = prism.radius > 0
                                 ? abut_cylinder_create(side * prism.radius, half_height, &made)
                                 : abut_box_create(side * prism.half[0], side * prism.half[1], half_height, &made);
  out.reset(made);
  return status;
}

// Where an open hole has left everything behind that is as far away as `reach`.
[[nodiscard]] Prism ended(Prism prism, double reach) {
  prism.low = std::max(prism.low, -reach);
  prism.high = std::min(prism.high, reach);
  return prism;
}

[[nodiscard]] abut_status distance_of(const Plug& plug, const abut_shape* shape, const abut_pose& pose, double& out) {
  abut_distance found;
  const abut_status status = abut_pair_distance(plug.shape.get(), &plug.pose, shape, &pose, nullptr, &found);
  out = found.distance;
  return status;
}

// How often triangles go around a point that lies on none of them: Van Oosterom and Strackee, "The solid angle of a
// plane triangle" (1983), https://doi.org/10.1109/TBME.1983.325207.
[[nodiscard]] double turns_around(const abut_vec3& point, const std::vector<double>& xyz,
                                  const std::vector<std::uint32_t>& triangles) {
  using namespace response;
  double angle = 0;
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
    std::array<abut_vec3, 3> to{};
    for (std::size_t j = 0; j < to.size(); ++j) {
      const std::size_t at = 3 * std::size_t{triangles[i + j]};
      to[j] = subtract({xyz[at], xyz[at + 1], xyz[at + 2]}, point);
    }
    const double a = length(to[0]), b = length(to[1]), c = length(to[2]);
    angle += std::atan2(dot(to[0], cross(to[1], to[2])),
                        a * b * c + dot(to[0], to[1]) * c + dot(to[0], to[2]) * b + dot(to[1], to[2]) * a);
  }
  return angle / (2 * std::numbers::pi);
}

enum class Where : unsigned char { beside, within, across };

// The surface of a solid of triangles: a plug that crosses none of them is within or beside them as a whole.
[[nodiscard]] abut_status find_among_triangles(const Plug& plug, CompositePart& solid, Where& out) {
  std::size_t vertices = 0, triangles = 0;
  abut_status status = abut_shape_triangles(solid.shape.get(), nullptr, 0, &vertices, nullptr, 0, &triangles);
  std::vector<double> xyz(3 * vertices);
  std::vector<std::uint32_t> indices(3 * triangles);
  if (status == ABUT_OK)
    status =
        abut_shape_triangles(solid.shape.get(), xyz.data(), vertices, &vertices, indices.data(), triangles, &triangles);
  if (status == ABUT_OK && !solid.sheet) {
    abut_shape* made = nullptr;
    status = abut_mesh_create(xyz.data(), vertices, indices.data(), triangles, nullptr, &made);
    solid.sheet.reset(made);
  }
  double distance = 0;
  if (status == ABUT_OK) status = distance_of(plug, solid.sheet.get(), solid.info.pose, distance);
  if (status != ABUT_OK) return status;
  const response::Matrix turn = response::matrix_of(response::normalized(solid.info.pose.orientation));
  const abut_vec3 apart = response::subtract(plug.pose.position, solid.info.pose.position);
  const abut_vec3 local = response::times(response::transposed(turn), apart);
  out = Where::across;
  if (distance > 0) out = turns_around(local, xyz, indices) > 0.5 ? Where::within : Where::beside;
  return ABUT_OK;
}

// Points whose hull holds a solid. The rim of a cylinder lies within a polygon around it, of so many corners that it
// is wider by 5e-6 of the radius.
[[nodiscard]] std::vector<abut_vec3> points_around(const Plug& plug, const Prism& prism) {
  constexpr int corners = 1000;
  std::vector<abut_vec3> out;
  const double half_height = (1 - part_of_size) * 0.5 * (prism.high - prism.low);
  std::vector<std::array<double, 2>> profile;
  if (prism.radius > 0) {
    const double around = (1 - part_of_size) * prism.radius / std::cos(std::numbers::pi / corners);
    for (int i = 0; i < corners; ++i) {
      const double angle = 2 * std::numbers::pi * i / corners;
      profile.push_back({around * std::cos(angle), around * std::sin(angle)});
    }
  } else {
    for (const double x : {-prism.half[0], prism.half[0]}) {
      for (const double y : {-prism.half[1], prism.half[1]})
        profile.push_back({(1 - part_of_size) * x, (1 - part_of_size) * y});
    }
  }
  const response::Matrix turn = response::matrix_of(plug.pose.orientation);
  for (const auto& [x, y] : profile) {
    for (const double z : {-half_height, half_height})
      out.push_back(response::add(plug.pose.position, response::times(turn, {x, y, z})));
  }
  return out;
}

// Of a convex solid with a curved surface, from which the distance is a convex function: it is largest at a corner.
[[nodiscard]] abut_status find_in_convex(const Plug& plug, const Prism* prism, const CompositePart& solid, Where& out) {
  double distance = 0;
  abut_status status = distance_of(plug, solid.shape.get(), solid.info.pose, distance);
  if (status != ABUT_OK) return status;
  out = Where::beside;
  if (distance >= 0) return ABUT_OK;
  double room = 0;
  std::size_t count = 0;
  if (prism == nullptr) {
    status = abut_shape_parameters(plug.shape.get(), &room, 1, &count);
    if (status != ABUT_OK) return status;
  }
  abut_shape* made = nullptr;
  status = abut_point_create(&made);
  Plug point;
  point.shape.reset(made);
  const std::vector<abut_vec3> points =
      prism == nullptr ? std::vector<abut_vec3>{plug.pose.position} : points_around(plug, *prism);
  bool is_within = true;
  for (const abut_vec3& at : points) {
    if (status != ABUT_OK) return status;
    point.pose = {.position = at, .orientation = {1, 0, 0, 0}};
    status = distance_of(point, solid.shape.get(), solid.info.pose, distance);
    is_within = is_within && distance <= -room;
  }
  out = is_within ? Where::within : Where::across;
  return status;
}

[[nodiscard]] abut_status find(const Plug& plug, const Prism* prism, CompositePart& solid, Where& out) {
  for (const std::string_view kind : {"sphere", "capsule", "cylinder", "cone", "ellipsoid"}) {
    if (solid.kind == kind) return find_in_convex(plug, prism, solid, out);
  }
  return find_among_triangles(plug, solid, out);
}

// What a hole takes out of a solid; no shape where that is nothing.
[[nodiscard]] abut_status cut(const CompositePart& hole, CompositePart& solid, Plug& out) {
  const abut_pose& pose = hole.info.pose;
  out = {.number = hole.number, .shape = nullptr, .pose = pose, .mass = {}};
  abut_status status = ABUT_OK;
  Where where = Where::across;
  if (hole.kind == "sphere_hole") {
    const double radius = hole.parameters.at(0);
    if (radius == 0) return ABUT_OK;
    status = make_ball((1 - part_of_size) * radius, out.shape);
    if (status == ABUT_OK) status = find(out, nullptr, solid, where);
    if (status != ABUT_OK) return status;
    out.mass = response::placed(response::ellipsoid_mass({radius, radius, radius}), pose);
  } else {
    abut_aabb box;
    status = abut_shape_aabb(solid.shape.get(), &solid.info.pose, &box);
    if (status != ABUT_OK) return status;
    const double reach = response::length(response::subtract(box.minimum, pose.position)) +
                         response::length(response::subtract(box.maximum, box.minimum));
    const std::vector<Prism> ways = response::prisms_of(hole.kind, hole.parameters, pose);
    Prism whole = ended(ways.at(0), reach);
    if (!(response::mass_of(whole).mass > 0)) return ABUT_OK;
    out.pose = response::pose_of(whole);
    status = make_prism(whole, out.shape);
    if (status == ABUT_OK) status = find(out, &whole, solid, where);
    if (status != ABUT_OK) return status;
    if (where == Where::across) {
      const std::vector<Prism> solids = response::prisms_of(solid.kind, solid.parameters, solid.info.pose);
      for (const Prism& way : ways) {
        for (const Prism& other : solids) {
          const auto part = response::part_within(way, other);
          if (!part || where == Where::within) continue;
          whole = *part;
          where = Where::within;
        }
      }
      if (where == Where::within) {
        out.pose = response::pose_of(whole);
        status = make_prism(whole, out.shape);
      }
    }
    out.mass = response::mass_of(whole);
  }
  if (where == Where::across) return refuse_hole(hole.number, solid.number, "crosses the surface of");
  if (where == Where::beside) out.shape.reset();
  return status;
}

}  // namespace

abut_status parts_of_composite(const abut_shape* shape, std::vector<CompositePart>& out) {
  std::size_t count = 0;
  abut_status status = abut_composite_children(shape, nullptr, 0, &count);
  std::vector<abut_composite_child> children(count);
  if (status == ABUT_OK) status = abut_composite_children(shape, children.data(), count, &count);
  for (std::size_t i = 0; status == ABUT_OK && i < children.size(); ++i) {
    CompositePart& part = out.emplace_back();
    part.number = i;
    part.info = children[i];
    abut_shape* child = nullptr;
    status = abut_composite_child_shape(shape, static_cast<std::uint32_t>(i), &child);
    part.shape.reset(child);
    const char* const name = abut_shape_kind_name(abut_shape_kind_of(child));
    part.kind = name == nullptr ? "" : name;
    if (status == ABUT_OK) status = abut_shape_parameters(child, nullptr, 0, &count);
    part.parameters.resize(count);
    if (status == ABUT_OK) status = abut_shape_parameters(child, part.parameters.data(), count, &count);
  }
  return status;
}

abut_status missing_of_holes(std::vector<CompositePart>& parts, std::vector<MassProperties>& out) {
  for (CompositePart& solid : parts) {
    if (solid.info.is_hole != 0) continue;
    std::vector<Plug> plugs;
    for (const CompositePart& hole : parts) {
      const bool cuts =
          hole.info.is_hole != 0 && hole.info.cut_begin <= solid.number && solid.number < hole.info.cut_end;
      if (!cuts) continue;
      Plug plug;
      if (const abut_status status = cut(hole, solid, plug); status != ABUT_OK) return status;
      if (!plug.shape) continue;
      for (const Plug& other : plugs) {
        double distance = 0;
        if (const abut_status status = distance_of(plug, other.shape.get(), other.pose, distance); status != ABUT_OK)
          return status;
        if (distance < 0) return refuse_hole(plug.number, other.number, "overlaps the hole");
      }
      out.push_back(response::scaled(plug.mass, -1));
      plugs.push_back(std::move(plug));
    }
  }
  return ABUT_OK;
}

}  // namespace abut::capi
