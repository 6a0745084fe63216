#include "read/title_value.h"

#include <string.h>

#include "read/characters.h"

static const char *past_blanks(const char *at) {
  while (is_blank(*at)) ++at;
  return at;
}

/* Behind the quote or the bracket that closes the one that is here; NULL: none does. */
static const char *behind_closing(const char *at) {
  const char quote = *at == '"' || *at == '\'' ? *at : '\0';
  size_t open = quote == '\0' ? 0 : 1;
  for (at += open; *at != '\0'; ++at) {
    if (quote != '\0' && *at == '\\' && at[1] != '\0') {
      ++at;
    } else if (quote != '\0' ? *at == quote : *at == ']' || *at == '}') {
      if (--open == 0) return at + 1;
    } else if (quote == '\0' && (*at == '[' || *at == '{')) {
      ++open;
    }
  }
  return NULL;
}

/* Behind the value that begins here, a word if nothing closes it. */
static const char *end_of_value(const char *at) {
  const char *const closed = *at != '\0' && strchr("\"'[{", *at) != NULL ? behind_closing(at) : NULL;
  return closed != NULL ? closed : at + strcspn(at, " \t");
}

bool title_value(const char *title, const char *key, struct field *value) {
  const size_t length = strlen(key);
  for (const char *at = title; *at != '\0';) {
    while (is_blank(*at) || *at == ',') ++at;
    const char *const begin = at;
    while (*at != '\0' && *at != '=' && !is_blank(*at)) ++at;
    const bool same = (size_t)(at - begin) == length && memcmp(begin, key, length) == 0;
    const char *const sign = past_blanks(at);
    if (*sign != '=') continue;
    const char *const from = past_blanks(sign + 1);
    at = end_of_value(from);
    *value = (struct field){from, (size_t)(at - from)};
    if (same) return true;
  }
  return false;
}

size_t title_value_split(struct field value, struct field *parts, size_t capacity) {
  static const char between[] = " \t,[]{}\"'";
  size_t count = 0;
  for (size_t at = 0; at < value.length;) {
    const size_t begin = at;
    while (at < value.length && strchr(between, value.text[at]) == NULL) ++at;
    if (at > begin && count++ < capacity) parts[count - 1] = (struct field){value.text + begin, at - begin};
    if (at < value.length) ++at;
  }
  return count;
}
