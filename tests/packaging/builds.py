"""A project of a user's builds on the library: docs/examples/bindings in C and C++20, by pkg-config or CMake upon
what is installed, or by meson with the library as a subproject. usage: builds.py WAY ROOT BUILD JUDGE FOLDER
JUDGE is bindings.py of tests/cli, FOLDER what may be kept for the next time."""

import os
import pathlib
import shlex
import shutil
import subprocess
import sys

way, root, build, judge, folder = sys.argv[1], *map(pathlib.Path, sys.argv[2:])
examples = root / "docs/examples/bindings"
STRICT = ["-Wall", "-Wextra", "-Wpedantic", "-Werror"]
CMAKE = """cmake_minimum_required(VERSION 3.16)
project(user C CXX)
set(CMAKE_CXX_STANDARD 20)
find_package(fmb @VERSION@ REQUIRED)
find_package(fmb @VERSION@ REQUIRED) # as several parts of a project may
foreach(refused IN ITEMS @REFUSED@)
  find_package(other ${refused} QUIET CONFIG NAMES fmb)
  if(other_FOUND)
    message(FATAL_ERROR "${refused} was asked for, and @VERSION@ found")
  endif()
endforeach()
foreach(language IN ITEMS c cpp)
  add_executable(rows_${language} @EXAMPLES@/rows.${language})
  target_link_libraries(rows_${language} PRIVATE fmb::fmb)
endforeach()
"""
MESON = """project('user', 'c', 'cpp', default_options: ['c_std=c11', 'cpp_std=c++20'])
fmb = dependency('fmb', version: '@VERSION@', fallback: 'fmb')
foreach language : ['c', 'cpp']
  executable('rows_' + language, 'rows.' + language, dependencies: fmb)
endforeach
"""


def call(*command, **env):
    run = subprocess.run(command, env={**os.environ, **env}, capture_output=True, text=True)
    if run.returncode:
        sys.exit(f"{shlex.join(map(str, command))}:\n{run.stdout}{run.stderr}")
    return run.stdout


def install():
    """Where programs find libraries and headers after an installation."""
    shutil.rmtree(folder, ignore_errors=True)
    home = folder / "home"
    call("meson", "install", "-C", build, "--no-rebuild", "--destdir", home)
    return home, next(home.rglob("libfmb.so")).parent


def by_pkg_config():
    home, libraries = install()
    flags = shlex.split(call("pkg-config", "--cflags", "--libs", "fmb", PKG_CONFIG_PATH=str(libraries / "pkgconfig"),
                             PKG_CONFIG_SYSROOT_DIR=str(home)))
    for compiler, standard, language in (("gcc", "c11", "c"), ("g++", "c++20", "cpp")):
        call(compiler, f"-std={standard}", *STRICT, examples / f"rows.{language}", "-o",
             folder / f"rows_{language}", *flags)
    return libraries


def by_cmake():
    """Moved after it was installed, as archives of packages are."""
    home, libraries = install()
    moved = folder / "moved"
    shutil.move(home, moved)
    libraries = moved / libraries.relative_to(home)
    prefix = next(moved.rglob("fmb.h")).parents[2]
    version = call("pkg-config", "--modversion", libraries / "pkgconfig/fmb.pc").strip()
    major, minor, patch = map(int, version.split("."))
    refused = f"{major}.{minor}.{patch + 1} {major}.{minor + 1} {major + 1}.{minor}"
    text = CMAKE.replace("@VERSION@", version).replace("@EXAMPLES@", str(examples)).replace("@REFUSED@", refused)
    (folder / "CMakeLists.txt").write_text(text)
    call("cmake", "-G", "Ninja", "-S", folder, "-B", folder, f"-DCMAKE_PREFIX_PATH={prefix}")
    call("cmake", "--build", folder)
    return libraries


def by_meson():
    """The library is built once more: what did not change since the last time is kept."""
    (folder / "subprojects").mkdir(parents=True, exist_ok=True)
    if not (folder / "subprojects/fmb").exists():
        (folder / "subprojects/fmb").symlink_to(root)
    for name in ("rows.c", "rows.cpp", "ring.h"):
        shutil.copy(examples / name, folder)
    version = call("pkg-config", "--modversion", build / "meson-private/fmb.pc").strip()
    (folder / "meson.build").write_text(MESON.replace("@VERSION@", version))
    inside = folder / "inside"
    if not (inside / "build.ninja").exists():
        call("meson", "setup", inside, folder, "--wrap-mode=forcefallback", "-Doptimization=0", "-Ddebug=false",
             "-Dfmb:pair_widths=narrow")
    call("ninja", "-C", inside)
    for language in ("c", "cpp"):
        shutil.copy(inside / f"rows_{language}", folder)
    return next(inside.rglob("libfmb.so")).parent


libraries = {"pkg-config": by_pkg_config, "cmake": by_cmake, "meson": by_meson}[way]()
for language in ("c", "cpp"):
    call(sys.executable, "-B", judge, examples / f"rows.{language}", folder / f"rows_{language}",
         LD_LIBRARY_PATH=str(libraries))
print(f"{way}: C and C++20")
