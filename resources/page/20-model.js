// The FE result as the page has it: mesh, activity, places of nodes state by state.
class Structure {
    constructor(arrays, about) {
        this.elements = about.elementCount;
        this.nodes = about.nodeCount;
        this.step = about.nodeStep;
        this.faces = about.faces;
        this.shapes = arrays.numbers('shapes');
        this.components = arrays.integers('components', Int32Array);
        this.ids = arrays.steps('elementIds', Float64Array);
        this.times = arrays.numbers('stateTimes');
        this.activity = arrays.numbers('activity');
        this.row = (this.elements + 7) >> 3;
        const corners = arrays.steps('corners', Uint32Array);
        this.offsets = new Uint32Array(this.elements + 1);
        for (let e = 0; e < this.elements; ++e) {
            this.offsets[e + 1] = this.offsets[e] + about.cornerCounts[this.shapes[e]];
        }
        this.corners = corners;
        this.places = new Int32Array(3 * this.nodes * this.times.length);
        this.packed = arrays.reader('nodes');
        this.unpacked = 0;
    }

    // Places in steps up to a state, each against a straight way on: a page that opens needs the first two states only.
    unpackTo(state) {
        const { places, nodes } = this;
        const perState = 3 * nodes;
        for (; this.unpacked <= state; ++this.unpacked) {
            const first = perState * this.unpacked;
            this.packed.runs(places, first, perState);
            if (this.unpacked >= 2) {
                for (let i = first; i < first + perState; ++i) {
                    places[i] += 2 * places[i - perState] - places[i - 2 * perState];
                }
            } else if (this.unpacked === 1) {
                for (let i = first; i < first + perState; ++i) {
                    places[i] += places[i - perState];
                }
            } else {
                for (let i = 1; i < perState; ++i) {
                    places[i] += i % nodes > 0 ? places[i - 1] : 0;
                }
            }
        }
    }

    // The other states one by one, when nothing else is to be done.
    unpackRest() {
        if (this.unpacked < this.times.length) {
            this.unpackTo(this.unpacked);
            setTimeout(() => this.unpackRest(), 0);
        }
    }

    // Index of the first number of a state's places.
    placesAt(state) {
        if (state >= this.unpacked) {
            this.unpackTo(state);
        }
        return 3 * this.nodes * state;
    }

    active(state, element) {
        return (this.activity[state * this.row + (element >> 3)] >> (element & 7)) & 1;
    }

    stateAt(time) {
        return lastAtOrBelow(this.times, time);
    }

    // Share of the way to the next state.
    shareAt(time) {
        const k = this.stateAt(time);
        if (k + 1 >= this.times.length || time <= this.times[k]) {
            return 0;
        }
        return (time - this.times[k]) / (this.times[k + 1] - this.times[k]);
    }

    // Places of some nodes at a state, three numbers each.
    fillPlaces(state, which, out) {
        const from = this.placesAt(state);
        for (let i = 0; i < which.length; ++i) {
            const n = from + which[i];
            out[3 * i] = this.places[n] * this.step;
            out[3 * i + 1] = this.places[n + this.nodes] * this.step;
            out[3 * i + 2] = this.places[n + 2 * this.nodes] * this.step;
        }
    }

    node(state, n) {
        const from = this.placesAt(state);
        return [this.places[from + n] * this.step, this.places[from + this.nodes + n] * this.step,
            this.places[from + 2 * this.nodes + n] * this.step];
    }

    // Corners of an element at a time: between two states on the straight way, where it is alive at both.
    cornersAt(element, time) {
        const k = this.stateAt(time);
        const share = k + 1 < this.times.length && this.active(k + 1, element) ? this.shareAt(time) : 0;
        const corners = [];
        for (let c = this.offsets[element]; c < this.offsets[element + 1]; ++c) {
            const a = this.node(k, this.corners[c]);
            const b = share > 0 ? this.node(k + 1, this.corners[c]) : a;
            corners.push([0, 1, 2].map((i) => a[i] + share * (b[i] - a[i])));
        }
        return corners;
    }

