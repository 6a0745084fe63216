// Four cells of a row at a time; for AVX2. Floors become results, so that nothing is fused here.
#if HSP_AVX2
#include "view/depth_rows.hpp"

#include "lanes/words.hpp"

namespace hsp {
namespace {

// Four cells of one row, where the disc meets them.
struct FourCells {
  __m256d left_over;  // what R^2 leaves to the height of the front above its centre
  __m256d met;        // whether it leaves anything
  __m128i cells_met;  // the same for floats

  FourCells(double in_row, const double *squared) {
    left_over = _mm256_sub_pd(_mm256_set1_pd(in_row), _mm256_loadu_pd(squared));
    met = _mm256_cmp_pd(left_over, _mm256_setzero_pd(), _CMP_GT_OQ);
    cells_met = narrowed(met);
  }
  static __m128i narrowed(__m256d mask) {
    const __m256 halves = _mm256_castpd_ps(mask);
    const __m128 chosen =
        _mm_shuffle_ps(_mm256_castps256_ps128(halves), _mm256_extractf128_ps(halves, 1), _MM_SHUFFLE(2, 0, 2, 0));
    return _mm_castps_si128(chosen);
  }
};

__m256d widened_less(__m128 cells, double base) {
  return _mm256_sub_pd(_mm256_cvtps_pd(cells), _mm256_set1_pd(base));
}
__m256d is_positive(__m256d a) {
  return _mm256_cmp_pd(a, _mm256_setzero_pd(), _CMP_GT_OQ);
}

}  // namespace

void measure_cells_avx2(const DiscOnCells &disc, DiscCells &cells) {
  EdgeDistances<4>(disc).fill(cells);
}

bool hides_avx2(const FloorCells &cells, const DiscCells &disc, double base) {
  const float *row = cells.floor + disc.first_row * cells.columns + disc.first_column;
  for (uint32_t r = 0; r < disc.rows; ++r, row += cells.columns) {
    for (uint32_t k = 0; k < disc.columns; k += 4) {
      const FourCells four(disc.in_row[r], disc.squared + k);
      const __m256d above = widened_less(_mm_maskload_ps(row + k, four.cells_met), base);
      const __m256d higher = _mm256_cmp_pd(_mm256_mul_pd(above, above), four.left_over, _CMP_GT_OQ);
      const __m256d hidden = _mm256_and_pd(is_positive(above), higher);
      if (_mm256_movemask_pd(_mm256_andnot_pd(hidden, four.met)) != 0) return false;
    }
  }
  return true;
}

void raise_avx2(const FloorCells &cells, const DiscCells &disc, double base, double margin) {
  for (uint32_t r = 0; r < disc.rows; ++r) {
    const uint32_t row = disc.first_row + r;
    float *const floor = cells.floor + row * cells.columns + disc.first_column;
    for (uint32_t k = 0; k < disc.columns; k += 4) {
      const FourCells four(disc.in_row[r], disc.squared + k);
      const __m128 before = _mm_maskload_ps(floor + k, four.cells_met);
      const __m256d above = widened_less(before, base);
      const __m256d high_enough = _mm256_cmp_pd(_mm256_mul_pd(above, above), four.left_over, _CMP_GE_OQ);
      const __m256d kept = _mm256_and_pd(is_positive(above), high_enough);
      if (_mm256_movemask_pd(_mm256_andnot_pd(kept, four.met)) == 0) continue;
      // NaN beyond the disc, which is above nothing.
      const __m256d height = _mm256_add_pd(_mm256_set1_pd(base), _mm256_sqrt_pd(four.left_over));
      const __m256d size = _mm256_andnot_pd(_mm256_set1_pd(-0.0), height);
      const __m256d lowered =
          _mm256_sub_pd(_mm256_sub_pd(height, _mm256_mul_pd(_mm256_set1_pd(0x1p-22), size)), _mm256_set1_pd(margin));
      const __m128 after = _mm256_cvtpd_ps(lowered);
      const __m128i raised = _mm_and_si128(_mm_castps_si128(_mm_cmpgt_ps(after, before)), four.cells_met);
      const LaneBits bits = static_cast<LaneBits>(_mm_movemask_ps(_mm_castsi128_ps(raised)));
      if (bits == 0) continue;
      _mm_maskstore_ps(floor + k, raised, after);
      uint8_t *const stale = cells.stale + row / coarse_side * cells.coarse_columns;
      const uint32_t column = disc.first_column + k;
      stale[(column + lowest(bits)) / coarse_side] = 1;
      stale[(column + 31U - static_cast<uint32_t>(__builtin_clz(bits))) / coarse_side] = 1;
    }
  }
}

}  // namespace hsp
#endif
