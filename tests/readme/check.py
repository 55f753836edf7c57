# Copyright (c) 2026 The Pelage authors
# SPDX-License-Identifier: MIT
"""check.py ROOT COMPILER FLAG...: every README.md under ROOT is what it says it is.

Each ```cpp block is a translation unit of its own; one that has a main is also run, with Boost.Context if it explores. Each ```glsl block that
has a main is validated where glslangValidator is installed. The comment <!-- not compiled --> on the line
above a block leaves it out. Every relative link and picture leads to what exists, its #anchor to a heading.
First the check itself is tested: on a tree with faults planted in it, it must report each of them, and no more.
"""
import concurrent.futures
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

BLOCK = re.compile(
    r"^(?P<skip><!-- not compiled -->\n\s*)?```(?P<language>cpp|glsl)\n(?P<code>.*?)^```$", re.M | re.S)
FENCED = re.compile(r"^```.*?^```$", re.M | re.S)
INDENTED = re.compile(r"^    .*$", re.M)
LINK = re.compile(r"\]\((?P<target>[^()\s]+)\)")
HEADING = re.compile(r"^#+ +(.*?) *#*$", re.M)
LEFT_OUT = {".git", "build", "out", "__pycache__"}


def line_of(text, position):
    return text.count("\n", 0, position) + 1


def without_code(text):
    """The text with code blanked out, of the same length, so that positions stay what they are."""
    for code in FENCED, INDENTED:
        text = code.sub(lambda found: re.sub(r"[^\n]", " ", found[0]), text)
    return re.sub(r"`[^`\n]*`", lambda found: "`" + " " * (len(found[0]) - 2) + "`", text)


def anchors(path):
    """The anchors that GitHub gives to the headings of a file."""
    found = set()
    for heading in HEADING.findall(FENCED.sub("", path.read_text())):
        words = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading)
        base = anchor = re.sub(r"[^\w\- ]", "", words.lower()).replace(" ", "-")
        count = 0
        while anchor in found:
            count += 1
            anchor = f"{base}-{count}"
        found.add(anchor)
    return found


def broken_links(readme):
    text = readme.read_text()
    for link in LINK.finditer(without_code(text)):
        target = link["target"]
        if re.match(r"[a-z]+:", target):
            continue
        path, _, anchor = target.partition("#")
        there = readme.parent / path if path else readme
        if not there.exists():
            yield f"{readme}:{line_of(text, link.start())}: there is no {target}"
        elif anchor and (there.suffix != ".md" or anchor not in anchors(there)):
            yield f"{readme}:{line_of(text, link.start())}: there is no heading for {target}"


def commands(block, include, compile_cpp, work):
    """The commands that check one block, in order."""
    if block["language"] == "cpp":
        source, program = work / "block.cpp", work / "program"
        source.write_text(block["code"])
        if not re.search(r"^int main\(", block["code"], re.M):
            return [[*compile_cpp, f"-I{include}", "-fsyntax-only", str(source)]]
        libraries = ["-lboost_context"] if "<pelage/explore/explore.hpp>" in block["code"] else []
        return [[*compile_cpp, f"-I{include}", str(source), "-o", str(program), *libraries], [str(program)]]

    validator = shutil.which("glslangValidator")
    if validator is None or "void main" not in block["code"]:
        return []
    stage = "comp" if "local_size_x" in block["code"] else "vert" if "gl_Position" in block["code"] else "frag"
    source = work / f"block.{stage}"
    source.write_text(block["code"])
    vulkan = ["-V", "-o", str(work / "block.spv")] if re.search(r"\bset *=|push_constant", block["code"]) else ["-l"]
    return [[validator, *vulkan, f"-I{include}", str(source)]]


def check_block(readme, line, block, include, compile_cpp):
    """Whether there was anything to check, and the fault found, or None."""
    with tempfile.TemporaryDirectory() as work:
        steps = commands(block, include, compile_cpp, pathlib.Path(work))
        for step in steps:
            done = subprocess.run(step, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
            if done.returncode != 0:
                return True, f"{readme}:{line}: {pathlib.Path(step[0]).name} ends with {done.returncode}\n{done.stdout}"
    return bool(steps), None


def check(root, include, compile_cpp):
    """The number of files, of links' files and blocks checked, and the faults."""
    readmes = []
    for folder, folders, files in os.walk(root):
        folders[:] = sorted(set(folders) - LEFT_OUT)
        readmes += [pathlib.Path(folder, file) for file in files if file == "README.md"]
    faults = [fault for readme in readmes for fault in broken_links(readme)]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        jobs = []
        for readme in readmes:
            text = readme.read_text()
            for block in BLOCK.finditer(text):
                if not block["skip"]:
                    line = line_of(text, block.start("code"))
                    jobs.append(pool.submit(check_block, readme, line, block, include, compile_cpp))
        results = [job.result() for job in jobs]
    faults += [fault for _, fault in results if fault]
    return len(readmes), sum(checked for checked, _ in results), faults


PLANTED = """# Faults

[sound](#faults) [sound](room/README.md#a-room-its-door) [sound](room) `[code](nowhere)` [far](https://nowhere.invalid)
[no file](nowhere.md)
![no picture](nowhere.png)
[no heading](#nowhere)
[no heading there](room/README.md#nowhere)

```cpp
int main() { return 0; }
```

```cpp
int main() { return 1; }
```

```cpp
int answer() { return question; }
```

<!-- not compiled -->
```cpp
[left out](nowhere)
```
"""
PLANTED_AT = [("README.md", line) for line in (4, 5, 6, 7, 14, 18)] + [("room/README.md", 3)]


def test_itself(compile_cpp):
    """Whether each planted fault is found, and nothing else."""
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        (root / "room").mkdir()
        (root / "README.md").write_text(PLANTED)
        (root / "room" / "README.md").write_text("# A room: its `door`\n\n[up](../README.md#nowhere)\n")
        _, _, faults = check(root, root, compile_cpp)
        found = sorted(":".join(fault.split(":")[:2]) for fault in faults)
        expected = sorted(f"{root / name}:{line}" for name, line in PLANTED_AT)
    if found != expected:
        print(f"the check itself fails: planted {expected}, found {found}")
    return found == expected


def main(root, *compile_cpp):
    if not test_itself(compile_cpp):
        return 1
    root = pathlib.Path(root)
    files, blocks, faults = check(root, root / "include", compile_cpp)
    print(*faults, sep="\n", end="\n" if faults else "")
    print(f"{files} files and {blocks} blocks checked, {len(faults)} faults")
    return blocks == 0 or len(faults) > 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
