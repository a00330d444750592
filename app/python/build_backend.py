"""Builds the wheel with CMake (PEP 517): pip install . --no-build-isolation

It needs what packages.txt lists and no network. Settings: build-dir=FOLDER keeps or takes up a build there, which must have been
configured with RUBBLE_PYTHON=ON if it exists already; jobs=N.
"""

import base64
import hashlib
import os
import re
import subprocess
import sysconfig
import tarfile
import tempfile
import zipfile

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


def version():
    with open(os.path.join(ROOT, "CMakeLists.txt")) as file:
        return re.search(r"project\(Rubble VERSION ([0-9.]+)", file.read()).group(1)


def metadata():
    return (
        "Metadata-Version: 2.1\n"
        "Name: rubble\n"
        f"Version: {version()}\n"
        "Summary: Where the deactivated elements of a structural collapse go\n"
        "License: BSD-3-Clause\n"
        "Requires-Python: >=3.9\n"
        "Requires-Dist: numpy\n"
    )


def get_requires_for_build_wheel(config_settings=None):
    return []


def get_requires_for_build_sdist(config_settings=None):
    return []


def build(folder, jobs):
    if not os.path.exists(os.path.join(folder, "CMakeCache.txt")):
        words = ["cmake", "-S", ROOT, "-B", folder, "-DRUBBLE_PYTHON=ON", "-DCMAKE_BUILD_TYPE=Release"]
        subprocess.run(words, check=True)
    subprocess.run(["cmake", "--build", folder, "--target", "rubble_python", "--parallel", str(jobs)], check=True)
    return os.path.join(folder, "python", "rubble")


def write_wheel(path, package):
    """A wheel is a zip file with a list of its files and their SHA-256."""
    info = f"rubble-{version()}.dist-info"
    tag = os.path.basename(path)[: -len(".whl")].split("-", 2)[2]
    wheel = f"Wheel-Version: 1.0\nGenerator: rubble\nRoot-Is-Purelib: false\nTag: {tag}\n"
    files = {f"{info}/METADATA": metadata().encode(), f"{info}/WHEEL": wheel.encode()}
    for name in sorted(os.listdir(package)):
        if name.endswith((".py", ".pyi", ".so")) or name == "py.typed":
            with open(os.path.join(package, name), "rb") as file:
                files[f"rubble/{name}"] = file.read()
    record = ""
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in files.items():
            archive.writestr(name, content)
            digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
            record += f"{name},sha256={digest},{len(content)}\n"
        archive.writestr(f"{info}/RECORD", record + f"{info}/RECORD,,\n")


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    settings = config_settings or {}
    jobs = settings.get("jobs", os.cpu_count() or 1)
    python = "cp" + sysconfig.get_config_var("py_version_nodot")
    platform = re.sub("[-.]", "_", sysconfig.get_platform())
    name = f"rubble-{version()}-{python}-{python}-{platform}.whl"
    with tempfile.TemporaryDirectory() as temporary:
        package = build(settings.get("build-dir", temporary), jobs)
        write_wheel(os.path.join(wheel_directory, name), package)
    return name


def build_sdist(sdist_directory, config_settings=None):
    """What git tracks, or all but build folders where there is no git."""
    name = f"rubble-{version()}"
    listed = subprocess.run(["git", "-C", ROOT, "ls-files"], capture_output=True, text=True)
    files = listed.stdout.splitlines() if listed.returncode == 0 else []
    if not files:
        for folder, folders, names in os.walk(ROOT):
            folders[:] = [one for one in folders if one not in ("build", "out") and not one.startswith(".")]
            files += [os.path.relpath(os.path.join(folder, one), ROOT) for one in names]
    with tarfile.open(os.path.join(sdist_directory, name + ".tar.gz"), "w:gz") as archive:
        for file in sorted(files):
            archive.add(os.path.join(ROOT, file), f"{name}/{file}")
        with tempfile.NamedTemporaryFile("w", suffix="PKG-INFO") as about:
            about.write(metadata())
            about.flush()
            archive.add(about.name, f"{name}/PKG-INFO")
    return name + ".tar.gz"
