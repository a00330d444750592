// Contours: dark where something lies in front of what is seen beside it. Depths as they are kept are level along a plane however
// it lies, so that they bend at creases and jump at rims alone; the nearer side of a jump is drawn.
const contourFragment = `${shaderHead}
uniform sampler2D depths;
uniform ivec4 room;
uniform vec2 lens;
uniform vec2 least;
uniform float end;
uniform int thick;
uniform vec4 ink;
out vec4 pixel;
void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    float here = texelFetch(depths, at, 0).r;
    if (here >= 1.0) {
        discard;
    }
    float bend = 0.0;
    for (int axis = 0; axis < 2; ++axis) {
        ivec2 way = axis == 0 ? ivec2(thick, 0) : ivec2(0, thick);
        if (all(greaterThanEqual(at - way, room.xy)) && all(lessThan(at + way, room.zw))) {
            bend = max(bend, texelFetch(depths, at - way, 0).r + texelFetch(depths, at + way, 0).r - 2.0 * here);
        }
    }
    float away = 1.0 / (lens.x - lens.y * here);
    float jump = bend * lens.y * away * away;
    float dark = smoothstep(0.5, 1.5, jump / max(least.x, least.y * away)) * (1.0 - smoothstep(end, 1.5 * end, away));
    pixel = vec4(ink.rgb, ink.a * dark);
}`;

// Draws them into a pane of the picture with smooth edges.
// @param lens   1 over the nearest depth, and how much more that is than 1 over the farthest, 1/m
// @param least  jumps that are told: m, and shares of the distance
// @param end    m, distance from which nothing has contours any more
// @param thick  px
function drawContours(renderer, pane, { lens, least, end, thick, ink }) {
    const { gl, smooth } = renderer;
    const { program, places } = renderer.programs.contours;
    renderer.makeStill(smooth.width, smooth.height);
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, smooth[0].frame);
    gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, renderer.still.frame);
    const corners = [pane.x, pane.y, pane.x + pane.width, pane.y + pane.height];
    gl.blitFramebuffer(...corners, ...corners, gl.DEPTH_BUFFER_BIT, gl.NEAREST);
    gl.bindFramebuffer(gl.FRAMEBUFFER, smooth[0].frame);
    gl.useProgram(program);
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, renderer.still.depth);
    gl.uniform1i(places.depths, 0);
    gl.uniform4i(places.room, ...corners);
    gl.uniform2f(places.lens, ...lens);
    gl.uniform2f(places.least, ...least);
    gl.uniform1f(places.end, end);
    gl.uniform1i(places.thick, thick);
    gl.uniform4f(places.ink, ...ink);
    renderer.blended(true, () => renderer.drawScreen());
}
