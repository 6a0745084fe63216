"""How long arrays are: C does not say, comments do."""
import re

from .comments import functions_named


def stated(function, name):
    """The extents behind an argument's name in the comment: `xyz [n][3]` has n and 3."""
    if name in function.parameters:
        found = re.match(r"((?:\[[^\]]+\])+)", function.parameters[name])
    else:
        found = re.search(rf"(?<![\w.]){name} ((?:\[[^\]]+\])+)", function.prose)
    return re.findall(r"\[([^\]]+)\]", found[1]) if found else []


def extents_of(interface, function, argument, seen=()):
    """What is stated, else what a function that the comment names states of an argument of the same name and type."""
    found = stated(function, argument.name)
    if found or argument.name in function.parameters:
        return found
    for other in functions_named(interface, function):
        same = other.argument(argument.name)
        if other.name in seen or not same:
            continue
        if (same.base, same.stars, same.const) == (argument.base, argument.stars, argument.const):
            found = extents_of(interface, other, same, (*seen, function.name))
            if found:
                return found
    return []
