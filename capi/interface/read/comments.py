"""Doxygen comments: where they stand in a header, and their parts."""
import re


def comment_before(rows, line):
    """The comment that ends directly before a line (1-based), without its stars; empty if there is none."""
    last = line - 2
    if last < 0 or not rows[last].rstrip().endswith("*/"):
        return ""
    first = last
    while "/*" not in rows[first]:
        first -= 1
    return bare("\n".join(rows[first:last + 1]))


def remark_at(rows, line):
    """What is said of the constant or field that a line (1-based) declares: behind it, or in the comment before it."""
    while rows[line - 1].endswith("\\"):
        line += 1
    behind = re.search(r"/\*\*< *(.*)", rows[line - 1])
    if not behind:
        return re.sub(r"\s+", " ", comment_before(rows, line))
    text, line = behind[1], line + 1
    while "*/" not in text:
        text += " " + rows[line - 1].strip()
        line += 1
    return re.sub(r"\s+", " ", text[:text.index("*/")]).strip()


def bare(comment):
    """The text of a Doxygen comment; empty if it is another one."""
    comment = comment.strip()
    if not comment.startswith("/**"):
        return ""
    return "\n".join(re.sub(r"^ *\* ?(?: (?=\S))?", "", row).rstrip()
                     for row in comment[3:-2].split("\n")).strip()


def read_comment(function):
    """Takes the parts of a function's comment: prose and its first sentence, statuses, parameters."""
    prose, tagged = [], None  # tagged: the text of a tag that rows with an indent go on with
    for row in function.comment.split("\n"):
        status = re.fullmatch(r"@retval (HSP_\w+) +(.*)", row)
        parameter = re.fullmatch(r"@param\[(?:in|out|in,out)\] +(\w+) +(.*)", row)
        if status or parameter:
            tagged = function.statuses if status else function.parameters
            name, tagged[name] = (status or parameter).groups()
        elif tagged is not None and row.startswith(" "):
            tagged[name] += " " + row.strip()
        else:
            tagged = None
            prose.append(row)
    function.prose = re.sub(r"\s+", " ", " ".join(prose)).strip()
    function.brief = re.split(r"(?<=[^.][.]) ", function.prose)[0]  # `first .. last` goes on


def functions_named(interface, function):
    """The functions that a comment goes on from: those that it names, and the one before if it says so."""
    named = [interface.function(name) for name in dict.fromkeys(re.findall(r"\bhsp_\w+", function.prose))]
    named = [f for f in named if f and f is not function]
    if re.match(r"The same|The two parts|Make of such", function.prose):
        here = [f for f in interface.functions if f.header == function.header]
        if here[0] is not function:
            named.append(here[here.index(function) - 1])
    return named
