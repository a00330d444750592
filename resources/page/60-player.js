const paneGap = 2;
const slowFrame = 36;   // ms; above it a playing picture loses pixels
const quickFrame = 20;  // ms; below it it gets them back
const coarsest = 0.4;
const tellEvery = 120;  // ms between two changes of the texts while it plays
const longestFrame = 250;  // ms; what a picture takes longer, the clock of the page waits
const lineBeads = 400;
const largestSquare = 7;  // px; larger pieces stay boxes
const settleAfter = 300;  // ms without a move, after which a picture is drawn in full

const usualTones = {
    sky: [0.9, 0.92, 0.93, 1], ground: [0.80, 0.80, 0.775, 1], mesh: [0.72, 0.72, 0.69, 1], water: [0.37, 0.56, 0.68, 0.55],
    fragment: [213, 94, 0], structure: [163, 152, 138], released: [106, 61, 124], path: [0, 0.35, 0.6, 1], mark: [0.7, 0, 0.35, 1],
    site: [0.74, 0.74, 0.71, 1]
};
const highTones = {
    sky: [0, 0, 0, 1], ground: [0.1, 0.1, 0.1, 1], mesh: [0.33, 0.33, 0.33, 1], water: [0.1, 0.35, 0.6, 0.5],
    fragment: [255, 150, 20], structure: [235, 235, 235], released: [210, 130, 255], path: [0, 1, 1, 1], mark: [1, 1, 0, 1],
    site: [0.42, 0.42, 0.42, 1]
};
// Of the presentation style, as the program has it: earth, sky, and materials by their number, with how rough each is.
const fineTones = {
    ...usualTones, ground: [0.667, 0.647, 0.565, 1], horizon: [0.925, 0.933, 0.929], skyTop: [0.79, 0.83, 0.86],
    water: [0.30, 0.47, 0.56, 0.8]
};
const materialTones = [[184, 170, 144], [167, 168, 164], [118, 130, 143], [169, 107, 82], [139, 117, 86], [102, 132, 139]];
const materialRoughness = [1, 0.55, 0.2, 0.85, 0.8, 0.3];
const smallestEdges = 4;   // px, of an element below which its edges are not drawn: they would cover it
const darkestEdges = 0.5;
const darkestContours = 0.6;
const leastContour = 3;    // px, that a jump in depth must be worth to have one
let tones = usualTones;
const categories = [[0, 114, 178], [230, 159, 0], [0, 158, 115], [204, 121, 167], [86, 180, 233], [240, 228, 66], [213, 94, 0],
    [120, 94, 60], [140, 140, 150]];

// Colours that differ for the first nine; further ones by hues a golden angle apart.
function categoryColour(i) {
    if (i < categories.length) {
        return categories[i];
    }
    const hue = 6 * ((0.08 + 0.618034 * i) % 1);
    return [5, 3, 1].map((shift) => {
        const k = (shift + hue) % 6;
        return Math.round(255 * (0.72 - 0.42 * Math.min(1, Math.max(0, Math.min(k, 4 - k)))));
    });
}

// The largest of 1, 2 and 5 times a power of ten that is not above a number.
function roundBelow(number) {
    const power = Math.pow(10, Math.floor(Math.log10(number)));
    return [5, 2, 1].map((f) => f * power).find((each) => each <= number);
}

// Of 0 to 1, as light as it is large, also for those who see no red.
function heat(share) {
    const stops = [[68, 1, 84], [59, 82, 139], [33, 145, 140], [94, 201, 98], [253, 231, 37]];
    const at = Math.min(3.999, Math.max(0, share) * 4);
    const i = Math.floor(at);
    return stops[i].map((c, k) => Math.round(c + (at - i) * (stops[i + 1][k] - c)));
}

