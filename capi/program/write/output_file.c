#define _XOPEN_SOURCE 700 /* files, links and signals of POSIX.1-2008; SIGXFSZ */

#include "write/output_file.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "write/same_file.h"

/* Links that are followed one after the other, names that are tried for a new file, and new files of a run. */
enum { MOST_LINKS = 40, MOST_NAMES = 100, MOST_FILES = 16 };

/* The new files, which a signal must take away, and once they are finished those that they are to replace; NULL in
 * places that are not in use. */
static char *volatile unkept[MOST_FILES];
static char *target_of[MOST_FILES];

static const int ending_signals[] = {SIGHUP, SIGINT, SIGQUIT, SIGTERM};
enum { SIGNALS = sizeof ending_signals / sizeof ending_signals[0] };
static struct sigaction action_before[SIGNALS];
static struct sigaction size_action_before;

/* The signal strikes again, and ends the program, as soon as this returns: its action is the default by then. */
static void take_away(int signal_number) {
  for (size_t i = 0; i < MOST_FILES; ++i) {
    if (unkept[i] != NULL) unlink(unkept[i]);
  }
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
  action.sa_flags = (int)SA_RESETHAND;
  for (size_t i = 0; i < SIGNALS; ++i) {
    sigaction(ending_signals[i], NULL, &action_before[i]);
    if (action_before[i].sa_handler != SIG_IGN) sigaction(ending_signals[i], &action, NULL);
  }
}

static void release_signals(void) {
  for (size_t i = 0; i < SIGNALS; ++i) sigaction(ending_signals[i], &action_before[i], NULL);
  sigaction(SIGXFSZ, &size_action_before, NULL);
}

/* The number of a new file, or of a place that is not in use for NULL; MOST_FILES if there is none. */
static size_t place_of(const char *temporary) {
  size_t at = 0;
  while (at < MOST_FILES && unkept[at] != temporary) ++at;
  return at;
}

static bool any_unkept(void) {
  bool any = false;
  for (size_t i = 0; i < MOST_FILES; ++i) any = any || unkept[i] != NULL;
  return any;
}

/* From now on a new file is none that a signal must take away. */
static void forget(size_t at) {
  char *const temporary = unkept[at];
  unkept[at] = NULL;
  free(temporary);
  free(target_of[at]);
  target_of[at] = NULL;
  if (!any_unkept()) release_signals();
}

/* The part of a path up to its last slash, slash included, and a name behind it. NULL: memory is short. */
static char *beside(const char *path, const char *name) {
  const char *slash = strrchr(path, '/');
  const size_t folder = name[0] == '/' || slash == NULL ? 0 : (size_t)(slash - path) + 1;
  char *joined = malloc(folder + strlen(name) + 1);
  if (joined == NULL) return NULL;
  memcpy(joined, path, folder);
  memcpy(joined + folder, name, strlen(name) + 1);
  return joined;
}

/* The path that a link leads to, whether or not there is a file; a copy of any other path. NULL, with errno: links
 * that lead nowhere, or short memory. */
static char *without_links(const char *path) {
  char *at = beside("", path);
  for (int links = 0; at != NULL; ++links) {
    struct stat found;
    char text[4096];
    if (lstat(at, &found) != 0 || !S_ISLNK(found.st_mode)) return at;
    const ssize_t length = readlink(at, text, sizeof text);
    if (length < 0 || length == (ssize_t)sizeof text || links == MOST_LINKS) {
      if (length >= 0) errno = ELOOP;
      free(at);
      return NULL;
    }
    text[length] = '\0';
    char *next = beside(at, text);
    free(at);
    at = next;
  }
  return NULL;
}

/* Make a new file in the target's folder; its descriptor, or -1 with errno. `old` is NULL if there is none yet. */
static int make_temporary(struct output_file *file, const struct stat *old) {
  const size_t place = place_of(NULL);
  errno = EMFILE;
  for (int attempt = 0; place < MOST_FILES && attempt < MOST_NAMES; ++attempt) {
    char name[64];
    snprintf(name, sizeof name, ".hardsphere-%ld-%d", (long)getpid(), attempt);
    free(file->temporary);
    file->temporary = beside(file->target, name);
    if (file->temporary == NULL) return -1;
    sigset_t before;
    block_signals(&before);
    const int descriptor = open(file->temporary, O_WRONLY | O_CREAT | O_EXCL, old == NULL ? 0666 : 0600);
    const int reason = errno;
    if (descriptor >= 0) {
      if (!any_unkept()) catch_signals();
      unkept[place] = file->temporary;
    }
    sigprocmask(SIG_SETMASK, &before, NULL);
    errno = reason;
    if (descriptor >= 0 || errno != EEXIST) return descriptor;
  }
  return -1;
}

