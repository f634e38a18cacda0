// SPDX-License-Identifier: Apache-2.0
// Jolt, in single precision as most builds have it, by the functions that its step and its queries call. Shapes have no
// convex radius, so that the distance is that of the shape itself.
#include <Jolt/Jolt.h>
// Its other headers need the first one.
#include <Jolt/Core/Factory.h>
#include <Jolt/Geometry/ConvexSupport.h>
#include <Jolt/Geometry/GJKClosestPoint.h>
#include <Jolt/Physics/Collision/CastResult.h>
#include <Jolt/Physics/Collision/CollideShape.h>
#include <Jolt/Physics/Collision/CollisionCollectorImpl.h>
#include <Jolt/Physics/Collision/CollisionDispatch.h>
#include <Jolt/Physics/Collision/ManifoldBetweenTwoFaces.h>
#include <Jolt/Physics/Collision/RayCast.h>
#include <Jolt/Physics/Collision/Shape/BoxShape.h>
#include <Jolt/Physics/Collision/Shape/CapsuleShape.h>
#include <Jolt/Physics/Collision/Shape/ConvexHullShape.h>
#include <Jolt/Physics/Collision/Shape/CylinderShape.h>
#include <Jolt/Physics/Collision/Shape/MeshShape.h>
#include <Jolt/Physics/Collision/Shape/SphereShape.h>
#include <Jolt/Physics/Collision/ShapeCast.h>
#include <Jolt/RegisterTypes.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "pairs.hpp"

namespace bench {
namespace {

using JPH::Mat44;
using JPH::Vec3;
using JPH::Vec4;

// Tables that its functions look into, made once.
void make_ready() {
  struct Tables {
    JPH::Factory factory;
    Tables() {
      JPH::Factory::sInstance = &factory;
      JPH::RegisterTypes();
    }
  };
  JPH::RegisterDefaultAllocator();
  static const Tables tables;
}

Vec3 jolt_vector(const Point& p) {
  return {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])};
}

using Shape = JPH::Ref<JPH::Shape>;

// Null where the library refuses the shape.
template <class Settings>
Shape made(const Settings& settings) {
  const auto result = settings.Create();
  return result.HasError() ? nullptr : result.Get();
}

Shape hull_of(const Solid& solid) {
  JPH::Array<Vec3> points;
  for (const Point& p : solid.points) {
    points.push_back(jolt_vector(p));
  }
  JPH::ConvexHullShapeSettings settings(points, 0);
  settings.mHullTolerance = 1e-7F;
  return made(settings);
}

Shape mesh_of(const Solid& solid) {
  JPH::VertexList vertices;
  for (const Point& p : solid.points) {
    vertices.push_back({static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])});
  }
  JPH::IndexedTriangleList triangles;
  for (const auto& [a, b, c] : solid.triangles) {
    triangles.push_back({static_cast<JPH::uint32>(a), static_cast<JPH::uint32>(b), static_cast<JPH::uint32>(c), 0});
  }
  return made(JPH::MeshShapeSettings(vertices, triangles));
}

Shape shape_of(const Solid& solid) {
  const auto radius = static_cast<float>(solid.sizes[0]), half = static_cast<float>(solid.sizes[1]);
  switch (solid.kind) {
    case Kind::sphere: return made(JPH::SphereShapeSettings(radius));
    case Kind::box: return made(JPH::BoxShapeSettings(jolt_vector(solid.sizes), 0));
    case Kind::capsule: return made(JPH::CapsuleShapeSettings(half, radius));
    case Kind::cylinder: return made(JPH::CylinderShapeSettings(half, radius, 0));
    case Kind::mesh: return mesh_of(solid);
    default: return hull_of(solid);
  }
}

using Shapes = std::vector<Shape>;

Shapes shapes_of(std::span<const Solid> solids) {
  Shapes shapes;
  for (const Solid& solid : solids) {
    shapes.push_back(shape_of(solid));
  }
  return shapes;
}

// The frame in which the library sees a solid: its axes lie along y, and its middle is the centre of mass.
struct Frame {
  JPH::Quat turn;
  Vec3 middle;
};

