# The list of shapes and of hand-written pairs, and what is generated from it. Adding a shape is one
# file in modules/shapes and one line here.
include_guard(GLOBAL)

set_property(GLOBAL PROPERTY abut_known_shapes "")
set_property(GLOBAL PROPERTY abut_known_pairs "")

# name: of the file modules/shapes/<name>.cppm and its helpers <name>_*; class: in it; kind: the number
# in the C ABI, never reused; FEATURE: builds without this feature leave the shape out; OF_ANY: the class is
# a template that gets the type of a shape of any kind.
function(abut_shape name class kind)
  cmake_parse_arguments(PARSE_ARGV 3 arg "OF_ANY" "FEATURE" "")
  if(arg_OF_ANY)
    string(APPEND class "<AnyShape>")
  endif()
  set_property(GLOBAL APPEND PROPERTY abut_known_shapes ${name})
  set_property(GLOBAL PROPERTY abut_class_${name} ${class})
  set_property(GLOBAL PROPERTY abut_kind_${name} ${kind})
  set_property(GLOBAL PROPERTY abut_feature_${name} "${arg_FEATURE}")
endfunction()

# A hand-written pair in modules/pairs/<a>_<b>.cppm, built when both shapes are.
function(abut_pair a b)
  set_property(GLOBAL APPEND PROPERTY abut_known_pairs ${a}:${b})
endfunction()

abut_shape(sphere       Sphere      1)
abut_shape(box          Box         2)
abut_shape(capsule      Capsule     3)
abut_shape(plane        Plane       4)
abut_shape(hull         Hull        5 FEATURE hull)
abut_shape(mesh         Mesh        6)
abut_shape(height_field HeightField 7)
abut_shape(point        Point       8)
abut_shape(segment      Segment     9)
abut_shape(triangle     FreeTriangle 10)
abut_shape(cylinder     Cylinder    11)
abut_shape(cone         Cone        12)
abut_shape(ellipsoid    Ellipsoid   13)
abut_shape(particles    Particles   14)
abut_shape(composite    CompositeOf 15 OF_ANY)
abut_shape(sphere_hole  SphereHole  16)
abut_shape(cylinder_hole CylinderHole 17)
abut_shape(box_hole     BoxHole     18)

# ---- nothing below changes when a shape is added ----

get_property(known GLOBAL PROPERTY abut_known_shapes)
if(ABUT_SHAPES STREQUAL "all")
  set(abut_enabled_shapes "")
  foreach(name IN LISTS known)
    get_property(feature GLOBAL PROPERTY abut_feature_${name})
    if(NOT feature OR feature IN_LIST ABUT_FEATURES)
      list(APPEND abut_enabled_shapes ${name})
    endif()
  endforeach()
else()
  set(abut_enabled_shapes ${ABUT_SHAPES})
  foreach(name IN LISTS abut_enabled_shapes)
    get_property(feature GLOBAL PROPERTY abut_feature_${name})
    if(NOT name IN_LIST known)
      message(FATAL_ERROR "ABUT_SHAPES names '${name}'; known are: ${known}")
    elseif(feature AND NOT feature IN_LIST ABUT_FEATURES)
      message(FATAL_ERROR "The shape '${name}' needs the feature '${feature}' in ABUT_FEATURES")
    endif()
  endforeach()
endif()

# Shapes that are known and left out: tests whose scenes need every kind ask for it.
set(abut_missing_shapes ${known})
list(REMOVE_ITEM abut_missing_shapes ${abut_enabled_shapes})

