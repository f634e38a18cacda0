// SPDX-License-Identifier: Apache-2.0
// Shapes of any kind, each at a pose of its own, that never meet each other: one shape to the broad phase. Holes
// among them cut the solids. A template, since the list of all kinds (Any) has this one in it.
export module abut.shapes.composite;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.math.tolerance;
import abut.trees.boxes.bvh;

export namespace abut {

template <class Any>
class CompositeOf {
 public:
  static constexpr std::string_view name = "composite";
  static constexpr std::array<std::string_view, 0> parameter_names{};
  static constexpr bool is_assembly = true;
  static constexpr std::uint32_t deepest_nesting = 32;

  struct Child {
    Frozen<Any> shape;
    Pose pose;                   // in the frame of the composite
    std::uint32_t material = 0;  // 0: that of the geometry
  };

  // A hole cuts the solids of its own composite, and of those within that one: children of adjoining numbers.
  struct Hole {
    std::uint32_t child;
    std::uint32_t begin, end;
  };

  // Children of composites count as children of this one, depth first; that order is their number.
  [[nodiscard]] static Result<CompositeOf> of(std::span<const Child> given);

  // From what a composite tells about itself. The children are no composites; of all that cut, holes name the child and
  // the range.
  [[nodiscard]] static Result<CompositeOf> restored(std::vector<Child> children, std::vector<Hole> holes,
                                                    std::uint32_t nesting);

  // From numbers. indices, child by child: kind, how many parameters, reals and indices it takes, and its
  // indices. reals, child by child: position x y z, orientation w x y z, its parameters, its reals.
  [[nodiscard]] static Result<CompositeOf> make(std::span<const Real> parameters, std::span<const Real> reals,
                                                std::span<const std::uint32_t> indices) {
    if (Fault fault = check_count("parameter_count", parameters.size(), 0)) {
      return *fault;
    }
    return decode(reals, indices, 1);
  }
  [[nodiscard]] std::vector<Real> parameters() const { return {}; }
  [[nodiscard]] static std::vector<CompositeOf> samples();

  [[nodiscard]] Aabb aabb(const Pose& pose) const;

  // The first place where a surface is crossed that holes left, or a wall of a hole where there is material.
  [[nodiscard]] std::optional<RayHit> cast_ray(const Vec3& origin, const UnitVec3& direction, Real max_distance) const;

  [[nodiscard]] std::span<const Child> children() const [[clang::lifetimebound]] { return data_->children; }
  [[nodiscard]] std::span<const Hole> holes() const [[clang::lifetimebound]] { return data_->holes; }
  // Of each child; none where no child has one.
  [[nodiscard]] std::span<const std::uint32_t> materials() const [[clang::lifetimebound]] { return data_->materials; }
  // Of composites in each other; 1 where no child is one.
  [[nodiscard]] std::uint32_t nesting() const { return data_->nesting; }

  // Calls visit(number) for the solids whose box overlaps the given one, which visit may shrink.
  template <class Visitor>
  void visit_children(const Aabb& box, Visitor&& visit) const {
    for (const std::uint32_t child : data_->unbounded) {
      visit(child);
    }
    const auto visit_if_near = [&](std::uint32_t place) {
      if (data_->boxes[place].overlaps(box)) {
        visit(data_->bounded[place]);
      }
    };
    if (data_->bounded.size() > most_without_tree) {
      data_->tree.bvh.visit_overlaps(box, visit_if_near);
    } else {
      for (std::uint32_t place = 0; place < data_->bounded.size(); ++place) {
        visit_if_near(place);
      }
    }
  }

 private:
  // Fewer boxes are looked at faster than a tree is walked.
  static constexpr std::size_t most_without_tree = 8;

  // A tree is no value to compare or copy by itself.
  struct Tree {
    Bvh bvh;
  };
  struct Data {
    std::vector<Child> children;
    std::vector<Hole> holes;
    std::vector<std::uint32_t> bounded, unbounded;  // solids by their numbers
    std::vector<Aabb> boxes;                        // of the bounded ones, in the frame of the composite
    Tree tree;                                      // over the boxes, where there are many
    std::uint32_t nesting;
    std::vector<std::uint32_t> materials{};
  };

