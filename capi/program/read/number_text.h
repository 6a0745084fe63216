/* Numbers as text: by arithmetic in 128-bit integers if it is exact, else by printf. The bytes are the same. */
#pragma once

#include <stddef.h>
#include <stdint.h>

/* Room for a number as the functions below write it, NUL included. */
#define NUMBER_BYTES 40

/* Write the digits of a number, at most 20, so that they end before `end`. Returns their beginning. */
char *number_text_digits(char *end, uint64_t value);

/* The first of "%.15g", "%.16g" and "%.17g" from which a reader gets the same double again; "0" for both zeros. Returns
 * the length. */
size_t number_text_exact(char out[NUMBER_BYTES], double value);

/* "%.*g" with 1 to 17 significant digits. Returns the length. */
size_t number_text_general(char out[NUMBER_BYTES], double value, int digits);

/* "%.*f" with 0 to 10 decimals of a value below 1e21. Returns the length. */
size_t number_text_fixed(char out[NUMBER_BYTES], double value, int decimals);
