#include "app/completion.h"

#include <string.h>

#include "app/command_table.h"
#include "app/option.h"

/* The words that may stand behind an option, with blanks between them; of --format the names of all formats. */
static bool add_words(struct text_buffer *out, const struct option *option) {
  if (option->take == take_format) {
    const struct file_format *format;
    const char *blank = "";
    for (size_t i = 0; (format = file_format_at(i)) != NULL; ++i) {
      if (!file_format_has(format, FILE_ATOMS)) continue;
      text_buffer_add(out, "%s%s", blank, format->name);
      blank = " ";
    }
    return true;
  }
  if (option->words == NULL || option->argument == NULL) return false;
  for (const char *at = option->words; *at != '\0'; ++at) text_buffer_append(out, *at == '|' ? " " : at, 1);
  return true;
}

/* Add the names of options, each once: of those that all commands have, or else of those of one command. */
static void add_option_names(struct text_buffer *out, bool of_all, enum command command) {
  const struct option *option;
  const char *previous = "";
  for (size_t i = 0; (option = option_at(i)) != NULL; ++i) {
    if ((option->commands == EVERY_COMMAND) != of_all || !option_is_of(option, command)) continue;
    if (strcmp(option->name, previous) != 0) text_buffer_add(out, " %s", option->name);
    previous = option->name;
  }
}

static void add_command_names(struct text_buffer *out) {
  for (int command = 0; command < COMMANDS; ++command) text_buffer_add(out, "%s ", command_table[command].name);
}

/* If there are no words to complete, names of files are completed. */
static void bash_completion(struct text_buffer *out) {
  const struct option *option;
  text_buffer_add(out,
                  "# Completion for bash, written by: hardsphere completion bash\n"
                  "_hardsphere() {\n"
                  "  local command=${COMP_WORDS[1]} word=${COMP_WORDS[COMP_CWORD]} words=\n"
                  "  if [ \"$COMP_CWORD\" -eq 1 ]; then\n    words=\"");
  add_command_names(out);
  text_buffer_add(out,
                  "completion help --help --version\"\n"
                  "  elif [[ $word == -* ]]; then\n    words=\"--help");
  add_option_names(out, true, COMMAND_MODEL);
  text_buffer_add(out, "\"\n    case $command in\n");
  for (int command = 0; command < COMMANDS; ++command) {
    text_buffer_add(out, "      %s) words+=\"", command_table[command].name);
    add_option_names(out, false, (enum command)command);
    text_buffer_add(out, "\" ;;\n");
  }
  text_buffer_add(out,
                  "    esac\n  else\n"
                  "    case \"$command ${COMP_WORDS[COMP_CWORD - 1]}\" in\n"
                  "      \"help help\") words=\"");
  add_command_names(out);
  text_buffer_add(out, "\" ;;\n      \"completion completion\") words=\"bash zsh\" ;;\n");
  for (size_t i = 0; (option = option_at(i)) != NULL; ++i) {
    struct text_buffer words = TEXT_BUFFER_EMPTY;
    if (add_words(&words, option) && !words.out_of_memory) {
      const char *separator = "      ";
      for (int command = 0; command < COMMANDS && option->commands != EVERY_COMMAND; ++command) {
        if (!option_is_of(option, (enum command)command)) continue;
        text_buffer_add(out, "%s\"%s %s\"", separator, command_table[command].name, option->name);
        separator = " | ";
      }
      if (option->commands == EVERY_COMMAND) text_buffer_add(out, "      *\" %s\"", option->name);
      text_buffer_add(out, ") words=\"%s\" ;;\n", words.text);
    }
    out->out_of_memory = out->out_of_memory || words.out_of_memory;
    text_buffer_free(&words);
  }
  text_buffer_add(out,
                  "    esac\n  fi\n"
                  "  COMPREPLY=($(compgen -W \"$words\" -- \"$word\"))\n"
                  "}\n"
                  "complete -o bashdefault -o default -F _hardsphere hardsphere\n");
}

