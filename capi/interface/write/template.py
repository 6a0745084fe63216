"""Templates: what is written by hand of a file, and a row that names each part that is generated."""
import re


def filled(path, mark, part):
    """The text of a template, in which the rows part(name) stand for each row that `mark` matches with a name in it."""
    rows = []
    for row in path.read_text().split("\n"):
        found = re.fullmatch(mark, row)
        rows += part(found[1]) if found else [row]
    return "\n".join(rows)
