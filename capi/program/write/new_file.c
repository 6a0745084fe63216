#define _XOPEN_SOURCE 700 /* files, links and signals of POSIX.1-2008; SIGXFSZ */

#include "write/new_file.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "read/stopping.h"
#include "write/same_file.h"

/* Names that are tried for a new file. */
enum { MOST_NAMES = 100 };

/* A file that a signal must remove. */
struct new_file {
  char *temporary; /* its name until the end of the run */
  char *target;    /* the name of the file that it is to replace */
  struct new_file *volatile next;
};

/* The new files in the order in which they were begun; and whether a link led to one of them. */
static struct new_file *volatile unkept;
static bool any_link;

static const int ending_signals[] = {SIGHUP, SIGINT, SIGQUIT, SIGTERM};
enum { SIGNALS = sizeof ending_signals / sizeof ending_signals[0] };
static struct sigaction action_before[SIGNALS];
static struct sigaction size_action_before;

/* The signal strikes again, and ends the program, as soon as this returns: its action is the default by then. The first
 * SIGINT stops the run instead, which takes files away at its end. */
static void take_away(int signal_number) {
  if (signal_number == SIGINT && stopping_note()) return;
  signal(signal_number, SIG_DFL);
  for (const struct new_file *at = unkept; at != NULL; at = at->next) unlink(at->temporary);
  raise(signal_number);
}

static void block_signals(sigset_t *before) {
  sigset_t ending;
  sigemptyset(&ending);
  for (size_t i = 0; i < SIGNALS; ++i) sigaddset(&ending, ending_signals[i]);
  sigprocmask(SIG_BLOCK, &ending, before);
}

/* A signal that a user ignores stays ignored. A file beyond the size limit is an error like a full disk, not a
 * signal. */
static void catch_signals(void) {
  struct sigaction action;
  memset(&action, 0, sizeof action);
  sigemptyset(&action.sa_mask);
  action.sa_handler = SIG_IGN;
  sigaction(SIGXFSZ, &action, &size_action_before);
  action.sa_handler = take_away;
  for (size_t i = 0; i < SIGNALS; ++i) {
    sigaction(ending_signals[i], NULL, &action_before[i]);
    if (action_before[i].sa_handler != SIG_IGN) sigaction(ending_signals[i], &action, NULL);
  }
}

static void release_signals(void) {
  for (size_t i = 0; i < SIGNALS; ++i) sigaction(ending_signals[i], &action_before[i], NULL);
  sigaction(SIGXFSZ, &size_action_before, NULL);
}

/* The place of a file in the list; for NULL the end of the list. */
static struct new_file *volatile *place_of(const struct new_file *made) {
  struct new_file *volatile *at = &unkept;
  while (*at != made) at = &(*at)->next;
  return at;
}

static void free_new_file(struct new_file *made) {
  if (made == NULL) return;
  free(made->temporary);
  free(made->target);
  free(made);
}

/* From now on signals do not remove a new file. */
static void forget(struct new_file *made) {
  *place_of(made) = made->next;
  free_new_file(made);
  if (unkept == NULL) release_signals();
}

/* Make a new file in the target's folder; its descriptor, or -1 with errno. `old` is NULL if there is none yet. */
static int make_temporary(struct new_file *made, const struct stat *old) {
  static unsigned long names;
  for (int attempt = 0; attempt < MOST_NAMES; ++attempt) {
    char name[64];
    snprintf(name, sizeof name, ".hardsphere-%ld-%lu", (long)getpid(), names++);
    free(made->temporary);
    made->temporary = path_beside(made->target, name);
    if (made->temporary == NULL) return -1;
    sigset_t before;
    block_signals(&before);
    const int descriptor = open(made->temporary, O_WRONLY | O_CREAT | O_EXCL, old == NULL ? 0666 : 0600);
    const int reason = errno;
    if (descriptor >= 0) {
      if (unkept == NULL) catch_signals();
      *place_of(NULL) = made;
    }
    sigprocmask(SIG_SETMASK, &before, NULL);
    errno = reason;
    if (descriptor >= 0 || errno != EEXIST) return descriptor;
  }
  return -1;
}

/* The new file gets the owner and group of the old one, as far as the user may set them. If not even the group can be
 * set, the group's rights are taken away. */
static bool take_permissions(int descriptor, const struct stat *old) {
  mode_t mode = old->st_mode & 0777;
  const bool others = old->st_uid != geteuid() || old->st_gid != getegid();
  if (others && fchown(descriptor, old->st_uid, old->st_gid) != 0 && fchown(descriptor, (uid_t)-1, old->st_gid) != 0) {
    mode &= 0707;
  }
  if (fchmod(descriptor, mode) == 0) return true;
  const int reason = errno;
  struct stat now; /* there are file systems with one mode for all files */
  const bool same = fstat(descriptor, &now) == 0 && (now.st_mode & 0777) == mode;
  errno = reason;
  return same;
}

/* Whether a file of this run waits for the same name: links may lead two names to one that is not there yet. */
static bool is_taken(const char *target) {
  const struct new_file *at = any_link ? unkept : NULL;
  while (at != NULL && !outputs_are_one(at->target, target)) at = at->next;
  return at != NULL;
}

/* The target becomes the file's. */
static bool open_beside(struct output_file *file, char *target, const struct stat *old) {
  struct new_file *const made = calloc(1, sizeof *made);
  if (made == NULL) free(target);
  if (made == NULL) return false;
  made->target = target;
  any_link = any_link || strcmp(target, file->path) != 0;
  file->taken = is_taken(target);
  const bool open_to_user = !file->taken && (old == NULL || access(target, W_OK) == 0);
  const int descriptor = open_to_user ? make_temporary(made, old) : -1;
  if (descriptor < 0) {
    file->reason = errno;
    file->no_room = open_to_user && (errno == EACCES || errno == EPERM || errno == EROFS);
    free_new_file(made);
    return false;
  }
  file->made = made;
  if (old != NULL && !take_permissions(descriptor, old)) file->reason = errno;
  file->stream = fdopen(descriptor, "wb");
  if (file->stream != NULL) return true;
  file->reason = errno;
  close(descriptor);
  return false;
}

bool new_file_open(struct output_file *file) {
  struct stat old;
  const bool exists = stat(file->path, &old) == 0;
  if (!exists && errno != ENOENT) return false;
  if (exists && S_ISDIR(old.st_mode)) {
    errno = EISDIR;
    return false;
  }
  char *const target = path_without_links(file->path);
  if (target == NULL) return false;
  /* A link of /proc may show a name under which its file is not to be found. */
  struct stat there;
  const bool replaceable = !exists || (S_ISREG(old.st_mode) && lstat(target, &there) == 0 && same_file(&old, &there));
  if (replaceable) return open_beside(file, target, exists ? &old : NULL);
  free(target);
  file->stream = fopen(file->path, "wb");
  return file->stream != NULL;
}

void new_file_drop(struct output_file *file) {
  if (file->made == NULL) return;
  unlink(file->made->temporary);
  forget(file->made);
}

bool output_files_keep(struct failure *failure) {
  while (unkept != NULL) {
    if (rename(unkept->temporary, unkept->target) != 0) {
      failure->file = unkept->target;
      return failure_in_input(failure, 0, "%s", strerror(errno));
    }
    forget(unkept);
  }
  return true;
}

void output_files_drop(void) {
  while (unkept != NULL) {
    unlink(unkept->temporary);
    forget(unkept);
  }
}
