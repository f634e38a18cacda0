// SPDX-License-Identifier: Apache-2.0
// What can be changed of a shape that is in use, and which shapes can do it.
export module abut.capability.edits;
import abut.capability.checks;
import abut.capability.concepts;
import abut.core.standard;
import abut.core;
import abut.math;

export namespace abut {

// What a shape is made of beside its parameters: with these `make` gives the same shape, bit by bit.
struct Buffers {
  std::vector<Real> reals;
  std::vector<std::uint32_t> indices;
};

// All parameters, as `make` takes them.
struct [[gsl::Pointer]] ParameterEdit {
  static constexpr std::string_view subject = "parameters that can be changed without its data";
  std::span<const Real> parameters;
};

// Heights of a rectangle of samples of a height field, along X first.
struct [[gsl::Pointer]] HeightEdit {
  static constexpr std::string_view subject = "heights";
  std::uint32_t column, row;      // the first sample
  std::uint32_t columns, rows;    // how many
  std::span<const Real> heights;  // columns * rows
};

// Centres of particles from `first` on, three numbers each, and their radii, which stay as they are where there are
// none.
struct [[gsl::Pointer]] ParticleEdit {
  static constexpr std::string_view subject = "centres";
  std::size_t first;
  std::span<const Real> xyz, radii;
};

// Values of a box of samples of a distance field, along X first, then Y.
struct [[gsl::Pointer]] FieldEdit {
  static constexpr std::string_view subject = "values";
  std::uint32_t column, row, layer;     // the first sample
  std::uint32_t columns, rows, layers;  // how many
  std::span<const Real> values;         // columns * rows * layers
};

// Places of the points of a lattice that bends a distance field, three numbers each, along X first, then Y. Without
// points the field is as it was made.
struct [[gsl::Pointer]] LatticeEdit {
  static constexpr std::string_view subject = "a lattice";
  std::uint32_t columns, rows, layers;
  std::span<const Real> xyz;  // columns * rows * layers points
};

// Places of vertices, three numbers each: of those that `vertices` lists or, where it lists none, of those from `first`
// on.
struct [[gsl::Pointer]] VertexEdit {
  static constexpr std::string_view subject = "vertices that can be moved";
  std::size_t first;
  std::span<const std::uint32_t> vertices;
  std::span<const Real> xyz;
};

// Triangles that are no longer there. The others keep their numbers.
struct [[gsl::Pointer]] RemovalEdit {
  static constexpr std::string_view subject = "triangles that can be removed";
  std::span<const std::uint32_t> triangles;
};

// All that the shape is made of beside its parameters, as `make` takes it.
struct [[gsl::Pointer]] RecreationEdit {
  static constexpr std::string_view subject = "vertices and triangles to be made of";
  std::span<const Real> reals;
  std::span<const std::uint32_t> indices;
};

using Edit = std::variant<ParameterEdit, HeightEdit, ParticleEdit, FieldEdit, VertexEdit, RemovalEdit, RecreationEdit,
                          LatticeEdit>;

// Takes edits of a type. `check` says what is wrong with one. `own` makes the data of the shape its own, so that
// holders of the same data do not see the change. `make_room`, where the shape has it, gets the memory that the change
// takes; nothing else asks for memory. `apply`, after all of these, answers with a box in the frame of the shape:
// whatever meets the shape outside of it meets what it met before.
template <class S, class E>
concept Editable = requires(S& shape, const S& same, const E& edit) {
  { same.check(edit) } -> std::same_as<Fault>;
  shape.own();
  { shape.apply(edit) } -> std::same_as<Aabb>;
};

// Has nothing but its parameters, so that other parameters make another shape at no cost.
template <class S>
concept Resizable = Described<S> && std::is_trivially_copyable_v<S>;

}  // namespace abut
