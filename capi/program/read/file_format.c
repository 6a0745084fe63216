#include "read/file_format.h"

#include <stdio.h>
#include <string.h>

#include "read/characters.h"
#include "read/fields.h"

#define FORMATS(FORMAT) \
  FORMAT(xtc)           \
  FORMAT(trr)           \
  FORMAT(dcd)           \
  FORMAT(nc)            \
  FORMAT(xyzr)          \
  FORMAT(pdb)           \
  FORMAT(pqr)           \
  FORMAT(xyz)           \
  FORMAT(cif)           \
  FORMAT(gro)           \
  FORMAT(sdf)           \
  FORMAT(mol2)          \
  FORMAT(pdbqt)

#define DECLARE(name) extern const struct file_format name##_format;
FORMATS(DECLARE)

const struct file_format *file_format_at(size_t i) {
#define ADDRESS(name) &name##_format,
  static const struct file_format *const formats[] = {FORMATS(ADDRESS)};
  enum { FORMATS_ARE = sizeof formats / sizeof formats[0], ROOM_IS_LEFT = 1 / (FORMATS_ARE < MOST_FORMATS) };
  return i < FORMATS_ARE ? formats[i] : NULL;
}

bool file_format_has(const struct file_format *format, enum file_feature feature) {
  return (format->features & (unsigned)feature) != 0;
}

static bool has_all(const struct file_format *format, unsigned features) {
  return (format->features & features) == features;
}

const char *file_format_list(char out[FORMAT_LIST_BYTES], const char *prefix, const char *word, unsigned features,
                             bool has) {
  const char *name[FORMAT_LIST_BYTES / 2];
  size_t count = 0, at = 0;
  const struct file_format *format;
  for (size_t i = 0; (format = file_format_at(i)) != NULL; ++i) {
    const bool listed =
        has ? has_all(format, features) : file_format_has(format, FILE_ATOMS) && !has_all(format, features);
    if (listed) name[count++] = format->name;
  }
  out[0] = '\0';
  for (size_t i = 0; i < count && at < FORMAT_LIST_BYTES; ++i) {
    const char *blank = i == 0 ? "" : " ";
    at += (size_t)snprintf(out + at, FORMAT_LIST_BYTES - at, "%s%s%s%s%s", i > 0 && i + 1 < count ? "," : "", blank,
                           i > 0 && i + 1 == count ? word : "", i > 0 && i + 1 == count ? " " : "", prefix);
    if (at < FORMAT_LIST_BYTES) at += (size_t)snprintf(out + at, FORMAT_LIST_BYTES - at, "%s", name[i]);
  }
  return out;
}

/* Whether the name is one of the extensions between blanks. */
static bool is_extension(struct field name, const char *extensions) {
  for (const char *at = extensions; *at != '\0'; at += *at == ' ') {
    const char *begin = at;
    size_t same = 0;
    while (*at != '\0' && *at != ' ' && *at != '#') ++at;
    const size_t length = (size_t)(at - begin);
    while (same < length && same < name.length && to_upper(name.text[same]) == begin[same]) ++same;
    if (*at == '#') {
      while (same >= length && same < name.length && is_digit(name.text[same])) ++same;
      ++at;
    }
    if (same >= length && same == name.length) return true;
  }
  return false;
}

const struct file_format *file_format_named(const char *name, unsigned features) {
  const struct field written = {name, strlen(name)};
  const struct file_format *format;
  for (size_t i = 0; (format = file_format_at(i)) != NULL; ++i) {
    if (has_all(format, features) && is_extension(written, format->extensions)) return format;
  }
  return NULL;
}

const char *file_extension(const char *path) {
  const char *slash = strrchr(path, '/');
  const char *dot = strrchr(slash == NULL ? path : slash + 1, '.');
  return dot == NULL ? "" : dot + 1;
}

int file_extension_among(const char *path, const char *const *names, int count) {
  const char *const text = file_extension(path);
  const struct field extension = {text, strlen(text)};
  int place = count - 1;
  while (place >= 0 && !field_is(extension, names[place])) --place;
  return place;
}

const struct file_format *file_format_of(const char *path, struct failure *failure) {
  const char *const extension = file_extension(path);
  const struct file_format *format = file_format_named(extension, FILE_ATOMS);
  if (format != NULL) return format;
  failure->file = path;
  static const char *const packed[][2] = {
      {"GZ Z", "gunzip"}, {"BZ2", "bunzip2"}, {"XZ LZMA", "unxz"}, {"ZST", "unzstd"}};
  for (size_t i = 0; i < sizeof packed / sizeof packed[0]; ++i) {
    if (!is_extension((struct field){extension, strlen(extension)}, packed[i][0])) continue;
    failure_in_input(failure, 0, "compressed; for instance: %s -c FILE | hardsphere measure - --format pdb",
                     packed[i][1]);
    return NULL;
  }
  char list[FORMAT_LIST_BYTES];
  failure_in_input(failure, 0, "unknown extension; expected %s", file_format_list(list, ".", "or", FILE_ATOMS, true));
  return NULL;
}
