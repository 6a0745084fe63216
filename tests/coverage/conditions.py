"""Lists the conditions of the core that are not covered by MC/DC, from the output of `llvm-cov show -show-mcdc`:

  conditions.py SHOWN EXCLUSIONS FILE...

A condition is covered if one instance of its function has been run with the condition true and false, all others of
its decision the same or not evaluated (MC/DC). A condition that the compiler folds to a constant in every instance
does not count. An exclusion is a line of EXCLUSIONS, file | condition | reason | why, and holds for each condition
with this text in the file. It is an error if an exclusion fits no uncovered condition, or if there are more than
MOST. Prints the share of covered conditions by room, and those that are left. Fails if any is left."""
import re
import sys
from collections import Counter, defaultdict
from pathlib import Path

MOST = 60
REASONS = ("compile-time", "speed", "overflow", "invariant", "tool")


def text_of(lines, line, column):
    """From where a condition begins to where it ends."""
    depth, taken, rest = 0, "", "\n".join([lines[line - 1][column - 1:], *lines[line:line + 9]])
    for i, character in enumerate(rest):
        depth += (character in "([{") - (character in ")]}")
        if depth < 0 or (depth == 0 and (rest[i:i + 2] in ("&&", "||") or character in ";?" or
                                         (character == "," and taken.count("<") == taken.count(">")))):
            break
        taken += character
    return " ".join(re.sub("//.*", "", taken).split())


def states_of(shown, files):
    """By file and place of a condition the states of its instances: covered, not covered, constant folded."""
    states, file, places = defaultdict(set), None, {}
    for row in shown.read_text(errors="replace").splitlines():
        if row.endswith(":") and row[0] not in " |":
            path = row.split(":")[0]
            file = next((f for f in files if path.endswith("/" + f)), None) if path.startswith("/") else file
        elif file and (found := re.search(r"Condition C(\d+) --> \((\d+):(\d+)\)", row)):
            places[found[1]] = (int(found[2]), int(found[3]))
        elif file and (found := re.search(r"C(\d+)-Pair: (.*)", row)):
            states[file, *places[found[1]]].add("covered" if found[2].startswith("covered") else found[2])
    return {place: of for place, of in states.items() if of != {"constant folded"}}


def main(shown, exclusions, *files):
    rows = [[part.strip() for part in row.split(" | ")] for row in Path(exclusions).read_text().splitlines()
            if row and not row.startswith("#")]
    errors = [f"{len(rows)} exclusions, more than {MOST}"] if len(rows) > MOST else []
    excluded = defaultdict(list)
    for row in rows:
        if len(row) != 4 or row[2] not in REASONS or not row[3]:
            errors.append(f"not file | condition | reason | why: {' | '.join(row)}")
        elif excluded.setdefault((row[0], row[1]), []):
            errors.append(f"twice: {row[0]} | {row[1]}")
        else:
            excluded[row[0], row[1]] = [row[2]]
    count, covered, without, used = Counter(), Counter(), Counter(), set()
    for (file, line, column), states in sorted(states_of(Path(shown), files).items()):
        room = "shims" if file.startswith("capi") else file.split("/")[2]
        count[room] += 1
        covered[room] += "covered" in states
        if "covered" in states:
            continue
        text = text_of(Path(file).read_text().splitlines(), line, column)
        if (file, text) in excluded:
            used.add((file, text))
            without[room] += 1
        else:
            errors.append(f"not covered: {file}:{line}:{column}: {text}")
    errors += [f"names no condition that is not covered: {file} | {text}" for file, text in excluded
               if (file, text) not in used]
    for room in [*sorted(count), "all"]:
        numbers = [table.total() if room == "all" else table[room] for table in (covered, without, count)]
        print("{:9} {:4} covered, {:3} excluded, of {:4}".format(room, *numbers))
    by_reason = Counter(row[2] for row in rows)
    print("exclusions: " + ", ".join(f"{by_reason[reason]} {reason}" for reason in REASONS))
    print(*errors, sep="\n")
    return 1 if errors or not count else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