// The run at a time, drawn into both panes.
class Player {
    // @param started   of startedPrograms()
    // @param pictured  address of the picture of the ground; null: there is none
    constructor(canvas, started, facts, bytes, pictured) {
        const arrays = new PageArrays(bytes, facts.scene.arrays);
        this.facts = facts;
        this.canvas = canvas;
        this.structure = new Structure(arrays, facts.scene);
        this.motion = new Motion(arrays, facts.scene);
        this.pieces = new Pieces(arrays, facts.scene);
        this.frames = arrays.numbers('frames');
        this.renderer = new Renderer(canvas, started, this.structure, this.pieces, this.motion);
        this.start = this.structure.times[0];
        this.end = Math.max(this.structure.times[this.structure.times.length - 1], this.frames[this.frames.length - 1]);
        this.time = this.start;
        this.playing = false;
        this.glancing = false;
        this.pace = 1;
        this.quality = 1;
        this.colourBy = 'highlight';
        this.showsStructure = true;
        this.style = 'presentation';
        this.edges = true;
        this.chosen = -1;
        this.marks = [];
        this.path = null;
        this.listeners = [];
        this.camera = new Camera(this.bounds());
        this.event = NaN;
        this.events = distinct(this.structure.times, this.pieces.from, this.pieces.to);
        this.there = [new Uint8Array(this.structure.elements), new Uint8Array(this.structure.elements)];
        this.lasting = new Uint8Array(this.structure.elements);
        this.typicalSize = this.renderer.sizes.reduce((sum, size) => sum + size, 0) / Math.max(1, this.pieces.count);
        this.ground = this.groundTriangles();
        this.groundSolid = this.renderer.solid(this.ground.points);
        this.groundThrows = this.facts.ground.terrain !== null && shadesItself(this.ground.points);
        this.water = facts.ground.water === null ? null : this.renderer.solid(this.waterTriangles());
        this.sunBounds = this.boundsOfShadows();
        this.site = new Site(arrays, facts, this.renderer, pictured, () => {
            this.stillKey = '';
            this.draw();
        });
        this.colourStructure();
        this.colourPieces();
    }

    onChange(listener) {
        this.listeners.push(listener);
    }

    tell() {
        this.listeners.forEach((listener) => listener());
    }

    bounds() {
        const low = [Infinity, Infinity, Infinity];
        const high = [-Infinity, -Infinity, -Infinity];
        const take = (p) => p.forEach((x, c) => {
            low[c] = Math.min(low[c], x);
            high[c] = Math.max(high[c], x);
        });
        for (let n = 0; n < this.structure.nodes; ++n) {
            take(this.structure.node(0, n));
        }
        low[2] = Math.min(low[2], this.facts.ground.height);
        return { low, high };
    }

    // What throws shadows or takes them, with room for what falls beside the structure.
    boundsOfShadows() {
        const [low, high] = [[...this.camera.bounds.low], [...this.camera.bounds.high]];
        const room = 0.5 * (high[2] - low[2]) + 0.1 * Math.max(high[0] - low[0], high[1] - low[1]);
        for (const c of [0, 1]) {
            low[c] -= room;
            high[c] += room;
        }
        const { terrain } = this.facts.ground;
        for (let i = 0; terrain !== null && i < terrain.heights.length; ++i) {
            const [x, y, z] = terrainNode(terrain, i % terrain.nx, Math.floor(i / terrain.nx));
            if (x > low[0] && x < high[0] && y > low[1] && y < high[1]) {
                low[2] = Math.min(low[2], z);
            }
        }
        low[2] -= 0.01 * room;
        return { low, high, sunward: this.sunwardEnd({ low, high }) };
    }

    // How far towards the sun a terrain reaches that may throw shadows into a box, m.
    sunwardEnd(box) {
        const { terrain } = this.facts.ground;
        const [across, upward] = sunAxes.slice(0, 2).map((axis) => endsAlong(axis, box));
        let end = -Infinity;
        for (let i = 0; terrain !== null && i < terrain.heights.length; ++i) {
            const node = terrainNode(terrain, i % terrain.nx, Math.floor(i / terrain.nx));
            const [x, y, z] = sunAxes.map((axis) => dot3(axis, node));
            // A triangle reaches in by a cell.
            const near = (at, [from, to]) => at > from - 2 * terrain.cell && at < to + 2 * terrain.cell;
            end = near(x, across) && near(y, upward) ? Math.max(end, z) : end;
        }
        return end;
    }

    // Materials, light of a sun and its shadows. High contrast takes the plain colours of analysis.
    get fine() {
        return this.style === 'presentation' && tones !== highTones;
    }

    get tones() {
        return this.fine ? fineTones : tones;
    }

    moveTo(time) {
        this.settle();
        this.time = Math.min(this.end, Math.max(this.start, time));
        this.draw();
        this.tell();
    }

    get moving() {
        return this.playing || this.glancing;
    }

    // Draws what is dragged as while playing, and in full once it is let be.
    glance() {
        if (this.playing) {
            this.draw();
            return;
        }
        const began = performance.now();
        this.glancing = true;
        this.draw();
        this.renderer.finish();
        this.adapt(performance.now() - began);
        clearTimeout(this.settling);
        this.settling = setTimeout(() => {
            this.settle();
            this.draw();
            this.tell();
        }, settleAfter);
    }

