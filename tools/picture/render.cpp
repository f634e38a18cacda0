// SPDX-License-Identifier: Apache-2.0
#include "render.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <future>
#include <thread>

#include "light.hpp"

namespace tools {
namespace {

constexpr std::size_t block = 8192;  // samples that a thread takes at a time

// Runs work(first, last) over [0, count) in blocks, on every processor. What a block computes depends on the block
// alone, so the picture is the same for any number of threads.
template <class Work>
void in_blocks(std::size_t count, Progress& progress, Work work) {
  std::atomic<std::size_t> next{0};
  const auto run = [&](bool shows) {
    for (std::size_t first = next.fetch_add(block); first < count; first = next.fetch_add(block)) {
      work(first, std::min(first + block, count));
      if (shows) {
        progress.show(std::min(next.load(), count));
      }
    }
  };
  std::vector<std::future<void>> others;
  for (unsigned i = 1; i < std::thread::hardware_concurrency(); ++i) {
    others.push_back(std::async(std::launch::async, run, false));
  }
  run(true);
  for (std::future<void>& other : others) {
    other.get();
  }
}

abut_ray ray_of_pixel(const Picker& picker, const abut_camera& camera, std::size_t index) {
  return picker.ray(camera, static_cast<double>(index % camera.width) + 0.5,
                    static_cast<double>(index / camera.width) + 0.5);
}

// Width of a pixel at distance 1.
double pixel_width(const abut_camera& camera) { return 2.0 * std::tan(0.5 * camera.vertical_fov) / camera.height; }

std::uint32_t pattern_of_pixel(std::size_t index, std::uint32_t width) {
  return static_cast<std::uint32_t>((index % width) % 4 + 4 * ((index / width) % 4));
}

std::vector<Light> light_of_pixels(const Picker& picker, const Look& look, const abut_camera& camera,
                                   const std::vector<abut_pick>& picks, Elsewhere elsewhere) {
  std::vector<Light> lights(picks.size());
  Progress progress("light", picks.size(), elsewhere);
  in_blocks(picks.size(), progress, [&](std::size_t first, std::size_t last) {
    std::vector<Sample> samples;
    samples.reserve(last - first);
    for (std::size_t i = first; i < last; ++i) {
      samples.push_back({ray_of_pixel(picker, camera, i), picks[i], pattern_of_pixel(i, camera.width)});
    }
    std::ranges::copy(trace_light(picker, look, samples), lights.begin() + static_cast<std::ptrdiff_t>(first));
  });
  progress.finish();
  return lights;
}

// Light averaged over 4 x 4 pixels, in which every pattern occurs once, of the same thing at the same depth.
Light smoothed(const std::vector<Light>& lights, const std::vector<abut_pick>& picks, std::size_t index,
               const abut_camera& camera) {
  const std::size_t x = index % camera.width;
  const std::size_t y = index / camera.width;
  const abut_pick& centre = picks[index];
  Light sum{0.0, 0.0};
  double count = 0.0;
  for (std::size_t j = y > 0 ? y - 1 : y; j < std::min<std::size_t>(y + 3, camera.height); ++j) {
    for (std::size_t i = x > 0 ? x - 1 : x; i < std::min<std::size_t>(x + 3, camera.width); ++i) {
      const std::size_t neighbour = j * camera.width + i;
      const abut_pick& pick = picks[neighbour];
      if (pick.geometry.slot == centre.geometry.slot && dot(pick.normal, centre.normal) > 0.8 &&
          std::abs(pick.distance - centre.distance) < 0.02 * centre.distance) {
        sum = {sum.sun + lights[neighbour].sun, sum.sky + lights[neighbour].sky};
        count += 1.0;
      }
    }
  }
  return count > 0.0 ? Light{sum.sun / count, sum.sky / count} : lights[index];
}

// Perceived difference of two tone-mapped colours, roughly.
double contrast(const Colour& a, const Colour& b) {
  const auto eye = [](double c) { return std::sqrt(c); };
  return std::max({std::abs(eye(a.r) - eye(b.r)), std::abs(eye(a.g) - eye(b.g)), std::abs(eye(a.b) - eye(b.b))});
}

std::vector<std::size_t> edge_pixels(const Image& image) {
  constexpr double visible = 0.035;
  std::vector<std::size_t> edges;
  for (std::size_t y = 0; y < image.height(); ++y) {
    for (std::size_t x = 0; x < image.width(); ++x) {
      const Colour& c = image.at(x, y);
      const bool edge = (x > 0 && contrast(c, image.at(x - 1, y)) > visible) ||
                        (x + 1 < image.width() && contrast(c, image.at(x + 1, y)) > visible) ||
                        (y > 0 && contrast(c, image.at(x, y - 1)) > visible) ||
                        (y + 1 < image.height() && contrast(c, image.at(x, y + 1)) > visible);
      if (edge) {
        edges.push_back(y * image.width() + x);
      }
    }
  }
  return edges;
}

// Replaces pixels at edges by the mean of samples spread so that no two share a row or a column.
void refine(const Picker& picker, const Look& look, const abut_camera& camera, Image& image, Elsewhere elsewhere) {
  const double pixel = pixel_width(camera);
  constexpr std::array<double, 8> across{1.5, 4.5, 6.5, 0.5, 3.5, 7.5, 2.5, 5.5};
  const std::vector<std::size_t> edges = edge_pixels(image);
  Progress progress("edges", across.size() * edges.size(), elsewhere);
  in_blocks(across.size() * edges.size(), progress, [&](std::size_t first, std::size_t last) {
    std::vector<abut_ray> rays;
    for (std::size_t i = first; i < last; ++i) {
      const std::size_t edge = edges[i / across.size()];
      const std::size_t k = i % across.size();
      rays.push_back(picker.ray(camera, static_cast<double>(edge % image.width()) + across[k] / 8.0,
                                static_cast<double>(edge / image.width()) + (static_cast<double>(k) + 0.5) / 8.0));
    }
    const std::vector<abut_pick> picks = picker.cast(rays, ABUT_COHERENCE_NEIGHBOURS);
    std::vector<Sample> samples;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      samples.push_back({rays[i], picks[i], static_cast<std::uint32_t>(2 * (i % across.size()))});
    }
    const std::vector<Light> lights = trace_light(picker, look, samples);
    // A block holds whole pixels: its size is a multiple of the samples of a pixel.
    static_assert(block % across.size() == 0);
    for (std::size_t i = 0; i < samples.size(); i += across.size()) {
      Colour sum{0.0, 0.0, 0.0};
      for (std::size_t k = i; k < i + across.size(); ++k) {
        sum = sum + tone_mapped(look.shade(samples[k].ray, samples[k].pick, lights[k], pixel));
      }
      image.pixels()[edges[(first + i) / across.size()]] = sum * (1.0 / across.size());
    }
  });
  progress.finish();
}

}  // namespace

Picture render(const Picker& picker, const Look& look, const abut_camera& camera, Elsewhere elsewhere) {
  Picture picture{Image(camera.width, camera.height), picker.render(camera)};
  const std::vector<abut_pick>& picks = picture.picks;
  const double pixel = pixel_width(camera);
  const std::vector<Light> lights = light_of_pixels(picker, look, camera, picks, elsewhere);
  for (std::size_t i = 0; i < picks.size(); ++i) {
    const Light light = smoothed(lights, picks, i, camera);
    picture.image.pixels()[i] = tone_mapped(look.shade(ray_of_pixel(picker, camera, i), picks[i], light, pixel));
  }
  refine(picker, look, camera, picture.image, elsewhere);
  return picture;
}

}  // namespace tools