    // The three lowest nodes of a face of three or four corners, the lowest first.
    lowestNodes(face, first, out, at) {
        const { corners } = this;
        out.fill(0xffffffff, at, at + 3);
        for (let k = 0; k < face.length && face[k] >= 0; ++k) {
            // What is higher moves one place on; the highest of four falls out.
            for (let node = corners[first + face[k]], i = at; i < at + 3; ++i) {
                const there = out[i];
                if (node < there) {
                    out[i] = node;
                    node = there;
                }
            }
        }
    }

    // For each face, six a cell, the element on its other side; -1: none.
    neighbours() {
        if (this.others) {
            return this.others;
        }
        const others = new Int32Array(6 * this.elements).fill(-1);
        const size = 1 << Math.ceil(Math.log2(12 * this.elements + 16));
        const table = new Int32Array(size).fill(-1);
        const keys = new Uint32Array(3 * 6 * this.elements);
        for (let e = 0; e < this.elements; ++e) {
            const faces = this.shapes[e] < 4 ? this.faces[this.shapes[e]] : [];
            for (let f = 0; f < faces.length; ++f) {
                const slot = 6 * e + f;
                this.lowestNodes(faces[f], this.offsets[e], keys, 3 * slot);
                const [a, b, c] = [keys[3 * slot], keys[3 * slot + 1], keys[3 * slot + 2]];
                let hash = (Math.imul(a, 73856093) ^ Math.imul(b, 19349663) ^ Math.imul(c, 83492791)) >>> 0;
                for (hash &= size - 1; table[hash] >= 0; hash = (hash + 1) & (size - 1)) {
                    const there = table[hash];
                    if (keys[3 * there] === a && keys[3 * there + 1] === b && keys[3 * there + 2] === c) {
                        others[slot] = Math.floor(there / 6);
                        others[there] = e;
                        break;
                    }
                }
                if (table[hash] < 0) {
                    table[hash] = slot;
                }
            }
        }
        this.others = others;
        return others;
    }
}

// Motion of the bodies, from the instants that were kept.
class Motion {
    constructor(arrays, about) {
        this.count = about.bodyCount;
        this.ends = arrays.numbers('bodyEnds');
        const instants = arrays.numbers('instants');
        const counts = arrays.integers('keyCounts', Int32Array);
        const reader = arrays.reader('keys');
        this.first = new Uint32Array(this.count + 1);
        for (let b = 0; b < this.count; ++b) {
            this.first[b + 1] = this.first[b] + counts[b];
        }
        const keys = this.first[this.count];
        this.times = new Float64Array(keys);
        this.places = new Float32Array(3 * keys);
        this.turns = new Float32Array(4 * keys);
        this.unpack(reader, instants, about.placeStep);
        this.pointer = this.first.slice(0, this.count);
        // Place and turn of each body: x, y, z, 0, then x, y, z, w of the quaternion.
        this.poses = new Float32Array(8 * this.count);
        this.shown = NaN;
    }

    unpack(reader, instants, step) {
        const now = new Float64Array(8);
        for (let b = 0; b < this.count; ++b) {
            reader.next();  // bits of the turn, whose scale its norm takes out
            now.fill(0);
            for (let k = this.first[b]; k < this.first[b + 1]; ++k) {
                for (let c = 0; c < 8; ++c) {
                    now[c] += reader.next();
                }
                this.times[k] = instants[now[0]];
                this.places[3 * k] = now[1] * step;
                this.places[3 * k + 1] = now[2] * step;
                this.places[3 * k + 2] = now[3] * step;
                const norm = Math.hypot(now[4], now[5], now[6], now[7]) || 1;
                for (let c = 0; c < 4; ++c) {
                    this.turns[4 * k + c] = now[4 + c] / norm;
                }
            }
        }
    }

