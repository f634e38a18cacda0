// SPDX-License-Identifier: Apache-2.0
// abut-demo: bodies of many shapes slide over real terrain, and a cloth falls on a bunny; see usage() for what it does
// and writes.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include "annotate.hpp"
#include "csv.hpp"
#include "common/progress.hpp"
#include "options.hpp"
#include "picture/render.hpp"
#include "scene.hpp"
#include "shade.hpp"
#include "statistics.hpp"

namespace demo {
namespace {

class Stopwatch {
 public:
  [[nodiscard]] double microseconds() const {
    const std::chrono::duration<double, std::micro> elapsed = std::chrono::steady_clock::now() - start_;
    return elapsed.count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

constexpr PickingFunctions picking{abut_picker_create, abut_picker_destroy, abut_picker_render, abut_picker_cast_rays,
                                   abut_camera_init,   abut_camera_look_at, abut_camera_ray};

// A camera above the slopes on which the bodies lie: at the edge of the plateau, looking north-east over the spurs
// below it to the water gap in the far ridge.
abut_camera make_camera(const Picker& picker, const Terrain& terrain, const Options& options) {
  const double x = -250.0;
  const double y = -1750.0;
  const Vec3 eye{x, y, terrain.height(x, y) + 540.0};
  return picker.camera(options.width, options.height, 0.76, eye, {1400.0, 400.0, 590.0}, {0.0, 0.0, 1.0});
}

struct Seen {
  std::size_t contacts;
  std::size_t on_cloth;
};

// Draws the last step; returns how many contacts are in plain sight.
Seen draw_picture(const std::filesystem::path& path, const Options& options, const Scene& scene,
                  const std::vector<abut_contact>& contacts, Elsewhere progress) {
  const Picker picker(picking, scene.universe());
  const abut_camera camera = make_camera(picker, scene.terrain(), options);
  Picture picture = render(picker, Hillside(scene), camera, progress);
  const Seen seen{mark_contacts(picture, camera, contacts, scene), mark_cloth(picture, camera, scene)};
  draw_legend(picture.image, scene, contacts.size());
  write_png(path, picture.image);
  return seen;
}

Statistics run_steps(Scene& scene, const Options& options) {
  const std::uint32_t steps = options.steps;
  Statistics statistics;
  Progress progress("steps", steps);
  progress.show(0);
  for (std::uint32_t step = 1; step <= steps; ++step) {
    const Stopwatch motion;
    scene.move();
    const double motion_microseconds = motion.microseconds();
    const Stopwatch cloth;
    scene.move_cloth();
    const double cloth_microseconds = cloth.microseconds();
    const Stopwatch whole;
    scene.detect();
    statistics.record(scene.universe(), motion_microseconds, whole.microseconds());
    statistics.record_cloth(scene.cloth(), cloth_microseconds);
    if (options.every > 0 && step % options.every == 0) {
      const std::string name = std::to_string(step / options.every) + ".png";
      draw_picture(options.out / "film" / name, options, scene, contacts_of(scene.universe()), Elsewhere::nothing);
    }
    progress.show(step);
  }
  progress.finish();
  return statistics;
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    throw Failure("cannot make the folder " + folder.string() + ": " + error.message());
  }
}

void run(const Options& options) {
  make_folder(options.every > 0 ? options.out / "film" : options.out);
  Scene scene(options.data, options.bodies, options.seed, options.threads);
  std::printf(
      "abut %s: %zu bodies of %zu geometries and %zu shapes on %u x %u elevations (heights x %g), %u steps of %g s, "
      "seed %llu, threads: %s\n",
      abut_version_string(), scene.body_count(), scene.geometry_count(), scene.shape_count(), scene.terrain().columns(),
      scene.terrain().rows(), Terrain::exaggeration, options.steps, step_seconds,
      static_cast<unsigned long long>(options.seed),
      options.threads == 0 ? "all" : std::to_string(options.threads).c_str());
  std::fflush(stdout);
  const Statistics statistics = run_steps(scene, options);
  const std::vector<abut_contact> contacts = contacts_of(scene.universe());
  statistics.print();
  std::printf("\nexcavation: %.2f million cubic metres\n", 1e-6 * scene.terrain().excavated());
  if (options.explain) {
    std::printf("\n%s", plan_of(scene.universe()).c_str());
  }
  write_contacts(options.out / "contacts.csv", options.steps, contacts, scene);
  write_steps(options.out / "steps.csv", statistics.steps());
  write_cloth(options.out / "cloth.csv", scene.cloth());
  std::fflush(stdout);
  const Stopwatch watch;
  const Seen seen = draw_picture(options.out / "scene.png", options, scene, contacts, Elsewhere::lines);
  std::printf("\npicture: %u x %u pixels, %zu of %zu contacts and %zu of %zu element contacts in plain sight, %.1f s\n",
              options.width, options.height, seen.contacts, contacts.size(), seen.on_cloth,
              scene.cloth().contacts().size(), 1e-6 * watch.microseconds());
  std::printf("wrote %s: contacts.csv and cloth.csv (the last step), steps.csv (all steps), scene.png\n",
              options.out.c_str());
}

}  // namespace
}  // namespace demo

int main(int argc, char** argv) {
  try {
    std::vector<const char*> words(static_cast<std::size_t>(argc));
    std::copy_n(argv, words.size(), words.begin());
    const std::vector<std::string> arguments(words.begin() + (words.empty() ? 0 : 1), words.end());
    const demo::Options options = demo::parse_options(arguments);
    if (options.help) {
      std::fputs(demo::usage(), stdout);
      return EXIT_SUCCESS;
    }
    demo::check(abut_check_version(ABUT_VERSION_MAJOR, ABUT_VERSION_MINOR),
                "this program needs another version of abut");
    demo::run(options);
    return EXIT_SUCCESS;
  } catch (const std::exception& failure) {
    std::fprintf(stderr, "abut-demo: %s.\n", failure.what());
    return EXIT_FAILURE;
  }
}
