"""The page of the guide: its blocks of Python are one program, which prints the blocks of text and writes the picture.
    page_test.py [--write]    --write: puts what is printed into the page, and the picture beside it"""
import contextlib
import io
import os
import re
import shutil
import sys
import tempfile

from program import CRAMBIN, SOURCE

GUIDE = f"{SOURCE}/capi/guide"
BLOCK = re.compile(r"```(python|text)\n(.*?)```\n", re.S)


def main(write):
    with open(f"{GUIDE}/python.md") as file:
        page = file.read()
    names, printed = {}, io.StringIO()

    def run(block):
        if block[1] == "python":
            with contextlib.redirect_stdout(printed):
                exec(compile(block[2], "python.md", "exec"), names)
            return block[0]
        text = printed.getvalue()
        printed.seek(0)
        printed.truncate()
        return f"```text\n{text}```\n"

    with tempfile.TemporaryDirectory() as folder:
        shutil.copy(CRAMBIN, folder)
        os.chdir(folder)
        said = BLOCK.sub(run, page)
        with open("python.svg") as file:
            picture = file.read()
        os.chdir("/")
    if write:
        with open(f"{GUIDE}/python.md", "w") as file:
            file.write(said)
        with open(f"{GUIDE}/python.svg", "w") as file:
            file.write(picture)
    with open(f"{GUIDE}/python.svg") as file:
        assert picture == file.read(), "python.svg is another picture"
    for shown, text in zip(BLOCK.findall(page), BLOCK.findall(said)):
        assert write or shown == text, f"the page shows\n{shown[1]}and what is printed is\n{text[1]}"
    assert len(BLOCK.findall(page)) > 12


if __name__ == "__main__":
    main(sys.argv[1:] == ["--write"])
