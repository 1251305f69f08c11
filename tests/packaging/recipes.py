"""Recipes of packages for conda, vcpkg, Homebrew, Nix and Debian set every option of meson that is a choice, list what these
need, and are read without an error by their own languages, as far as those are installed here: recipes.py ROOT"""

import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

root = pathlib.Path(sys.argv[1])
packaging = root / "packaging"
# What a part of ours needs beside GMP; packages bear these names with a prefix or an ending.
NEEDS = {"apps": "jansson", "study": "gsl", "nauty": "nauty", "python": "cffi"}
# A recipe, the file that says what it needs, and where in that.
RECIPES = {
    "conda/meta.yaml": ("conda/meta.yaml", r"  host:.*?  run:"),
    "vcpkg/fmb/portfile.cmake": ("vcpkg/fmb/vcpkg.json", r'"dependencies".*'),
    "homebrew/fmb.rb": ("homebrew/fmb.rb", r"  depends_on.*  depends_on"),
    "nix/package.nix": ("nix/package.nix", r"\A\{.*?\}:"),
    "debian/rules": ("debian/control", r"^Build-Depends:.*?\n\n"),
}
# What vcpkg's functions are told; the port itself is run.
VCPKG = """cmake_minimum_required(VERSION 3.16)
set(CURRENT_PACKAGES_DIR "{folder}/packages")
foreach(name IN ITEMS check_linkage install_meson fixup_pkgconfig)
  cmake_language(EVAL CODE "function(vcpkg_${{name}})\nendfunction()")
endforeach()
function(vcpkg_configure_meson)
  cmake_parse_arguments(PARSE_ARGV 0 asked "" "SOURCE_PATH" "OPTIONS")
  if(NOT EXISTS "${{asked_SOURCE_PATH}}/meson.build")
    message(FATAL_ERROR "no sources at ${{asked_SOURCE_PATH}}")
  endif()
endfunction()
function(vcpkg_install_copyright)
  cmake_parse_arguments(PARSE_ARGV 0 asked "" "" "FILE_LIST")
  foreach(file IN LISTS asked_FILE_LIST)
    file(READ "${{file}}" text)
  endforeach()
endfunction()
include("{port}")
"""
# The recipe of Nix as a function of names alone, evaluated without a store.
NIX = """(import {recipe}) {{
  lib = {{ cleanSource = path: if builtins.pathExists (path + "/meson.build") then "sources" else abort "no sources";
    licenses = {{ lgpl3Plus = 1; gpl3Plus = 2; }}; platforms.linux = [ "linux" ]; }};
  stdenv.mkDerivation = given: given;
  meson = "meson"; ninja = "ninja"; pkg-config = "pkg-config"; python3 = "python3"; gmp = "gmp"; jansson = "jansson";
}}"""


def text(path):
    return (packaging / path).read_text(encoding="utf-8")


def features():
    """Options of ours that take `auto`, which a package must not leave to what the machine happens to have."""
    options = (root / "meson_options.txt").read_text(encoding="utf-8")
    return set(re.findall(r"option\('(\w+)', type: 'feature'", options))


def choice_faults(path):
    chosen = dict(re.findall(r"-D(\w+)=([\w$()]+)", text(path)))
    if set(chosen) != features():
        yield f"{path}: sets {sorted(chosen)}, and there are {sorted(features())}"
    place, part = RECIPES[path]
    wanted = {"gmp"} | {need for option, need in NEEDS.items() if chosen.get(option) == "enabled"}
    said = re.search(part, text(place), re.M | re.S).group(0)
    listed = {n for n in ("gmp", *NEEDS.values()) if re.search(rf"\b(lib|python3-)?{n}2?(-dev)?\b", said)}
    if listed != wanted:
        yield f"{place}: lists {sorted(listed)}, and {path} needs {sorted(wanted)}"


def call(*command):
    """What a command printed; where it is not installed, nothing."""
    if not shutil.which(command[0]):
        print(f"{command[0]} is not installed: left out")
        return None
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode:
        raise ValueError(f"{' '.join(map(str, command))}:\n{done.stdout}{done.stderr}")
    return done.stdout


def read_conda():
    try:
        import jinja2 # pylint: disable=import-outside-toplevel
        import yaml # pylint: disable=import-outside-toplevel
    except ModuleNotFoundError as missing:
        print(f"{missing}: left out")
        return
    template = jinja2.Environment(undefined=jinja2.StrictUndefined).from_string(text("conda/meta.yaml"))
    recipe = yaml.safe_load(template.render(compiler=lambda name: f"{name}-compiler",
                                            pin_subpackage=lambda name, max_pin: f"{name} {max_pin}"))
    source = packaging / "conda" / recipe["source"]["path"]
    for file in ["meson.build", *recipe["about"]["license_file"]]:
        if not (source / file).exists():
            raise ValueError(f"conda/meta.yaml: no {file}")


def read_vcpkg(folder):
    json.loads(text("vcpkg/fmb/vcpkg.json"))
    script = folder / "port.cmake"
    script.write_text(VCPKG.format(folder=folder, port=packaging / "vcpkg/fmb/portfile.cmake"))
    call("cmake", "-P", script)


def read_homebrew():
    call("ruby", "-wc", packaging / "homebrew/fmb.rb")


def read_nix():
    for path in (packaging / "nix").glob("*.nix"):
        call("nix-instantiate", "--parse", path)
    expression = NIX.format(recipe=packaging / "nix/package.nix")
    if given := call("nix-instantiate", "--eval", "--strict", "--json", "--store", "dummy://", "-E", expression):
        if json.loads(given)["src"] != "sources":
            raise ValueError("nix/package.nix: not of these sources")


def faults():
    for path in RECIPES:
        yield from choice_faults(path)
    with tempfile.TemporaryDirectory() as name:
        for read in (read_conda, lambda: read_vcpkg(pathlib.Path(name)), read_homebrew, read_nix):
            try:
                read()
            except Exception as wrong: # whatever a reader finds # pylint: disable=broad-except
                yield str(wrong)


wrong = list(faults())
print("\n".join(wrong) or "recipes: no faults")
sys.exit(1 if wrong else 0)
