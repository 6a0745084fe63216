#include "element_radii.hpp"

namespace hsp {
namespace {

// Radii are in hundredths of an angstrom; 0: there is none.

// Van der Waals radii.
//   Main group: Mantina, Chamberlin, Valero, Cramer, Truhlar, "Consistent van der Waals radii for the whole main
//   group", J. Phys. Chem. A 113 (2009) 5806, Table 12, which keeps the radii of
//   Bondi, "Van der Waals volumes and radii", J. Phys. Chem. 68 (1964) 441, where he gives one (but for hydrogen, after
//   Rowland and Taylor, J. Phys. Chem. 100 (1996) 7384) and adds the others.
//   Ni Cu Zn Pd Ag Cd Au Hg U: Bondi 1964. Platinum is left out: those who cite Bondi disagree about it (1.72, 1.75).
constexpr uint16_t bondi[] = {
    110, 140,                                                         // H He
    181, 153, 192, 170, 155, 152, 147, 154,                           // Li to Ne
    227, 173, 184, 210, 180, 180, 175, 188,                           // Na to Ar
    275, 231,                                                         // K Ca
    0,   0,   0,   0,   0,   0,   0,   163, 140, 139,                 // Sc to Zn
    187, 211, 185, 190, 183, 202,                                     // Ga to Kr
    303, 249,                                                         // Rb Sr
    0,   0,   0,   0,   0,   0,   0,   163, 172, 158,                 // Y to Cd
    193, 217, 206, 206, 198, 216,                                     // In to Xe
    343, 268,                                                         // Cs Ba
    0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0, 0, 0, 0, 0,  // La to Lu
    0,   0,   0,   0,   0,   0,   0,   166, 155,                      // Hf to Hg
    196, 202, 207, 197, 202, 220,                                     // Tl to Rn
    348, 283,                                                         // Fr Ra
    0,   0,   0,   186,                                               // Ac to U
    0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,              // Np to Lr
    0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0, 0, 0, 0, 0,  // Rf to Og
};
static_assert(sizeof bondi / sizeof bondi[0] == element_count);

// The radii of Halperin and Overmars, Section 2, which come from the modelling package Chem3D Plus.
uint32_t chem3d(uint32_t atomic_number) {
  switch (atomic_number) {
    case 1:  // H
      return 70;
    case 6:  // C
      return 152;
    case 7:  // N
      return 136;
    case 8:  // O
      return 128;
    case 15:  // P
      return 218;
    case 16:  // S
      return 210;
    case 20:  // Ca
      return 348;
    default:
      return 0;
  }
}

// The distances x_I of Rappe et al. 1992, Table 1, in thousandths of an angstrom, which all types of an element share.
constexpr uint16_t uff[] = {
    2886, 2362,                                                                                // H He
    2451, 2745, 4083, 3851, 3660, 3500, 3364, 3243,                                            // Li to Ne
    2983, 3021, 4499, 4295, 4147, 4035, 3947, 3868,                                            // Na to Ar
    3812, 3399,                                                                                // K Ca
    3295, 3175, 3144, 3023, 2961, 2912, 2872, 2834, 3495, 2763,                                // Sc to Zn
    4383, 4280, 4230, 4205, 4189, 4141,                                                        // Ga to Kr
    4114, 3641,                                                                                // Rb Sr
    3345, 3124, 3165, 3052, 2998, 2963, 2929, 2899, 3148, 2848,                                // Y to Cd
    4463, 4392, 4420, 4470, 4500, 4404,                                                        // In to Xe
    4517, 3703,                                                                                // Cs Ba
    3522, 3556, 3606, 3575, 3547, 3520, 3493, 3368, 3451, 3428, 3409, 3391, 3374, 3355, 3640,  // La to Lu
    3141, 3170, 3069, 2954, 3120, 2840, 2754, 3293, 2705,                                      // Hf to Hg
    4347, 4297, 4370, 4709, 4750, 4765,                                                        // Tl to Rn
    4900, 3677,                                                                                // Fr Ra
    3478, 3396, 3424, 3395,                                                                    // Ac to U
    3424, 3424, 3381, 3326, 3339, 3313, 3299, 3286, 3274, 3248, 3236,                          // Np to Lr
};
constexpr uint32_t uff_count = sizeof uff / sizeof uff[0];
static_assert(uff_count == 103);

// x_I / 2^(1/6), rounded: 58386 is 2^(95/6).
constexpr uint32_t sigma(uint32_t distance) {
  return (distance * 58386 + 32768) >> 16;
}

constexpr uint32_t substitute = 200;

// Division rounds correctly: the result is the double nearest to the printed radius.
constexpr double angstrom(uint32_t hundredths) {
  return hundredths / 100.0;
}

}  // namespace

ElementRadius element_radius(RadiiSet set, uint32_t atomic_number) {
  if (set == RadiiSet::uff && atomic_number <= uff_count) return {sigma(uff[atomic_number - 1]) / 2000.0, false};
  const uint32_t of_bondi = bondi[atomic_number - 1];
  const uint32_t published = set == RadiiSet::chem3d ? chem3d(atomic_number) : of_bondi;
  if (published != 0) return {angstrom(published), false};
  return {angstrom(of_bondi != 0 ? of_bondi : substitute), true};
}

}  // namespace hsp
