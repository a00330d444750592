"""pip install SOURCE without network, out of a build folder that is there; then the tutorial with what was installed."""

import os
import subprocess
import sys
import tempfile

source, build = sys.argv[1:]
with tempfile.TemporaryDirectory() as folder:
    words = ["--no-build-isolation", "--no-deps", "--no-index", "--disable-pip-version-check", "--target", folder]
    subprocess.run([sys.executable, "-m", "pip", "install", *words, f"--config-settings=build-dir={build}", source], check=True)
    environment = {key: value for key, value in os.environ.items() if key != "PYTHONPATH"}
    environment["PYTHONPATH"] = folder
    told = subprocess.run(
        [sys.executable, os.path.join(source, "app/python/tutorial.py")], env=environment, cwd=folder, capture_output=True, text=True
    )
    print(told.stdout, told.stderr)
    assert told.returncode == 0
    where = subprocess.run([sys.executable, "-c", "import rubble; print(rubble.__file__)"], env=environment, cwd="/", capture_output=True, text=True)
    assert where.stdout.startswith(folder), where.stdout + where.stderr