    settle() {
        clearTimeout(this.settling);
        this.glancing = false;
        this.quality = 1;
    }

    scrubTo(time) {
        this.time = Math.min(this.end, Math.max(this.start, time));
        this.glance();
        this.tell();
    }

    step(way) {
        const all = Float64Array.from(new Set([...this.structure.times, ...this.frames])).sort();
        const k = lastAtOrBelow(all, this.time + 1e-9);
        this.stop();
        this.moveTo(way > 0 ? all[Math.min(all.length - 1, k + 1)] : all[Math.max(0, all[k] < this.time - 1e-9 ? k : k - 1)]);
    }

    play() {
        if (this.time >= this.end) {
            this.time = this.start;
        }
        this.settle();
        this.playing = true;
        this.shownFrames = 0;
        this.began = performance.now();
        let last = this.began;
        let told = 0;
        const next = (now) => {
            if (!this.playing) {
                return;
            }
            this.advance(Math.max(0, now - last));
            last = now;
            this.draw();
            ++this.shownFrames;
            if (now - told > tellEvery) {
                told = now;
                this.tell();
            }
            if (this.time >= this.end) {
                this.stop();
            } else {
                requestAnimationFrame(next);
            }
        };
        requestAnimationFrame(next);
        this.tell();
    }

    // The time goes on by what a picture took, ms.
    advance(took) {
        this.adapt(took);
        this.time = Math.min(this.end, this.time + this.pace * Math.min(took, longestFrame) / 1000);
        const share = Math.min(1, longestFrame / Math.max(1, took));
        this.kept = this.kept === undefined ? share : 0.5 * (this.kept + share);
    }

    // Share of its pace at which it plays; less than 1 where pictures take too long.
    get paceKept() {
        return this.playing && this.kept < 0.95 ? this.kept : 1;
    }

    stop() {
        if (!this.playing) {
            return;
        }
        this.playing = false;
        this.kept = undefined;
        this.rate = 1000 * this.shownFrames / Math.max(1, performance.now() - this.began);
        this.quality = 1;
        this.draw();
        this.tell();
    }

    // Nothing is drawn any more.
    close() {
        this.playing = false;
        clearTimeout(this.settling);
        this.listeners = [];
    }

    // Fewer pixels where a machine is slow, more where it is not.
    adapt(took) {
        // One that takes twice as long is no chance.
        const share = took > 2 * slowFrame ? 0.5 : 0.2;
        this.mean = (1 - share) * (this.mean || took) + share * took;
        if (this.mean > slowFrame && !this.slow) {
            this.slow = true;
            this.mean = 0.5 * (slowFrame + quickFrame);
        } else if (this.mean > slowFrame && this.quality > coarsest) {
            // Time goes with the pixels, the square of this.
            const step = Math.min(0.85, Math.sqrt(slowFrame / this.mean));
            this.quality = Math.max(coarsest, this.quality * step);
            this.mean = 0.5 * (slowFrame + quickFrame);
        } else if (this.mean < quickFrame && this.quality < 1) {
            this.quality = Math.min(1, this.quality * 1.06);
        }
    }

    // Panes of the canvas.
    panes() {
        return this.panesOf(this.canvas.width, this.canvas.height);
    }

    // Keeps what is seen in the panes when the page gives them another room.
    follow() {
        const size = [this.canvas.clientWidth, this.canvas.clientHeight];
        if (Math.min(...size) < 1) {
            return;
        }
        const reach = ([width, height]) => {
            const [pane] = this.panesOf(width, height);
            return this.camera.distanceFor(pane.width / pane.height);
        };
        this.camera.zoom(reach(size) / reach(this.room || size));
        this.room = size;
    }

    // Side by side, or one above the other where that shows everything larger.
    panesOf(width, height) {
        const wide = Math.floor((width - paneGap) / 2);
        const low = Math.floor((height - paneGap) / 2);
        if (this.camera.distanceFor(wide / height) <= this.camera.distanceFor(width / low)) {
            return [{ x: 0, y: 0, width: wide, height }, { x: width - wide, y: 0, width: wide, height }];
        }
        return [{ x: 0, y: height - low, width, height: low }, { x: 0, y: 0, width, height: low }];
    }

