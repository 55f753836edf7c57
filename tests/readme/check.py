# Copyright (c) 2026 The Pelage authors
# SPDX-License-Identifier: MIT
"""check.py README INCLUDE_DIR COMPILER FLAG...: the code in the README is what it says it is.

Each ```cpp block is a translation unit of its own; one that has a main is also run. Each ```glsl block that
has a main is validated where glslangValidator is installed. The comment <!-- not compiled --> on the line
above a block leaves it out.
"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

BLOCK = re.compile(
    r"^(?P<skip><!-- not compiled -->\n\s*)?```(?P<language>cpp|glsl)\n(?P<code>.*?)^```$", re.M | re.S)


def commands(block, include, compile_cpp, work):
    """The commands that check one block, in order."""
    if block["language"] == "cpp":
        source, program = work / "block.cpp", work / "program"
        source.write_text(block["code"])
        if not re.search(r"^int main\(", block["code"], re.M):
            return [[*compile_cpp, f"-I{include}", "-fsyntax-only", str(source)]]
        return [[*compile_cpp, f"-I{include}", str(source), "-o", str(program)], [str(program)]]

    validator = shutil.which("glslangValidator")
    if validator is None or "void main" not in block["code"]:
        return []
    stage = "comp" if "local_size_x" in block["code"] else "vert" if "gl_Position" in block["code"] else "frag"
    source = work / f"block.{stage}"
    source.write_text(block["code"])
    vulkan = ["-V", "-o", str(work / "block.spv")] if re.search(r"\bset *=|push_constant", block["code"]) else ["-l"]
    return [[validator, *vulkan, f"-I{include}", str(source)]]


def main(readme, include, *compile_cpp):
    text = pathlib.Path(readme).read_text()
    checked = failed = 0
    for block in BLOCK.finditer(text):
        line = text.count("\n", 0, block.start("code")) + 1
        if block["skip"]:
            continue
        with tempfile.TemporaryDirectory() as work:
            steps = commands(block, include, compile_cpp, pathlib.Path(work))
            checked += bool(steps)
            for step in steps:
                done = subprocess.run(step, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
                if done.returncode != 0:
                    failed += 1
                    print(f"{readme}:{line}: {pathlib.Path(step[0]).name} ends with {done.returncode}\n{done.stdout}")
                    break
    print(f"{checked} blocks checked, {failed} failed")
    return checked == 0 or failed > 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
