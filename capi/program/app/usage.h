/* The program's texts about itself. */
#pragma once

#include "commands/request.h"
#include "read/text_buffer.h"

void usage_of_program(struct text_buffer *out);
void usage_of_command(struct text_buffer *out, enum command command);
void usage_version(struct text_buffer *out);