  explicit CompositeOf(Data data) : data_(std::move(data)) {}
  // Of children and holes what follows from them.
  [[nodiscard]] static Result<CompositeOf> finished(Data data);
  // Whether a point of a solid lies in a hole that cuts it, but for one.
  [[nodiscard]] bool is_cut(std::uint32_t solid, const Vec3& point, std::uint32_t but) const;
  [[nodiscard]] bool has_material(const Hole& hole, const Vec3& point) const;
  // The first crossing of a child's surface that counts.
  [[nodiscard]] std::optional<RayHit> cast_ray_at(std::uint32_t number, const Vec3& origin, const UnitVec3& direction,
                                                  Real max_distance, const Hole* as_hole) const;
  [[nodiscard]] static Result<CompositeOf> decode(std::span<const Real> reals, std::span<const std::uint32_t> indices,
                                                  std::uint32_t nesting);

  Frozen<Data> data_;
};

template <class Any>
Result<CompositeOf<Any>> CompositeOf<Any>::of(std::span<const Child> given) {
  Data data{{}, {}, {}, {}, {}, {}, 1};
  for (const Child& child : given) {
    if (const auto* nested = std::get_if<CompositeOf>(&static_cast<const typename Any::Variant&>(*child.shape))) {
      data.nesting = std::max(data.nesting, nested->nesting() + 1);
      const auto before = static_cast<std::uint32_t>(data.children.size());
      for (const Hole& hole : nested->holes()) {
        data.holes.push_back({hole.child + before, hole.begin + before, hole.end + before});
      }
      for (const Child& inner : nested->children()) {
        data.children.push_back(
            {inner.shape, child.pose * inner.pose, inner.material != 0 ? inner.material : child.material});
      }
    } else {
      data.children.push_back(child);
    }
  }
  if (data.children.empty()) {
    return Error{Errc::empty, "count is 0; a composite needs at least one child"};
  }
  if (data.nesting > deepest_nesting) {
    return error_about(Errc::out_of_range, "nesting of composites", std::uint64_t{data.nesting}, "at most 32");
  }
  if (data.children.size() >= no_index) {
    return Error{Errc::size_overflow, "a composite has at most 2^32 - 2 children"};
  }
  // Those of the composite itself, which are not yet in the list, cut all of it.
  const auto count = static_cast<std::uint32_t>(data.children.size());
  for (std::uint32_t i = 0; i < count; ++i) {
    if (data.children[i].shape->is_hole() &&
        std::ranges::none_of(data.holes, [&](const Hole& hole) { return hole.child == i; })) {
      data.holes.push_back({i, 0, count});
    }
  }
  return finished(std::move(data));
}

template <class Any>
Result<CompositeOf<Any>> CompositeOf<Any>::restored(std::vector<Child> children, std::vector<Hole> holes,
                                                    std::uint32_t nesting) {
  Data data{std::move(children), std::move(holes), {}, {}, {}, {}, nesting};
  const std::size_t count = data.children.size();
  const bool is_nested = std::ranges::any_of(data.children, [](const Child& child) {
    return std::get_if<CompositeOf>(&static_cast<const typename Any::Variant&>(*child.shape)) != nullptr;
  });
  if (count == 0 || count >= no_index || is_nested || nesting == 0 || nesting > deepest_nesting) {
    return Error{Errc::invalid_argument, "a composite has no children, or its nesting is wrong"};
  }
  std::vector<bool> is_listed(count);
  for (const Hole& hole : data.holes) {
    if (hole.child >= count || hole.begin > hole.end || hole.end > count || is_listed[hole.child] ||
        !data.children[hole.child].shape->is_hole()) {
      return Error{Errc::invalid_argument, "the holes of a composite are not among its children"};
    }
    is_listed[hole.child] = true;
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (data.children[i].shape->is_hole() != is_listed[i]) {
      return Error{Errc::invalid_argument, "a hole of a composite cuts nothing"};
    }
  }
  return finished(std::move(data));
}

template <class Any>
Result<CompositeOf<Any>> CompositeOf<Any>::finished(Data data) {
  const auto count = static_cast<std::uint32_t>(data.children.size());
  if (data.holes.size() == count) {
    return Error{Errc::empty, "all children are holes; a composite needs a solid"};
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    const Child& child = data.children[i];
    if (child.shape->is_hole()) {
      continue;
    }
    const Aabb box = std::visit([&](const auto& shape) { return shape.aabb(child.pose); }, *child.shape);
    if (box.is_bounded()) {
      data.bounded.push_back(i);
      data.boxes.push_back(box);
    } else {
      data.unbounded.push_back(i);
    }
  }
  if (data.bounded.size() > most_without_tree) {
    data.tree.bvh = Bvh(data.boxes);
  }
  if (std::ranges::any_of(data.children, [](const Child& child) { return child.material != 0; })) {
    for (const Child& child : data.children) {
      data.materials.push_back(child.material);
    }
  }
  return CompositeOf(std::move(data));
}

template <class Any>
Result<CompositeOf<Any>> CompositeOf<Any>::decode(std::span<const Real> reals, std::span<const std::uint32_t> indices,
                                                  std::uint32_t nesting) {
  if (nesting > deepest_nesting) {
    return error_about(Errc::out_of_range, "nesting of composites", std::uint64_t{nesting}, "at most 32");
  }
  constexpr std::size_t head = 4, pose_numbers = 7;
  std::vector<Child> children;
  while (!indices.empty()) {
    const std::string at = "child " + std::to_string(children.size());
    if (indices.size() < head) {
      return Error{Errc::invalid_argument, at + ": indices end within its kind and counts"};
    }
    const std::uint32_t kind = indices[0];
    const std::size_t parameter_count = indices[1], real_count = indices[2], index_count = indices[3];
    indices = indices.subspan(head);
    if (index_count > indices.size()) {
      return Error{Errc::invalid_argument, at + ": indices end before its " + std::to_string(index_count) + " indices"};
    }
    if (pose_numbers + parameter_count + real_count > reals.size()) {
      return Error{Errc::invalid_argument, at + ": reals end before its pose, " + std::to_string(parameter_count) +
                                               " parameters and " + std::to_string(real_count) + " reals"};
    }
    const std::span<const Real> pose = reals.first(pose_numbers);
    for (const Real value : pose) {
      if (Fault fault = check_finite(at + ": pose", value)) {
        return *fault;
      }
    }
    const auto orientation = normalized(Quat{pose[3], pose[4], pose[5], pose[6]});
    if (!orientation) {
      return Error{Errc::zero_vector, at + ": its orientation has no length"};
    }
    const std::span<const Real> own = reals.subspan(pose_numbers);
    const auto own_parameters = own.first(parameter_count), own_reals = own.subspan(parameter_count, real_count);
    const auto own_indices = indices.first(index_count);
    Result<Any> shape = kind == Any::template kind_of<CompositeOf>()
                            ? decode(own_reals, own_indices, nesting + 1).transform([](CompositeOf nested) {
                                return Any(std::move(nested));
                              })
                            : Any::make(kind, own_parameters, own_reals, own_indices);
    if (!shape) {
      return Error{shape.error().code, at + ": " + shape.error().message};
    }
    children.push_back(
        {Frozen<Any>(std::move(shape).value()), {Rotation::from(*orientation), {pose[0], pose[1], pose[2]}}});
    reals = own.subspan(parameter_count + real_count);
    indices = indices.subspan(index_count);
  }
  if (!reals.empty()) {
    return error_about(Errc::invalid_argument, "real_count", static_cast<std::uint64_t>(reals.size()),
                       "0 after the last child");
  }
  return of(children);
}

// A few and many bounded shapes of the first kinds of the build, side by side, and one composite in another.
template <class Any>
std::vector<CompositeOf<Any>> CompositeOf<Any>::samples() {
  std::vector<Child> few, many;
  const auto append = [&]<std::size_t Place>(std::integral_constant<std::size_t, Place>) {
    using S = std::variant_alternative_t<Place, typename Any::Variant>;
    if constexpr (Convex<S>) {
      const auto x = static_cast<Real>(many.size());
      const Frozen<Any> shape{Any(S::samples().front())};
      many.push_back({shape, {Rotation::from({1, 0.3, -0.2, 0.1}), {0.8 * x, 0.1 * x, 0}}});
      many.push_back({shape, {Rotation::identity(), {0.8 * x, 1, 0.2 * x}}});
      if (few.size() < 2) {
        few.push_back(many.back());
      }
    }
  };
  [&]<std::size_t... Places>(std::index_sequence<Places...>) {
    (append(std::integral_constant<std::size_t, Places>{}), ...);
  }(std::make_index_sequence<std::variant_size_v<typename Any::Variant>>{});
  CompositeOf small = of(few).value();
  few.push_back({Frozen<Any>(Any(small)), {Rotation::identity(), {0, 0, 2}}});
  return {small, of(many).value(), of(few).value()};
}

template <class Any>
Aabb CompositeOf<Any>::aabb(const Pose& pose) const {
  if (!data_->unbounded.empty()) {
    return Aabb::everything();
  }
  if (data_->bounded.size() > most_without_tree) {
    return transformed(data_->tree.bvh.bounds(), pose);
  }
  Aabb all = Aabb::empty();
  for (const std::uint32_t solid : data_->bounded) {
    const Child& child = data_->children[solid];
    all.include(std::visit([&](const auto& shape) { return shape.aabb(pose * child.pose); }, *child.shape));
  }
  return all;
}

template <class Any>
bool CompositeOf<Any>::is_cut(std::uint32_t solid, const Vec3& point, std::uint32_t but) const {
  return std::ranges::any_of(data_->holes, [&](const Hole& hole) {
    const Child& cavity = data_->children[hole.child];
    return hole.child != but && hole.begin <= solid && solid < hole.end &&
           cavity.shape->cavity_holds(cavity.pose.undo(point), 0);
  });
}

template <class Any>
bool CompositeOf<Any>::has_material(const Hole& hole, const Vec3& point) const {
  for (std::uint32_t solid = hole.begin; solid < hole.end; ++solid) {
    const Child& child = data_->children[solid];
    if (!child.shape->is_hole() && !is_cut(solid, point, hole.child)) {
      const auto found = child.shape->distance_to(child.pose.undo(point));
      if (found && found->distance <= 0) {
        return true;
      }
    }
  }
  return false;
}

template <class Any>
std::optional<RayHit> CompositeOf<Any>::cast_ray_at(std::uint32_t number, const Vec3& origin, const UnitVec3& direction,
                                                    Real max_distance, const Hole* as_hole) const {
  // A surface is crossed a few times at most, but for meshes; this many crossings in holes are looked behind.
  constexpr int most_crossings = 64;
  const Child& child = data_->children[number];
  const UnitVec3 turned = UnitVec3::make(child.pose.rotation.undo(direction)).value_or(direction);
  const Vec3 from = child.pose.undo(origin);
  Real start = 0;
  for (int crossing = 0; crossing < most_crossings; ++crossing) {
    const Vec3 place = from + start * turned.vec();
    auto hit = std::visit([&](const auto& shape) { return shape.cast_ray(place, turned, max_distance - start); },
                          *child.shape);
    if (!hit) {
      return std::nullopt;
    }
    hit->distance += start;
    const Vec3 point = origin + hit->distance * direction.vec();
    if (as_hole ? has_material(*as_hole, point) : !is_cut(number, point, no_index)) {
      hit->normal = child.pose.rotation * hit->normal;
      return hit;
    }
    // Behind the crossing by more than it may be off.
    start = hit->distance + noise_of(largest_magnitude(place) + hit->distance);
  }
  return std::nullopt;
}

template <class Any>
std::optional<RayHit> CompositeOf<Any>::cast_ray(const Vec3& origin, const UnitVec3& direction,
                                                 Real max_distance) const {
  std::optional<RayHit> best;
  Real limit = max_distance;
  const auto try_child = [&](std::uint32_t number, const Hole* as_hole) {
    const auto hit = cast_ray_at(number, origin, direction, limit, as_hole);
    if (hit && (!best || hit->distance < best->distance)) {
      best = hit;
      limit = hit->distance;
    }
  };
  for (const std::uint32_t child : data_->unbounded) {
    try_child(child, nullptr);
  }
  if (data_->bounded.size() > most_without_tree) {
    data_->tree.bvh.visit_ray(origin, direction, limit,
                              [&](std::uint32_t place) { try_child(data_->bounded[place], nullptr); });
  } else {
    for (const std::uint32_t child : data_->bounded) {
      try_child(child, nullptr);
    }
  }
  for (const Hole& hole : data_->holes) {
    try_child(hole.child, &hole);
  }
  return best;
}

}  // namespace abut
