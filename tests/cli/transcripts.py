"""Play the console blocks of Markdown files and compare what comes back, to the letter.

    ```console
    $ fmb solve schedule.fmb
    infeasible
    ! a line of standard error
    [exit 1]
    ```

All blocks of a file run in one fresh folder that holds copies of the files in the folders given;
bash runs each command. An exit code of 0 is not shown. --rewrite writes what came back into the
file. FMB_UNDER is put in front of fmb ("valgrind -q"). A folder in the place of a FILE means all of
its documents that have such blocks; these find what lies beside them, too.

usage: transcripts.py [--rewrite] FMB FOLDER,FOLDER FILE|FOLDER...
"""

import difflib
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

import under

BLOCK = re.compile(r"(^```console\n)(.*?)(^```$)", re.M | re.S)


def play(command, folder, path):
    env = {"PATH": path, "HOME": str(folder), "LC_ALL": "C", "TERM": "dumb"}
    for name in ("ASAN_OPTIONS", "UBSAN_OPTIONS", "LD_LIBRARY_PATH"):
        if name in os.environ:
            env[name] = os.environ[name]
    run = subprocess.run(["bash", "-c", command], cwd=folder, env=env, stdin=subprocess.DEVNULL,
                         capture_output=True, timeout=300)
    out = run.stdout.decode(errors="backslashreplace").splitlines()
    out += ["! " + line for line in run.stderr.decode(errors="backslashreplace").splitlines()]
    if run.returncode:
        out.append(f"[exit {run.returncode}]")
    return out


def play_block(text, folder, path):
    """The block with fresh answers to its commands. A command goes on over lines with `> `."""
    result, command = [], None
    for line in [*text.splitlines(), "$ "]:
        if command is not None and line.startswith("> "):
            command += "\n" + line[2:]
            result.append(line)
            continue
        if line.startswith("$ ") or command is None:
            if command is not None:
                result += play(command, folder, path)
            if line.startswith("$ "):
                command = line[2:]
            result.append(line)
    return "".join(line + "\n" for line in result[:-1])


def play_file(document, fmb, folders):
    with tempfile.TemporaryDirectory() as name:
        folder, bin = pathlib.Path(name, "here"), pathlib.Path(name, "bin")
        for source in folders:
            shutil.copytree(source, folder, dirs_exist_ok=True)
        bin.mkdir()
        wrapper = bin / "fmb"
        wrapper.write_text(f'#!/bin/sh\nexec {shlex.join(under.command(fmb))} "$@"\n')
        wrapper.chmod(0o755)
        path = f"{bin}:/usr/bin:/bin"
        text = document.read_text()
        return text, BLOCK.sub(lambda m: m[1] + play_block(m[2], folder, path) + m[3], text)


def documents(paths, folders):
    """Each document, and the folders whose files it finds."""
    for path in map(pathlib.Path, paths):
        if not path.is_dir():
            yield path, folders
        for document in sorted(path.rglob("*.md")) if path.is_dir() else ():
            if BLOCK.search(document.read_text()):
                yield document, [*folders, document.parent]


def main():
    arguments = sys.argv[1:]
    rewrite = arguments[0] == "--rewrite"
    fmb, folders, *paths = arguments[rewrite:]
    failed = False
    for document, known in documents(paths, folders.split(",")):
        expected, found = play_file(document, fmb, known)
        if not BLOCK.search(expected):
            print(f"{document}: no console blocks")
            failed = True
        elif rewrite:
            document.write_text(found)
        elif expected != found:
            failed = True
            sys.stdout.writelines(difflib.unified_diff(
                expected.splitlines(True), found.splitlines(True), str(document), "now"))
    return failed


sys.exit(main())
