// SPDX-License-Identifier: Apache-2.0
module abut.pairs.any_shape.shape_archive;
import abut.capability;
import abut.core.archive;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.pairs.any_shape;
import abut.pairs.registry;

namespace abut {
namespace {

struct SavedChild {
  std::uint32_t shape;
  Pose pose;
  std::uint32_t material;
};
struct SavedHole {
  std::uint32_t child, begin, end;
};

// What a shape is made of. Only composites have what comes after the buffers.
struct SavedShape {
  std::uint32_t kind = 0;
  std::vector<Real> parameters;
  Buffers buffers;
  std::vector<SavedChild> children;
  std::vector<SavedHole> holes;
  std::uint32_t nesting = 0;

  template <class Archive, class Self>
  static void transfer(Archive& archive, Self& self) {
    archive(self.kind, self.parameters, self.buffers.reals, self.buffers.indices, self.children, self.holes,
            self.nesting);
  }
};

SavedShape saved(const AnyShape& any, const ShapeList& list) {
  SavedShape out;
  out.kind = Shapes::kinds[kind_of(any)];
  out.parameters = parameters_of(any);
  std::visit(
      [&]<class S>(const S& shape) {
        if constexpr (Assembly<S>) {
          for (const auto& child : shape.children()) {
            out.children.push_back({list.number_of(child.shape), child.pose, child.material});
          }
          for (const auto& hole : shape.holes()) {
            out.holes.push_back({hole.child, hole.begin, hole.end});
          }
          out.nesting = shape.nesting();
        } else if constexpr (requires { shape.buffers(); }) {
          out.buffers = shape.buffers();
        }
      },
      any);
  return out;
}

// Of children that come before it in the list.
template <class Composite>
Result<ShapeHandle> made_of_children(const SavedShape& saved, std::span<const ShapeHandle> known) {
  std::vector<typename Composite::Child> children;
  std::vector<typename Composite::Hole> holes;
  for (const SavedChild& child : saved.children) {
    if (child.shape >= known.size() || !is_rigid(child.pose)) {
      return Error{Errc::invalid_argument, "a child of a composite is no shape, or its pose is none"};
    }
    children.push_back({known[child.shape], child.pose, child.material});
  }
  for (const SavedHole& hole : saved.holes) {
    holes.push_back({hole.child, hole.begin, hole.end});
  }
  return Composite::restored(std::move(children), std::move(holes), saved.nesting).transform([](Composite made) {
    return ShapeHandle(AnyShape(std::move(made)));
  });
}

template <std::size_t Place>
Result<ShapeHandle> made(std::size_t place, const SavedShape& saved, std::span<const ShapeHandle> known) {
  if constexpr (Place == Shapes::count) {
    return make_shape(place, saved.parameters, saved.buffers.reals, saved.buffers.indices);
  } else if constexpr (Assembly<Shapes::At<Place>>) {
    return place == Place ? made_of_children<Shapes::At<Place>>(saved, known) : made<Place + 1>(place, saved, known);
  } else {
    return made<Place + 1>(place, saved, known);
  }
}

}  // namespace

bool is_rigid(const Pose& pose) {
  constexpr Real slack = 1e-9, farthest = 4 * largest_coordinate;
  const auto& [x, y, z] = pose.rotation;
  const Vec3 out = cross(x, y) - z;
  return std::fabs(squared_norm(x) - 1) <= slack && std::fabs(squared_norm(y) - 1) <= slack &&
         std::fabs(dot(x, y)) <= slack && squared_norm(out) <= slack * slack &&
         largest_magnitude(pose.position) <= farthest && is_finite(pose.position);
}

void ShapeList::add(const ShapeHandle& shape) {
  if (numbers_.contains(address_of(shape))) {
    return;
  }
  std::visit(
      [&]<class S>(const S& its) {
        if constexpr (Assembly<S>) {
          for (const auto& child : its.children()) {
            add(child.shape);
          }
        }
      },
      *shape);
  numbers_.try_emplace(address_of(shape), static_cast<std::uint32_t>(shapes_.size()));
  shapes_.push_back(shape);
}

void ShapeList::write(ByteWriter& out) const {
  out(std::uint64_t{shapes_.size()});
  for (const ShapeHandle& shape : shapes_) {
    out(saved(*shape, *this));
  }
}

void ShapeList::read(ByteReader& in) {
  std::uint64_t count = 0;
  in(count);
  for (std::uint64_t number = 0; number < count && !in.has_failed(); ++number) {
    SavedShape its;
    in(its);
    const std::string name = "shape " + std::to_string(number);
    const auto place = find_kind(its.kind);
    if (in.has_failed()) {
      return;
    }
    if (!place) {
      in.fail({Errc::unsupported, name + " is of the kind " + std::to_string(its.kind) + ", which this build has not"});
      return;
    }
    Result<ShapeHandle> shape = made<0>(*place, its, shapes_);
    if (!shape) {
      in.fail({shape.error().code, name + ": " + shape.error().message});
      return;
    }
    shapes_.push_back(std::move(shape).value());
  }
}

}  // namespace abut