    // Poses of all bodies at a time; what rests costs nothing.
    moveTo(time) {
        const back = !(time >= this.shown);
        for (let b = 0; b < this.count; ++b) {
            const first = this.first[b];
            const last = this.first[b + 1] - 1;
            let k = this.pointer[b];
            if (!back && k === last && this.times[last] <= this.shown) {
                continue;
            }
            if (back) {
                while (k > first && this.times[k] > time) {
                    --k;
                }
            }
            while (k < last && this.times[k + 1] <= time) {
                ++k;
            }
            this.pointer[b] = k;
            this.fill(b, k, last, time);
        }
        this.shown = time;
    }

    fill(b, k, last, time) {
        const out = 8 * b;
        const { places, turns, poses } = this;
        if (k === last || time <= this.times[k]) {
            for (let c = 0; c < 3; ++c) {
                poses[out + c] = places[3 * k + c];
            }
            for (let c = 0; c < 4; ++c) {
                poses[out + 4 + c] = turns[4 * k + c];
            }
            return;
        }
        const share = (time - this.times[k]) / (this.times[k + 1] - this.times[k]);
        for (let c = 0; c < 3; ++c) {
            poses[out + c] = places[3 * k + c] + share * (places[3 * k + 3 + c] - places[3 * k + c]);
        }
        const q = 4 * k;
        const dot = turns[q] * turns[q + 4] + turns[q + 1] * turns[q + 5] + turns[q + 2] * turns[q + 6] + turns[q + 3] * turns[q + 7];
        let a = 1 - share;
        let z = dot < 0 ? -share : share;
        if (Math.abs(dot) < 0.9999) {
            const angle = Math.acos(Math.abs(dot));
            const sine = Math.sin(angle);
            a = Math.sin((1 - share) * angle) / sine;
            z = Math.sin(share * angle) / sine * (dot < 0 ? -1 : 1);
        }
        for (let c = 0; c < 4; ++c) {
            poses[out + 4 + c] = a * turns[q + c] + z * turns[q + 4 + c];
        }
    }

    // Whether there are bodies at a time.
    entered(time) {
        if (this.firstEntry === undefined) {
            this.firstEntry = this.count > 0 ? Array.from({ length: this.count }, (_, b) => this.times[this.first[b]])
                .reduce((least, entry) => Math.min(least, entry)) : Infinity;
        }
        return time >= this.firstEntry;
    }

    // The kept instant from which a body is on its way to the next; -1: it is not. What is recorded last says nothing of what
    // comes after it, so there the way that led to it counts.
    leg(b, time) {
        const last = this.first[b + 1] - 1;
        const k = this.pointer[b];
        if (k < last) {
            return time < this.times[k] ? -1 : k;
        }
        return k > this.first[b] ? k - 1 : -1;
    }

    // Mean speed of a body between two instants that were kept, m/s.
    speed(b, time) {
        const k = this.leg(b, time);
        if (k < 0) {
            return 0;
        }
        const p = this.places;
        return Math.hypot(p[3 * k + 3] - p[3 * k], p[3 * k + 4] - p[3 * k + 1], p[3 * k + 5] - p[3 * k + 2]) / this.span(k);
    }

    // s from a kept instant to the next.
    span(k) {
        return this.times[k + 1] - this.times[k];
    }

    // Takes a point of a body to where it is in the pose that was moved to last.
    carried(b, point) {
        return posed(this.poses, 8 * b, point);
    }
}

// A point turned by a quaternion and moved: place at `at`, quaternion four numbers further.
function posed(poses, at, [x, y, z]) {
    const [qx, qy, qz, qw] = [poses[at + 4], poses[at + 5], poses[at + 6], poses[at + 7]];
    const tx = 2 * (qy * z - qz * y);
    const ty = 2 * (qz * x - qx * z);
    const tz = 2 * (qx * y - qy * x);
    return [poses[at] + x + qw * tx + qy * tz - qz * ty, poses[at + 1] + y + qw * ty + qz * tx - qx * tz,
        poses[at + 2] + z + qw * tz + qx * ty - qy * tx];
}

