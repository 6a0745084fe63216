#include "picture/palettes.hpp"

#include "picture/colour.hpp"

namespace hsp {
namespace {

// Jmol's colours of the elements 1 to 109, and at 0 of those that it does not know (its documentation, "Jmol colors").
constexpr uint32_t by_element[] = {
    0xFF1493, 0xFFFFFF, 0xD9FFFF, 0xCC80FF, 0xC2FF00, 0xFFB5B5, 0x909090, 0x3050F8, 0xFF0D0D, 0x90E050, 0xB3E3F5,
    0xAB5CF2, 0x8AFF00, 0xBFA6A6, 0xF0C8A0, 0xFF8000, 0xFFFF30, 0x1FF01F, 0x80D1E3, 0x8F40D4, 0x3DFF00, 0xE6E6E6,
    0xBFC2C7, 0xA6A6AB, 0x8A99C7, 0x9C7AC7, 0xE06633, 0xF090A0, 0x50D050, 0xC88033, 0x7D80B0, 0xC28F8F, 0x668F8F,
    0xBD80E3, 0xFFA100, 0xA62929, 0x5CB8D1, 0x702EB0, 0x00FF00, 0x94FFFF, 0x94E0E0, 0x73C2C9, 0x54B5B5, 0x3B9E9E,
    0x248F8F, 0x0A7D8C, 0x006985, 0xC0C0C0, 0xFFD98F, 0xA67573, 0x668080, 0x9E63B5, 0xD47A00, 0x940094, 0x429EB0,
    0x57178F, 0x00C900, 0x70D4FF, 0xFFFFC7, 0xD9FFC7, 0xC7FFC7, 0xA3FFC7, 0x8FFFC7, 0x61FFC7, 0x45FFC7, 0x30FFC7,
    0x1FFFC7, 0x00FF9C, 0x00E675, 0x00D452, 0x00BF38, 0x00AB24, 0x4DC2FF, 0x4DA6FF, 0x2194D6, 0x267DAB, 0x266696,
    0x175487, 0xD0D0E0, 0xFFD123, 0xB8B8D0, 0xA6544D, 0x575961, 0x9E4FB5, 0xAB5C00, 0x754F45, 0x428296, 0x420066,
    0x007D00, 0x70ABFA, 0x00BAFF, 0x00A1FF, 0x008FFF, 0x0080FF, 0x006BFF, 0x545CF2, 0x785CE3, 0x8A4FE3, 0xA136D4,
    0xB31FD4, 0xB31FBA, 0xB30DA6, 0xBD0D87, 0xC70066, 0xCC0059, 0xD1004F, 0xD90045, 0xE00038, 0xE6002E, 0xEB0026};
constexpr uint32_t elements = sizeof by_element / sizeof by_element[0];
static_assert(elements == 110);

// Lightness in OKLab (Ottosson 2020) of the first four: .77, .70, .90, .83, so that they differ in grey print.
// As protanopes and deuteranopes see them (Machado, Oliveira and Fernandes 2009) any two of these four are at least .09
// apart, any two of all twelve .045; for others .12 and .075.
constexpr uint32_t tints[12] = {0xE8A074, 0x6BA0E1, 0xFDDC88, 0xB0D3BB, 0xC4ADCE, 0x6F9F97,
                                0xCE785D, 0xC1F3BD, 0xEAD3F3, 0x67BFA8, 0xD9C280, 0xA099C2};

// All elements but carbon are made darker by that, and keep their hue.
constexpr double darker = 0.12;

constexpr uint32_t carbon = 6;

uint32_t soft_colour(uint32_t atomic_number) {
  switch (atomic_number) {
    case 1:
      return 0xFBFAF7;
    case carbon:
      return 0xD2CDC3;
    case 7:
      return 0x86A9F2;
    case 8:
      return 0xF2705C;
    case 15:
      return 0xF0A04B;
    case 16:
      return 0xF8D660;
    case 26:
      return 0xD9822B;
    default:
      break;
  }
  // All other elements keep their hue, half way to a light grey.
  return 0 < atomic_number && atomic_number < elements ? mixed(by_element[atomic_number], 0xDCD8D0, 0.5) : 0xD7A6C8;
}

}  // namespace

uint32_t palette_colour(Palette palette, uint32_t atomic_number, uint32_t chain) {
  switch (palette) {
    case Palette::jmol:
      return by_element[atomic_number < elements ? atomic_number : 0];
    case Palette::chain: {
      const uint32_t tint = tints[chain % 12];
      return atomic_number == carbon ? tint : mixed(tint, 0x000000, darker);
    }
    default:
      return soft_colour(atomic_number);
  }
}

}  // namespace hsp
