"""Small headers for the tests of capi/interface, and what the reader makes of them."""
import tempfile
import textwrap
from pathlib import Path

from read import read_interface

DECLARED = """
typedef struct hsp_x hsp_x;
typedef struct hsp_row {
  double centre[3]; /**< length */
  uint32_t ball;
  uint32_t reserved; /**< 0 */
} hsp_row;
typedef struct hsp_limits {
  uint32_t struct_size; /**< sizeof(hsp_limits) */
  /** most balls,
   *  as they come */
  uint32_t balls;
} hsp_limits;
typedef int32_t (*hsp_sink)(void *context, const char *bytes, size_t count);
"""


def interface_of(text, listed=("x.h",), tier="Stable: from version 1.0 on this stays as it is, and is only added to."):
    """The interface of a header x.h that holds the text, and says of which tier it is."""
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "hardsphere").mkdir()
        (Path(folder) / "hardsphere" / "x.h").write_text(
            f"/* hardsphere/x.h: what it is for.\n *\n * {tier} */\n#include <stddef.h>\n#include <stdint.h>\n" + text)
        names = "".join(f" *   hardsphere/{name}  what it is for\n" for name in listed)
        (Path(folder) / "hardsphere.h").write_text(f'/*\n{names} */\n#include "hardsphere/x.h"\n')
        return read_interface(folder)


def function_of(arguments, comment, before=""):
    """hsp_f(arguments) with a comment, read behind the declarations above and `before`."""
    rows = "\n".join(f" *  {row}" for row in textwrap.dedent(comment).strip().split("\n"))
    text = f"{DECLARED}{before}\n/**\n{rows} */\nHSP_API int32_t hsp_f({arguments});\n"
    return interface_of(text).function("hsp_f")
