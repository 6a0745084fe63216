"""Templates: what is written by hand of a file, and a row that names each part that is generated."""
import re


def filled(path, mark, part, headers=None):
    """The text of a template, in which the rows part(name) stand for each row that `mark` matches with a name in it.
    A row such as `---- view.h` begins what is for that header, to the next one or to the end of an interface, a module
    or a file: with `headers`, those that are there, what is for others is left out."""
    rows, there = [], True
    for row in path.read_text().split("\n"):
        section = re.fullmatch(r" *(?:!|/\*) ---- (?:(\w+\.h).*)?", row)
        if section or re.fullmatch(r" *(?:(?:abstract |end )?interface|end module.*|#endif)", row):
            there = headers is None or not section or section[1] is None or section[1] in headers
        found = re.fullmatch(mark, row)
        if found and not found[1].startswith("compute "):  # it is made of what is there
            there = True
        if there and is_there(row, headers):
            rows += part(found[1]) if found else [row]
    return "\n".join(rows)


def is_there(row, headers):
    """Whether a row of a Fortran module names no header behind it, or one of these."""
    named = re.search(r"! hardsphere/(\w+\.h)$", row)
    return headers is None or not named or named[1] in headers


def guarded(rows, component):
    """Rows in C, those for a component between #if HSP_HAS_.. and #endif: from a row `---- view.h`, which is left out, to
    the next one, and within these rows that name another component's header at their end. `component`: of each header
    that has one."""
    done, outer, inner = [], None, None
    for row in rows:
        title = re.fullmatch(r"/\* ---- (\w+\.h) \*/", row)
        if title:
            if component.get(title[1]) != outer:
                if outer:
                    done[-1:] = ["#endif", ""]
                outer = component.get(title[1])
                if outer:
                    done.append(f"#if HSP_HAS_{outer.upper()}")
            continue
        if row == "" and done[-1:] == [""]:
            continue
        named = re.search(r"hardsphere/(\w+\.h)\)? \*/$", row)
        wanted = component.get(named[1]) if named else None
        if wanted == outer:
            wanted = None
        if wanted != inner:
            if inner:
                done.append("#endif")
            if wanted:
                done.append(f"#if HSP_HAS_{wanted.upper()}")
            inner = wanted
        done.append(row)
    return aligned(done)


def aligned(rows):
    """Remarks behind rows that follow each other, in one column."""
    done, run = [], []

    def end_run():
        column = max((len(code) for code, _ in run), default=0)
        done.extend(f"{code.ljust(column)} {remark}" for code, remark in run)
        run.clear()

    for row in rows:
        found = re.fullmatch(r"( +.*[;)]) +(/\*.*\*/)", row)
        if found:
            run.append(found.groups())
            continue
        end_run()
        done.append(row)
    end_run()
    return done
