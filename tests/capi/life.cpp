// SPDX-License-Identifier: Apache-2.0
#include "life.hpp"

#include <abut/abut.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace abut_test {
namespace {

constexpr abut_pose origin{{0, 0, 0}, {1, 0, 0, 0}};

class Life {
 public:
  Life() = default;
  Life(const Life&) = delete;
  Life& operator=(const Life&) = delete;
  ~Life() {
    abut_universe_destroy(universe_);
    abut_universe_destroy(copy_);
    for (abut_shape* shape : shapes_) abut_shape_release(shape);
  }

  abut_status live(bool with_hull, std::uint32_t threads) {
    make_shapes(with_hull);
    fill_universe(threads);
    step_and_ask();
    write_and_read();
    fail();
    return status_;
  }

 private:
  // What comes after a failure is left out.
  template <class Call>
  void then(Call&& call) {
    if (status_ == ABUT_OK) status_ = call();
  }
  template <class Create>
  void make(Create&& create) {
    then([&] { return create(&shapes_.at(made_)); });
    made_ += status_ == ABUT_OK ? 1 : 0;
  }

  void make_shapes(bool with_hull) {
    static constexpr std::array<double, 12> corners{-1, -1, 0, 1, -1, 0, 0, 1, 0, 0, 0, 1};
    static constexpr std::array<std::uint32_t, 12> triangles{0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};
    static constexpr std::array<double, 9> heights{0, 0.1, 0, 0.1, 0.3, 0.1, 0, 0.1, 0};
    static constexpr std::array<abut_pose, 2> beside{origin, abut_pose{{1, 0, 0}, {1, 0, 0, 0}}};
    make([](abut_shape** out) { return abut_sphere_create(0.7, out); });
    make([](abut_shape** out) { return abut_box_create(0.6, 0.5, 0.4, out); });
    make([](abut_shape** out) { return abut_cylinder_create(0.6, 0.5, out); });
    make([](abut_shape** out) { return abut_mesh_create(corners.data(), 4, triangles.data(), 4, nullptr, out); });
    make([](abut_shape** out) {
      abut_height_field_desc desc;
      abut_height_field_desc_init(&desc, sizeof desc);
      desc.columns = desc.rows = 3;
      desc.spacing_x = desc.spacing_y = 1;
      desc.heights = heights.data();
      return abut_height_field_create(&desc, out);
    });
    make([](abut_shape** out) { return abut_particles_create(corners.data(), 4, 0.2, out); });
    make([&](abut_shape** out) { return abut_composite_create(shapes_.data(), beside.data(), 2, out); });
    if (with_hull) make([](abut_shape** out) { return abut_hull_create(corners.data(), 4, out); });
  }

  void fill_universe(std::uint32_t threads) {
    then([&] {
      abut_universe_options options;
      abut_universe_options_init(&options, sizeof options);
      options.threads = abut_has_feature("threads") != 0 ? threads : 1;
      return abut_universe_create(&options, &universe_);
    });
    for (std::size_t body = 0; body < parts_.size(); ++body) {
      then([&] { return abut_part_create(universe_, nullptr, &parts_.at(body)); });
      then([&] {
        abut_geometry_id geometry;
        return abut_geometry_create(universe_, parts_.at(body), shapes_.at(body % made_), nullptr, &geometry);
      });
    }
  }

  void step_and_ask() {
    for (int step = 0; step < 3; ++step) {
      for (std::size_t body = 0; body < parts_.size(); ++body) {
        const abut_pose pose{{0.8 * static_cast<double>(body % 4), 0.8 * static_cast<double>(body / 4), 0.1 * step},
                             {1, 0, 0, 0}};
        then([&] { return abut_part_set_pose(universe_, parts_.at(body), &pose); });
      }
      then([&] { return abut_universe_step(universe_, 0.01); });
    }
    then([&] {
      const abut_ray ray{{0, 0, 9}, {0, 0, -1}, 20};
      std::array<abut_query_hit, 4> hits;
      std::size_t count = 0;
      return abut_universe_cast_ray(universe_, &ray, nullptr, ABUT_HIT_ALL, hits.data(), hits.size(), &count);
    });
    then([&] {
      std::array<char, 100> text;
      std::size_t needed = 0;
      return abut_universe_explain(universe_, text.data(), text.size(), &needed);
    });
  }

  void write_and_read() {
    static std::array<std::uint8_t, 1 << 17> bytes;
    std::size_t size = 0;
    then([&] { return abut_universe_save(universe_, bytes.data(), bytes.size(), &size); });
    then([&] { return size > bytes.size() ? ABUT_INTERNAL : abut_universe_load(bytes.data(), size, &copy_); });
    then([&] { return abut_universe_step(copy_, 0.01); });
  }

  // A sentence about what is wrong needs memory too.
  void fail() {
    then([&] {
      abut_shape* none = nullptr;
      const abut_status status = abut_sphere_create(-1, &none);
      return status == ABUT_OUT_OF_RANGE ? abut_status{ABUT_OK} : status;
    });
  }

  abut_status status_ = ABUT_OK;
  std::array<abut_shape*, 8> shapes_{};
  std::size_t made_ = 0;
  std::array<abut_part_id, 16> parts_{};
  abut_universe* universe_ = nullptr;
  abut_universe* copy_ = nullptr;
};

}  // namespace

int live_once(bool with_hull, unsigned threads) { return Life().live(with_hull, threads); }

}  // namespace abut_test
