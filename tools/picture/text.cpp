// SPDX-License-Identifier: Apache-2.0
#include "text.hpp"

#include <array>

namespace tools {
namespace {

// Strokes on a grid 4 wide and 6 high: pairs of digits are x and y from the upper left; a space lifts the pen.
struct Glyph {
  char letter;
  std::string_view strokes;
};

constexpr std::array<Glyph, 44> glyphs{{
    {'A', "061220323646 0444"},
    {'B', "0003060636454434030300303141423303"},
    {'C', "413010010516363645"},
    {'D', "000626444220 2000"},
    {'E', "40000646 0333"},
    {'F', "400006 0333"},
    {'G', "413010010516364544432343"},
    {'H', "0006 4046 0343"},
    {'I', "2026 1030 1636"},
    {'J', "404535261605"},
    {'K', "0006 400346"},
    {'L', "000646"},
    {'M', "0600234046"},
    {'N', "06004640"},
    {'O', "10010516364541301010"},
    {'P', "06003041423303"},
    {'Q', "103041453616050110 2446"},
    {'R', "06003041423303 2346"},
    {'S', "413010010213334445361605"},
    {'T', "0040 2026"},
    {'U', "000516364540"},
    {'V', "002640"},
    {'W', "0016233640"},
    {'X', "0046 4006"},
    {'Y', "0023 402326"},
    {'Z', "00400646"},
    {'0', "103041453616050110 1432"},
    {'1', "112026 1636"},
    {'2', "01103041420646"},
    {'3', "0110304142334445361605 1333"},
    {'4', "36300444"},
    {'5', "4000023242 324345361605"},
    {'6', "403010010516364544331303"},
    {'7', "004016"},
    {'8', "133342413010010213041516363645443313"},
    {'9', "4330100102133343 41453616"},
    {'.', "2626"},
    {',', "2517"},
    {'-', "1333"},
    {':', "2222 2525"},
    {'/', "0640"},
    {'%', "0640 1010 3636"},
    {'(', "30121434 3436"},
    {')', "10323416"},
}};

constexpr double advance = 6.0 / 6.0;  // of the height
constexpr double grid = 6.0;

char capital(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

std::string_view strokes_of(char c) {
  for (const Glyph& glyph : glyphs) {
    if (glyph.letter == capital(c)) {
      return glyph.strokes;
    }
  }
  return {};
}

void draw_strokes(Image& image, double x, double y, double unit, std::string_view strokes, const Colour& colour) {
  bool down = false;
  double from_x = 0.0;
  double from_y = 0.0;
  for (std::size_t i = 0; i + 1 < strokes.size();) {
    if (strokes[i] == ' ') {
      down = false;
      ++i;
      continue;
    }
    const double to_x = x + unit * (strokes[i] - '0');
    const double to_y = y + unit * (strokes[i + 1] - '0');
    if (down) {
      image.draw_line(from_x, from_y, to_x, to_y, 0.85 * unit + 0.25, colour, 1.0);
    }
    from_x = to_x;
    from_y = to_y;
    down = true;
    i += 2;
  }
}

}  // namespace

void draw_text(Image& image, double x, double y, double height, std::string_view text, const Colour& colour) {
  for (const char c : text) {
    draw_strokes(image, x, y, height / grid, strokes_of(c), colour);
    x += advance * height;
  }
}

double text_width(std::string_view text, double height) { return advance * height * static_cast<double>(text.size()); }

}  // namespace tools
