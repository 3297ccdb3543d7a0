#!/usr/bin/python3 -P
"""Runs the program of the Python package that has the name of this file, of which builds and
installations have copies."""

import os
import signal
import sys
from importlib import import_module
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str((HERE / r"""@RUPTURE_HOME@/python""").resolve()))
os.environ.setdefault("RUPTURE_BIN", str(HERE))


# A stream that is closed would become the next file. As in cli/interruption.cpp, output that nobody
# can read fails.
for number, (stream, mode) in enumerate((("stdin", "r"), ("stdout", "w"), ("stderr", "w"))):
    if getattr(sys, stream) is None:
        os.open(os.devnull, os.O_RDONLY if stream == "stdout" else os.O_RDWR)
        setattr(sys, stream, open(number, mode, encoding="utf-8"))
if signal.getsignal(signal.SIGINT) != signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.SIG_DFL)  # no traceback while packages are loaded

name = os.path.basename(sys.argv[0])
try:
    tool = import_module(f"rupture.tools.{name}")
    from rupture.tools.command_line import run_tool
except ModuleNotFoundError as error:
    hint = f"install it, on Debian with apt-get install python3-{error.name}"
    sys.exit(f"rupture {name}: {error.name} is not installed; {hint}")
sys.exit(run_tool(name, tool.run))
