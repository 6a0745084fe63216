"""What each argument is: by its type, its name and its place, and by the extents that the comment states."""
import re

from .extents import extents_of

KINDS = ("handle", "handle_out", "memory", "context", "callback", "string", "value", "capacity", "needed", "array_in",
         "array_out", "struct_in", "struct_out", "value_out", "sized_in", "sized", "outputs")


def take_kinds(interface, function):
    """Sets kind, extents and `held` of the arguments of a function."""
    capacity = place_of_capacity(function)
    for place, argument in enumerate(function.arguments):
        after = function.arguments[place + 1] if place + 1 < len(function.arguments) else None
        if argument.base in interface.handles:
            argument.kind = "handle" if argument.stars == 1 else "handle_out"
        elif argument.base == "void":
            argument.kind = "memory" if after and after.name == "bytes" and after.base == "size_t" else "context"
        elif argument.base in interface.callbacks:
            argument.kind = "callback"
        elif argument.base == "char":
            argument.kind = "string"
        elif not argument.stars:
            argument.kind = "capacity" if place == capacity else "value"
        elif capacity is not None and place == capacity + 1:
            argument.kind = "needed"
        else:
            take_kind_of_data(interface, function, place, capacity)
    for argument in function.arguments:
        argument.held = argument.kind == "array_out" and capacity is not None and is_held(function, argument, capacity)
        extent = argument.extents[0] if argument.extents else "n"
        if capacity is None and extent.isidentifier() and extent != "n" and not function.argument(extent):
            function.open_questions.append(f"what [{extent}] of {argument.name} is")
    ask_about_names(function, capacity)


def ask_about_names(function, capacity):
    """Names that mean something stand where they mean it: `capacity, needed` and `first, count`."""
    for place, argument in enumerate(function.arguments):
        if argument.name == "capacity" and place != capacity:
            function.open_questions.append("what capacity is of: no pointer follows that becomes what is needed")
        after = function.arguments[place + 1].name if place + 1 < len(function.arguments) else ""
        if argument.name == "first" and argument.kind == "value" and after != "count":
            function.open_questions.append("what first begins: no count follows")


def place_of_capacity(function):
    """Where `capacity` stands, or `words`, the capacity of scratch memory: before the pointer that becomes `needed`."""
    for place, (argument, after) in enumerate(zip(function.arguments, function.arguments[1:])):
        if argument.name in ("capacity", "words") and not argument.stars and after.stars == 1:
            return place
    return None


def take_kind_of_data(interface, function, place, capacity):
    """A pointer to numbers or structs: one of them or an array, to be read or written."""
    argument = function.arguments[place]
    before = function.arguments[place - 1] if place else None
    struct = interface.structs.get(argument.base)
    if struct and struct.sized:
        argument.kind = "sized_in" if argument.const else "sized"
        return
    argument.extents = extents_of(interface, function, argument)
    if argument.extents:
        argument.kind = "array_in" if argument.const else "array_out"
    elif not argument.const and capacity is not None and place == capacity - 1:
        argument.kind, argument.extents = "array_out", ["needed"]
    elif not argument.const and before and before.name == "count" and function.argument("first"):
        argument.kind, argument.extents = "array_out", ["count"]
    elif struct:
        argument.kind = "struct_in" if argument.const else "struct_out"
        # One struct, or as many as the argument before says? C is silent.
        several = before and (before.kind == "value" and f"[{before.name}]" in function.prose or
                              before.kind == "array_in" and function.argument(before.extents[0]))
        if several and argument.name not in function.parameters:
            function.open_questions.append(f"whether {argument.name} is one struct or several")
    elif argument.const or capacity is not None and place < capacity:
        argument.kind = "array_in" if argument.const else "array_out"
        function.open_questions.append(f"length of {argument.name}")
    else:
        argument.kind = "value_out"


def is_held(function, argument, capacity):
    """Whether an output array is held to the capacity: whether its first extent is what `needed` becomes. The nine
    numbers of a matrix are not, nor is what has one more."""
    if not argument.extents:
        return False
    first = argument.extents[0]
    return first == "needed" or (function.arguments[capacity].name == "capacity" and
                                 not re.fullmatch(r"\d+|.* \+ 1", first))
