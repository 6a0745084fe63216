#define _XOPEN_SOURCE 700 /* sigaction, setitimer */

#include "read/stopping.h"

#include <string.h>
#include <time.h>

/* For systems without signals, or without one for a time that is over. */
#if defined(__wasi__)
#define HAS_INTERRUPTS 0
#define HAS_ALARMS 0
typedef int sig_atomic_t;
#else
#include <signal.h>
#define HAS_INTERRUPTS 1
#if defined(_WIN32)
#define HAS_ALARMS 0
#else
#include <sys/time.h>
#define HAS_ALARMS 1
#endif
#endif

static volatile sig_atomic_t interrupted, time_is_over;
static double seconds_given;

#if !HAS_ALARMS
static time_t last_second;
#endif

bool stopping_note(void) {
  if (interrupted != 0) return false;
  interrupted = 1;
  return true;
}

#if HAS_INTERRUPTS
/* The second time as if this were not here. */
static void take_interrupt(int number) {
  if (stopping_note()) {
#if !HAS_ALARMS
    signal(number, take_interrupt); /* it was reset */
#endif
    return;
  }
  signal(number, SIG_DFL);
  raise(number);
}
#endif

#if HAS_ALARMS
/* Calls that read are not begun again, so that none waits for input that does not come. */
static void catch_signal(int number, void (*handler)(int)) {
  struct sigaction action, before;
  memset(&action, 0, sizeof action);
  sigemptyset(&action.sa_mask);
  action.sa_handler = handler;
  if (sigaction(number, NULL, &before) == 0 && before.sa_handler != SIG_IGN) sigaction(number, &action, NULL);
}

static void take_alarm(int number) {
  (void)number;
  time_is_over = 1;
}
#endif

void stopping_by_interrupt(void) {
#if HAS_ALARMS
  catch_signal(SIGINT, take_interrupt);
#elif HAS_INTERRUPTS
  signal(SIGINT, take_interrupt);
#endif
}

void stopping_after(double seconds) {
  if (!(seconds > 0.0)) return;
  seconds_given = seconds;
#if HAS_ALARMS
  struct itimerval timer;
  memset(&timer, 0, sizeof timer);
  timer.it_value.tv_sec = (time_t)seconds;
  timer.it_value.tv_usec = (suseconds_t)((seconds - (double)timer.it_value.tv_sec) * 1e6);
  if (timer.it_value.tv_sec == 0 && timer.it_value.tv_usec == 0) timer.it_value.tv_usec = 1;
  timer.it_interval.tv_usec = 100000; /* what reads after the first one is ended, too */
  catch_signal(SIGALRM, take_alarm);
  setitimer(ITIMER_REAL, &timer, NULL);
#else
  last_second = time(NULL) + (time_t)(seconds + 0.999);
#endif
}

bool stopping_asked(void) {
#if !HAS_ALARMS
  if (seconds_given > 0.0 && time(NULL) > last_second) time_is_over = 1;
#endif
  return interrupted != 0 || time_is_over != 0;
}

int32_t stopping_proceed(void *context) {
  (void)context;
  return stopping_asked();
}

const hsp_executor *stopping_executor(void) {
  static const hsp_executor alone = {.struct_size = (uint32_t)sizeof alone, .proceed = stopping_proceed};
  return &alone;
}

void stopping_is_why(struct failure *failure) {
  failure->file = NULL;
  if (interrupted != 0) {
    failure_in_input(failure, 0, "stopped");
    failure->exit_status = EXIT_INTERRUPTED;
  } else {
    failure_in_input(failure, 0, "stopped, as --timeout %g is over", seconds_given);
    failure->exit_status = EXIT_TIME_IS_OVER;
  }
}
