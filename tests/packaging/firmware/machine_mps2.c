/* The boards mps2-an385, an386 and an500, with a Cortex-M3, M4 or M7, as QEMU has them: start-up, semihosting, and a
 * timer that counts instructions: with -icount shift=5 each takes 32 ns, and the timer's ticks are 40 ns. */
#include "machine.h"

extern unsigned char pool_begin[], stack_end[], stack_top[];
extern uint32_t data_begin[], data_end[], data_in_rom[], bss_begin[], bss_end[];

int main(void);

/* Requests to the debugger, here QEMU. */
enum { WRITE_TEXT = 4, EXIT_WITH_STATUS = 0x20, APPLICATION_EXIT = 0x20026 };

static void request(uint32_t number, const void *argument) {
  register uint32_t r0 __asm__("r0") = number;
  register const void *r1 __asm__("r1") = argument;
  __asm__ volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
}

static void leave(uint32_t status) {
  const uint32_t block[2] = {APPLICATION_EXIT, status};
  request(EXIT_WITH_STATUS, block);
  for (;;) {
  }
}

void reset(void);
static void fault(void) {
  leave(86);
}

__attribute__((section(".vectors"), used)) static const void *const vectors[16] = {
    stack_top,           (const void *)reset, (const void *)fault, (const void *)fault,
    (const void *)fault, (const void *)fault, (const void *)fault};

/* Before any variable is used; the coprocessor register lets M4 and M7 use their floating-point units. */
__attribute__((noreturn)) void reset(void) {
  *(volatile uint32_t *)0xE000ED88 |= UINT32_C(0xF) << 20;
  __asm__ volatile("dsb\n isb");
  for (uint32_t *to = data_begin, *from = data_in_rom; to < data_end;) *to++ = *from++;
  for (uint32_t *to = bss_begin; to < bss_end;) *to++ = 0;
  leave((uint32_t)main());
  for (;;) {
  }
}

unsigned char *machine_pool(void) {
  return pool_begin;
}

size_t machine_pool_bytes(void) {
  return (size_t)(stack_end - pool_begin);
}

void machine_print(const char *text) {
  request(WRITE_TEXT, text);
}

static volatile uint32_t *const timer = (volatile uint32_t *)0x40000000; /* control, value, reload */
static unsigned char *top;
enum { UNUSED = 0xA5 };

/* The stack below this function's frame is painted; what is painted no more was used. */
__attribute__((noinline)) void machine_begin(void) {
  top = (unsigned char *)__builtin_frame_address(0) - 64;
  for (volatile unsigned char *byte = stack_end; byte < top; ++byte) *byte = UNUSED;
  timer[0] = 0;
  timer[2] = timer[1] = UINT32_MAX;
  timer[0] = 1;
}

int machine_cost(uint32_t cost[2]) {
  const uint32_t ticks = UINT32_MAX - timer[1];
  const volatile unsigned char *byte = stack_end;
  while (byte < top && *byte == UNUSED) ++byte;
  cost[0] = (uint32_t)((uint64_t)ticks * 40 / 32 / 1000);
  cost[1] = (uint32_t)(top - byte) + 64;
  if (byte == stack_end) leave(87); /* the stack was too small, or just large enough */
  return 1;
}

int machine_may_retry(void) {
  return 0;
}