# Writes abut.registry, with one implementation unit per row of the pair table so that the rows build
# in parallel, and abut, which exports everything. Also sets the lists of shape and pair sources.
function(abut_write_registry out_interfaces out_implementations)
  set(source ${CMAKE_CURRENT_SOURCE_DIR})
  set(gen ${CMAKE_BINARY_DIR}/gen)
  set(imports "")
  set(entries "")
  set(declarations "")
  set(rows "")
  set(interfaces "")
  set(implementations "")
  set(pair_interfaces "")
  set(pair_imports "")
  set(row_files "")
  set(index 0)
  foreach(name IN LISTS abut_enabled_shapes)
    get_property(class GLOBAL PROPERTY abut_class_${name})
    get_property(kind GLOBAL PROPERTY abut_kind_${name})
    file(GLOB more CONFIGURE_DEPENDS ${source}/shapes/${name}_*.cppm)
    file(GLOB units CONFIGURE_DEPENDS ${source}/shapes/${name}_*.cpp)
    # A sphere_hole is no piece of the sphere.
    get_property(known GLOBAL PROPERTY abut_known_shapes)
    list(FILTER known INCLUDE REGEX "^${name}_")
    foreach(other IN LISTS known)
      list(FILTER more EXCLUDE REGEX "/${other}[_.][a-z_.]*$")
      list(FILTER units EXCLUDE REGEX "/${other}[_.][a-z_.]*$")
    endforeach()
    list(APPEND interfaces ${source}/shapes/${name}.cppm ${more})
    list(APPEND implementations ${units})
    string(APPEND imports "export import abut.shape.${name};\n")
    list(APPEND entries "Entry<${class}, ${kind}>")
    string(APPEND declarations "extern const PairRow row_${name};\n")
    list(APPEND rows "&row_${name}")
    set(row_file ${gen}/row_${name}.cpp)
    file(CONFIGURE OUTPUT ${row_file} @ONLY CONTENT
"module abut.registry;
import abut.dispatch;

namespace abut {
constinit const PairRow row_@name@ = make_row<Shapes, @index@>(by_children);
}  // namespace abut
")
    list(APPEND row_files ${row_file})
    math(EXPR index "${index} + 1")
  endforeach()
  get_property(pairs GLOBAL PROPERTY abut_known_pairs)
  foreach(pair IN LISTS pairs)
    string(REPLACE ":" ";" both ${pair})
    list(GET both 0 a)
    list(GET both 1 b)
    if(a IN_LIST abut_enabled_shapes AND b IN_LIST abut_enabled_shapes)
      list(APPEND pair_interfaces ${source}/pairs/${a}_${b}.cppm)
      string(APPEND pair_imports "export import abut.pair.${a}_${b};\n")
    endif()
  endforeach()
  list(JOIN entries ", " entries)
  list(JOIN rows ", " rows)
  file(CONFIGURE OUTPUT ${gen}/registry.cppm @ONLY CONTENT
"// Generated from cmake/registry.cmake: the shapes of this build and the table of their pairs.
export module abut.registry;
export import abut.dispatch;
import abut.core;
import abut.core.standard;
import abut.math;
import abut.shape;
@imports@@pair_imports@
export namespace abut {
struct AnyShape;
using Shapes = Registry<AnyShape, @entries@>;

// A shape of any kind of this build.
struct AnyShape : Shapes::Variant {
  using Variant = Shapes::Variant;
  using Variant::Variant;

  // The number of a class of shape.
  template <class S>
  [[nodiscard]] static constexpr std::uint32_t kind_of() {
    return Shapes::kind_of<S>();
  }
  // A shape of the kind of that number, from numbers that are checked.
  [[nodiscard]] static Result<AnyShape> make(std::uint32_t kind, std::span<const Real> parameters, std::span<const Real> reals,
                                             std::span<const std::uint32_t> indices);

  // From the shape to a point, in the frame of the shape; nothing where that has no answer.
  [[nodiscard]] std::optional<Distance> distance_to(const Vec3& point) const;
  [[nodiscard]] bool is_hole() const;
  // Whether this is a hole and a point in its frame lies in it by more than `inset`.
  [[nodiscard]] bool cavity_holds(const Vec3& point, Real inset) const;
};
using PairRow = std::array<PairKernels<AnyShape>, Shapes::count>;
}  // namespace abut

namespace abut {
void carve(const AnyShape& composite, const Pose& pose, const AnyShape& other, const Pose& other_pose, const QuerySettings& settings,
           std::span<const ContactPoint> contacts, std::vector<bool>& is_cut, Manifold& added);
Outcome children_distance(const AnyShape& a, const AnyShape& b, const Pose& pose_a, const Pose& pose_b, bool swapped,
                          const QuerySettings& settings, Distance& out);
Outcome children_contacts(const AnyShape& a, const AnyShape& b, const Pose& pose_a, const Pose& pose_b, bool swapped,
                          const QuerySettings& settings, Manifold& out);
Outcome children_contacts_with_memory(const AnyShape& a, const AnyShape& b, const Pose& pose_a, const Pose& pose_b, bool swapped,
                                      const QuerySettings& settings, PairMemory& memory, Manifold& out);
void children_contacts_of_run(std::span<const Frozen<AnyShape>> shapes, std::span<const Pose> poses, std::span<const PairJob> jobs,
                              const QuerySettings& common, std::span<PairMemory> memories, Manifold& out,
                              std::span<PairResult> results);
inline constexpr PairKernels<AnyShape> by_children{Route::children, false, children_distance, children_contacts,
                                                   children_contacts_with_memory, children_contacts_of_run};
@declarations@}  // namespace abut

export namespace abut {
// Kernels of a pair of shapes by their places in the registry.
[[nodiscard]] inline const PairKernels<AnyShape>& pair_kernels(std::size_t row, std::size_t column) {
  static constexpr std::array<const PairRow*, Shapes::count> table{@rows@};
  return (*table[row])[column];
}
}  // namespace abut
")
  file(CONFIGURE OUTPUT ${gen}/abut.cppm @ONLY CONTENT
"// Everything of abut that a C++ program uses.
export module abut;
export import abut.core;
export import abut.math;
export import abut.shape;
export import abut.registry;
export import abut.any_shape;
export import abut.contact;
export import abut.universe;
")
  set(${out_interfaces} ${gen}/registry.cppm ${gen}/abut.cppm PARENT_SCOPE)
  set(${out_implementations} ${row_files} PARENT_SCOPE)
  set(abut_shape_interfaces ${interfaces} PARENT_SCOPE)
  set(abut_shape_implementations ${implementations} PARENT_SCOPE)
  set(abut_pair_interfaces ${pair_interfaces} PARENT_SCOPE)
endfunction()
