"""What a command writes to a file gets its name when it is whole, an input is never written to, and
names of files cannot speak to a terminal. usage: outputs.py FMB EXAMPLES [named]

named: no_nameless.c is loaded, so every file must have a name from the beginning."""

import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile

import default_signals  # noqa: F401

fmb, examples = sys.argv[1], pathlib.Path(sys.argv[2])
NAMED = sys.argv[3:] == ["named"]
faults = []


def expect(truth, what):
    if not truth:
        faults.append(what)


def run(*words, **how):
    return subprocess.run([fmb, *map(str, words)], capture_output=True, text=True, **how)


def clean(folder, *names):
    return sorted(p.name for p in folder.iterdir()) == sorted(names)


def nameless_files(folder):
    """Has the file system such, and can they be given a name?"""
    try:
        one = os.open(folder, os.O_TMPFILE | os.O_WRONLY, 0o600)
        os.link(f"/proc/self/fd/{one}", folder / "tried", src_dir_fd=0, follow_symlinks=True)
        (folder / "tried").unlink()
        os.close(one)
        return True
    except OSError:
        return False


def kill_while_writing(folder, *words):
    """Its outputs are open when the trace begins, which is megabytes, and nobody takes them from the pipe."""
    rows = "".join(f"x{i} + {i + 2} x{j} - x{(i * j) % 40} >= {i - j}\n"
                   for i in range(40) for j in range(i))
    one = subprocess.Popen([fmb, *map(str, words), "--trace", "/dev/stdout", "--trace-rows=true",
                            "--method", "fm"], text=True, bufsize=0,
                           stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    one.stdin.write(rows)
    one.stdin.close()
    begun = os.read(one.stdout.fileno(), 1)
    one.send_signal(signal.SIGKILL)
    one.stdout.close()
    return begun == b"{" and one.wait() == -signal.SIGKILL


with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)
    os.umask(mask := os.umask(0))
    system, proof = folder / "s.fmb", folder / "s.proof"
    shutil.copy(examples / "breakfast.fmb", system)
    before = system.read_text()

    expect(run("solve", system, "--proof", proof).returncode == 0, "a proof is written")
    expect(clean(folder, "s.fmb", "s.proof"), "no temporary file stays")
    expect(proof.stat().st_mode & 0o777 == 0o666 & ~mask, "mode of an output")
    good = proof.read_text()

    for words in (("solve", system, "--proof", system), ("bounds", system, "--trace", system)):
        r = run(*words)
        expect(r.returncode == 64 and "cannot be an output" in r.stderr, f"refused: {r.stderr}")
        expect(system.read_text() == before, "the input is as it was")
    (folder / "link").symlink_to(system)
    expect(run("solve", system, "--proof", folder / "link").returncode == 64, "nor through a link")
    with open(system, "a") as out:
        r = subprocess.run([fmb, "convert", system, "--to", "fmb"], stdout=out,
                           stderr=subprocess.PIPE, text=True)
    expect(r.returncode == 64 and "this very file" in r.stderr, f"FILE >> FILE: {r.stderr}")
    expect(system.read_text() == before, "nothing is appended to the input")
    (folder / "link").unlink()

    # A failure leaves what was there: here the rules do not go together, which shows at the query.
    r = run("solve", system, "--rebase=never", "--proof", proof, "--trace", folder / "t")
    expect(r.returncode == 64 and proof.read_text() == good, "a failure keeps the old proof")
    expect(clean(folder, "s.fmb", "s.proof"), f"a failure leaves no file: {os.listdir(folder)}")

    nameless = nameless_files(folder)
    expect(not (nameless and NAMED), "there are files without names all the same")
    for target in (proof, folder / "new"):
        expect(kill_while_writing(folder, "bounds", "-", "--proof", target), "killed midway")
        left = [p for p in folder.iterdir() if p not in (system, proof)]
        expect(len(left) == (0 if nameless else 1) and all(p.name.startswith(target.name + ".") for p in left),
               f"a kill leaves: {left}")
        for path in left:
            path.unlink()
    expect(proof.read_text() == good, "a kill keeps the old proof")

    # A proof through a link goes to the file behind it.
    (folder / "latest").symlink_to(proof)
    expect(run("bounds", system, "--proof", folder / "latest").returncode == 0, "through a link")
    expect((folder / "latest").is_symlink() and proof.read_text() != good, "the link stays")

    r = run("solve", system, "--proof", proof, "--trace", folder / "latest")
    expect(r.returncode == 64 and "two outputs" in r.stderr, f"two outputs, one file: {r.stderr}")

    full = run("solve", system, "--proof", "/dev/full")
    expect(full.returncode == 74, "a device is written to as it is")

    evil = folder / "a\x1b[31m\nb.fmb"
    r = run("solve", evil)
    expect(r.returncode == 66 and "\x1b" not in r.stderr and r"a\x1b[31m\x0ab.fmb" in r.stderr,
           f"escapes in names: {r.stderr!r}")
    evil.write_text("x <= ,\n")
    r = run("solve", evil)
    expect(r.returncode == 65 and "\x1b" not in r.stderr and r"\x1b" in r.stderr,
           f"escapes in places: {r.stderr!r}")

print("\n".join(faults) or "outputs: no faults")
sys.exit(bool(faults))