Frame frame_of(const Solid& solid, const JPH::Shape& shape, const Placement& at) {
  const bool has_axis = solid.kind == Kind::capsule || solid.kind == Kind::cylinder;
  const Quaternion to_z = turn_by({has_axis ? std::numbers::pi / 2 : 0, 0, 0});
  const auto [w, x, y, z] = product(at.orientation, to_z);
  const JPH::Quat turn =
      JPH::Quat(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z), static_cast<float>(w))
          .Normalized();
  return {turn, jolt_vector(at.position) + turn * shape.GetCenterOfMass()};
}

// What its step keeps of a pair: the points of the two faces that touch, at most four; of shapes without faces one.
class Manifold final : public JPH::CollideShapeCollector {
 public:
  explicit Manifold(bool has_points) : has_points_(has_points) {}

  void AddHit(const JPH::CollideShapeResult& hit) override {
    deepest = std::max(deepest, hit.mPenetrationDepth);
    is_hit = true;
    if (!has_points_) {
      return;
    }
    JPH::ContactPoints on_1, on_2;
    JPH::ManifoldBetweenTwoFaces(hit.mContactPointOn1, hit.mContactPointOn2, hit.mPenetrationAxis, 1e-3F,
                                 hit.mShape1Face, hit.mShape2Face, on_1, on_2);
    if (on_1.size() > 4) {
      JPH::PruneContactPoints(hit.mPenetrationAxis.Normalized(), on_1, on_2);
    }
    points += static_cast<std::uint32_t>(on_1.size());
  }

  float deepest = -FLT_MAX;
  bool is_hit = false;
  std::uint32_t points = 0;

 private:
  bool has_points_;
};

class Jolt final : public Contender {
 public:
  Jolt(Query query, const Cell& cell, Shapes a, Shapes b) : query_(query), a_(std::move(a)), b_(std::move(b)) {
    for (const Case& one : cell.cases) {
      const Frame at_a = frame_of(cell.solids_a[one.a], *a_[one.a], one.pose_a);
      const Frame at_b = query == Query::ray ? Frame{JPH::Quat::sIdentity(), jolt_vector(one.pose_b.position)}
                                             : frame_of(cell.solids_b[one.b], *b_[one.b], one.pose_b);
      jobs_.push_back({one.a, one.b, at_a, at_b, jolt_vector(one.motion)});
    }
    // Faces are gathered for manifolds alone.
    const bool has_faces = query == Query::contacts;
    settings_.mCollectFacesMode = has_faces ? JPH::ECollectFacesMode::CollectFaces : JPH::ECollectFacesMode::NoFaces;
  }

  void answer(std::span<Answer> answers) override {
    for (std::size_t i = 0; i < jobs_.size(); ++i) {
      const Job& job = jobs_[i];
      switch (query_) {
        case Query::distance: answers[i] = distance(job); break;
        case Query::cast: answers[i] = cast(job); break;
        case Query::ray: answers[i] = ray(job); break;
        default: answers[i] = collided(job);
      }
    }
  }

 private:
  struct Job {
    std::size_t a, b;
    Frame at_a, at_b;
    Vec3 motion;
  };

  // As its step does, seen from the middle of the first.
  static Mat44 turned(const Job& job) { return Mat44::sRotation(job.at_a.turn); }
  static Mat44 placed(const Job& job) {
    return Mat44::sRotationTranslation(job.at_b.turn, job.at_b.middle - job.at_a.middle);
  }

