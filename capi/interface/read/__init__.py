"""The interface as data, read from the headers: declarations by a C parser, and what C does not say of an argument, how
long an array is and whether it may be NULL, from the comment of its function. README.md has the rules."""
from pathlib import Path

from .comments import read_comment
from .declarations import read_declarations
from .fields import take_fields
from .kinds import take_kinds
from .nulls import take_nulls
from .tiers import take_tiers

MOST_ARGUMENTS = 8


def read_interface(include):
    """The interface of the headers in a folder. What the rules do not settle is among its open questions."""
    interface = read_declarations(include)
    for function in interface.functions:
        read_comment(function)
    for function in interface.functions:
        if not function.comment:
            function.open_questions.append("what it does: there is no comment")
        if len(function.arguments) > MOST_ARGUMENTS:
            function.open_questions.append(f"more than {MOST_ARGUMENTS} arguments: a request and outputs have names")
        take_kinds(interface, function)
        take_fields(interface, function)
    for function in interface.functions:
        take_nulls(interface, function)
        function.open_questions += [f"an argument {name}, of which @param speaks" for name in function.parameters
                                    if not function.argument(name)]
    take_tiers(interface, {name: (Path(include) / "hardsphere" / name).read_text() for name in interface.headers})
    return interface
