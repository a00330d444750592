# %% [markdown]
# # Rubble from Python
#
# A collapse from the FE result to a debris map. Cells begin with `# %%`, as notebooks read them. It takes a case or an FE result as
# argument; without one it makes a wall of its own from arrays.

# %%
import sys
import tempfile

import numpy as np

import rubble

print("Rubble", rubble.__version__)
folder = tempfile.mkdtemp()


# %% A wall of 6 x 1 x 4 blocks that falls from 3 m and loses a block at every other state.
def wall():
    nx, nz, size = 6, 4, 0.5
    grid = np.array([[x, y, z] for z in range(nz + 1) for y in range(2) for x in range(nx + 1)], dtype=float)
    start = grid * size + [0.0, 0.0, 3.0]

    def node(x, y, z):
        return (z * 2 + y) * (nx + 1) + x

    elements = np.array(
        [
            [node(x + dx, dy, z + dz) for dz in (0, 1) for dx, dy in ((0, 0), (1, 0), (1, 1), (0, 1))]
            for z in range(nz)
            for x in range(nx)
        ]
    )
    times = np.linspace(0.0, 0.6, 13)
    positions = start[None] + np.array([0, 0, -0.5 * 9.80665]) * times[:, None, None] ** 2
    death = 1 + np.arange(len(elements)) // 2
    active = np.arange(len(times))[:, None] < death[None]
    return rubble.from_arrays(times, positions, elements, active, density=2000.0, part_names=["wall"])


collapse = rubble.open(sys.argv[1]) if len(sys.argv) > 1 else wall()
collapse.set("settle_time", "1 s")
print(collapse)
print(collapse.fe)

# %% What is in it?
audit = collapse.inspect()
print(f"{audit['dead']} of {sum(row['elements'] for row in audit['components'])} elements are dead at the end")
for row in audit["components"]:
    print(f"  {row['name']:20} {row['elements']:7} elements, {row['dead']:7} dead, {row['mass'] / 1000:10.1f} t")

# %% Fragments are views of what Rubble holds: NumPy works on them without a copy.
fragments = collapse.fragments()
speed = np.linalg.norm(fragments.velocity, axis=1)
print(f"{len(fragments)} fragments, {fragments.mass.sum() / 1000:.1f} t, born at {speed.mean():.2f} m/s in the mean")
assert not fragments.mass.flags.owndata and not fragments.mass.flags.writeable

# %% The Basic Grid decides which fragments move together.
sizing = collapse.size()
clusters = collapse.cluster()
print(f"grid {np.round(sizing.grid, 3)} m, {len(clusters)} clusters, stopped by {sizing.stopped_by}")
assert np.isclose(clusters.mass.sum(), fragments.mass.sum())

# %% Let it fall. The callback sees the progress; returning False would cancel, Ctrl-C does so too.
stages = []
run = collapse.run(folder + "/tutorial.run.h5", progress=lambda stage, share: stages.append((stage, share)))
print(f"{len(run)} frames up to {run.times[-1]:.2f} s, trajectory {run.trajectory_hash[:8]}...")
assert stages

# %% Where does everything lie?
final = run.final_positions
travel = np.linalg.norm(final[:, :2] - run.birth_positions[:, :2], axis=1)
print(f"highest centre at rest {final[:, 2].max():.2f} m, longest way in plan {travel.max():.2f} m")
frame = run.frame(-1)
print(f"last frame: {len(frame)} bodies, fastest {frame.speeds.max():.2f} m/s")

# %% The trajectory of the heaviest fragment.
heaviest = int(np.argmax(fragments.mass))
path = np.array([run.places(t)[heaviest] for t in run.times[:: max(1, len(run) // 10)]])
print("height of the heaviest fragment:", np.round(path[~np.isnan(path[:, 2]), 2], 2))

# %% A debris map for a GIS and for NumPy: the sum over the cells is the mass of the debris.
debris = run.debris_map(cell=0.5)
mass = debris.raster("mass")
total = np.nansum(mass) * debris.cell**2
print(f"map of {mass.shape[1]} x {mass.shape[0]} cells, {total / 1000:.2f} t of {debris.ledger['mass'] / 1000:.2f} t")
assert np.isclose(total, debris.ledger["mass"])
debris.save(folder + "/debris.tif")
run.export("gltf", folder + "/fragments.glb")

# %% Mistakes are told in words.
try:
    collapse.set("ground_height", "2 ft")
except rubble.UsageError as error:
    print(error.id, "-", error.what)
