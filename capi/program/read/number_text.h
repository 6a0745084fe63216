/* Numbers as text, without printf where 128-bit integers hold what is exact; printf writes the rest, the same bytes. */
#pragma once

#include <stddef.h>
#include <stdint.h>

/* Room for a number as the functions below write it, NUL included. */
#define NUMBER_BYTES 40

/* The digits of a number, ending before `end`, at most 20. Returns where they begin. */
char *number_text_digits(char *end, uint64_t value);

/* The shortest of 15 to 17 significant digits that a reader turns into the same double again: "%.15g", "%.16g" or
 * "%.17g", with "0" for both zeros. Returns the length. */
size_t number_text_exact(char out[NUMBER_BYTES], double value);

/* "%.*g" with 1 to 17 significant digits. Returns the length. */
size_t number_text_general(char out[NUMBER_BYTES], double value, int digits);

/* "%.*f" with 0 to 10 decimals of a value below 1e21. Returns the length. */
size_t number_text_fixed(char out[NUMBER_BYTES], double value, int decimals);
