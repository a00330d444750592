const smoothSamples = 4;
const edgeInk = [0.13, 0.12, 0.1];

// The drawing programs of a canvas. They are compiled beside what else is done until somebody asks what came of it.
// Throws where the browser has no WebGL 2.
function startedPrograms(canvas) {
    const gl = canvas.getContext('webgl2', { antialias: false, alpha: false, powerPreference: 'high-performance' });
    if (!gl) {
        throw new Error('WebGL 2');
    }
    const started = (vertex, fragment, attributes) => {
        const program = gl.createProgram();
        const shaders = [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]].map(([kind, text]) => {
            const shader = gl.createShader(kind);
            gl.shaderSource(shader, text);
            gl.compileShader(shader);
            gl.attachShader(program, shader);
            return shader;
        });
        attributes.forEach((name, i) => gl.bindAttribLocation(program, i, name));
        gl.linkProgram(program);
        return { program, shaders };
    };
    const programs = {
        structure: started(structureVertex, solidFragment, ['now', 'next', 'tint', 'rest']),
        pieces: started(pieceVertex, solidFragment, ['place', 'body', 'tint', 'rest']),
        squares: started(squareVertex, solidFragment, ['place', 'tint']),
        plain: started(plainVertex, groundFragment, ['place']),
        picture: started(pictureVertex, pictureFragment, ['place']),
        sky: started(pictureVertex, skyFragment, ['place']),
        contours: started(pictureVertex, contourFragment, ['place']),
        structureDepth: started(structureVertex, depthFragment, ['now', 'next', 'tint', 'rest']),
        piecesDepth: started(pieceVertex, depthFragment, ['place', 'body', 'tint', 'rest']),
        plainDepth: started(plainVertex, depthFragment, ['place'])
    };
    gl.flush();
    return { gl, programs };
}

