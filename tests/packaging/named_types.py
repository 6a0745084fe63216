"""Every file of lib/ includes, itself or by what it includes, the header of each type that it names. Rooms are compiled as one unit
each, where a header that forgets another one finds it in the file before; file by file it would not compile.
    named_types.py SOURCE-FOLDER"""
import re
import sys
from pathlib import Path

lib = Path(sys.argv[1]) / "lib"
includes, code = {}, {}
for path in sorted(lib.rglob("*.[hc]pp")):
    name, text = "/".join(path.parts[-2:]), path.read_text()
    includes[name] = re.findall(r'#include "(\w+/[\w.]+)"', text)
    code[name] = re.sub(r'//.*|"[^"\n]*"', "", text)

headers_of = {}  # of each type at the margin
for name in code:
    if name.endswith(".hpp"):
        for each in re.findall(r"^(?:class|struct|enum class|enum|using) (\w+)(?=[^;\n]*[{:=]|\n)", code[name], re.M):
            headers_of.setdefault(each, []).append(name)
if len(headers_of) < 500:
    sys.exit("lib/ has more types than are found")

reached = {}


def reach(name):
    if name not in reached:
        reached[name] = {name}
        reached[name].update(*(reach(other) for other in includes[name] if other in code))
    return reached[name]


failed = False
for name in code:
    declared = set()
    for other in reach(name):
        declared.update(re.findall(r"\b(?:class|struct|enum class|enum|using|typename) (\w+)", code[other]))
    for each in sorted(set(re.findall(r"\b[A-Z]\w+", code[name])) & set(headers_of) - declared):
        # Parts of a header, as tables of kernels, are included behind what they take.
        if not any(name in reach(header) for header in headers_of[each]):
            print(f"lib/*/{name} names {each} and does not include {' or '.join(headers_of[each])}")
            failed = True
sys.exit(failed)
