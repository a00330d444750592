const shadowSide = 2048;  // px, of a map of depths

// To the right and upwards as the sun sees it, and towards it.
const sunAxes = (() => {
    const back = unit3(sun);
    const right = unit3(cross3([0, 0, 1], back));
    return [right, cross3(back, right), back];
})();

// Where a box begins and ends along an axis, m.
function endsAlong(axis, { low, high }) {
    return [0, 1].map((end) => axis.reduce((sum, x, c) => sum + x * ((x > 0) === (end === 1) ? high[c] : low[c]), 0));
}

// Whether some of a ground faces away from the sun; else it throws no shadow. @param points  in rows of three that make triangles
function shadesItself(points) {
    const corner = (i) => points.subarray(3 * i, 3 * i + 3);
    for (let i = 0; 3 * i < points.length; i += 3) {
        const normal = cross3(add3(corner(i + 1), corner(i), -1), add3(corner(i + 2), corner(i), -1));
        if (normal[2] * dot3(normal, sunAxes[2]) < 0) {
            return true;
        }
    }
    return false;
}

// Depths along the rays of the sun, by which a surface knows whether it is lit. Where a browser cannot draw depths alone, nothing
// throws a shadow.
class Shadow {
    constructor(gl) {
        this.gl = gl;
        this.texture = gl.createTexture();
        gl.bindTexture(gl.TEXTURE_2D, this.texture);
        gl.texStorage2D(gl.TEXTURE_2D, 1, gl.DEPTH_COMPONENT24, shadowSide, shadowSide);
        for (const [what, value] of [[gl.TEXTURE_COMPARE_MODE, gl.COMPARE_REF_TO_TEXTURE], [gl.TEXTURE_COMPARE_FUNC, gl.LEQUAL],
            [gl.TEXTURE_MIN_FILTER, gl.LINEAR], [gl.TEXTURE_MAG_FILTER, gl.LINEAR], [gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE],
            [gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE]]) {
            gl.texParameteri(gl.TEXTURE_2D, what, value);
        }
        this.frame = gl.createFramebuffer();
        gl.bindFramebuffer(gl.FRAMEBUFFER, this.frame);
        gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.TEXTURE_2D, this.texture, 0);
        gl.drawBuffers([gl.NONE]);
        gl.readBuffer(gl.NONE);
        this.works = gl.checkFramebufferStatus(gl.FRAMEBUFFER) === gl.FRAMEBUFFER_COMPLETE;
        gl.bindFramebuffer(gl.FRAMEBUFFER, null);
        this.view = new Float32Array(16);
    }

    // Sees all of a box from the sun, and what is before it up to the place `sunward` towards the sun, m.
    // @param part  of the side of the map that is used
    begin(bounds, part) {
        const gl = this.gl;
        this.part = part;
        this.look(bounds);
        gl.bindFramebuffer(gl.FRAMEBUFFER, this.frame);
        gl.disable(gl.SCISSOR_TEST);
        gl.viewport(0, 0, part * shadowSide, part * shadowSide);
        gl.clear(gl.DEPTH_BUFFER_BIT);
        // Else what is lit at a slant would shade itself.
        gl.enable(gl.POLYGON_OFFSET_FILL);
        gl.polygonOffset(2, 4);
    }

    end() {
        const gl = this.gl;
        gl.disable(gl.POLYGON_OFFSET_FILL);
        gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    }

    look(bounds) {
        const { low, high, sunward } = bounds;
        const rows = sunAxes.map((axis, i) => {
            const ends = endsAlong(axis, bounds);
            ends[1] = i === 2 ? Math.max(ends[1], sunward) : ends[1];
            // Depth grows away from the sun.
            const scale = (i === 2 ? -2 : 2) / Math.max(1e-6, ends[1] - ends[0]);
            return [...axis.map((x) => scale * x), -scale * (ends[0] + ends[1]) / 2];
        });
        [...rows, [0, 0, 0, 1]].forEach((row, r) => row.forEach((x, c) => {
            this.view[4 * c + r] = x;
        }));
        const middle = [0, 1, 2].map((c) => (low[c] + high[c]) / 2);
        // As good as a place at infinity for the choice of the faces that see the sun.
        this.far = add3(middle, sunAxes[2], 100 * length3(add3(high, low, -1)));
    }
}