class Renderer {
    // @param started  of startedPrograms()
    constructor(canvas, started, structure, pieces, motion) {
        const { gl } = started;
        Object.assign(this, { gl, canvas, structure, pieces, motion });
        this.side = Math.min(2048, gl.getParameter(gl.MAX_TEXTURE_SIZE));
        this.blank = this.texture(1, gl.R8, gl.RED, gl.UNSIGNED_BYTE);
        this.tested = false;
        this.look = { fine: false };
        this.shadows = [0, 1].map(() => new Shadow(gl));
        this.makePoses();
        this.makeStructure();
        this.makePieces();
        this.plain = { array: gl.createVertexArray(), buffer: gl.createBuffer() };
        gl.bindVertexArray(this.plain.array);
        gl.bindBuffer(gl.ARRAY_BUFFER, this.plain.buffer);
        gl.enableVertexAttribArray(0);
        gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 0, 0);
        gl.bindVertexArray(null);
        gl.enable(gl.DEPTH_TEST);
        // Asked last, so that nobody waits for the compiler before.
        this.programs = Object.fromEntries(Object.entries(started.programs).map(([name, each]) => [name, this.finished(each)]));
    }

    finished({ program, shaders }) {
        const gl = this.gl;
        if (!gl.getProgramParameter(program, gl.LINK_STATUS)) {
            throw new Error(shaders.map((shader) => gl.getShaderInfoLog(shader)).join('') || gl.getProgramInfoLog(program));
        }
        const places = {};
        const count = gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS);
        for (let i = 0; i < count; ++i) {
            const { name } = gl.getActiveUniform(program, i);
            places[name] = gl.getUniformLocation(program, name);
        }
        return { program, places };
    }

    texture(count, internal, format, type) {
        const gl = this.gl;
        const width = Math.max(1, Math.min(this.side, Math.ceil(Math.sqrt(count))));
        const height = Math.max(1, Math.ceil(count / width));
        const texture = gl.createTexture();
        gl.bindTexture(gl.TEXTURE_2D, texture);
        gl.texStorage2D(gl.TEXTURE_2D, 1, internal, width, height);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
        return { texture, width, height, format, type };
    }

    // @param data  as many texels as the texture has
    fill(target, data) {
        const gl = this.gl;
        gl.activeTexture(gl.TEXTURE0);
        gl.bindTexture(gl.TEXTURE_2D, target.texture);
        gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
        gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, target.width, target.height, target.format, target.type, data);
    }

    makePoses() {
        const gl = this.gl;
        this.poses = this.texture(2 * this.motion.count, gl.RGBA32F, gl.RGBA, gl.FLOAT);
        this.poseBuffer = new Float32Array(4 * this.poses.width * this.poses.height);
        this.motion.poses = this.poseBuffer;
    }

    // @param data  numbers, or how many bytes of zeros
    buffer(data, usage) {
        const gl = this.gl;
        const buffer = gl.createBuffer();
        gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
        gl.bufferData(gl.ARRAY_BUFFER, data, usage);
        return buffer;
    }

    // An attribute that a buffer of its own gives.
    attach(place, buffer, size, type, normalised = false) {
        const gl = this.gl;
        gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
        gl.enableVertexAttribArray(place);
        if (type === gl.UNSIGNED_INT) {
            gl.vertexAttribIPointer(place, size, type, 0, 0);
        } else {
            gl.vertexAttribPointer(place, size, type, normalised, 0, 0);
        }
    }

    // A vertex for each node and component that meet, since a node at a border has two colours.
    makeStructure() {
        const gl = this.gl;
        const { elements, nodes, offsets, corners, components } = this.structure;
        const latest = new Int32Array(nodes).fill(-1);
        const before = [];
        const nodeOf = [];
        const componentOf = [];
        this.vertexOf = new Uint32Array(corners.length);
        for (let e = 0; e < elements; ++e) {
            for (let c = offsets[e]; c < offsets[e + 1]; ++c) {
                let vertex = latest[corners[c]];
                while (vertex >= 0 && componentOf[vertex] !== components[e]) {
                    vertex = before[vertex];
                }
                if (vertex < 0) {
                    vertex = nodeOf.length;
                    nodeOf.push(corners[c]);
                    componentOf.push(components[e]);
                    before.push(latest[corners[c]]);
                    latest[corners[c]] = vertex;
                }
                this.vertexOf[c] = vertex;
            }
        }
        this.nodeOf = Uint32Array.from(nodeOf);
        this.componentOf = Uint32Array.from(componentOf);
        this.placeBuffer = new Float32Array(3 * nodeOf.length);
        this.states = [0, 1].map(() => ({ buffer: this.buffer(this.placeBuffer.byteLength, gl.DYNAMIC_DRAW), state: -1 }));
        this.structureTints = this.buffer(4 * nodeOf.length, gl.DYNAMIC_DRAW);
        this.structure.fillPlaces(0, this.nodeOf, this.placeBuffer);
        this.structureRest = this.buffer(this.placeBuffer, gl.STATIC_DRAW);
        // Each view has its own faces, since what has fallen is left out of one of them.
        this.shells = ['fe', 'standing'].map(() => {
            const shell = {
                array: gl.createVertexArray(), faces: gl.createBuffer(), parts: [], count: 0, beams: [[], []],
                corners: new Uint32Array(24 * elements), kinds: new Uint8Array(6 * elements), normals: new Float32Array(24 * elements)
            };
            gl.bindVertexArray(shell.array);
            gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, shell.faces);
            this.attach(2, this.structureTints, 4, gl.UNSIGNED_BYTE, true);
            this.attach(3, this.structureRest, 3, gl.FLOAT);
            return shell;
        });
        gl.bindVertexArray(null);
        this.scratch = new Uint32Array(38 * elements);
        this.margin = 1;
    }

    makePieces() {
        const gl = this.gl;
        const { count, offsets, corners, bodies } = this.pieces;
        const middles = new Float32Array(3 * count);
        const sizes = new Float32Array(count);
        for (let p = 0; p < count; ++p) {
            const middle = this.pieces.middle(p);
            middles.set(middle, 3 * p);
            sizes[p] = this.pieces.size(p, middle);
        }
        this.sizes = sizes;
        this.middles = middles;
        const { faces, ends } = this.pieceFaces();
        this.boxes = { array: gl.createVertexArray(), faces, ends, count: 0, live: null };
        gl.bindVertexArray(this.boxes.array);
        this.attach(0, this.buffer(corners, gl.STATIC_DRAW), 3, gl.FLOAT);
        this.attach(1, this.buffer(this.perCorner(bodies), gl.STATIC_DRAW), 1, gl.UNSIGNED_INT);
        this.boxes.tints = this.buffer(4 * offsets[count], gl.DYNAMIC_DRAW);
        this.attach(2, this.boxes.tints, 4, gl.UNSIGNED_BYTE, true);
        this.attach(3, this.buffer(this.restOfPieces(), gl.STATIC_DRAW), 3, gl.FLOAT);
        gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
        this.makeSquares();
    }

    // Where the corners of the pieces were at rest: a piece keeps the grain that its element had.
    restOfPieces() {
        const { structure, pieces } = this;
        const { corners, offsets, shapes } = structure;
        const nodes = new Uint32Array(pieces.offsets[pieces.count]);
        const rest = new Float32Array(3 * nodes.length);
        for (let p = 0; p < pieces.count; ++p) {
            // A piece of another shape than its element takes one of its nodes: its grain is of one tone.
            const e = pieces.elements[p];
            const same = pieces.shapes[p] === shapes[e] ? 1 : 0;
            for (let c = pieces.offsets[p]; c < pieces.offsets[p + 1]; ++c) {
                nodes[c] = corners[offsets[e] + same * (c - pieces.offsets[p])];
            }
        }
        structure.fillPlaces(0, nodes, rest);
        return rest;
    }

    // One value of each piece at each of its corners.
    perCorner(values) {
        const { count, offsets } = this.pieces;
        const out = new values.constructor(offsets[count]);
        for (let p = 0; p < count; ++p) {
            const value = values[p];
            for (let c = offsets[p]; c < offsets[p + 1]; ++c) {
                out[c] = value;
            }
        }
        return out;
    }

    makeSquares() {
        const gl = this.gl;
        const { count } = this.pieces;
        this.squares = { array: gl.createVertexArray(), places: new Float32Array(4 * count), tints: new Uint8Array(4 * count) };
        gl.bindVertexArray(this.squares.array);
        this.squares.placeBuffer = this.buffer(this.squares.places.byteLength, gl.DYNAMIC_DRAW);
        this.attach(0, this.squares.placeBuffer, 4, gl.FLOAT);
        this.squares.tintBuffer = this.buffer(this.squares.tints.byteLength, gl.DYNAMIC_DRAW);
        this.attach(1, this.squares.tintBuffer, 4, gl.UNSIGNED_BYTE, true);
        gl.bindVertexArray(null);
        this.shades = new Uint8Array(4 * count);
        this.world = new Float32Array(3 * count);
    }

    // @param tints  [4 * pieces]
    tintPieces(tints) {
        const gl = this.gl;
        gl.bindBuffer(gl.ARRAY_BUFFER, this.boxes.tints);
        gl.bufferSubData(gl.ARRAY_BUFFER, 0, this.perCorner(new Uint32Array(tints.buffer)));
        // A square has no sides: some are darker, as sides of boxes are.
        for (let i = 0; i < tints.length; ++i) {
            this.shades[i] = i % 4 === 3 ? 255 : tints[i] * (0.62 + 0.1 * ((i >> 2) * 7 % 5));
        }
    }

    // @param tintOf  colour and roughness of a component, four numbers to 255
    tintStructure(tintOf) {
        const gl = this.gl;
        const tints = new Uint8Array(4 * this.nodeOf.length);
        for (let v = 0; v < this.nodeOf.length; ++v) {
            tints.set(tintOf(this.componentOf[v]), 4 * v);
        }
        gl.bindBuffer(gl.ARRAY_BUFFER, this.structureTints);
        gl.bufferSubData(gl.ARRAY_BUFFER, 0, tints);
    }

    // Triangles of the pieces in the order in which they appear, without what lies between neighbours on one body; and where those of
    // each piece end.
    pieceFaces() {
        const { structure, pieces } = this;
        const others = structure.neighbours();
        const ends = new Uint32Array(pieces.count + 1);
        const out = new Uint32Array(36 * pieces.count);
        let length = 0;
        for (let p = 0; p < pieces.count; ++p) {
            const e = pieces.elements[p];
            const faces = structure.faces[pieces.shapes[p]];
            const own = pieces.shapes[p] === structure.shapes[e];
            for (let f = 0; f < faces.length; ++f) {
                const other = own && pieces.shapes[p] < 4 ? others[6 * e + f] : -1;
                if (other >= 0 && this.together(p, other)) {
                    continue;
                }
                const [a, b, c, d] = faces[f];
                const first = pieces.offsets[p];
                out[length++] = first + a;
                out[length++] = first + b;
                out[length++] = first + c;
                if (d >= 0) {
                    out[length++] = first + a;
                    out[length++] = first + c;
                    out[length++] = first + d;
                }
            }
            ends[p + 1] = length;
        }
        return { faces: out.subarray(0, length), ends };
    }

    together(p, other) {
        const { bodies, from, to, shapes, firstOf, nextOf } = this.pieces;
        const own = this.structure.shapes[other];
        for (let q = firstOf[other]; q >= 0; q = nextOf[q]) {
            if (bodies[q] === bodies[p] && from[q] <= from[p] && to[q] >= to[p] && shapes[q] === own) {
                return true;
            }
        }
        return false;
    }

    // Outer faces of the elements that `there` says are there; those that die next stay where they were, part from the others and hide
    // nothing of them.
    showShell(index, there, lasting, state) {
        const { elements, shapes, faces, offsets, corners } = this.structure;
        const others = this.structure.neighbours();
        const shell = this.shells[index];
        const { vertexOf } = this;
        let count = 0;
        shell.beams = [[], []];
        for (let e = 0; e < elements; ++e) {
            if (!there[e]) {
                continue;
            }
            const stays = lasting[e];
            const shape = shapes[e];
            const first = offsets[e];
            if (shape === 6) {
                shell.beams[stays].push(vertexOf[first], vertexOf[first + 1]);
                continue;
            }
            const list = faces[shape];
            for (let f = 0; f < list.length; ++f) {
                const other = shape < 4 ? others[6 * e + f] : -1;
                if (other >= 0 && there[other] && lasting[other] === stays) {
                    continue;
                }
                const [a, b, c, d] = list[f];
                shell.corners[4 * count] = vertexOf[first + a];
                shell.corners[4 * count + 1] = vertexOf[first + b];
                shell.corners[4 * count + 2] = vertexOf[first + c];
                shell.corners[4 * count + 3] = d >= 0 ? vertexOf[first + d] : vertexOf[first + c];
                shell.kinds[count] = stays + (shape < 4 ? 2 : 0);
                this.setNormal(shell.normals, 4 * count, state, corners[first + a], corners[first + b], corners[first + c],
                    corners[first + (d >= 0 ? d : a)]);
                ++count;
            }
        }
        shell.count = count;
    }

    // Normal of a face by its diagonals, and how far its plane lies along it, all over its length.
    setNormal(out, at, state, a, b, c, d) {
        const { places, nodes, step } = this.structure;
        const o = this.structure.placesAt(state);
        const ux = places[o + c] - places[o + a];
        const uy = places[o + nodes + c] - places[o + nodes + a];
        const uz = places[o + 2 * nodes + c] - places[o + 2 * nodes + a];
        const vx = places[o + d] - places[o + b];
        const vy = places[o + nodes + d] - places[o + nodes + b];
        const vz = places[o + 2 * nodes + d] - places[o + 2 * nodes + b];
        const x = uy * vz - uz * vy;
        const y = uz * vx - ux * vz;
        const z = ux * vy - uy * vx;
        const length = Math.sqrt(x * x + y * y + z * z) || 1;
        out[at] = x / length;
        out[at + 1] = y / length;
        out[at + 2] = z / length;
        out[at + 3] = step * (x * places[o + a] + y * places[o + nodes + a] + z * places[o + 2 * nodes + a]) / length;
    }

    // Puts together what faces the eye: half of it costs half.
    faceShell(shell, [ex, ey, ez]) {
        const { corners, kinds, normals, count } = shell;
        const out = this.scratch;
        let length = 0;
        shell.parts = [];
        for (const stays of [1, 0]) {
            for (const solid of [2, 0]) {
                const first = length;
                for (let i = 0; i < count; ++i) {
                    const n = 4 * i;
                    // A face that turns until the next state is kept a little beyond the edge.
                    if (kinds[i] !== stays + solid ||
                        (solid && normals[n] * ex + normals[n + 1] * ey + normals[n + 2] * ez - normals[n + 3] < -this.margin)) {
                        continue;
                    }
                    out[length++] = corners[n];
                    out[length++] = corners[n + 1];
                    out[length++] = corners[n + 2];
                    if (corners[n + 3] !== corners[n + 2]) {
                        out[length++] = corners[n];
                        out[length++] = corners[n + 2];
                        out[length++] = corners[n + 3];
                    }
                }
                if (length > first) {
                    shell.parts.push({ mode: this.gl.TRIANGLES, stays, solid, first, count: length - first });
                }
            }
            if (shell.beams[stays].length > 0) {
                out.set(shell.beams[stays], length);
                shell.parts.push({ mode: this.gl.LINES, stays, solid: 0, first: length, count: shell.beams[stays].length });
                length += shell.beams[stays].length;
            }
        }
        return out.subarray(0, length);
    }

    showState(state) {
        const gl = this.gl;
        const next = Math.min(state + 1, this.structure.times.length - 1);
        if (this.states[0].state === state && this.states[1].state === next) {
            return;
        }
        if (this.states[1].state === state) {
            this.states.reverse();
        }
        [state, next].forEach((k, i) => {
            if (this.states[i].state !== k) {
                this.structure.fillPlaces(k, this.nodeOf, this.placeBuffer);
                gl.bindBuffer(gl.ARRAY_BUFFER, this.states[i].buffer);
                gl.bufferSubData(gl.ARRAY_BUFFER, 0, this.placeBuffer);
                this.states[i].state = k;
            }
        });
        for (const shell of this.shells) {
            gl.bindVertexArray(shell.array);
            this.attach(0, this.states[0].buffer, 3, gl.FLOAT);
            this.attach(1, this.states[1].buffer, 3, gl.FLOAT);
        }
        gl.bindVertexArray(null);
    }

    // Pictures as large as the canvas: one with smooth edges, and one that it is copied to.
    smoothFrames(width, height) {
        const gl = this.gl;
        if (!this.smooth) {
            this.smooth = [smoothSamples, 0].map((samples) => ({
                samples, frame: gl.createFramebuffer(), colour: gl.createRenderbuffer(), depth: gl.createRenderbuffer()
            }));
        }
        if (this.smooth.width !== width || this.smooth.height !== height) {
            for (const { samples, frame, colour, depth } of this.smooth) {
                gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
                for (const [buffer, format, place] of [[colour, gl.RGBA8, gl.COLOR_ATTACHMENT0],
                    [depth, gl.DEPTH_COMPONENT24, gl.DEPTH_ATTACHMENT]]) {
                    gl.bindRenderbuffer(gl.RENDERBUFFER, buffer);
                    gl.renderbufferStorageMultisample(gl.RENDERBUFFER, samples, format, width, height);
                    gl.framebufferRenderbuffer(gl.FRAMEBUFFER, place, gl.RENDERBUFFER, buffer);
                }
            }
            Object.assign(this.smooth, { width, height });
        }
        return this.smooth;
    }

    // A picture with depth of what stands, as textures; true where it is new.
    makeStill(width, height) {
        const gl = this.gl;
        if (this.still && this.still.width === width && this.still.height === height) {
            return false;
        }
        if (this.still) {
            gl.deleteTexture(this.still.colour);
            gl.deleteTexture(this.still.depth);
        }
        this.still = { frame: this.still ? this.still.frame : gl.createFramebuffer(), width, height };
        gl.bindFramebuffer(gl.FRAMEBUFFER, this.still.frame);
        for (const [name, format, place] of [['colour', gl.RGBA8, gl.COLOR_ATTACHMENT0],
            ['depth', gl.DEPTH_COMPONENT24, gl.DEPTH_ATTACHMENT]]) {
            this.still[name] = gl.createTexture();
            gl.bindTexture(gl.TEXTURE_2D, this.still[name]);
            gl.texStorage2D(gl.TEXTURE_2D, 1, format, width, height);
            gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
            gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
            gl.framebufferTexture2D(gl.FRAMEBUFFER, place, gl.TEXTURE_2D, this.still[name], 0);
        }
        return true;
    }

    // Draws that picture.
    drawStill() {
        const gl = this.gl;
        const { program, places } = this.programs.picture;
        gl.useProgram(program);
        gl.activeTexture(gl.TEXTURE0);
        gl.bindTexture(gl.TEXTURE_2D, this.still.colour);
        gl.uniform1i(places.picture, 0);
        this.drawScreen();
    }

    // A triangle that covers the viewport, behind everything.
    drawScreen() {
        const gl = this.gl;
        if (!this.screen) {
            this.screen = gl.createVertexArray();
            gl.bindVertexArray(this.screen);
            this.attach(0, this.buffer(Float32Array.of(-1, -1, 3, -1, -1, 3), gl.STATIC_DRAW), 2, gl.FLOAT);
        }
        gl.bindVertexArray(this.screen);
        gl.disable(gl.DEPTH_TEST);
        gl.drawArrays(gl.TRIANGLES, 0, 3);
        gl.enable(gl.DEPTH_TEST);
    }

    copy(from, to, width, height) {
        const gl = this.gl;
        gl.bindFramebuffer(gl.READ_FRAMEBUFFER, from);
        gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, to);
        gl.blitFramebuffer(0, 0, width, height, 0, 0, width, height, gl.COLOR_BUFFER_BIT, gl.NEAREST);
    }

    use(program, view, over = false) {
        const gl = this.gl;
        gl.useProgram(program.program);
        gl.uniformMatrix4fv(program.places.view, false, view);
        const { fine, shadow } = this.look;
        gl.uniform1i(program.places.fine, fine ? 1 : 0);
        gl.uniform1i(program.places.shadowed, fine && shadow ? 1 : 0);
        gl.uniform1i(program.places.sunDepth, 2);
        gl.activeTexture(gl.TEXTURE2);
        gl.bindTexture(gl.TEXTURE_2D, this.shadows[0].texture);
        if (fine && shadow) {
            gl.bindTexture(gl.TEXTURE_2D, shadow.texture);
            gl.uniformMatrix4fv(program.places.sunView, false, shadow.view);
            gl.uniform1f(program.places.sunPart, shadow.part);
        }
        // Behind what stands, where that is a picture of its own.
        const tested = this.tested && !over;
        gl.uniform1i(program.places.tested, tested ? 1 : 0);
        gl.uniform1i(program.places.behind, 1);
        gl.activeTexture(gl.TEXTURE1);
        gl.bindTexture(gl.TEXTURE_2D, tested ? this.still.depth : this.blank.texture);
    }

    // @param edges  opacity of the edges of the elements; 0: none
    drawShell(index, view, share, eye, { program = this.programs.structure, edges = 0 } = {}) {
        const gl = this.gl;
        this.use(program, view);
        gl.bindVertexArray(this.shells[index].array);
        gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, this.faceShell(this.shells[index], eye), gl.STREAM_DRAW);
        gl.uniform4f(program.places.ink, 0, 0, 0, 0);
        this.standBack(edges > 0, () => this.drawParts(this.shells[index].parts, program, share));
        if (edges > 0) {
            gl.uniform4f(program.places.ink, ...edgeInk, edges);
            this.drawParts(this.sidesOf(this.scratch, this.shells[index].parts, gl.STREAM_DRAW), program, share);
            gl.disable(gl.BLEND);
        }
    }

    // Faces leave room in front of them for the lines of their edges.
    standBack(needed, drawing) {
        const gl = this.gl;
        if (needed) {
            gl.enable(gl.POLYGON_OFFSET_FILL);
            gl.polygonOffset(1, 1);
        }
        drawing();
        if (needed) {
            gl.disable(gl.POLYGON_OFFSET_FILL);
        }
    }

    // Hands over the sides of triangles as lines; of two that make a face of four corners not the one between them.
    sidesOf(triangles, parts, usage) {
        const gl = this.gl;
        const total = parts.reduce((sum, part) => sum + part.count, 0);
        if (!this.sides || this.sides.length < 2 * total) {
            this.sides = new Uint32Array(2 * total);
        }
        const { sides } = this;
        let length = 0;
        const put = (a, b) => {
            sides[length++] = a;
            sides[length++] = b;
        };
        const lines = parts.filter((part) => part.mode === gl.TRIANGLES).map((part) => {
            const first = length;
            const end = part.first + part.count;
            for (let i = part.first; i < end; i += 3) {
                const [a, b, c] = [triangles[i], triangles[i + 1], triangles[i + 2]];
                put(a, b);
                put(b, c);
                if (i + 3 < end && triangles[i + 3] === a && triangles[i + 4] === c) {
                    put(c, triangles[i + 5]);
                    put(triangles[i + 5], a);
                    i += 3;
                } else {
                    put(c, a);
                }
            }
            return { ...part, mode: gl.LINES, first, count: length - first };
        });
        gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, sides.subarray(0, length), usage);
        gl.enable(gl.BLEND);
        gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
        return lines;
    }

    drawParts(parts, program, share) {
        const gl = this.gl;
        for (const { mode, stays, solid, first, count } of parts) {
            if (solid) {
                gl.enable(gl.CULL_FACE);
            } else {
                gl.disable(gl.CULL_FACE);
            }
            gl.uniform1f(program.places.share, stays ? share : 0);
            gl.uniform1i(program.places.unlit, mode === gl.LINES ? 1 : 0);
            gl.drawElements(mode, count, gl.UNSIGNED_INT, 4 * first);
        }
        gl.disable(gl.CULL_FACE);
    }

    // Hands over the faces of the pieces that are live.
    fillBoxes() {
        const { boxes, gl } = this;
        const { live } = this.pieces;
        if (boxes.live === live) {
            return;
        }
        boxes.live = live;
        boxes.count = 0;
        boxes.room = boxes.room || new Uint32Array(boxes.faces.length);
        for (const p of live) {
            for (let i = boxes.ends[p]; i < boxes.ends[p + 1]; ++i) {
                boxes.room[boxes.count++] = boxes.faces[i];
            }
        }
        gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, boxes.room.subarray(0, boxes.count), gl.DYNAMIC_DRAW);
    }

    // Returns when all is drawn.
    finish() {
        const gl = this.gl;
        gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
    }

    drawBoxes(view, { program = this.programs.pieces, edges = 0 } = {}) {
        const gl = this.gl;
        this.use(program, view);
        gl.uniform1i(program.places.unlit, 0);
        gl.uniform4f(program.places.ink, 0, 0, 0, 0);
        gl.activeTexture(gl.TEXTURE0);
        gl.bindTexture(gl.TEXTURE_2D, this.poses.texture);
        gl.uniform1i(program.places.poses, 0);
        gl.bindVertexArray(this.boxes.array);
        this.fillBoxes();
        gl.enable(gl.CULL_FACE);
        this.standBack(edges > 0, () => gl.drawElements(gl.TRIANGLES, this.boxes.count, gl.UNSIGNED_INT, 0));
        gl.disable(gl.CULL_FACE);
        if (edges > 0) {
            gl.uniform4f(program.places.ink, ...edgeInk, edges);
            const triangles = [{ mode: gl.TRIANGLES, stays: 0, solid: 0, first: 0, count: this.boxes.count }];
            const [{ count }] = this.sidesOf(this.boxes.room, triangles, gl.STREAM_DRAW);
            gl.drawElements(gl.LINES, count, gl.UNSIGNED_INT, 0);
            gl.disable(gl.BLEND);
            this.boxes.live = null;
        }
    }

    // Pieces as squares, of those that cover one another only the nearest.
    // @param scale  pixels of a metre at a distance of one
    // @param cell   px, of what one of them covers
    drawSquares(view, pane, scale, cell) {
        const gl = this.gl;
        const program = this.programs.squares;
        const { squares } = this;
        const count = this.chooseSquares(view, pane, cell);
        this.use(program, view);
        gl.uniform1f(program.places.scale, scale);
        gl.uniform1i(program.places.unlit, 1);
        gl.uniform4f(program.places.ink, 0, 0, 0, 0);
        gl.bindVertexArray(squares.array);
        gl.bindBuffer(gl.ARRAY_BUFFER, squares.placeBuffer);
        gl.bufferSubData(gl.ARRAY_BUFFER, 0, squares.places, 0, 4 * count);
        gl.bindBuffer(gl.ARRAY_BUFFER, squares.tintBuffer);
        gl.bufferSubData(gl.ARRAY_BUFFER, 0, squares.tints, 0, 4 * count);
        gl.drawArrays(gl.POINTS, 0, count);
    }

    chooseSquares(view, pane, cell) {
        const columns = Math.ceil(pane.width / cell);
        const rows = Math.ceil(pane.height / cell);
        if (!this.cells || this.cells.length < columns * rows) {
            this.cells = new Int32Array(columns * rows);
            this.depths = new Float32Array(columns * rows);
        }
        const { cells, depths, middles, world, poseBuffer, squares, sizes, shades } = this;
        cells.fill(-1, 0, columns * rows);
        const { bodies, live } = this.pieces;
        for (let i = 0; i < live.length; ++i) {
            const p = live[i];
            const b = 8 * bodies[p];
            const [x, y, z] = [middles[3 * p], middles[3 * p + 1], middles[3 * p + 2]];
            const [qx, qy, qz, qw] = [poseBuffer[b + 4], poseBuffer[b + 5], poseBuffer[b + 6], poseBuffer[b + 7]];
            const tx = 2 * (qy * z - qz * y);
            const ty = 2 * (qz * x - qx * z);
            const tz = 2 * (qx * y - qy * x);
            const wx = poseBuffer[b] + x + qw * tx + qy * tz - qz * ty;
            const wy = poseBuffer[b + 1] + y + qw * ty + qz * tx - qx * tz;
            const wz = poseBuffer[b + 2] + z + qw * tz + qx * ty - qy * tx;
            const w = view[3] * wx + view[7] * wy + view[11] * wz + view[15];
            const column = Math.floor((0.5 + 0.5 * (view[0] * wx + view[4] * wy + view[8] * wz + view[12]) / w) * columns);
            const row = Math.floor((0.5 + 0.5 * (view[1] * wx + view[5] * wy + view[9] * wz + view[13]) / w) * rows);
            if (w <= 0 || column < 0 || row < 0 || column >= columns || row >= rows) {
                continue;
            }
            const at = row * columns + column;
            if (cells[at] < 0 || w < depths[at]) {
                cells[at] = p;
                depths[at] = w;
                world[3 * p] = wx;
                world[3 * p + 1] = wy;
                world[3 * p + 2] = wz;
            }
        }
        let count = 0;
        for (let at = 0; at < columns * rows; ++at) {
            const p = cells[at];
            if (p >= 0) {
                for (let i = 0; i < 3; ++i) {
                    squares.places[4 * count + i] = world[3 * p + i];
                }
                squares.places[4 * count + 3] = sizes[p];
                for (let i = 0; i < 4; ++i) {
                    squares.tints[4 * count + i] = shades[4 * p + i];
                }
                ++count;
            }
        }
        return count;
    }

    // A picture as a texture whose lowest row is that of the south.
    pictureOf(image) {
        const gl = this.gl;
        const texture = gl.createTexture();
        gl.activeTexture(gl.TEXTURE0);
        gl.bindTexture(gl.TEXTURE_2D, texture);
        gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, true);
        gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, gl.RGBA, gl.UNSIGNED_BYTE, image);
        gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, false);
        gl.generateMipmap(gl.TEXTURE_2D);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR_MIPMAP_LINEAR);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
        return texture;
    }

    // Triangles that stay as they are: what lies around the structure.
    // @param indices  of points; none: points in rows of three make triangles
    solid(points, indices = null) {
        const gl = this.gl;
        const array = gl.createVertexArray();
        gl.bindVertexArray(array);
        this.attach(0, this.buffer(points, gl.STATIC_DRAW), 3, gl.FLOAT);
        if (indices) {
            gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
            gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, indices, gl.STATIC_DRAW);
        }
        gl.bindVertexArray(null);
        return { array, count: indices ? indices.length : points.length / 3, indexed: indices !== null };
    }

    // @param surface  0: of one colour; 1: ground; 2: water
    drawSolid(view, solid, tone, { shaded = false, surface = 0, program = this.programs.plain } = {}) {
        const gl = this.gl;
        this.use(program, view);
        this.usePlain(program, tone, shaded, surface);
        gl.bindVertexArray(solid.array);
        this.blended(tone[3] < 1, () => {
            if (solid.indexed) {
                gl.drawElements(gl.TRIANGLES, solid.count, gl.UNSIGNED_INT, 0);
            } else {
                gl.drawArrays(gl.TRIANGLES, 0, solid.count);
            }
        });
    }

    usePlain(program, tone, shaded, surface) {
        const gl = this.gl;
        const { places } = program;
        const { eye, far, horizon, photo } = this.look;
        gl.uniform4fv(places.tone, tone);
        gl.uniform1i(places.shaded, shaded ? 1 : 0);
        gl.uniform1i(places.surface, surface);
        gl.uniform1i(places.photo, 0);
        gl.uniform1i(places.pictured, surface === 1 && photo ? 1 : 0);
        gl.activeTexture(gl.TEXTURE0);
        gl.bindTexture(gl.TEXTURE_2D, surface === 1 && photo ? photo.texture : this.blank.texture);
        if (surface > 0) {
            gl.uniform3fv(places.eye, eye);
            gl.uniform4fv(places.far, far);
            gl.uniform3fv(places.horizon, horizon);
            gl.uniform4fv(places.place, photo ? photo.place : [0, 0, 1, 1]);
        }
    }

    blended(needed, drawing) {
        const gl = this.gl;
        if (needed) {
            gl.enable(gl.BLEND);
            gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
        }
        drawing();
        gl.disable(gl.BLEND);
    }

    // A sky over all of a pane, brightest at the horizon.
    drawSky(pane, low, top) {
        const gl = this.gl;
        const { program, places } = this.programs.sky;
        gl.useProgram(program);
        gl.uniform2f(places.room, pane.y, pane.height);
        gl.uniform3fv(places.low, low);
        gl.uniform3fv(places.top, top);
        this.drawScreen();
    }

    // What throws shadows in a pane, along the rays of the sun.
    // @param part  of the side of the map; the rest is what is there
    castShadow(index, bounds, share, part, { structure, solids, boxes }) {
        const shadow = this.shadows[index];
        const { structureDepth, piecesDepth, plainDepth } = this.programs;
        shadow.begin(bounds, part);
        this.look = { ...this.look, shadow: null };
        if (structure) {
            this.drawShell(index, shadow.view, share, shadow.far, { program: structureDepth });
        }
        solids.forEach((solid) => this.drawSolid(shadow.view, solid, [0, 0, 0, 1], { program: plainDepth }));
        if (boxes) {
            this.drawBoxes(shadow.view, { program: piecesDepth });
        }
        shadow.end();
    }

    // Points in rows of three numbers, as lines, triangles or points in one colour.
    drawPlain(view, mode, points, tone, { shaded = false, over = false, thick = 1, surface = 0 } = {}) {
        const gl = this.gl;
        const program = this.programs.plain;
        this.use(program, view, over);
        this.usePlain(program, tone, shaded, surface);
        gl.uniform1f(program.places.thick, thick);
        gl.bindVertexArray(this.plain.array);
        gl.bindBuffer(gl.ARRAY_BUFFER, this.plain.buffer);
        gl.bufferData(gl.ARRAY_BUFFER, points, gl.STREAM_DRAW);
        if (over) {
            gl.disable(gl.DEPTH_TEST);
        }
        this.blended(tone[3] < 1, () => gl.drawArrays(mode, 0, points.length / 3));
        gl.enable(gl.DEPTH_TEST);
    }
}
