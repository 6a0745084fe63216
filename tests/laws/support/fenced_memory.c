#define _DEFAULT_SOURCE /* MAP_ANONYMOUS, sigsetjmp */
#include "fenced_memory.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "untouched.h"

#if defined(__unix__) && !defined(__EMSCRIPTEN__)
#include <setjmp.h>
#include <signal.h>
#include <sys/mman.h>
#include <unistd.h>
#define HAS_PAGES 1
#else
#define HAS_PAGES 0
#endif

enum { FRONT = 64 };

static struct {
  unsigned char *end; /* of FENCE_BYTES bytes */
  unsigned char *copy;
  size_t bytes, slack;
} fences[FENCES];

#if HAS_PAGES
static unsigned char *new_area(void) {
  const size_t page = (size_t)sysconf(_SC_PAGESIZE), bytes = (FENCE_BYTES + page - 1) / page * page;
  unsigned char *area = mmap(NULL, bytes + page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (area == MAP_FAILED || mprotect(area + bytes, page, PROT_NONE) != 0) return NULL;
  return area + bytes;
}

static sigjmp_buf stopped;
static volatile sig_atomic_t inside;

static void on_fault(int signal_number) {
  if (inside) siglongjmp(stopped, signal_number);
  _exit(3);
}

int fence_watch(void (*call)(void *context), void *context) {
  static int installed;
  if (!installed) {
    struct sigaction action;
    memset(&action, 0, sizeof action);
    action.sa_handler = on_fault;
    sigaction(SIGSEGV, &action, NULL);
    sigaction(SIGBUS, &action, NULL);
    installed = 1;
  }
  if (sigsetjmp(stopped, 1) != 0) {
    inside = 0;
    return 0;
  }
  inside = 1;
  call(context);
  inside = 0;
  return 1;
}

int fences_exist(const char **why) {
  *why = "";
  return 1;
}
#else
static unsigned char *new_area(void) {
  return NULL;
}

int fence_watch(void (*call)(void *context), void *context) {
  call(context);
  return 1;
}

int fences_exist(const char **why) {
  *why = "there are no pages here that may not be touched";
  return 0;
}
#endif

void *fence_take(int place, size_t bytes, size_t slack) {
  if (fences[place].end == NULL) {
    fences[place].end = new_area();
    fences[place].copy = malloc(FENCE_BYTES);
  }
  if (fences[place].end == NULL || fences[place].copy == NULL || bytes + slack + FRONT > FENCE_BYTES) {
    printf("no fenced memory of %zu bytes\n", bytes);
    exit(2);
  }
  unpoison(fences[place].end - FENCE_BYTES, FENCE_BYTES);
  fences[place].bytes = bytes;
  fences[place].slack = slack;
  memset(fence_data(place) - FRONT, FENCE_PATTERN, FRONT + bytes + slack);
  return fence_data(place);
}

unsigned char *fence_data(int place) {
  return fences[place].end - fences[place].slack - fences[place].bytes;
}

size_t fence_size(int place) {
  return fences[place].bytes;
}

const unsigned char *fence_copy(int place) {
  return fences[place].copy;
}

void fence_remember(int place) {
  memcpy(fences[place].copy, fence_data(place), fences[place].bytes);
}

static int is_pattern(const unsigned char *bytes, size_t count) {
  size_t i;
  for (i = 0; i < count; ++i) {
    if (bytes[i] != FENCE_PATTERN) return 0;
  }
  return 1;
}

int fence_holds(int place) {
  return is_pattern(fence_data(place) - FRONT, FRONT) &&
         is_pattern(fences[place].end - fences[place].slack, fences[place].slack);
}

int fence_unchanged(int place, size_t from) {
  if (from >= fences[place].bytes) return 1;
  unpoison(fence_data(place), fences[place].bytes);
  return memcmp(fences[place].copy + from, fence_data(place) + from, fences[place].bytes - from) == 0;
}
