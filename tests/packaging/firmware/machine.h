/* The image's demands on a machine: memory, a way out for text, and what its instructions and stack cost. */
#ifndef HARDSPHERE_FIRMWARE_MACHINE_H
#define HARDSPHERE_FIRMWARE_MACHINE_H

#include <stddef.h>
#include <stdint.h>

/* All memory that is neither variables nor stack. */
unsigned char *machine_pool(void);
size_t machine_pool_bytes(void);

void machine_print(const char *text);

/* From here on instructions and stack are counted. */
void machine_begin(void);

/* Thousands of instructions since then, and the most bytes of stack. Returns 0 where neither is counted. */
int machine_cost(uint32_t cost[2]);

/* Whether limits that were too small may be made larger: not on the machine that they have to be exact for. */
int machine_may_retry(void);

#endif