/* The first words of a text in what stands between brackets in an argument of _arguments. A point within a name of a
 * file or a number does not end them. */
static void add_description(struct text_buffer *out, const char *text) {
  size_t length = 0;
  while (strchr(";:\n", text[length]) == NULL && (text[length] != '.' || strchr(" \n", text[length + 1]) == NULL)) {
    ++length;
  }
  for (size_t i = 0; i < length; ++i) {
    const char *const safe = text[i] == '\'' ? "'\\''" : NULL;
    if (safe != NULL) text_buffer_add(out, "%s", safe);
    if (safe == NULL) text_buffer_append(out, strchr("[]", text[i]) != NULL ? "|" : text + i, 1);
  }
}

/* An argument of _arguments for each option: '*--name=[text]:what stands behind it:words or files'. */
static void zsh_options(struct text_buffer *out, bool of_all, enum command command) {
  const struct option *option;
  const char *previous = "";
  for (size_t i = 0; (option = option_at(i)) != NULL; ++i) {
    if ((option->commands == EVERY_COMMAND) != of_all || !option_is_of(option, command)) continue;
    if (strcmp(option->name, previous) == 0) continue;
    previous = option->name;
    const struct option *described = option; /* the row that has its text */
    for (size_t k = i; described != NULL && described->help == NULL; ++k) described = option_at(k + 1);
    const bool brief = option->name[1] != '-';
    text_buffer_add(out, "    '*%s%s[", option->name, option->argument == NULL ? "" : brief ? "+" : "=");
    if (described != NULL) add_description(out, described->help);
    text_buffer_add(out, "]");
    if (option->argument != NULL) {
      struct text_buffer words = TEXT_BUFFER_EMPTY;
      text_buffer_add(out, ":");
      add_description(out, option->argument);
      if (add_words(&words, option) && !words.out_of_memory) {
        text_buffer_add(out, ":(%s)", words.text);
      } else if (option->take == take_path || option->take == take_text) {
        text_buffer_add(out, ":_files");
      } else {
        text_buffer_add(out, ":");
      }
      text_buffer_free(&words);
    }
    text_buffer_add(out, "'\n");
  }
}

static void zsh_completion(struct text_buffer *out) {
  text_buffer_add(out,
                  "#compdef hardsphere\n"
                  "# Completion for zsh, written by: hardsphere completion zsh\n"
                  "local -a names common own\n"
                  "if (( CURRENT == 2 )); then\n  names=(\n");
  for (int command = 0; command < COMMANDS; ++command) {
    text_buffer_add(out, "    '%s:", command_table[command].name);
    add_description(out, command_table[command].summary);
    text_buffer_add(out, "'\n");
  }
  text_buffer_add(out,
                  "    'completion:what makes a shell complete commands and options'\n"
                  "    'help:more about a command'\n  )\n"
                  "  _describe command names\n  return\nfi\ncommon=(\n");
  zsh_options(out, true, COMMAND_MODEL);
  text_buffer_add(out, "    '--help[more about the command]'\n    '*:file:_files'\n)\ncase $words[2] in\n");
  for (int command = 0; command < COMMANDS; ++command) {
    text_buffer_add(out, "  %s) own=(\n", command_table[command].name);
    zsh_options(out, false, (enum command)command);
    text_buffer_add(out, "  ) ;;\n");
  }
  text_buffer_add(out, "  completion) _values shell bash zsh; return ;;\n  help) _values command ");
  add_command_names(out);
  text_buffer_add(out, "; return ;;\nesac\n(( CURRENT-- ))\nshift words\n_arguments -S $own $common\n");
}

bool completion_of_shell(const char *shell, struct text_buffer *out) {
  if (strcmp(shell, "bash") == 0) {
    bash_completion(out);
  } else if (strcmp(shell, "zsh") == 0) {
    zsh_completion(out);
  } else {
    return false;
  }
  return true;
}
