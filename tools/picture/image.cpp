// SPDX-License-Identifier: Apache-2.0
#include "image.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>

#include <png.h>

#include "common/owners.hpp"

namespace tools {
namespace {

double distance_to_segment(double px, double py, double x0, double y0, double x1, double y1) {
  const double dx = x1 - x0;
  const double dy = y1 - y0;
  const double square = dx * dx + dy * dy;
  const double t = square > 0.0 ? std::clamp(((px - x0) * dx + (py - y0) * dy) / square, 0.0, 1.0) : 0.0;
  return std::hypot(px - (x0 + t * dx), py - (y0 + t * dy));
}

std::uint8_t srgb_byte(double linear) {
  const double c = std::clamp(linear, 0.0, 1.0);
  const double encoded = c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1.0 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(255.0 * encoded));
}

}  // namespace

// Blends the colour in where the signed distance from the outline is negative, over one pixel of transition.
template <class Distance>
void Image::cover(double x0, double y0, double x1, double y1, const Colour& colour, double opacity, Distance distance) {
  const auto limit = [](double v, std::uint32_t most) {
    return static_cast<std::size_t>(std::clamp(v, 0.0, static_cast<double>(most)));
  };
  const std::size_t last_x = limit(std::ceil(x1) + 1.0, width_);
  const std::size_t last_y = limit(std::ceil(y1) + 1.0, height_);
  for (std::size_t y = limit(std::floor(y0) - 1.0, height_); y < last_y; ++y) {
    for (std::size_t x = limit(std::floor(x0) - 1.0, width_); x < last_x; ++x) {
      const double inside = 0.5 - distance(static_cast<double>(x) + 0.5, static_cast<double>(y) + 0.5);
      const double coverage = std::clamp(inside, 0.0, 1.0) * opacity;
      at(x, y) = mix(at(x, y), colour, coverage);
    }
  }
}

void Image::draw_disc(double x, double y, double radius, const Colour& colour, double opacity) {
  cover(x - radius, y - radius, x + radius, y + radius, colour, opacity,
        [&](double px, double py) { return std::hypot(px - x, py - y) - radius; });
}

void Image::draw_ring(double x, double y, double radius, double width, const Colour& colour, double opacity) {
  const double outer = radius + 0.5 * width;
  cover(x - outer, y - outer, x + outer, y + outer, colour, opacity,
        [&](double px, double py) { return std::abs(std::hypot(px - x, py - y) - radius) - 0.5 * width; });
}

void Image::draw_line(double x0, double y0, double x1, double y1, double width, const Colour& colour, double opacity) {
  const double half = 0.5 * width;
  cover(std::min(x0, x1) - half, std::min(y0, y1) - half, std::max(x0, x1) + half, std::max(y0, y1) + half, colour,
        opacity, [&](double px, double py) { return distance_to_segment(px, py, x0, y0, x1, y1) - half; });
}

void Image::draw_panel(double x0, double y0, double x1, double y1, double corner, const Colour& colour,
                       double opacity) {
  cover(x0, y0, x1, y1, colour, opacity, [&](double px, double py) {
    const double dx = std::max({x0 + corner - px, px - (x1 - corner), 0.0});
    const double dy = std::max({y0 + corner - py, py - (y1 - corner), 0.0});
    return std::hypot(dx, dy) - corner;
  });
}

// Fit of the ACES film curve by Narkowicz (2015).
Colour tone_mapped(const Colour& light) {
  const auto curve = [](double c) {
    return std::clamp(c * (2.51 * c + 0.03) / (c * (2.43 * c + 0.59) + 0.14), 0.0, 1.0);
  };
  return {curve(light.r), curve(light.g), curve(light.b)};
}

std::string encode_png(const Image& image) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(3 * std::size_t{image.width()} * image.height());
  for (std::size_t y = 0; y < image.height(); ++y) {
    for (std::size_t x = 0; x < image.width(); ++x) {
      const Colour& c = image.at(x, y);
      bytes.insert(bytes.end(), {srgb_byte(c.r), srgb_byte(c.g), srgb_byte(c.b)});
    }
  }
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = image.width();
  header.height = image.height();
  header.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(header);
  std::string encoded(size, '\0');
  if (png_image_write_to_memory(&header, encoded.data(), &size, 0, bytes.data(), 0, nullptr) == 0) {
    throw Failure("cannot encode a picture as PNG");
  }
  encoded.resize(size);
  return encoded;
}

void write_png(const std::filesystem::path& path, const Image& image) {
  std::ofstream out(path, std::ios::binary);
  out << encode_png(image) << std::flush;
  if (!out) {
    throw Failure("cannot write " + path.string());
  }
}

}  // namespace tools
