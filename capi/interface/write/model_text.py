"""The model as a text: a line for each function, so that a review sees what has been understood of a comment."""


def model_text(interface):
    rows = ["# What capi/interface reads from the headers, a function a line. README.md beside this file says how.",
            "# Generated: bash capi/interface/generate.sh"]
    rows += [function_row(f) for f in interface.functions]
    return "\n".join([*rows, ""])


def function_row(function):
    result = {"int32_t": "status", "uint32_t": "number"}.get(function.result, "text")
    statuses = " ".join(name.removeprefix("HSP_") for name in function.statuses if name != "HSP_OK")
    return (f"{function.name}({', '.join(argument_text(a) for a in function.arguments)}) -> {result}"
            f"{' ' if statuses else ''}{statuses}")


def argument_text(argument):
    kind = argument.kind if argument.kind != argument.name else ""
    extents = "".join(f"[{extent}]" for extent in argument.extents)
    null = {"never": "", "always": "or NULL", "empty": "or NULL if empty", "box": "or NULL in a box"}[argument.null]
    fields = f"{{{', '.join(map(argument_text, argument.fields))}}}" if argument.fields else ""
    parts = (argument.name, kind, extents, "held" if argument.held else "", null, fields)
    return " ".join(part for part in parts if part)
