// The colours in which hardsphere draw shows balls.
#pragma once

#include <map>
#include <string>
#include <vector>

std::string crambin();

// The lines of a file's atoms.
std::vector<std::string> atoms_of(const std::string &file);

// The picture that the program writes; empty, and a failure of the test, if it writes none.
std::string drawn(const std::string &file, std::vector<std::string> options = {},
                  const std::string &extension = ".svg");

// The colour of every ball that has a piece, RRGGBB in capitals, as a flat picture without fog shows it.
std::map<int, std::string> fills(const std::string &file, std::vector<std::string> options);

// The sum of a colour's channels.
double brightness(const std::string &colour);

// How much the two most alike of these colours, RRGGBB, differ in CIE L*a*b* for one who sees no red or no green, as
// Machado, Oliveira and Fernandes (IEEE Trans. Vis. Comput. Graph. 15 (2009) 1291) simulate that.
double least_difference(const std::vector<std::string> &colours);

// Of two colours by WCAG, from 1 to 21.
double contrast(const std::string &one, const std::string &other);