    // Gives the canvas the pixels that it takes; true where it had others.
    resize() {
        const ratio = Math.min(2, window.devicePixelRatio || 1);
        this.ratio = ratio * this.quality;
        const scale = this.moving ? this.quality * ratio : ratio;
        const width = Math.max(2, Math.round(this.canvas.clientWidth * scale));
        const height = Math.max(2, Math.round(this.canvas.clientHeight * scale));
        if (this.canvas.width !== width || this.canvas.height !== height) {
            this.canvas.width = width;
            this.canvas.height = height;
            return true;
        }
        return false;
    }

    // What stands and what lies at the time; new faces only where something has changed.
    update() {
        const { structure, pieces, renderer, time } = this;
        const state = structure.stateAt(time);
        renderer.showState(state);
        const event = lastAtOrBelow(this.events, time);
        if (event !== this.event) {
            const next = Math.min(state + 1, structure.times.length - 1);
            const [inFe, standing] = this.there;
            let count = 0;
            const live = pieces.liveAt(time);
            for (let e = 0; e < structure.elements; ++e) {
                inFe[e] = standing[e] = structure.active(state, e);
                this.lasting[e] = structure.active(next, e);
                count += inFe[e];
            }
            for (const p of live) {
                standing[pieces.elements[p]] = 0;
            }
            renderer.showShell(0, inFe, this.lasting, state);
            renderer.showShell(1, standing, this.lasting, state);
            this.event = event;
            this.activeCount = count;
            this.pieceCount = pieces.fragmentsAt(time);
        }
        this.motion.moveTo(time);
        renderer.fill(renderer.poses, renderer.poseBuffer);
        if (this.colourBy === 'speed') {
            this.colourPieces();
        }
    }

    // Bodies are on their way between two recorded instants: their places are interpolated.
    betweenFrames() {
        const frame = lastAtOrBelow(this.frames, this.time);
        return this.motion.entered(this.time) && Math.abs(this.time - this.frames[frame]) > 1e-9;
    }

    draw() {
        this.resize();
        this.update();
        if (this.moving && this.slow) {
            this.drawSlowly();
            return;
        }
        const gl = this.renderer.gl;
        const { width, height } = this.canvas;
        const [smooth, work] = this.moving ? [] : this.renderer.smoothFrames(width, height);
        this.renderer.tested = false;
        const share = this.structure.shareAt(this.time);
        this.castShadows(share, 1, true);
        gl.bindFramebuffer(gl.FRAMEBUFFER, this.moving ? null : smooth.frame);
        this.drawPanes((index, pane, view) => {
            const edges = this.edgesIn(pane);
            this.drawStanding(index, view, share, edges);
            this.drawDebris(index, pane, view, edges);
            if (!this.moving) {
                this.drawContours(pane);
            }
            this.drawOver(index, view);
        }, true);
        if (!this.moving) {
            // Edges are smoothed by the first copy; the second cannot do that.
            this.renderer.copy(smooth.frame, work.frame, width, height);
            this.renderer.copy(work.frame, null, width, height);
        }
        gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    }

    // Maps of what is lit in both panes. @param part  of the side of a map; smaller ones are made in less time
    castShadows(share, part, boxes) {
        const { renderer } = this;
        const solids = this.groundThrows ? [...this.site.solids, this.groundSolid] : this.site.solids;
        for (const index of this.fine ? [0, 1] : []) {
            if (renderer.shadows[index].works) {
                renderer.castShadow(index, this.sunBounds, share, part, {
                    structure: index === 0 || this.showsStructure, solids, boxes: boxes && index === 1
                });
            }
        }
    }

    // Of a usual element, px of the page.
    elementPixels(pane) {
        return this.typicalSize * this.pixelsPerMetre(pane) / this.camera.distance / this.ratio;
    }

    // How dark the edges of elements are in a pane; 0: there are none, or they would cover what they belong to.
    edgesIn(pane) {
        const pixels = this.elementPixels(pane);
        return this.fine && this.edges ? darkestEdges * Math.min(1, Math.max(0, pixels / smallestEdges - 1)) : 0;
    }

    // What stands is drawn once for each state, and what moves over that picture.
    drawSlowly() {
        const { renderer } = this;
        const gl = renderer.gl;
        const { width, height } = this.canvas;
        const { camera } = this;
        const key = [this.event, width, height, camera.yaw, camera.pitch, camera.distance, ...camera.target, this.showsStructure,
            tones === highTones, this.style].join(' ');
        renderer.tested = false;
        const fresh = renderer.makeStill(width, height);
        if (key !== this.stillKey || fresh) {
            this.castShadows(0, 0.5, false);
            gl.bindFramebuffer(gl.FRAMEBUFFER, renderer.still.frame);
            this.drawPanes((index, pane, view) => this.drawStanding(index, view, 0), true);
            this.stillKey = key;
        }
        gl.bindFramebuffer(gl.FRAMEBUFFER, null);
        gl.viewport(0, 0, width, height);
        gl.clear(gl.DEPTH_BUFFER_BIT);
        renderer.drawStill();
        renderer.tested = true;
        this.drawPanes((index, pane, view) => {
            this.drawDebris(index, pane, view);
            this.drawOver(index, view);
        }, false);
        renderer.tested = false;
    }

