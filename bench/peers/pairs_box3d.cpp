// SPDX-License-Identifier: Apache-2.0
// Box3D, in single precision as most builds have it, by the functions that its step and its queries call.
#include <box3d/box3d.h>
#include <box3d/collision.h>

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

#include "pairs.hpp"

namespace bench {
namespace {

b3Vec3 box3d_vector(const Point& p) {
  return {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])};
}

b3Transform box3d_transform(const Placement& placement) {
  const auto& [w, x, y, z] = placement.orientation;
  return {box3d_vector(placement.position), {box3d_vector({x, y, z}), static_cast<float>(w)}};
}

// In the order in which its functions take two of them: the higher first.
enum class Form : std::uint8_t { sphere, capsule, hull, mesh };

struct DestroyHull {
  void operator()(b3HullData* hull) const { b3DestroyHull(hull); }
};
struct DestroyMesh {
  void operator()(b3MeshData* mesh) const { b3DestroyMesh(mesh); }
};

// Ready to be asked; what it points to stays where it is.
class Body {
 public:
  explicit Body(const Solid& solid) {
    const Point& s = solid.sizes;
    const auto radius = static_cast<float>(s[0]), half = static_cast<float>(s[1]);
    if (solid.kind == Kind::sphere) {
      form_ = Form::sphere;
      sphere_ = {{0, 0, 0}, radius};
      points_ = {{0, 0, 0}};
      radius_ = radius;
    } else if (solid.kind == Kind::capsule) {
      form_ = Form::capsule;
      capsule_ = {{0, 0, -half}, {0, 0, half}, radius};
      points_ = {capsule_.center1, capsule_.center2};
      radius_ = radius;
    } else if (solid.kind == Kind::mesh) {
      form_ = Form::mesh;
      make_mesh(solid);
    } else {
      form_ = Form::hull;
      make_hull(solid);
    }
  }

  // A hull of more than 128 vertices or edges has no hull here.
  [[nodiscard]] bool is_made() const { return form_ != Form::hull || hull_ != nullptr; }
  [[nodiscard]] Form form() const { return form_; }
  [[nodiscard]] const b3Sphere& sphere() const { return sphere_; }
  [[nodiscard]] const b3Capsule& capsule() const { return capsule_; }
  [[nodiscard]] const b3HullData& hull() const { return *hull_; }
  [[nodiscard]] b3Mesh mesh() const { return {mesh_.get(), {1, 1, 1}}; }
  [[nodiscard]] b3ShapeProxy proxy() const { return {points_.data(), static_cast<int>(points_.size()), radius_}; }

  [[nodiscard]] b3AABB bounds(const b3Transform& at) const {
    switch (form_) {
      case Form::sphere: return b3ComputeSphereAABB(&sphere_, at);
      case Form::capsule: return b3ComputeCapsuleAABB(&capsule_, at);
      default: return b3ComputeHullAABB(hull_, at);
    }
  }

 private:
  void make_hull(const Solid& solid) {
    if (solid.kind == Kind::box) {
      const b3Vec3 half = box3d_vector(solid.sizes);
      box_ = b3MakeBoxHull(half.x, half.y, half.z);
      hull_ = &box_.base;
    } else if (solid.points.size() <= B3_MAX_HULL_VERTICES) {
      std::vector<b3Vec3> points;
      for (const Point& p : solid.points) {
        points.push_back(box3d_vector(p));
      }
      const int count = static_cast<int>(points.size());
      owned_hull_.reset(b3CreateHull(points.data(), count, count));
      hull_ = owned_hull_.get();
    }
    if (hull_ != nullptr) {
      const b3Vec3* points = b3GetHullPoints(hull_);
      points_.assign(points, points + hull_->vertexCount);
    }
  }
  void make_mesh(const Solid& solid) {
    std::vector<b3Vec3> vertices;
    for (const Point& p : solid.points) {
      vertices.push_back(box3d_vector(p));
    }
    std::vector<std::int32_t> indices;
    for (const auto& triangle : solid.triangles) {
      indices.insert(indices.end(), triangle.begin(), triangle.end());
    }
    b3MeshDef definition{};
    definition.vertices = vertices.data();
    definition.indices = indices.data();
    definition.vertexCount = static_cast<int>(vertices.size());
    definition.triangleCount = static_cast<int>(solid.triangles.size());
    definition.identifyEdges = true;
    mesh_.reset(b3CreateMesh(&definition, nullptr, 0));
  }

