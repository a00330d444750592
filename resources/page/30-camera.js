const verticalAngle = Math.PI / 6;
const steepest = 1.55;

const add3 = (a, b, s = 1) => [a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]];
const dot3 = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross3 = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const length3 = (a) => Math.sqrt(dot3(a, a));
const unit3 = (a) => {
    const length = length3(a) || 1;
    return [a[0] / length, a[1] / length, a[2] / length];
};

// Looks at a point from an angle and a distance; z is up.
class Camera {
    constructor(bounds) {
        this.bounds = bounds;
        this.target = [0, 1, 2].map((c) => (bounds.low[c] + bounds.high[c]) / 2);
        const wide = bounds.high[0] - bounds.low[0] >= bounds.high[1] - bounds.low[1];
        this.along = wide ? -Math.PI / 2 : 0;
        this.distance = 1;
        this.look('side', 1);
    }

    // One of the named directions, with all of the scene in a pane of this width over height.
    look(from, aspect) {
        const turns = { side: [0, 0.12], end: [Math.PI / 2, 0.12], top: [0, steepest], corner: [0.65, 0.45] };
        const [turn, pitch] = turns[from] || turns.side;
        this.yaw = this.along + turn;
        this.pitch = pitch;
        this.fit(aspect);
    }

    fit(aspect) {
        const { low, high } = this.bounds;
        this.target = [0, 1, 2].map((c) => (low[c] + high[c]) / 2);
        this.distance = 1.03 * this.distanceFor(aspect);
    }

    // From which everything is seen in the direction of now.
    distanceFor(aspect) {
        const { low, high } = this.bounds;
        const middle = [0, 1, 2].map((c) => (low[c] + high[c]) / 2);
        const frame = this.frame();
        const vertical = Math.tan(verticalAngle / 2);
        let distance = 1;
        for (let corner = 0; corner < 8; ++corner) {
            const at = add3([corner & 1 ? high[0] : low[0], corner & 2 ? high[1] : low[1], corner & 4 ? high[2] : low[2]], middle, -1);
            const depth = dot3(at, frame.back);
            distance = Math.max(distance, depth + Math.abs(dot3(at, frame.right)) / (vertical * aspect),
                depth + Math.abs(dot3(at, frame.up)) / vertical);
        }
        return distance;
    }

    frame() {
        const back = [Math.cos(this.yaw) * Math.cos(this.pitch), Math.sin(this.yaw) * Math.cos(this.pitch), Math.sin(this.pitch)];
        const right = [-Math.sin(this.yaw), Math.cos(this.yaw), 0];
        return { back, right, up: cross3(back, right) };
    }

    eye() {
        return add3(this.target, this.frame().back, this.distance);
    }

    // Nearest and farthest depth that is drawn, m.
    depths() {
        const far = this.distance + 4 * length3(add3(this.bounds.high, this.bounds.low, -1));
        return { near: Math.max(far / 20000, 0.02 * this.distance), far };
    }

    // View and projection, column by column.
    matrix(aspect) {
        const { back, right, up } = this.frame();
        const eye = this.eye();
        const { near, far: reach } = this.depths();
        const f = 1 / Math.tan(verticalAngle / 2);
        const a = (reach + near) / (near - reach);
        const b = 2 * reach * near / (near - reach);
        const rows = [
            [...right.map((x) => x * f / aspect), -dot3(right, eye) * f / aspect],
            [...up.map((x) => x * f), -dot3(up, eye) * f],
            [...back.map((x) => x * a), -dot3(back, eye) * a + b],
            [...back.map((x) => -x), dot3(back, eye)]
        ];
        const out = new Float32Array(16);
        rows.forEach((row, r) => row.forEach((x, c) => {
            out[4 * c + r] = x;
        }));
        return out;
    }

    // Ray through a place of a pane, both from -1 to 1.
    ray(x, y, aspect) {
        const { back, right, up } = this.frame();
        const vertical = Math.tan(verticalAngle / 2);
        const way = add3(add3(add3([0, 0, 0], back, -1), right, x * vertical * aspect), up, y * vertical);
        return { from: this.eye(), way: unit3(way) };
    }

    // Metres that a pixel covers at the target.
    metresPerPixel(height) {
        return 2 * this.distance * Math.tan(verticalAngle / 2) / height;
    }

    orbit(dx, dy) {
        this.yaw -= dx;
        this.pitch = Math.min(steepest, Math.max(-0.2, this.pitch + dy));
    }

    pan(dx, dy, height) {
        const { right, up } = this.frame();
        const scale = this.metresPerPixel(height);
        this.target = add3(add3(this.target, right, -dx * scale), up, dy * scale);
    }

    zoom(factor) {
        this.distance = Math.min(1e5, Math.max(0.5, this.distance * factor));
    }
}

// Nearest hit of a ray with the faces of a solid or a shell: its distance; null if it misses.
function rayMeets({ from, way }, corners, faces) {
    let nearest = null;
    for (const face of faces) {
        const ring = face.filter((c) => c >= 0).map((c) => corners[c]);
        for (let i = 2; i < ring.length; ++i) {
            const a = add3(ring[i - 1], ring[0], -1);
            const b = add3(ring[i], ring[0], -1);
            const p = cross3(way, b);
            const det = dot3(a, p);
            if (Math.abs(det) < 1e-12) {
                continue;
            }
            const t = add3(from, ring[0], -1);
            const u = dot3(t, p) / det;
            const q = cross3(t, a);
            const v = dot3(way, q) / det;
            const distance = dot3(b, q) / det;
            if (u >= -1e-6 && v >= -1e-6 && u + v <= 1 + 1e-6 && distance > 0 && (nearest === null || distance < nearest)) {
                nearest = distance;
            }
        }
    }
    return nearest;
}
