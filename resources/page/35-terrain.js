// Heights of a grid of nodes, as two triangles a cell.
const cellTriangles = [[[0, 0], [1, 0], [1, 1]], [[0, 0], [1, 1], [0, 1]]];

function terrainNode(terrain, i, j) {
    return [terrain.x0 + i * terrain.cell, terrain.y0 + j * terrain.cell, terrain.heights[j * terrain.nx + i]];
}

// Nearest hit of a ray with a terrain: its distance; null if it misses.
function rayMeetsTerrain(ray, terrain) {
    const { from, way } = ray;
    const level = Math.hypot(way[0], way[1]);
    let nearest = null;
    for (let j = 0; j + 1 < terrain.ny; ++j) {
        for (let i = 0; i + 1 < terrain.nx; ++i) {
            // In plan the ray passes no farther from the middle of a cell than a corner of it lies.
            const x = terrain.x0 + (i + 0.5) * terrain.cell - from[0];
            const y = terrain.y0 + (j + 0.5) * terrain.cell - from[1];
            if (Math.abs(x * way[1] - y * way[0]) > 0.7072 * terrain.cell * level && level > 1e-9) {
                continue;
            }
            for (const triangle of cellTriangles) {
                const distance = rayMeets(ray, triangle.map(([a, b]) => terrainNode(terrain, i + a, j + b)), [[0, 1, 2]]);
                if (distance !== null && (nearest === null || distance < nearest)) {
                    nearest = distance;
                }
            }
        }
    }
    return nearest;
}
