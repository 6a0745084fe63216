/* Scripts that make a shell complete commands, options and the words behind them. */
#pragma once

#include <stdbool.h>

#include "read/text_buffer.h"

/* The script for "bash" or "zsh"; false: it is of another shell. */
bool completion_of_shell(const char *shell, struct text_buffer *out);