  Answer distance(const Job& job) {
    JPH::ConvexShape::SupportBuffer room_a, room_b;
    const auto* a = support(*a_[job.a], room_a);
    const auto* b = support(*b_[job.b], room_b);
    const Mat44 at = turned(job).Transposed3x3() * placed(job);
    const JPH::TransformedConvexObject moved(at, *b);
    Vec3 axis = -at.GetTranslation(), on_a, on_b;
    if (axis.IsNearZero()) {
      axis = Vec3::sAxisX();
    }
    const float square =
        search_.GetClosestPoints(*a, moved, JPH::cDefaultCollisionTolerance, FLT_MAX, axis, on_a, on_b);
    return {static_cast<double>(std::sqrt(square) - a->GetConvexRadius() - b->GetConvexRadius()), 1};
  }
  static const JPH::ConvexShape::Support* support(const JPH::Shape& shape, JPH::ConvexShape::SupportBuffer& room) {
    return static_cast<const JPH::ConvexShape&>(shape).GetSupportFunction(
        JPH::ConvexShape::ESupportMode::ExcludeConvexRadius, room, Vec3::sOne());
  }

  // Of depths, contacts and overlaps.
  Answer collided(const Job& job) {
    Manifold found(query_ == Query::contacts);
    JPH::CollisionDispatch::sCollideShapeVsShape(a_[job.a], b_[job.b], Vec3::sOne(), Vec3::sOne(), turned(job),
                                                 placed(job), JPH::SubShapeIDCreator(), JPH::SubShapeIDCreator(),
                                                 settings_, found);
    if (query_ == Query::overlap) {
      return {found.is_hit ? -1.0 : 1.0, 1};
    }
    const double depth = found.is_hit ? static_cast<double>(-found.deepest) : 0;
    return {depth, query_ == Query::contacts ? found.points : found.is_hit ? 1u : 0u};
  }

  Answer cast(const Job& job) {
    JPH::ClosestHitCollisionCollector<JPH::CastShapeCollector> found;
    const JPH::ShapeCast way(b_[job.b], Vec3::sOne(), Mat44::sRotationTranslation(job.at_b.turn, job.at_b.middle),
                             job.motion);
    JPH::CollisionDispatch::sCastShapeVsShapeWorldSpace(way, casts_, a_[job.a], Vec3::sOne(), JPH::ShapeFilter(),
                                                        Mat44::sRotationTranslation(job.at_a.turn, job.at_a.middle),
                                                        JPH::SubShapeIDCreator(), JPH::SubShapeIDCreator(), found);
    return {found.HadHit() ? static_cast<double>(found.mHit.mFraction) : 1, 1};
  }

  Answer ray(const Job& job) {
    const JPH::Quat back = job.at_a.turn.Conjugated();
    const JPH::RayCast way{back * (job.at_b.middle - job.at_a.middle), back * job.motion};
    JPH::RayCastResult found;
    const bool is_hit = a_[job.a]->CastRay(way, JPH::SubShapeIDCreator(), found);
    return {is_hit ? static_cast<double>(found.mFraction) : 1, 1};
  }

  Query query_;
  Shapes a_, b_;
  std::vector<Job> jobs_;
  JPH::CollideShapeSettings settings_;
  JPH::ShapeCastSettings casts_;
  JPH::GJKClosestPoint search_;
};

bool is_known(Kind kind) {
  return kind == Kind::sphere || kind == Kind::capsule || kind == Kind::box || kind == Kind::cylinder || is_hull(kind);
}

bool are_made(const Shapes& shapes) {
  return std::ranges::all_of(shapes, [](const Shape& shape) { return shape != nullptr; });
}

}  // namespace

// It has no cones, ellipsoids or times of impact of bodies that turn. Its height fields round their heights.
std::unique_ptr<Contender> make_jolt(Query query, const Cell& cell) {
  const Kind a = cell.solids_a.front().kind, b = cell.solids_b.front().kind;
  const bool is_ray = query == Query::ray;
  const bool is_of_mesh = a == Kind::mesh && query != Query::distance && query != Query::depth;
  if (query == Query::impact || !(is_known(a) || is_of_mesh) || !(is_ray || is_known(b))) {
    return nullptr;
  }
  make_ready();
  Shapes its_a = shapes_of(cell.solids_a), its_b = is_ray ? Shapes{} : shapes_of(cell.solids_b);
  return are_made(its_a) && are_made(its_b) ? std::make_unique<Jolt>(query, cell, std::move(its_a), std::move(its_b))
                                            : nullptr;
}

}  // namespace bench
