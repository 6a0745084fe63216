"""The page of the guide on how exact results are: the table HOW EXACT of hardsphere.h."""
import re

OPENING = """\
# How exact results are

Coordinates and radii are rounded once, to a decimal lattice. Balls, faces and cells, and how they hang together,
are then decided in integers, ties included: no tolerance takes part. Numbers such as areas are sums in doubles over
what was decided, with errors of a few last bits. A few headers decide in floating point where integers would be too
long; a status or a number says where that did not suffice. `hardsphere.h` has this table, EXACTNESS there says how ties are
decided, and each function its own bounds.

Next: [robustness](robustness.md)
"""
GENERATED = "<!-- Generated from the headers by capi/interface/generate.sh -->"


def exactness_page(interface):
    rows = table(interface.text)
    names = ["header", *rows[0][1:]]
    lines = [OPENING, GENERATED, "", f"| {' | '.join(names)} |", "|---" * len(names) + "|"]
    lines += [f"| `{name}.h` | {' | '.join(plain(cell) for cell in cells)} |" for name, *cells in rows[1:]]
    return "\n".join([*lines, ""])


def table(text):
    """The rows of the table, each cell as one text. Columns begin where their names do."""
    block = text.split(" * HOW EXACT\n")[1].split("\n *   A rounded number")[0].split("\n")
    begins = [place.start() for place in re.finditer(r"(?<=  )\S", block[0])]
    rows = []
    for line in block:
        cells = [line[begin:end].strip() for begin, end in zip(begins, [*begins[1:], None])]
        if cells[0]:
            rows.append(cells)
        else:
            rows[-1] = [f"{before} {more}".strip() for before, more in zip(rows[-1], cells)]
    return rows


def plain(cell):
    """A cell in Markdown, names of the interface as code."""
    return re.sub(r"\b(HSP_\w+|hsp_[\w.]+|open_joints)", r"`\1`", cell.replace("-", "") if cell == "-" else cell)