  Form form_ = Form::sphere;
  b3Sphere sphere_{};
  b3Capsule capsule_{};
  b3BoxHull box_{};
  const b3HullData* hull_ = nullptr;
  std::unique_ptr<b3HullData, DestroyHull> owned_hull_;
  std::unique_ptr<b3MeshData, DestroyMesh> mesh_;
  std::vector<b3Vec3> points_;
  float radius_ = 0;
};

using Bodies = std::vector<std::unique_ptr<Body>>;

Bodies bodies_of(std::span<const Solid> solids) {
  Bodies bodies;
  for (const Solid& solid : solids) {
    bodies.push_back(std::make_unique<Body>(solid));
  }
  return bodies;
}

constexpr int most_points = 32;

class Box3d final : public Contender {
 public:
  Box3d(Query query, const Cell& cell, Bodies a, Bodies b) : query_(query), a_(std::move(a)), b_(std::move(b)) {
    for (const Case& one : cell.cases) {
      jobs_.push_back(
          {one.a, one.b, box3d_transform(one.pose_a), box3d_transform(one.pose_b), box3d_vector(one.motion)});
    }
  }

  void answer(std::span<Answer> answers) override {
    for (std::size_t i = 0; i < jobs_.size(); ++i) {
      const Job& job = jobs_[i];
      const Body* b = query_ == Query::ray ? nullptr : b_[job.b].get();
      answers[i] = answered(*a_[job.a], b, job);
    }
  }

 private:
  struct Job {
    std::size_t a, b;
    b3Transform pose_a, pose_b;
    b3Vec3 motion;
  };

  Answer answered(const Body& a, const Body* b, const Job& job) {
    switch (query_) {
      case Query::distance: return {static_cast<double>(distance(a, *b, job)), 1};
      case Query::overlap: return {is_overlapping(a, *b, job) ? -1.0 : 1.0, 1};
      case Query::cast: return cast(a, *b, job);
      case Query::ray: return ray(a, job);
      case Query::depth: {
        const Answer found = contacts(a, *b, job);
        return {found.distance, found.points > 0 ? 1u : 0u};
      }
      default: return contacts(a, *b, job);
    }
  }

  static b3Transform relative(const Job& job) { return b3InvMulTransforms(job.pose_a, job.pose_b); }

  static float distance(const Body& a, const Body& b, const Job& job) {
    const b3DistanceInput input{a.proxy(), b.proxy(), relative(job), true};
    b3SimplexCache cache{};
    return b3ShapeDistance(&input, &cache, nullptr, 0).distance;
  }

  static bool is_overlapping(const Body& a, const Body& b, const Job& job) {
    if (a.form() != Form::mesh) {
      return distance(a, b, job) <= 0;
    }
    const b3Mesh mesh = a.mesh();
    const b3ShapeProxy proxy = b.proxy();
    return b3OverlapMesh(&mesh, b3InvMulTransforms(job.pose_b, job.pose_a), &proxy);
  }

  Answer cast(const Body& a, const Body& b, const Job& job) {
    const b3Transform at = relative(job);
    const b3Vec3 way = b3InvRotateVector(job.pose_a.q, job.motion);
    b3CastOutput found;
    if (a.form() == Form::mesh) {
      const b3ShapeProxy its = b.proxy();
      moved_.clear();
      for (int i = 0; i < its.count; ++i) {
        moved_.push_back(b3TransformPoint(at, its.points[i]));
      }
      const b3ShapeCastInput input{{moved_.data(), its.count, its.radius}, way, 1, false};
      const b3Mesh mesh = a.mesh();
      found = b3ShapeCastMesh(&mesh, &input);
    } else {
      const b3ShapeCastPairInput input{a.proxy(), b.proxy(), at, way, 1, false};
      found = b3ShapeCast(&input);
    }
    return {found.hit ? static_cast<double>(found.fraction) : 1, 1};
  }

  static Answer ray(const Body& a, const Job& job) {
    const b3RayCastInput input{b3InvTransformPoint(job.pose_a, job.pose_b.p),
                               b3InvRotateVector(job.pose_a.q, job.motion), 1};
    b3CastOutput found{};
    const b3Mesh mesh = a.mesh();
    switch (a.form()) {
      case Form::sphere: found = b3RayCastSphere(&a.sphere(), &input); break;
      case Form::capsule: found = b3RayCastCapsule(&a.capsule(), &input); break;
      case Form::hull: found = b3RayCastHull(&a.hull(), &input); break;
      case Form::mesh: found = b3RayCastMesh(&mesh, &input); break;
    }
    return {found.hit ? static_cast<double>(found.fraction) : 1, 1};
  }

  static void add(const b3LocalManifold& manifold, Answer& found) {
    for (int i = 0; i < manifold.pointCount; ++i) {
      const auto separation = static_cast<double>(manifold.points[i].separation);
      if (separation < 0) {
        found.distance = std::min(found.distance, separation);
        ++found.points;
      }
    }
  }

