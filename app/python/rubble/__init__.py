"""Where the deactivated elements of a structural collapse go.

    import rubble
    collapse = rubble.open("stone-arch.rubble", settings={"settle_time": 1})
    run = collapse.run("stone-arch.run.h5")
    run.final_positions        # NumPy array [fragments, 3], m

Lengths are in m, masses in kg, times in s; z is up. Arrays are read-only views of what Rubble holds, unless their docstring says
that they are copies; each keeps what it looks at in memory. Long work takes progress=callable(stage, fraction) and obeys Ctrl-C.
"""

from ._rubble import (
    Cancelled,
    Clusters,
    Collapse,
    DebrisMap,
    Drop,
    Error,
    FeResult,
    FeState,
    Fragments,
    Frame,
    ParseError,
    Run,
    Sizing,
    UsageError,
    WorldError,
    __version__,
    build,
    drop,
    from_arrays,
    open,
    open_run,
    parameters,
)

__all__ = [
    "Cancelled",
    "Clusters",
    "Collapse",
    "DebrisMap",
    "Drop",
    "Error",
    "FeResult",
    "FeState",
    "Fragments",
    "Frame",
    "ParseError",
    "Run",
    "Sizing",
    "UsageError",
    "WorldError",
    "build",
    "drop",
    "from_arrays",
    "open",
    "open_run",
    "parameters",
]
