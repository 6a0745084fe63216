/* Presets of `draw`: several of its options by one name. An option that the user gives by itself wins. */
#ifndef HARDSPHERE_TOOL_LOOK_H
#define HARDSPHERE_TOOL_LOOK_H

struct drawing;

/* Sets the options that the user has left open, by the look that was asked for, if there is one. */
void look_apply(struct drawing *drawing);

#endif
