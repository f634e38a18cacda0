// SPDX-License-Identifier: Apache-2.0
#include "response_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "svg.hpp"

namespace bench {
namespace {

constexpr double panel_width = 300, panel_height = 260, left = 70, top = 60, gap_x = 70, gap_y = 80;
constexpr std::size_t columns = 4;
// Powers of ten at the ends of the axis of times, and how far down errors go.
constexpr int first_time = -3, last_time = 3, least_error = -30;

struct Mark {
  std::string_view engine, colour;
  int corners;  // 0: a circle
};
constexpr std::array marks{Mark{"abut Newton", "#08519c", 0}, Mark{"abut sweeps", "#6baed6", 0},
                           Mark{"Bullet", "#d62728", 3}, Mark{"ODE sweeps", "#7b4fa3", 5},
                           Mark{"ODE factors", "#c994c7", 5}};

double power_of(double value) {
  return value > 0 && std::isfinite(value) ? std::log10(value) : value > 0 ? 10 : least_error;
}

class Panel {
 public:
  Panel(Svg& svg, std::size_t place, const std::vector<Measured>& rows)
      : svg_(svg),
        x_(left + static_cast<double>(place % columns) * (panel_width + gap_x)),
        y_(top + static_cast<double>(place / columns) * (panel_height + gap_y)) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Measured& row : rows) {
      low = std::min(low, std::max<double>(least_error, power_of(row.error)));
      high = std::max(high, power_of(row.error));
    }
    first_error_ = static_cast<int>(std::floor(low)) - 1;
    last_error_ = std::min(static_cast<int>(std::ceil(high)) + 1, 10);
  }

  void draw(const std::vector<Measured>& rows) {
    frame(rows.front());
    for (const Mark& mark : marks) {
      double before_x = 0, before_y = 0;
      bool has_before = false;
      for (const Measured& row : rows) {
        if (row.engine != mark.engine) continue;
        const double x = across(power_of(row.milliseconds)), y = up(power_of(row.error));
        if (has_before) svg_.line(before_x, before_y, x, y, {mark.colour, 1.2});
        if (mark.corners == 0) {
          svg_.circle(x, y, 4.5, mark.colour, {"#404040", 0.6});
        } else {
          svg_.polygon(x, y, 5.5, mark.corners, mark.colour, {"#404040", 0.6});
        }
        before_x = x;
        before_y = y;
        has_before = true;
      }
    }
  }

 private:
  [[nodiscard]] double across(double power) const {
    return x_ + panel_width * std::clamp((power - first_time) / (last_time - first_time), 0.0, 1.0);
  }
  [[nodiscard]] double up(double power) const {
    const double part = (power - first_error_) / (last_error_ - first_error_);
    return y_ + panel_height * (1 - std::clamp(part, 0.0, 1.0));
  }

  void frame(const Measured& row) {
    svg_.rectangle(x_, y_, panel_width, panel_height, "#fafafa", {"#808080", 1});
    svg_.text(x_, y_ - 22, row.trial, 14, Anchor::start, true);
    svg_.text(x_, y_ - 7, row.error_name, 11, Anchor::start);
    for (int i = first_time; i <= last_time; ++i) {
      svg_.line(across(i), y_, across(i), y_ + panel_height, {"#e0e0e0", 0.7});
      svg_.text(across(i), y_ + panel_height + 14, "1e" + std::to_string(i), 10, Anchor::middle);
    }
    const int every = std::max(1, (last_error_ - first_error_) / 8);
    for (int i = first_error_; i <= last_error_; i += every) {
      svg_.line(x_, up(i), x_ + panel_width, up(i), {"#e0e0e0", 0.7});
      svg_.text(x_ - 5, up(i) + 3, "1e" + std::to_string(i), 10, Anchor::end);
    }
    svg_.text(x_ + panel_width / 2, y_ + panel_height + 30, "ms a step", 11, Anchor::middle);
  }

  Svg& svg_;
  double x_, y_;
  int first_error_ = 0, last_error_ = 0;
};

}  // namespace

void draw_errors(const std::filesystem::path& path, const std::vector<Measured>& all) {
  std::vector<std::vector<Measured>> panels;
  for (const Measured& row : all) {
    if (panels.empty() || panels.back().front().trial != row.trial) panels.emplace_back();
    panels.back().push_back(row);
  }
  const std::size_t lines = (panels.size() + columns) / columns;
  Svg svg(left + static_cast<double>(columns) * (panel_width + gap_x),
          top + static_cast<double>(lines) * (panel_height + gap_y));
  for (std::size_t i = 0; i < panels.size(); ++i) Panel(svg, i, panels[i]).draw(panels[i]);
  const double x = left + static_cast<double>(panels.size() % columns) * (panel_width + gap_x);
  double y = top + static_cast<double>(panels.size() / columns) * (panel_height + gap_y) + 20;
  for (const Mark& mark : marks) {
    if (mark.corners == 0) {
      svg.circle(x + 8, y - 4, 4.5, mark.colour, {"#404040", 0.6});
    } else {
      svg.polygon(x + 8, y - 4, 5.5, mark.corners, mark.colour, {"#404040", 0.6});
    }
    svg.text(x + 22, y, mark.engine, 12, Anchor::start);
    y += 20;
  }
  svg.write(path);
}

}  // namespace bench
