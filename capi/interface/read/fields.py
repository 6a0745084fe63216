"""The fields of requests and outputs: each is what an argument of the function would be."""
import re

from .interface import Argument


def take_fields(interface, function):
    """Sets the fields of a `const hsp_.._request *` and of a `hsp_.._outputs *`, and the kind of the latter."""
    for argument in function.arguments:
        struct = interface.structs.get(argument.base)
        if not struct or not struct.sized:
            continue
        if argument.base.endswith("_outputs"):
            argument.kind = "outputs"
        elif not argument.base.endswith("_request") or not argument.const:
            continue
        argument.fields = [argument_of(interface, function, argument, field) for field in struct.fields[1:]
                           if not field.name.startswith("reserved")]


def argument_of(interface, function, holder, field):
    found = Argument(field.name, field.base, field.stars, field.const)
    extents = re.match(r"((?:\[[^\]]+\])+)", field.remark)
    struct = interface.structs.get(field.base)
    if not field.stars:
        outputs = {"capacity": "capacity", "needed": "needed"}
        found.kind = outputs.get(field.name, "value_out") if holder.kind == "outputs" else "value"
        return found
    if extents:
        found.extents = re.findall(r"\[([^\]]+)\]", extents[1])
        found.kind = "array_in" if field.const else "array_out"
        found.held = not field.const and not found.extents[0].isdigit()
    elif struct:
        found.kind = ("sized" if struct.sized else "struct") + ("_in" if field.const else "" if struct.sized else "_out")
    else:
        function.open_questions.append(f"length of {holder.name}->{field.name}")
    found.null = "always" if re.search(r"\bor NULL\b", field.remark) else "never"
    return found
