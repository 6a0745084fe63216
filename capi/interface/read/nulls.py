"""Which pointers may be NULL: what the comment says beside @retval HSP_E_ARGUMENT."""
import re

NAMES = r"(?:a null pointer|\w+(?:(?:, (?:or )?| or | and )\w+)*)"
# `with n > 0`, `with a count above 0`, `and count is not 0`
CONDITION = r" ?(?:with |and )?(?:an? )?\w+ (?:above 0|> 0|is not 0)"


def take_nulls(interface, function):
    """Sets `null` of the arguments of a function."""
    rule = rule_of(interface, function)
    held = [a for a in function.arguments if a.held]
    for argument in pointers_of(interface, function):
        stated = function.parameters.get(argument.name)
        if stated is not None:
            argument.null = ("empty" if re.search(r"or NULL with ", stated) else
                             "box" if re.search(r"\bNULL in a box\b", stated) else
                             "always" if re.search(r"\bor NULL\b", stated) else "never")
        elif argument.kind in ("context", "needed"):
            argument.null = "always"
        elif rule is not None and argument.name in rule:
            argument.null = rule[argument.name]
            # OUTPUT ARRAYS of hardsphere.h: records may be asked for with no room for them.
            if argument.null == "never" and held == [argument]:
                argument.null = "empty"
        elif rule is not None or function.result == "int32_t":
            function.open_questions.append(f"whether {argument.name} may be NULL")


def pointers_of(interface, function):
    return [a for a in function.arguments if a.stars or a.base in interface.callbacks]


def rule_of(interface, function, seen=()):
    """From names of arguments to never, always or empty; None if the comment does not say.

    `A, B or C is NULL`       everything else may be NULL; with a condition A, B, C may where there is nothing to hold
    `a null pointer`          nothing may be NULL but what the prose allows: `may be NULL`
    `as for hsp_X`            as there"""
    text = function.statuses.get("HSP_E_ARGUMENT", "")
    names = [a.name for a in pointers_of(interface, function)]
    rule, says = {}, False
    refer = re.match(r"as for (hsp_\w+)", text)
    if refer and refer[1] not in seen:
        rule, says = rule_of(interface, interface.function(refer[1]), (*seen, function.name)) or {}, True
    listed = names_listed(text, names)
    rule.update(listed)
    if re.search(r"\ba null pointer\b", text):
        for name in names:
            rule.setdefault(name, "never")
        rule.update(names_allowed(function, text, names))
        if re.search(r"a null pointer with \w+ > 0", text):
            rule.update({a.name: "empty" for a in pointers_of(interface, function)
                         if a.base not in interface.handles and a.extents})
    elif listed and not refer:
        for name in names:
            rule.setdefault(name, "always")
    return rule if rule or says else None


def names_listed(text, names):
    """Those of `A, B or C is NULL`, and whether that holds only of an array that holds something."""
    listed = {}
    for clause in re.split(r"; |(?<=NULL), or ", text):
        found = re.match(rf"({NAMES}) (?:is NULL|with)(.*)", clause)
        if found and "null pointer" not in found[1]:
            null = "empty" if re.match(CONDITION, found[2]) else "never"
            listed.update({name: null for name in re.split(r", or |, | or | and ", found[1]) if name in names})
    return listed


def names_allowed(function, text, names):
    """Those of which the comment says `may be NULL`, or `if not NULL`; and `a null pointer, but A and B with n = 0`."""
    allowed = {}
    for part in re.split(r"[.;] |\(|\)", f"{function.prose} ; {text}"):
        found = re.search(r"(.*?)(?:, )?(?:may (?:each )?be NULL|if not NULL)(.*)", part)
        if found:
            null = "empty" if re.match(r" (?:only )?(?:with|if) ", found[2]) else "always"
            allowed.update({name: null for name in names if re.search(rf"(?<!\w){name}(?!\w)", found[1])})
    but = re.search(r"a null pointer, but (\w+) and (\w+) with", text)
    return allowed | {name: "empty" for name in (but.groups() if but else ())}
