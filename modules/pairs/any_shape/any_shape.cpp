// SPDX-License-Identifier: Apache-2.0
module abut.pairs.any_shape;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.pairs.registry;

namespace abut {
namespace {

struct [[gsl::Pointer]] KindEntry {
  std::string_view name;
  std::span<const std::string_view> parameter_names;
};

constexpr auto kind_entries = Shapes::for_each_kind([]<class S>() { return KindEntry{S::name, S::parameter_names}; });

// Of each form, the place of its class, and whether a shape of that class is of the form. Of a class, itself.
struct FormOf {
  std::size_t place;
  bool (*has_made)(const AnyShape& shape);
};
constexpr auto forms = Shapes::for_each_kind([]<class S>() -> FormOf {
  if constexpr (requires { typename S::OfClass; }) {
    using Class = typename S::OfClass;
    constexpr auto is_of_form = [](const AnyShape& shape) { return S::has_made(std::get<Class>(shape)); };
    return {Shapes::place_of<Class>(), is_of_form};
  } else {
    return {Shapes::place_of<S>(), nullptr};
  }
});

}  // namespace

std::optional<std::size_t> find_kind(std::uint32_t kind) {
  for (std::size_t place = 0; place < named_kind_count; ++place) {
    if (Shapes::kinds[place] == kind) {
      return place;
    }
  }
  return std::nullopt;
}

std::optional<std::size_t> find_kind(std::string_view name) {
  for (std::size_t place = 0; place < named_kind_count; ++place) {
    if (kind_entries[place].name == name) {
      return place;
    }
  }
  return std::nullopt;
}

std::size_t kind_of(const AnyShape& shape) {
  for (std::size_t place = shape_kind_count; place < named_kind_count; ++place) {
    if (forms[place].place == shape.index() && forms[place].has_made(shape)) {
      return place;
    }
  }
  return shape.index();
}

std::size_t kind_in_pairs(std::size_t place) { return forms[place].place; }
std::size_t kind_in_pairs(const AnyShape& shape) { return shape.index(); }
std::uint32_t kind_number(std::size_t place) { return Shapes::kinds[place]; }

std::string_view kind_name(std::size_t place) { return kind_entries[place].name; }
std::size_t kind_parameter_count(std::size_t place) { return kind_entries[place].parameter_names.size(); }
std::string_view kind_parameter_name(std::size_t place, std::size_t index) {
  return kind_entries[place].parameter_names[index];
}

Result<ShapeHandle> make_shape(std::size_t place, std::span<const Real> parameters, std::span<const Real> reals,
                               std::span<const std::uint32_t> indices) {
  return AnyShape::make(Shapes::kinds[place], parameters, reals, indices).transform([](AnyShape made) {
    return ShapeHandle(std::move(made));
  });
}

ShapeHandle sample_shape() { return ShapeHandle(AnyShape(Shapes::At<0>::samples().front())); }

namespace {

template <std::size_t Place>
Result<ShapeHandle> make_first_assembly(std::span<const PlacedShape> given) {
  if constexpr (Place == Shapes::count) {
    return Error{Errc::unsupported, "this build of abut has no composites"};
  } else if constexpr (Assembly<Shapes::At<Place>>) {
    using Made = Shapes::At<Place>;
    std::vector<typename Made::Child> children;
    children.reserve(given.size());
    for (const PlacedShape& child : given) {
      children.push_back({child.shape, child.pose, child.material});
    }
    return Made::of(children).transform([](Made made) { return ShapeHandle(AnyShape(std::move(made))); });
  } else {
    return make_first_assembly<Place + 1>(given);
  }
}

}  // namespace

Result<ShapeHandle> make_composite(std::span<const PlacedShape> children) { return make_first_assembly<0>(children); }

Aabb aabb_of(const AnyShape& shape, const Pose& pose) {
  return std::visit([&](const auto& s) { return s.aabb(pose); }, shape);
}

std::vector<Real> parameters_of(const AnyShape& shape) {
  return std::visit([](const auto& s) { return s.parameters(); }, shape);
}

std::optional<RayHit> cast_ray(const AnyShape& shape, const Vec3& origin, const UnitVec3& direction,
                               Real max_distance) {
  return std::visit([&](const auto& s) { return s.cast_ray(origin, direction, max_distance); }, shape);
}

void prepare(const AnyShape& shape, const Workers& workers) {
  std::visit(
      [&]<class S>(const S& s) {
        if constexpr (Assembly<S>) {
          for (const auto& child : s.children()) {
            prepare(*child.shape, workers);
          }
        } else if constexpr (requires { s.prepare(workers); }) {
          s.prepare(workers);
        }
      },
      shape);
}

std::optional<Triangles> triangles_of(const AnyShape& shape) {
  return std::visit(
      []<class S>(const S& s) -> std::optional<Triangles> {
        if constexpr (Triangulated<S>) {
          return s.triangles();
        } else {
          return std::nullopt;
        }
      },
      shape);
}

bool has_holes(const AnyShape& shape) { return shape.has_holes(); }

bool holds(const AnyShape& shape, const Vec3& point, Real reach) {
  return std::visit(
      [&]<class S>(const S& s) {
        if constexpr (Assembly<S>) {
          const auto children = s.children();
          const auto is_cut = [&](std::uint32_t solid) {
            return std::ranges::any_of(s.holes(), [&](const auto& hole) {
              const auto& cavity = children[hole.child];
              return hole.begin <= solid && solid < hole.end &&
                     cavity.shape->cavity_holds(cavity.pose.undo(point), std::max(reach, Real{0}));
            });
          };
          bool is_held = false;
          s.visit_children(Aabb{point, point}.inflated(std::max(reach, Real{0})), [&](std::uint32_t child) {
            is_held =
                is_held || (holds(*children[child].shape, children[child].pose.undo(point), reach) && !is_cut(child));
          });
          return is_held;
        } else if constexpr (Hole<S>) {
          return false;
        } else {
          const auto found = shape.distance_to(point);
          return found && found->distance <= reach;
        }
      },
      static_cast<const AnyShape::Variant&>(shape));
}

bool has_triangles(std::size_t place) {
  static constexpr auto have_triangles = Shapes::for_each_kind([]<class S>() { return Triangulated<S>; });
  return have_triangles[place];
}

HeldTriangles held_triangles(const AnyShape& shape) {
  return std::visit(
      []<class S>(const S& s) -> HeldTriangles {
        if constexpr (requires { HeldTriangles{s.vertices(), s.indices()}; }) {
          return {s.vertices(), s.indices()};
        } else {
          return {};
        }
      },
      shape);
}

std::span<const std::uint32_t> materials_of_children(const AnyShape& shape) {
  return std::visit(
      []<class S>(const S& s) -> std::span<const std::uint32_t> {
        if constexpr (Assembly<S>) {
          return s.materials();
        } else {
          return {};
        }
      },
      shape);
}

std::optional<BuildReport> build_report_of(const AnyShape& shape) {
  return std::visit(
      [](const auto& s) -> std::optional<BuildReport> {
        if constexpr (requires { s.report(); }) {
          const auto& its = s.report();
          return BuildReport{its.dimension,  its.point_count, its.vertex_count,
                             its.edge_count, its.face_count,  its.error};
        } else {
          return std::nullopt;
        }
      },
      shape);
}

bool is_supported(std::size_t place_a, std::size_t place_b) {
  const auto [low, high] = std::minmax(place_a, place_b);
  return pair_kernels(low, high).route != Route::unsupported;
}

namespace {

std::array<Real, 3> numbers(const Vec3& v) { return {v.x, v.y, v.z}; }

// What tells two shapes of one kind apart, in numbers.
std::vector<Real> form_of(const AnyShape& shape) {
  std::vector<Real> form = parameters_of(shape);
  const auto add = [&](const Vec3& v) { form.insert(form.end(), {v.x, v.y, v.z}); };
  if (const std::optional<Triangles> surface = triangles_of(shape)) {
    for (const Vec3& vertex : surface->vertices) {
      add(vertex);
    }
    form.insert(form.end(), surface->indices.begin(), surface->indices.end());
  }
  std::visit(
      [&]<class S>(const S& s) {
        if constexpr (Assembly<S>) {
          for (const auto& child : s.children()) {
            form.push_back(static_cast<Real>(child.shape->index()));
            for (const Vec3& part :
                 {child.pose.position, child.pose.rotation.x, child.pose.rotation.y, child.pose.rotation.z}) {
              add(part);
            }
            const std::vector<Real> its = form_of(*child.shape);
            form.insert(form.end(), its.begin(), its.end());
          }
        } else if constexpr (Scattered<S>) {
          for (std::uint32_t i = 0; i < s.particle_count(); ++i) {
            add(s.place(i));
            form.push_back(s.part(i).radius());
          }
        }
      },
      shape);
  return form;
}

// The order of two shapes of one kind whose first coordinates do not tell it: by the rest of their poses, else by their
// form. Shapes alike in all of these are the same one, and no order can be told from the other.
[[gnu::cold]] bool comes_after(const AnyShape& a, const AnyShape& b, const Pose& pose_a, const Pose& pose_b) {
  const Vec3 apart = pose_b.position - pose_a.position;
  if (std::fabs(apart.y) > tie_share * std::fabs(apart.z)) {
    return apart.y < 0;
  }
  if (apart.z != 0) {
    return apart.z < 0;
  }
  const auto place = [](const Pose& pose) {
    return std::array{numbers(pose.position), numbers(pose.rotation.x), numbers(pose.rotation.y),
                      numbers(pose.rotation.z)};
  };
  if (place(pose_a) != place(pose_b)) {
    return place(pose_b) < place(pose_a);
  }
  // Most shapes are told apart by their boxes, which takes no memory.
  const auto size = [](const AnyShape& shape) {
    const Aabb box = aabb_of(shape, Pose::identity());
    return std::array{numbers(box.high), numbers(box.low)};
  };
  return size(a) != size(b) ? size(b) < size(a) : form_of(b) < form_of(a);
}

}  // namespace

bool starts_from_b(const AnyShape& a, const AnyShape& b, const Pose& pose_a, const Pose& pose_b) {
  if (a.index() != b.index()) {
    return b.index() < a.index();
  }
  const Vec3 apart = pose_b.position - pose_a.position;
  if (std::fabs(apart.x) > tie_share * (std::fabs(apart.y) + std::fabs(apart.z))) [[likely]] {
    return apart.x < 0;
  }
  return comes_after(a, b, pose_a, pose_b);
}

Outcome pair_distance(const AnyShape& a, const AnyShape& b, const Pose& pose_a, const Pose& pose_b,
                      const QuerySettings& settings, Distance& out) {
  const bool from_b = starts_from_b(a, b, pose_a, pose_b);
  const AnyShape &first = from_b ? b : a, &second = from_b ? a : b;
  return pair_kernels(first.index(), second.index())
      .distance(first, second, from_b ? pose_b : pose_a, from_b ? pose_a : pose_b, from_b, settings, out);
}

Outcome pair_contacts(const AnyShape& a, const AnyShape& b, const Pose& pose_a, const Pose& pose_b,
                      const QuerySettings& settings, Manifold& out) {
  const bool from_b = starts_from_b(a, b, pose_a, pose_b);
  const AnyShape &first = from_b ? b : a, &second = from_b ? a : b;
  return pair_kernels(first.index(), second.index())
      .contacts(first, second, from_b ? pose_b : pose_a, from_b ? pose_a : pose_b, from_b, settings, out);
}

}  // namespace abut
