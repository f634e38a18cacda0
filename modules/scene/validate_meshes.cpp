// SPDX-License-Identifier: Apache-2.0
// What is odd about the meshes of a scene, by what they enclose.
module abut.scene;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.pairs.any_shape;
import abut.pairs.any_shape.sides;
import abut.scene.meetings;
import abut.trees.inside.winding_number;
import abut.triangles.volume;

namespace abut {
namespace {

// A point counts as enclosed from this winding number on: surfaces with small gaps enclose as well.
constexpr Real least_winding = 0.9;
constexpr Real winding_error = 0.05;

// A shape that several geometries may have, looked at once, and only at what is asked.
struct MeshForm {
  SurfaceSides sides;
  bool is_inside_out;
  std::optional<WindingNumber> winding;

  explicit MeshForm(const AnyShape& shape)
      : sides(sides_of(shape)),
        is_inside_out(sides == SurfaceSides::solid && enclosed_volume(*triangles_of(shape)).is_inside_out()) {}

  [[nodiscard]] bool encloses(const AnyShape& shape, const Vec3& point) {
    if (!winding) {
      const Triangles triangles = triangles_of(shape).value_or(Triangles{});
      winding.emplace(triangles.vertices, triangles.indices);
    }
    return std::fabs(winding->at(point, winding_error).number) >= least_winding;
  }
};

struct BoxedGeometry {
  Aabb box;
  GeometryId id;
};

bool is_within(const Aabb& inner, const Aabb& outer) {
  return inner.low.x > outer.low.x && inner.low.y > outer.low.y && inner.low.z > outer.low.z &&
         inner.high.x < outer.high.x && inner.high.y < outer.high.y && inner.high.z < outer.high.z;
}

std::string named(GeometryId id) { return "geometry " + std::to_string(id.slot); }

}  // namespace

void Scene::find_odd_meshes(std::vector<Finding>& findings) const {
  std::map<const AnyShape*, MeshForm> forms;
  std::vector<BoxedGeometry> boxes;
  geometries_.for_each([&](GeometryId id, const Geometry& geometry) {
    const AnyShape& shape = *places_.shapes[id.slot - 1];
    forms.try_emplace(&shape, shape);
    boxes.push_back({aabb_of(shape, world_of(geometry).pose()), id});
  });
  std::ranges::sort(boxes, {}, [](const BoxedGeometry& its) { return std::pair(its.box.low.x, its.id.slot); });
  // The first geometry that lies in a closed sheet and could meet it.
  const auto first_within = [&](const BoxedGeometry& sheet, MeshForm& form) -> const BoxedGeometry* {
    const Pose pose = world_of(geometries_.at(sheet.id)).pose();
    const auto from = std::lower_bound(boxes.begin(), boxes.end(), sheet.box.low.x,
                                       [](const BoxedGeometry& its, Real x) { return its.box.low.x < x; });
    const auto first = static_cast<std::size_t>(from - boxes.begin());
    for (const BoxedGeometry& other : std::span<const BoxedGeometry>(boxes).subspan(first)) {
      if (other.box.low.x > sheet.box.high.x) {
        break;
      }
      const std::uint32_t low = std::min(sheet.id.slot, other.id.slot), high = std::max(sheet.id.slot, other.id.slot);
      const bool may_meet = other.id != sheet.id && is_within(other.box, sheet.box) &&
                            meetings_.reasons(places_, low - 1, high - 1) == 0 &&
                            geometries_.at(other.id).options.parking == Parking::none;
      if (may_meet && form.encloses(*places_.shapes[sheet.id.slot - 1], pose.undo(other.box.centre()))) {
        return &other;
      }
    }
    return nullptr;
  };
  for (const BoxedGeometry& its : boxes) {
    MeshForm& form = forms.at(&*places_.shapes[its.id.slot - 1]);
    if (form.sides == SurfaceSides::solid && form.is_inside_out) {
      findings.push_back({FindingCode::inside_out,
                          its.id,
                          {},
                          named(its.id) + " is a solid mesh that is wound inside out, so it has no inside; turn its "
                                          "triangles: they are counter-clockwise seen from outside"});
    } else if (form.sides == SurfaceSides::both && geometries_.at(its.id).options.parking == Parking::none) {
      if (const BoxedGeometry* const other = first_within(its, form)) {
        findings.push_back({FindingCode::hollow, its.id, other->id,
                            named(other->id) + " lies inside of " + named(its.id) +
                                ", a closed mesh with two sides, "
                                "which is hollow; with ABUT_SIDES_SOLID what lies in it is pushed out"});
      }
    }
  }
}

}  // namespace abut
