/* Scripts by which a shell completes commands, options and the words behind options. */
#pragma once

#include <stdbool.h>

#include "read/text_buffer.h"

/* The script for the shell "bash" or "zsh". False: it is another shell. */
bool completion_of_shell(const char *shell, struct text_buffer *out);
