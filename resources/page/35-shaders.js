// Towards the sun of every picture of the program: from the west-south-west, high up.
const sun = [-0.55, -0.30, 0.78];
const sunWay = `normalize(vec3(${sun.map((x) => x.toFixed(2)).join(', ')}))`;

const shaderHead = '#version 300 es\nprecision highp float;\nprecision highp int;\nprecision highp sampler2D;\n';

// Light of both styles. That of presentation comes from the sun of the program's pictures, and its shadows from a map of depths
// along its rays. Grain is noise over the place at rest, which an element keeps when it falls.
const lightOf = `
uniform bool fine;
uniform bool shadowed;
uniform mat4 sunView;
uniform float sunPart;
uniform highp sampler2DShadow sunDepth;
vec3 normalOf(vec3 at) {
    return normalize(cross(dFdx(at), dFdy(at)));
}
vec3 lit(vec3 colour, vec3 at) {
    float sun = 0.5 + 0.5 * dot(normalOf(at), normalize(vec3(0.35, 0.45, 0.8)));
    return colour * (0.42 + 0.62 * sun);
}
{{grain.glsl}}float sunlight(vec3 at, vec3 normal) {
    float facing = dot(normal, ${sunWay});
    if (facing <= 0.0 || !shadowed) {
        return max(facing, 0.0);
    }
    vec3 seen = 0.5 + 0.5 * (sunView * vec4(at, 1.0)).xyz;
    if (any(lessThan(seen, vec3(0.0))) || any(greaterThan(seen, vec3(1.0)))) {
        return facing;
    }
    return facing * texture(sunDepth, vec3(sunPart * seen.xy, seen.z));
}
vec3 finelyLit(vec3 colour, vec3 at, vec3 normal) {
    return colour * (0.47 + 0.16 * (0.5 + 0.5 * normal.z) + 0.58 * sunlight(at, normal));
}`;

const structureVertex = `${shaderHead}
in vec3 now;
in vec3 next;
in vec4 tint;
in vec3 rest;
uniform mat4 view;
uniform float share;
out vec3 at;
out vec3 origin;
flat out vec4 colour;
void main() {
    at = mix(now, next, share);
    origin = rest;
    colour = tint;
    gl_Position = view * vec4(at, 1.0);
}`;

const pieceVertex = `${shaderHead}
in vec3 place;
in uint body;
in vec4 tint;
in vec3 rest;
uniform mat4 view;
uniform sampler2D poses;
out vec3 at;
out vec3 origin;
flat out vec4 colour;
void main() {
    origin = rest;
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
out vec3 origin;
flat out vec4 colour;
void main() {
    at = place.xyz;
    origin = place.xyz;
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
in vec3 origin;
flat in vec4 colour;
uniform bool unlit;
uniform vec4 ink;
out vec4 pixel;
${lightOf}
${behindTest}
void main() {
    hideBehind();
    if (ink.a > 0.0) {
        pixel = ink;
    } else if (unlit || !fine) {
        pixel = vec4(unlit ? colour.rgb : lit(colour.rgb, at), 1.0);
    } else {
        // How rough the material is stands where others have opacity.
        float tone = grainTone(origin, colour.a);
        pixel = vec4(finelyLit(colour.rgb * tone, at, normalOf(at)), 1.0);
    }
}`;

// Into the map of depths along the rays of the sun.
const depthFragment = `${shaderHead}
void main() {
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

// Ground, water and all that has one colour. What is pictured from above has the colours of that picture where it covers it and
// where it would not be smeared along a steep slope.
const groundFragment = `${shaderHead}
in vec3 at;
uniform vec4 tone;
uniform bool shaded;
uniform int surface;
uniform vec3 eye;
uniform vec4 far;
uniform vec3 horizon;
uniform bool pictured;
uniform vec4 place;
uniform sampler2D photo;
out vec4 pixel;
${lightOf}
${behindTest}
vec4 fromAbove(vec3 normal) {
    vec2 on = (at.xy - place.xy) * place.zw;
    bool seen = all(greaterThan(on, vec2(0.0))) && all(lessThan(on, vec2(1.0))) && 2.0 * abs(normal.z) >= 1.0;
    vec4 found = texture(photo, on);
    return vec4(found.rgb, seen ? found.a : 0.0);
}
void main() {
    hideBehind();
    vec3 normal = normalOf(at);
    vec3 colour = tone.rgb;
    float opacity = tone.a;
    if (!fine) {
        if (shaded) {
            colour = lit(colour, at);
        }
        if (pictured && surface == 1) {
            vec4 found = fromAbove(normal);
            colour = mix(colour, found.rgb, found.a);
        }
        pixel = vec4(colour, opacity);
        return;
    }
    float level = distance(at.xy, far.xy);
    if (surface == 1) {
        colour *= 1.0 + 0.16 * (grainNoise(at * 0.35) - 0.5) + 0.12 * (grainNoise(at * 2.1) - 0.5);
        float light = sunlight(at, normal);
        vec3 earth = colour * (0.42 + 0.22 * (0.5 + 0.5 * normal.z) + 0.5 * light);
        if (pictured) {
            // A picture has its own light; shadows of what stands and falls only take some of it.
            vec4 found = fromAbove(normal);
            earth = mix(earth, found.rgb * (0.72 + 0.36 * light), found.a);
        }
        colour = earth;
    } else if (surface == 2) {
        vec3 way = normalize(at - eye);
        float ripple = 0.5 * (grainNoise(vec3(at.xy * vec2(0.9, 1.7), 0.0)) - 0.5);
        float mirrored = pow(1.0 - min(1.0, abs(way.z)), 3.0);
        colour = mix(colour * (1.0 + 0.25 * ripple), horizon, 0.65 * mirrored);
        colour *= 0.78 + 0.28 * sunlight(at, vec3(0.0, 0.0, 1.0));
        opacity = mix(0.62, 0.94, mirrored);
    } else if (shaded) {
        colour = finelyLit(colour, at, normal);
    }
    if (surface > 0) {
        colour = mix(colour, horizon, smoothstep(far.z, far.w, level));
    }
    pixel = vec4(colour, opacity);
}`;

// From the horizon upwards.
const skyFragment = `${shaderHead}
uniform vec2 room;
uniform vec3 low;
uniform vec3 top;
out vec4 pixel;
void main() {
    pixel = vec4(mix(low, top, clamp((gl_FragCoord.y - room.x) / room.y, 0.0, 1.0)), 1.0);
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
