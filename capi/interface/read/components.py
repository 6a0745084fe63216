"""Which component each header belongs to: lib/<component>/component.cmake says so. All others are the core's."""
import re
from dataclasses import replace
from pathlib import Path

LIB = Path(__file__).resolve().parents[3] / "lib"


def component_of_headers():
    """From the names of headers to those of components."""
    found = {}
    for path in sorted(LIB.glob("*/component.cmake")):
        headers = re.search(r"^  HEADERS ([\w ]+)", path.read_text(), re.M)
        found.update({f"{name}.h": path.parent.name for name in (headers[1].split() if headers else ())})
    return found


def restricted(interface, parts):
    """The interface without headers of components that are not among the parts of a build."""
    component = component_of_headers()

    def there(header):
        return component.get(header) is None or component[header] in parts

    return replace(
        interface,
        headers={name: subject for name, subject in interface.headers.items() if there(name)},
        functions=[f for f in interface.functions if there(f.header)],
        structs={name: s for name, s in interface.structs.items() if there(s.header)},
        handles={name: header for name, header in interface.handles.items() if there(header)},
        constants={name: c for name, c in interface.constants.items() if there(c.header)},
        macros={name: m for name, m in interface.macros.items() if there(m.header)})
