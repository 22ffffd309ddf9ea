#!/usr/bin/env python3
"""syntax.py COMPILE_COMMANDS PATTERN: compiles the sources whose path matches, for the warnings alone."""
import concurrent.futures
import json
import os
import re
import shlex
import subprocess
import sys


def check(entry):
    words = shlex.split(entry["command"])
    if "-o" in words:
        del words[words.index("-o"):words.index("-o") + 2]
    return subprocess.run([*words, "-fsyntax-only"], cwd=entry["directory"]).returncode == 0


with open(sys.argv[1]) as file:
    entries = {entry["file"]: entry for entry in json.load(file) if re.search(sys.argv[2], entry["file"])}
with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
    passed = list(pool.map(check, entries.values()))
print(f"{sum(passed)} of {len(passed)} sources without a warning")
sys.exit(0 if passed and all(passed) else 1)
