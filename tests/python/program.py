"""What the program says of a file of balls, and balls for tests."""
import json
import os
import random
import re
import shutil
import subprocess
import sys
import tempfile

if os.environ.get("HSP_WITHOUT_NUMPY"):
    sys.modules["numpy"] = None

SOURCE = os.environ["HSP_SOURCE"]
CRAMBIN = f"{SOURCE}/bench/molecules/crambin.pdb"


def run_block_of_page(word):
    """The block of the page of the guide that has this word, which no other one has, in a folder with crambin.pdb."""
    with open(f"{SOURCE}/capi/guide/python.md") as file:
        blocks = [block for block in re.findall(r"```py\n(.*?)```\n", file.read(), re.S) if word in block]
    assert len(blocks) == 1, f"{len(blocks)} blocks have {word}"
    names, folder = {}, tempfile.mkdtemp()
    shutil.copy(CRAMBIN, folder)
    before = os.getcwd()
    os.chdir(folder)
    try:
        exec(compile(blocks[0], "python.md", "exec"), names)
    finally:
        os.chdir(before)
        shutil.rmtree(folder)
    return names


def said(*arguments):
    run = subprocess.run([os.environ["HSP_PROGRAM"], *arguments, "--json"], capture_output=True, text=True, check=True)
    return json.loads(run.stdout)


def read_of(path):
    """Centres and radii as the program reads them."""
    balls = said("measure", path, "--per-ball")["balls"]
    return [ball["xyz"] for ball in balls], [ball["radius"] for ball in balls]


def random_balls(n, side, seed=1, low=1.0, high=1.8):
    numbers = random.Random(seed)
    return ([[numbers.uniform(0, side) for _ in range(3)] for _ in range(n)],
            [numbers.uniform(low, high) for _ in range(n)])