// What bodies carry: fragments, and elements of islands.
class Pieces {
    constructor(arrays, about) {
        this.count = about.pieceCount;
        this.bodies = arrays.steps('pieceBodies', Int32Array);
        this.fragments = arrays.steps('pieceFragments', Int32Array);
        this.elements = arrays.steps('pieceElements', Int32Array);
        this.shapes = arrays.numbers('pieceShapes');
        this.from = this.timesOf(arrays, 'pieceFrom');
        this.to = this.timesOf(arrays, 'pieceTo');
        const ends = arrays.numbers('bodyEnds');
        this.births = arrays.numbers('fragmentBirths');
        this.masses = arrays.numbers('fragmentMasses');
        this.clusters = arrays.integers('fragmentClusters', Int32Array);
        this.offsets = new Uint32Array(this.count + 1);
        for (let p = 0; p < this.count; ++p) {
            this.offsets[p + 1] = this.offsets[p] + about.cornerCounts[this.shapes[p]];
            this.to[p] = Math.min(this.to[p], ends[this.bodies[p]]);
        }
        this.corners = arrays.places('pieceCorners', about.cornerStep);
        // The first piece of each element, and after each piece the next of its element; -1: none.
        this.firstOf = new Int32Array(about.elementCount).fill(-1);
        this.nextOf = new Int32Array(this.count);
        for (let p = this.count - 1; p >= 0; --p) {
            this.nextOf[p] = this.firstOf[this.elements[p]];
            this.firstOf[this.elements[p]] = p;
        }
    }

    timesOf(arrays, name) {
        const times = arrays.numbers('pieceTimes');
        const which = arrays.steps(name, Int32Array);
        const out = new Float64Array(this.count);
        for (let p = 0; p < this.count; ++p) {
            out[p] = times[which[p]];
        }
        return out;
    }

    // Pieces of an element, ascending.
    of(element) {
        const found = [];
        for (let p = this.firstOf[element]; p >= 0; p = this.nextOf[p]) {
            found.push(p);
        }
        return found;
    }

    // Whether bodies carry structure that lives.
    loose() {
        return this.fragments.some((f) => f < 0);
    }

    shown(p, time) {
        return this.from[p] <= time && time < this.to[p];
    }

    // Pieces that are seen at a time, in the order in which they appear; kept as `live`.
    liveAt(time) {
        const { from, to, count } = this;
        let length = 0;
        this.room = this.room || new Uint32Array(count);
        for (let p = 0; p < count && from[p] <= time; ++p) {
            if (time < to[p]) {
                this.room[length++] = p;
            }
        }
        this.live = this.room.subarray(0, length);
        return this.live;
    }

    // The piece of an element that is seen at a time; -1: none.
    at(element, time) {
        const found = this.of(element).filter((p) => this.shown(p, time));
        return found.length > 0 ? found[found.length - 1] : -1;
    }

    corner(p, c) {
        const i = 3 * (this.offsets[p] + c);
        return [this.corners[i], this.corners[i + 1], this.corners[i + 2]];
    }

    middle(p) {
        const { corners } = this;
        const count = this.offsets[p + 1] - this.offsets[p];
        const sum = [0, 0, 0];
        for (let i = 3 * this.offsets[p]; i < 3 * this.offsets[p + 1]; i += 3) {
            sum[0] += corners[i] / count;
            sum[1] += corners[i + 1] / count;
            sum[2] += corners[i + 2] / count;
        }
        return sum;
    }

    // Side of a square that covers about as much as the piece does, m.
    size(p, [x, y, z]) {
        const { corners } = this;
        let sum = 0;
        for (let i = 3 * this.offsets[p]; i < 3 * this.offsets[p + 1]; i += 3) {
            sum += Math.sqrt((corners[i] - x) ** 2 + (corners[i + 1] - y) ** 2 + (corners[i + 2] - z) ** 2);
        }
        return 1.25 * sum / (this.offsets[p + 1] - this.offsets[p]);
    }

    // Fragments among what is live at a time.
    fragmentsAt(time) {
        let count = 0;
        for (const p of this.live) {
            count += this.fragments[p] >= 0 && this.births[this.fragments[p]] <= time ? 1 : 0;
        }
        return count;
    }
}
