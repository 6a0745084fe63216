// Checks of lanes/avx2_lanes.hpp, compiled for AVX2 apart from the test, which asks first whether the processor has it.
#pragma once

// Each returns null, or what is wrong.
const char *check_float_lanes();
const char *check_double_lanes();
const char *check_integer_lanes();
const char *check_comparisons();
const char *check_parts_and_counts();
const char *check_long_integers();
const char *check_front_orders();
const char *check_four_doubles();  // those of lanes/wide.hpp
