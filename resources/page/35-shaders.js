const shaderHead = '#version 300 es\nprecision highp float;\nprecision highp int;\nprecision highp sampler2D;\n';

const lightOf = `
vec3 lit(vec3 colour, vec3 at) {
    vec3 normal = normalize(cross(dFdx(at), dFdy(at)));
    float sun = 0.5 + 0.5 * dot(normal, normalize(vec3(0.35, 0.45, 0.8)));
    return colour * (0.42 + 0.62 * sun);
}`;

const structureVertex = `${shaderHead}
in vec3 now;
in vec3 next;
in vec4 tint;
uniform mat4 view;
uniform float share;
out vec3 at;
flat out vec4 colour;
void main() {
    at = mix(now, next, share);
    colour = tint;
    gl_Position = view * vec4(at, 1.0);
}`;

const pieceVertex = `${shaderHead}
in vec3 place;
in uint body;
in vec4 tint;
uniform mat4 view;
uniform sampler2D poses;
out vec3 at;
flat out vec4 colour;
void main() {
    colour = tint;
    int width = textureSize(poses, 0).x;
    int first = 2 * int(body);
    vec3 position = texelFetch(poses, ivec2(first % width, first / width), 0).xyz;
    vec4 turn = texelFetch(poses, ivec2((first + 1) % width, (first + 1) / width), 0);
    vec3 t = 2.0 * cross(turn.xyz, place);
    at = position + place + turn.w * t + cross(turn.xyz, t);
    gl_Position = view * vec4(at, 1.0);
}`;

// A piece from afar: a square.
const squareVertex = `${shaderHead}
in vec4 place;
in vec4 tint;
uniform mat4 view;
uniform float scale;
out vec3 at;
flat out vec4 colour;
void main() {
    at = place.xyz;
    colour = tint;
    gl_Position = view * vec4(at, 1.0);
    gl_PointSize = clamp(place.w * scale / gl_Position.w, 1.0, 48.0);
}`;

// What stands was drawn before, into a picture of its own with depth.
const behindTest = `
uniform sampler2D behind;
uniform bool tested;
void hideBehind() {
    if (tested && gl_FragCoord.z > texelFetch(behind, ivec2(gl_FragCoord.xy), 0).r) {
        discard;
    }
}`;

const solidFragment = `${shaderHead}
in vec3 at;
flat in vec4 colour;
uniform bool unlit;
out vec4 pixel;
${lightOf}
${behindTest}
void main() {
    hideBehind();
    pixel = vec4(unlit ? colour.rgb : lit(colour.rgb, at), 1.0);
}`;

const plainVertex = `${shaderHead}
in vec3 place;
uniform mat4 view;
uniform float thick;
out vec3 at;
void main() {
    at = place;
    gl_Position = view * vec4(place, 1.0);
    gl_PointSize = thick;
}`;

const groundFragment = `${shaderHead}
in vec3 at;
uniform vec4 tone;
uniform bool shaded;
out vec4 pixel;
${lightOf}
${behindTest}
void main() {
    hideBehind();
    pixel = shaded ? vec4(lit(tone.rgb, at), tone.a) : tone;
}`;

const pictureVertex = `${shaderHead}
in vec2 place;
void main() {
    gl_Position = vec4(place, 0.0, 1.0);
}`;

const pictureFragment = `${shaderHead}
uniform sampler2D picture;
out vec4 pixel;
void main() {
    pixel = texelFetch(picture, ivec2(gl_FragCoord.xy), 0);
}`;