  Answer contacts(const Body& a, const Body& b, const Job& job) {
    Answer found;
    if (a.form() == Form::mesh) {
      of_triangles(a, b, relative(job), found);
    } else if (a.form() >= b.form()) {
      of_convex(a, b, relative(job), found);
    } else {
      of_convex(b, a, b3InvMulTransforms(job.pose_b, job.pose_a), found);
    }
    return found;
  }

  void of_convex(const Body& a, const Body& b, const b3Transform& at, Answer& found) {
    b3LocalManifold manifold{};
    manifold.points = points_.data();
    b3SATCache faces{};
    b3SimplexCache simplex{};
    if (a.form() == Form::hull && b.form() == Form::hull) {
      b3CollideHulls(&manifold, most_points, &a.hull(), &b.hull(), at, &faces);
    } else if (a.form() == Form::hull && b.form() == Form::capsule) {
      b3CollideHullAndCapsule(&manifold, most_points, &a.hull(), &b.capsule(), at, &simplex);
    } else if (a.form() == Form::hull) {
      b3CollideHullAndSphere(&manifold, most_points, &a.hull(), &b.sphere(), at, &simplex);
    } else if (b.form() == Form::capsule) {
      b3CollideCapsules(&manifold, most_points, &a.capsule(), &b.capsule(), at);
    } else if (a.form() == Form::capsule) {
      b3CollideCapsuleAndSphere(&manifold, most_points, &a.capsule(), &b.sphere(), at);
    } else {
      b3CollideSpheres(&manifold, most_points, &a.sphere(), &b.sphere(), at);
    }
    add(manifold, found);
  }

  // All triangles near the body, each in the frame of the body, as its step asks them.
  void of_triangles(const Body& a, const Body& b, const b3Transform& at, Answer& found) {
    const b3Mesh mesh = a.mesh();
    triangles_.clear();
    b3QueryMesh(&mesh, b.bounds(at), collect, &triangles_);
    const b3Transform back = b3InvertTransform(at);
    for (std::array<b3Vec3, 3>& corners : triangles_) {
      for (b3Vec3& corner : corners) {
        corner = b3TransformPoint(back, corner);
      }
      b3LocalManifold manifold{};
      manifold.points = points_.data();
      b3SATCache faces{};
      b3SimplexCache simplex{};
      switch (b.form()) {
        case Form::sphere: b3CollideTriangleAndSphere(&manifold, most_points, corners.data(), &b.sphere()); break;
        case Form::capsule:
          b3CollideTriangleAndCapsule(&manifold, most_points, corners.data(), &b.capsule(), &simplex);
          break;
        default:
          b3CollideTriangleAndHull(&manifold, most_points, corners[0], corners[1], corners[2], 0, &b.hull(), &faces,
                                   true);
      }
      add(manifold, found);
    }
  }
  static bool collect(b3Vec3 a, b3Vec3 b, b3Vec3 c, int, void* list) {
    static_cast<std::vector<std::array<b3Vec3, 3>>*>(list)->push_back({a, b, c});
    return true;
  }

  Query query_;
  Bodies a_, b_;
  std::vector<Job> jobs_;
  std::vector<b3Vec3> moved_;
  std::vector<std::array<b3Vec3, 3>> triangles_;
  std::array<b3LocalManifoldPoint, most_points> points_{};
};

bool is_known(Kind kind) { return kind == Kind::sphere || kind == Kind::capsule || kind == Kind::box || is_hull(kind); }

bool are_made(const Bodies& bodies) {
  return std::ranges::all_of(bodies, [](const auto& body) { return body->is_made(); });
}

}  // namespace

// It has no curved shapes. Bodies that turn take another way between their poses, so times of impact do not compare.
// Its height fields round their heights to 16 bits.
std::unique_ptr<Contender> make_box3d(Query query, const Cell& cell) {
  const Kind a = cell.solids_a.front().kind, b = cell.solids_b.front().kind;
  const bool is_ray = query == Query::ray;
  const bool is_of_mesh = a == Kind::mesh && query != Query::distance && query != Query::depth;
  if (query == Query::impact || !(is_known(a) || is_of_mesh) || !(is_ray || is_known(b))) {
    return nullptr;
  }
  Bodies its_a = bodies_of(cell.solids_a), its_b = is_ray ? Bodies{} : bodies_of(cell.solids_b);
  return are_made(its_a) && are_made(its_b) ? std::make_unique<Box3d>(query, cell, std::move(its_a), std::move(its_b))
                                            : nullptr;
}

}  // namespace bench
