// SPDX-License-Identifier: Apache-2.0
// Many small balls in one shape.
export module abut.shapes.particles;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.trees.grids.particle_grid;

export namespace abut {

class Particles {
 public:
  using Part = Ball;
  static constexpr std::string_view name = "particles";
  static constexpr std::array<std::string_view, 1> parameter_names{"radius"};

  // With a radius: three reals a particle. With radius 0: four, the last one its own radius.
  [[nodiscard]] static Result<Particles> make(std::span<const Real> parameters, std::span<const Real> reals,
                                              std::span<const std::uint32_t> indices);
  [[nodiscard]] std::vector<Real> parameters() const { return {data_->common_radius}; }
  [[nodiscard]] Buffers buffers() const {
    Buffers out;
    for (std::size_t i = 0; i < data_->places.size(); ++i) {
      const Vec3& place = data_->places[i];
      out.reals.insert(out.reals.end(), {place.x, place.y, place.z});
      if (!data_->radii.empty()) {
        out.reals.push_back(data_->radii[i]);
      }
    }
    return out;
  }
  [[nodiscard]] static std::vector<Particles> samples();

  [[nodiscard]] Aabb aabb(const Pose& pose) const {
    return transformed(data_->centres, pose).inflated(data_->largest_radius);
  }
  [[nodiscard]] std::size_t particle_count() const { return data_->places.size(); }

  [[nodiscard]] inline Ball part(std::uint32_t index) const { return Ball(radius_of(index)); }
  [[nodiscard]] inline Vec3 place(std::uint32_t index) const { return data_->places[index]; }

  template <class Visitor>
  void visit_places(Aabb& box, Visitor&& visit) const {
    grid().visit_near(box.inflated(data_->largest_radius), [&](const HashGrid::Item& item) {
      const Real radius = radius_of(item.index);
      if (Aabb::around(item.point, {radius, radius, radius}).overlaps(box)) {
        visit(item.point, item.index);
      }
    });
  }
  // Visits one of each two, and with it the ones near it: memory is read in the order of space.
  template <class Visitor>
  void visit_pairs(Real margin, Visitor&& visit) const {
    // Rounding may take a gap for a smaller one, never for a larger one that counts.
    constexpr Real slack = 1e-12;
    const auto reach_of = [&](Real radii) { return (1 + slack) * std::max(radii + margin, Real{0}); };
    const Real reach = reach_of(2 * data_->largest_radius);
    grid().visit_pairs(reach, [&](const HashGrid::Item& a, const HashGrid::Item& b) {
      if (!data_->radii.empty()) {
        const Real own_reach = reach_of(radius_of(a.index) + radius_of(b.index));
        if (squared_norm(b.point - a.point) > own_reach * own_reach) {
          return;
        }
      }
      const bool is_swapped = b.index < a.index;
      const HashGrid::Item &low = is_swapped ? b : a, &high = is_swapped ? a : b;
      visit(low.index, low.point, high.index, high.point);
    });
  }
  [[nodiscard]] std::uint32_t place_near(const Vec3& point) const { return grid().item_near(point); }

  // Slab by slab of cells along the axis that the ray follows most.
  [[nodiscard]] std::optional<RayHit> cast_ray(const Vec3& origin, const UnitVec3& direction, Real max_distance) const;

  // Other centres and radii. O(particles), and as much again when a query next needs the grid.
  [[nodiscard]] Fault check(const ParticleEdit& edit) const;
  void own() { static_cast<void>(data_.own()); }
  [[nodiscard]] Aabb apply(const ParticleEdit& edit);

  // Whether a query has needed the grid so far.
  [[nodiscard]] bool has_grid() const { return data_->grid.is_made(); }

 private:
  struct Data {
    std::vector<Vec3> places;
    std::vector<Real> radii;  // empty where all are alike
    Real common_radius;       // 0 where they are not
    Real largest_radius;
    Aabb centres;
    Lazy<HashGrid> grid;
  };

  explicit Particles(Data data) : data_(std::move(data)) {}
  // What follows from places and radii.
  static void measure(Data& data);
  [[nodiscard]] inline Real radius_of(std::uint32_t index) const {
    return data_->radii.empty() ? data_->common_radius : data_->radii[index];
  }
  [[nodiscard]] const HashGrid& grid() const [[clang::lifetimebound]] {
    // Cells have room for a margin: what is near a particle lies in the cells around its own.
    return data_->grid.get([this] { return HashGrid(data_->places, 2.2 * data_->largest_radius); });
  }

  Frozen<Data> data_;
};
static_assert(Shape<Particles> && Scattered<Particles> && Editable<Particles, ParticleEdit>);

}  // namespace abut