    drawPanes(drawPane, clear) {
        const gl = this.renderer.gl;
        gl.enable(gl.SCISSOR_TEST);
        if (clear) {
            gl.scissor(0, 0, this.canvas.width, this.canvas.height);
            gl.clearColor(0.35, 0.37, 0.4, 1);
            gl.clear(gl.COLOR_BUFFER_BIT);
        }
        this.panes().forEach((pane, index) => {
            gl.viewport(pane.x, pane.y, pane.width, pane.height);
            gl.scissor(pane.x, pane.y, pane.width, pane.height);
            this.renderer.look = this.lookIn(index);
            if (clear) {
                gl.clearColor(...tones.sky);
                gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
                if (this.fine) {
                    this.renderer.drawSky(pane, fineTones.horizon, fineTones.skyTop);
                }
            }
            drawPane(index, pane, this.camera.matrix(pane.width / pane.height));
        });
        gl.disable(gl.SCISSOR_TEST);
    }

    // How surfaces of a pane look.
    lookIn(index) {
        const { low, high } = this.camera.bounds;
        const size = Math.max(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
        // Level ground has an end that nobody is to see; a terrain ends where nothing is known any more.
        const haze = this.facts.ground.terrain === null ? [1.0 * size, 2.9 * size] : [1e9, 2e9];
        const shadow = this.renderer.shadows[index];
        return {
            fine: this.fine, shadow: this.fine && shadow.works ? shadow : null, eye: this.camera.eye(), horizon: fineTones.horizon,
            far: [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, ...haze],
            photo: tones === highTones ? null : this.site.photo
        };
    }

    drawStanding(index, view, share, edges = 0) {
        const { renderer } = this;
        const gl = renderer.gl;
        renderer.drawSolid(view, this.groundSolid, this.tones.ground, { shaded: this.ground.shaded, surface: 1 });
        for (const solid of this.site.solids) {
            renderer.drawSolid(view, solid, this.tones.site, { shaded: true });
        }
        if (!this.fine) {
            renderer.drawPlain(view, gl.LINES, this.ground.lines, tones.mesh);
        }
        if (index === 0 || this.showsStructure) {
            renderer.drawShell(index, view, share, this.camera.eye(), { edges });
        }
    }

    drawDebris(index, pane, view, edges = 0) {
        const pixels = this.squarePixels(pane);
        if (index === 1 && pixels > 0) {
            this.renderer.drawSquares(view, pane, this.pixelsPerMetre(pane), Math.max(1, 0.6 * pixels));
        } else if (index === 1) {
            this.renderer.drawBoxes(view, { edges });
        }
    }

    // In pictures at rest alone: a slow machine has no time for them while it plays.
    drawContours(pane) {
        if (!this.fine || !this.edges) {
            return;
        }
        const { near, far } = this.camera.depths();
        const { low, high } = this.camera.bounds;
        drawContours(this.renderer, pane, {
            lens: [1 / near, 1 / near - 1 / far],
            least: [this.typicalSize, leastContour / this.pixelsPerMetre(pane)],
            end: this.camera.distance + length3(add3(high, low, -1)),
            thick: Math.max(1, Math.round(this.ratio)),
            // A pile seen from afar would be all lines.
            ink: [...edgeInk, darkestContours * Math.min(1, Math.max(0.5, this.elementPixels(pane) / smallestEdges))]
        });
        // Their depths lie where a picture of what stands was.
        this.stillKey = '';
    }

    // What lies over solids: water, and all that is seen through everything.
    drawOver(index, view) {
        const { renderer } = this;
        const gl = renderer.gl;
        if (index === 1) {
            if (this.water !== null) {
                renderer.drawSolid(view, this.water, this.tones.water, { surface: 2 });
            }
            if (this.path) {
                renderer.drawPlain(view, gl.LINE_STRIP, this.path, tones.path, { over: true });
                renderer.drawPlain(view, gl.POINTS, this.path, tones.path, { over: true, thick: 3 * this.ratio });
            }
        }
        this.drawChosen(index, view);
        if (this.marks.length > 0) {
            const ends = Float32Array.from(this.marks.flat());
            renderer.drawPlain(view, gl.POINTS, ends, tones.mark, { over: true, thick: 9 * this.ratio });
        }
        if (this.marks.length === 2) {
            // A line is a pixel wide everywhere; beads are as wide as they are to be.
            const [from, to] = this.marks;
            const beads = Array.from({ length: lineBeads }, (_, i) => add3(from, add3(to, from, -1), i / (lineBeads - 1)));
            renderer.drawPlain(view, gl.POINTS, Float32Array.from(beads.flat()), tones.mark, { over: true, thick: 2.5 * this.ratio });
        }
    }

    // At a distance of one.
    pixelsPerMetre(pane) {
        return pane.height / (2 * Math.tan(verticalAngle / 2));
    }

    // Pixels of a usual piece where pieces are to be drawn as squares: while a slow machine plays and they are small. 0: as boxes.
    squarePixels(pane) {
        const pixels = this.typicalSize * this.pixelsPerMetre(pane) / this.camera.distance;
        return this.moving && this.slow && pixels < largestSquare ? pixels : 0;
    }

    // The element that is chosen, seen through everything.
    drawChosen(index, view) {
        const seen = this.chosen >= 0 ? this.cornersNow(this.chosen, index) : null;
        if (!seen) {
            return;
        }
        const gl = this.renderer.gl;
        const faces = this.structure.faces[seen.shape];
        const ring = (face) => face.filter((c) => c >= 0).map((c) => seen.corners[c]);
        const triangles = faces.map(ring).flatMap((r) => r.slice(2).flatMap((p, i) => [...r[0], ...r[i + 1], ...p]));
        const edges = faces.map(ring).flatMap((r) => r.flatMap((p, i) => [...p, ...r[(i + 1) % r.length]]));
        const lines = edges.length > 0 ? edges : seen.corners.flat();
        this.renderer.drawPlain(view, gl.TRIANGLES, Float32Array.from(triangles), [0, 0.7, 1, 0.6], { over: true });
        this.renderer.drawPlain(view, gl.LINES, Float32Array.from(lines), [0, 0.15, 0.3, 1], { over: true });
    }

    levelSquare(height) {
        const { low, high } = this.camera ? this.camera.bounds : this.bounds();
        const reach = 3 * Math.max(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
        const [x, y] = [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2];
        const corners = [[x - reach, y - reach], [x + reach, y - reach], [x + reach, y + reach], [x - reach, y + reach]];
        return Float32Array.from([0, 1, 2, 0, 2, 3].flatMap((c) => [...corners[c], height]));
    }

    // Water over the ground that lies below its level, as far as the ground is known.
    waterTriangles() {
        const { terrain, water } = this.facts.ground;
        if (terrain === null) {
            return this.levelSquare(water);
        }
        const points = [];
        for (let j = 0; j + 1 < terrain.ny; ++j) {
            for (let i = 0; i + 1 < terrain.nx; ++i) {
                const corners = cellTriangles.flat();
                if (corners.some(([a, b]) => terrain.heights[(j + b) * terrain.nx + i + a] < water)) {
                    corners.forEach(([a, b]) => points.push(terrain.x0 + (i + a) * terrain.cell, terrain.y0 + (j + b) * terrain.cell, water));
                }
            }
        }
        return Float32Array.from(points);
    }

    // The ground, and lines on it a round distance apart.
    groundTriangles() {
        const { low, high } = this.camera.bounds;
        const size = Math.max(high[0] - low[0], high[1] - low[1]);
        const mesh = roundBelow(size / 8);
        const terrain = this.facts.ground.terrain;
        if (terrain !== null) {
            return { points: this.terrainTriangles(terrain), lines: new Float32Array(0), shaded: true };
        }
        const height = this.facts.ground.height;
        const lines = [];
        const [x, y] = [mesh * Math.round((low[0] + high[0]) / 2 / mesh), mesh * Math.round((low[1] + high[1]) / 2 / mesh)];
        const reach = mesh * Math.ceil(1.5 * size / mesh);
        // In pieces, since some drivers leave out a line that ends behind the camera.
        for (let at = -reach; at <= reach; at += mesh) {
            for (let from = -reach; from < reach; from += 4 * mesh) {
                const to = Math.min(reach, from + 4 * mesh);
                lines.push(x + at, y + from, height, x + at, y + to, height, x + from, y + at, height, x + to, y + at, height);
            }
        }
        return { points: this.levelSquare(height - 0.002 * size), lines: Float32Array.from(lines), shaded: false };
    }

    terrainTriangles(terrain) {
        const points = new Float32Array(18 * (terrain.nx - 1) * (terrain.ny - 1));
        let at = 0;
        for (let j = 0; j + 1 < terrain.ny; ++j) {
            for (let i = 0; i + 1 < terrain.nx; ++i) {
                for (const [a, b] of cellTriangles.flat()) {
                    points.set(terrainNode(terrain, i + a, j + b), at);
                    at += 3;
                }
            }
        }
        return points;
    }

    colourStructure() {
        this.renderer.tintStructure((component) => (this.fine ? this.materialOf(component)
            : [...tones.structure.map((c) => Math.min(255, c * (0.86 + 0.07 * (component % 5)))), 255]));
    }

    // Colour and roughness of what a component is made of, to 255.
    materialOf(component) {
        const { kind } = this.facts.scene.materials[component];
        return [...materialTones[kind], 255 * materialRoughness[kind]];
    }

    colourPieces() {
        const { pieces, structure, motion } = this;
        const bytes = new Uint8Array(4 * pieces.count);
        const [first, last] = this.spanOfBirths();
        this.fastest = this.facts.outcome.maxSpeed || 20;
        for (let p = 0; p < pieces.count; ++p) {
            const f = pieces.fragments[p];
            const e = pieces.elements[p];
            const material = this.fine ? this.materialOf(structure.components[e]) : null;
            let colour = material || (f < 0 ? tones.released : tones.fragment);
            if (this.colourBy === 'component') {
                colour = categoryColour(structure.components[e]);
            } else if (this.colourBy === 'birth' && f >= 0) {
                colour = heat((pieces.births[f] - first) / Math.max(1e-9, last - first));
            } else if (this.colourBy === 'cluster' && f >= 0) {
                colour = categories[(pieces.clusters[f] < 0 ? f : pieces.clusters[f]) % categories.length];
            } else if (this.colourBy === 'speed') {
                if (!pieces.shown(p, this.time)) {
                    continue;
                }
                colour = heat(Math.sqrt(motion.speed(pieces.bodies[p], this.time) / this.fastest));
            }
            bytes[4 * p] = colour[0];
            bytes[4 * p + 1] = colour[1];
            bytes[4 * p + 2] = colour[2];
            bytes[4 * p + 3] = material ? material[3] : 255;
        }
        this.renderer.tintPieces(bytes);
    }

    spanOfBirths() {
        if (!this.birthSpan) {
            let [low, high] = [Infinity, -Infinity];
            for (const birth of this.pieces.births) {
                low = Math.min(low, birth);
                high = Math.max(high, birth);
            }
            this.birthSpan = [low, high];
        }
        return this.birthSpan;
    }

    showStructure(shown) {
        this.showsStructure = shown;
        this.draw();
    }

    setTones(high) {
        tones = high ? highTones : usualTones;
        this.colourStructure();
        this.colourPieces();
        this.draw();
    }

    // @param style  'presentation' or 'analysis'
    setStyle(style) {
        this.style = style;
        this.colourStructure();
        this.colourPieces();
        this.draw();
        this.tell();
    }

    setEdges(shown) {
        this.edges = shown;
        this.draw();
    }

    setColours(by) {
        this.colourBy = by;
        this.colourPieces();
        this.draw();
        this.tell();
    }

    // Corners of an element as a pane shows it now; null where it shows none.
    cornersNow(element, pane) {
        const { pieces, structure } = this;
        const p = pane === 1 ? pieces.at(element, this.time) : -1;
        if (p >= 0) {
            return { shape: pieces.shapes[p], corners: this.cornersOfPiece(p) };
        }
        if (!structure.active(structure.stateAt(this.time), element)) {
            return null;
        }
        return { shape: structure.shapes[element], corners: structure.cornersAt(element, this.time) };
    }

    cornersOfPiece(p) {
        const { pieces, motion } = this;
        return Array.from({ length: pieces.offsets[p + 1] - pieces.offsets[p] },
            (_, c) => motion.carried(pieces.bodies[p], pieces.corner(p, c)));
    }

    // What lies at a place of the canvas, in pixels of the page from its upper left corner.
    pickAt(x, y) {
        this.draw();
        const scale = this.canvas.width / this.canvas.clientWidth;
        const px = Math.floor(x * scale);
        const py = this.canvas.height - 1 - Math.floor(y * scale);
        const index = this.panes().findIndex((pane) => px >= pane.x && px < pane.x + pane.width && py >= pane.y &&
            py < pane.y + pane.height);
        if (index < 0) {
            return null;
        }
        const pane = this.panes()[index];
        const aspect = pane.width / pane.height;
        const ray = this.camera.ray(2 * (px + 0.5 - pane.x) / pane.width - 1, 2 * (py + 0.5 - pane.y) / pane.height - 1, aspect);
        const { element, distance } = this.nearest(ray, index);
        // A hill or a wall hides what lies behind it; what lies on level ground may reach into it.
        const hiding = [this.site.meets(ray), this.facts.ground.terrain === null ? null : this.groundAlong(ray)];
        const hidden = Math.min(...hiding.map((each) => (each === null ? Infinity : each)));
        if (element >= 0 && distance <= hidden) {
            return { element, pane: index, point: add3(ray.from, ray.way, distance) };
        }
        const ground = this.groundAlong(ray);
        const met = Math.min(hidden, ground === null ? Infinity : ground);
        return { element: -1, pane: index, point: met === Infinity ? null : add3(ray.from, ray.way, met) };
    }

    // Distance at which a ray meets the ground; null: nowhere.
    groundAlong(ray) {
        const { terrain, height } = this.facts.ground;
        if (terrain !== null) {
            return rayMeetsTerrain(ray, terrain);
        }
        return ray.way[2] < 0 ? (height - ray.from[2]) / ray.way[2] : null;
    }

    // The element of a pane that a ray meets first; -1: none.
    nearest(ray, index) {
        const { structure, pieces, motion, time } = this;
        let best = { element: -1, distance: Infinity };
        const take = (element, shape, corners) => {
            const distance = rayMeets(ray, corners, structure.faces[shape]);
            if (distance !== null && distance < best.distance) {
                best = { element, distance };
            }
        };
        const passes = (middle, reach) => {
            const way = add3(middle, ray.from, -1);
            const along = dot3(way, ray.way);
            return along > -reach && along - reach < best.distance && dot3(way, way) - along * along < reach * reach;
        };
        for (const p of index === 1 ? pieces.live : []) {
            const middle = motion.carried(pieces.bodies[p], this.renderer.middles.subarray(3 * p, 3 * p + 3));
            if (passes(middle, 2 * this.renderer.sizes[p])) {
                take(pieces.elements[p], pieces.shapes[p], this.cornersOfPiece(p));
            }
        }
        const there = this.there[index];
        const state = structure.stateAt(time);
        for (let e = 0; (index === 0 || this.showsStructure) && e < structure.elements; ++e) {
            if (there[e]) {
                const first = structure.node(state, structure.corners[structure.offsets[e]]);
                const last = structure.node(state, structure.corners[structure.offsets[e + 1] - 1]);
                if (passes(first, 4 * length3(add3(first, last, -1)) + 1)) {
                    take(e, structure.shapes[e], structure.cornersAt(e, time));
                }
            }
        }
        return best;
    }

    // Middle of an element at a time: as its fragment or its island where a body carries it, else as the FE result has it.
    middleAt(element, time) {
        const p = this.pieces.at(element, time);
        if (p >= 0) {
            this.motion.moveTo(time);
            return this.motion.carried(this.pieces.bodies[p], this.pieces.middle(p));
        }
        if (!this.structure.active(this.structure.stateAt(time), element)) {
            return null;
        }
        const corners = this.structure.cornersAt(element, time);
        return corners.reduce((sum, c) => add3(sum, c, 1 / corners.length), [0, 0, 0]);
    }

    // Way of the middle of an element from its first state on, at the instants of FE result and run.
    pathOf(element) {
        const first = this.pieces.firstOf[element];
        const born = first >= 0 ? this.pieces.from[first] : Infinity;
        const points = [];
        for (const time of [...this.structure.times].filter((t) => t < born)) {
            points.push(this.middleAt(element, time));
        }
        for (const time of [...this.frames].filter((t) => t >= born)) {
            points.push(this.middleAt(element, time));
        }
        this.motion.moveTo(this.time);
        return points.filter((p) => p !== null);
    }

    choose(element) {
        this.chosen = element;
        this.path = null;
        if (element >= 0) {
            this.pathPoints = this.pathOf(element);
            this.path = Float32Array.from(this.pathPoints.flat());
        }
        this.draw();
        this.tell();
    }
}
