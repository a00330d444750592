#!/usr/bin/env python3
"""Holds the self-test's trajectories of several builds against each other, bit by bit.

Builds rubble-bits by every compiler and set of flags that this machine has, runs each that its processor can run, and tells a table
of hashes: scenes by builds. Exits with 1 where two builds differ in a scene, with 2 where one could not be built or run.

    tests/bits/compare.py [--only NAME,NAME] [--work FOLDER] [--aarch64 SYSROOT] [CASE...]

AArch64 needs aarch64-linux-gnu-g++, qemu-aarch64, and libbullet-dev and libxxhash-dev of arm64, installed or unpacked below SYSROOT.
"""

import argparse
import os
import pathlib
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
# Name, compiler, flags, what the processor must have.
BUILDS = [
    ("g++-O2", "g++", "-O2", []),
    ("g++-O3", "g++", "-O3", []),
    ("g++-O2-v2", "g++", "-O2 -march=x86-64-v2", ["sse4_2"]),
    ("g++-O2-v3", "g++", "-O2 -march=x86-64-v3", ["avx2", "fma"]),
    ("g++-O3-v4", "g++", "-O3 -march=x86-64-v4", ["avx512f", "avx512vl"]),
    ("clang-O2", "clang++-19", "-O2", []),
    ("clang-O3-v2", "clang++-19", "-O3 -march=x86-64-v2", ["sse4_2"]),
    ("clang-O2-v3", "clang++-19", "-O2 -march=x86-64-v3", ["avx2", "fma"]),
    ("clang-O3-v4", "clang++-19", "-O3 -march=x86-64-v4", ["avx512f", "avx512vl"]),
]
ARM = "aarch64-linux-gnu"


def processor_flags():
    for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("flags"):
            return set(line.split(":", 1)[1].split())
    return set()


def arm_options(work, sysroot):
    """What CMake is told for AArch64, and the environment it runs in."""
    libraries = sysroot / "usr/lib" / ARM
    toolchain = work / "aarch64.cmake"
    toolchain.write_text(
        "set(CMAKE_SYSTEM_NAME Linux)\nset(CMAKE_SYSTEM_PROCESSOR aarch64)\n"
        f"set(CMAKE_C_COMPILER {ARM}-gcc)\nset(CMAKE_CXX_COMPILER {ARM}-g++)\n"
        f'set(CMAKE_CROSSCOMPILING_EMULATOR "qemu-aarch64;-L;/usr/{ARM};-E;LD_LIBRARY_PATH={libraries}")\n'
        'set(GOLD GOLD-NOTFOUND CACHE STRING "")\n')
    environment = dict(os.environ, PKG_CONFIG_LIBDIR=str(libraries / "pkgconfig"), PKG_CONFIG_SYSROOT_DIR=str(sysroot))
    tests = next(iter(pathlib.Path("/usr").glob("lib/*/cmake/GTest")), None)
    options = [f"-DCMAKE_TOOLCHAIN_FILE={toolchain}"] + ([f"-DGTest_DIR={tests}"] if tests else [])
    return options, environment, ["qemu-aarch64", "-L", f"/usr/{ARM}", "-E", f"LD_LIBRARY_PATH={libraries}"]


def built(work, name, flags, options, environment):
    folder = work / name
    log = work / f"{name}.log"
    configure = ["cmake", "-S", ROOT, "-B", folder, "-G", "Ninja", "-DRUBBLE_ROOMS=core", "-DCMAKE_BUILD_TYPE=RelWithDebInfo",
                 f"-DCMAKE_CXX_FLAGS_RELWITHDEBINFO={flags}", *options]
    with log.open("w") as out:
        for command in (configure, ["cmake", "--build", folder, "--target", "rubble-bits"]):
            if subprocess.run(command, stdout=out, stderr=out, env=environment).returncode != 0:
                print(f"{name}: not built, see {log}", file=sys.stderr)
                return None
    return folder / "bin/rubble-bits"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", default="", help="builds, by name and comma")
    parser.add_argument("--work", type=pathlib.Path, default=ROOT / "build/bits", help="folder of the builds")
    parser.add_argument("--aarch64", type=pathlib.Path, default=pathlib.Path("/"), help="where libraries of arm64 are unpacked")
    parser.add_argument("cases", nargs="*", metavar="CASE")
    asked = parser.parse_args()
    asked.work.mkdir(parents=True, exist_ok=True)
    only = set(filter(None, asked.only.split(",")))
    has = processor_flags()
    hashes, failed = {}, False

    def take(name, flags, options=(), environment=None, runner=()):
        nonlocal failed
        program = built(asked.work, name, flags, options, environment)
        if program is None:
            failed = True
            return
        run = subprocess.run([*runner, program, *asked.cases], capture_output=True, text=True)
        if run.returncode != 0:
            print(f"{name}: {run.stderr.strip()}", file=sys.stderr)
            failed = True
            return
        hashes[name] = {line.split()[0]: line.split()[1] for line in run.stdout.splitlines()}
        print(f"{name}: {len(hashes[name])} scenes", file=sys.stderr)

    for name, compiler, flags, needed in BUILDS:
        if only and name not in only:
            continue
        missing = [f for f in needed if f not in has] + ([] if shutil.which(compiler) else [compiler])
        if missing:
            print(f"{name}: left out, this machine has no {', '.join(missing)}", file=sys.stderr)
            continue
        take(name, flags, [f"-DCMAKE_CXX_COMPILER={compiler}"])
    if not only or "aarch64-O2" in only:
        missing = [p for p in (f"{ARM}-g++", "qemu-aarch64") if not shutil.which(p)]
        if not (asked.aarch64 / "usr/lib" / ARM / "pkgconfig/bullet-float64.pc").exists():
            missing.append("libbullet-dev of arm64")
        if missing:
            print(f"aarch64-O2: left out, this machine has no {', '.join(missing)}", file=sys.stderr)
        else:
            options, environment, runner = arm_options(asked.work, asked.aarch64)
            take("aarch64-O2", "-O2", options, environment, runner)
    if not hashes:
        return 2
    names = list(hashes)
    print("scene".ljust(22), *(name.ljust(12) for name in names))
    different = 0
    for scene in hashes[names[0]]:
        row = [hashes[name].get(scene, "-") for name in names]
        differs = len(set(row)) > 1
        different += differs
        print(scene.ljust(22), *(h[:8].ljust(12) for h in row), "DIFFERS" if differs else "")
    print(f"{different} of {len(hashes[names[0]])} scenes differ between {len(names)} builds")
    return 2 if failed else 1 if different else 0


if __name__ == "__main__":
    sys.exit(main())