/* The new file belongs to whom the old one belonged, as far as the user may decide that: to its group at least, or else
 * that group's rights are nobody's. */
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

static bool open_beside(struct output_file *file, const struct stat *old) {
  if (old != NULL && access(file->target, W_OK) != 0) return false;
  const int descriptor = make_temporary(file, old);
  if (descriptor < 0) {
    file->reason = errno;
    file->no_room = file->reason == EACCES || file->reason == EPERM || file->reason == EROFS;
    free(file->temporary);
    file->temporary = NULL;
    return false;
  }
  if (old != NULL && !take_permissions(descriptor, old)) file->reason = errno;
  file->stream = fdopen(descriptor, "wb");
  if (file->stream != NULL) return true;
  file->reason = errno;
  close(descriptor);
  return false;
}

static bool open_path(struct output_file *file) {
  struct stat old;
  const bool exists = stat(file->path, &old) == 0;
  if (!exists && errno != ENOENT) return false;
  if (exists && S_ISDIR(old.st_mode)) {
    errno = EISDIR;
    return false;
  }
  file->target = without_links(file->path);
  if (file->target == NULL) return false;
  /* A link of /proc may show a name under which its file is not to be found. */
  struct stat there;
  const bool replaceable =
      !exists || (S_ISREG(old.st_mode) && lstat(file->target, &there) == 0 && same_file(&old, &there));
  if (replaceable) return open_beside(file, exists ? &old : NULL);
  free(file->target);
  file->target = NULL;
  file->stream = fopen(file->path, "wb");
  return file->stream != NULL;
}

/* Take away what there is, and give the failure its reason. */
static bool give_up(struct output_file *file, struct failure *failure) {
  const int reason = file->reason != 0 ? file->reason : errno;
  const bool standard = file->stream == stdout;
  const char *what = standard ? "standard output: " : file->no_room ? "no new file can be made in its folder: " : "";
  failure->file = standard ? NULL : file->path;
  output_file_abandon(file);
  return failure_in_input(failure, 0, "%s%s", what, reason != 0 ? strerror(reason) : "cannot be written");
}

bool output_file_open(struct output_file *file, const char *path, struct failure *failure) {
  memset(file, 0, sizeof *file);
  file->path = path;
  if (output_is_standard(path)) {
    file->stream = stdout;
    return true;
  }
  errno = 0;
  struct stat standard;
  struct stat old;
  if (stat(path, &old) == 0 && fstat(STDOUT_FILENO, &standard) == 0 && same_file(&old, &standard)) {
    failure->file = path;
    return failure_in_input(failure, 0, "this is where standard output goes already");
  }
  errno = 0;
  return open_path(file) || give_up(file, failure);
}

bool output_file_write(struct output_file *file, const char *bytes, size_t count) {
  if (file->reason != 0) return false;
  errno = 0;
  if (count == 0 || fwrite(bytes, 1, count, file->stream) == count) return true;
  file->reason = errno != 0 ? errno : EIO;
  return false;
}

bool output_file_finish(struct output_file *file, struct failure *failure) {
  errno = 0;
  if (file->reason == 0 && fflush(file->stream) != 0) file->reason = errno != 0 ? errno : EIO;
  if (file->reason != 0) return give_up(file, failure);
  if (file->stream == stdout) return true;
  FILE *stream = file->stream;
  file->stream = NULL;
  if (fclose(stream) != 0) return give_up(file, failure);
  if (file->temporary != NULL) target_of[place_of(file->temporary)] = file->target;
  return true;
}

void output_file_abandon(struct output_file *file) {
  if (file->stream != NULL && file->stream != stdout) fclose(file->stream);
  if (file->temporary != NULL) {
    unlink(file->temporary);
    forget(place_of(file->temporary));
  }
  free(file->target);
  memset(file, 0, sizeof *file);
}

bool output_files_keep(struct failure *failure) {
  for (size_t i = 0; i < MOST_FILES; ++i) {
    if (target_of[i] == NULL) continue;
    if (rename(unkept[i], target_of[i]) != 0) {
      failure->file = target_of[i];
      return failure_in_input(failure, 0, "%s", strerror(errno));
    }
    forget(i);
  }
  return true;
}

void output_files_drop(void) {
  for (size_t i = 0; i < MOST_FILES; ++i) {
    if (target_of[i] == NULL) continue;
    unlink(unkept[i]);
    forget(i);
  }
}
