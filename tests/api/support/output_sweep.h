/* A sweep over the capacities of an output array. */
#pragma once

#include <stddef.h>
#include <stdint.h>

/* The number of capacities that are tried: 0, 1, needed-1, needed, needed+1. */
enum { AROUND = 5 };
void values_around(uint32_t needed, uint32_t values[AROUND]);

/* A function that fills an array of records, with all its other arguments in `question`. */
typedef int32_t (*asking)(const void *question, void *out, uint32_t capacity, uint32_t *needed);

/* Asks for an array of `expected` records, each of `record` bytes: without an array, and at all capacities around the
 * right one, between guard bytes. Checks for HSP_E_CAPACITY with nothing written, or success with exactly that many
 * records, every byte of them, and nothing behind them. The number needed is always reported. */
void sweep_output(asking ask, const void *question, size_t record, uint32_t expected);
