#pragma once

/// The shaders, OpenGL 3.3 (GLSL 330). World in metres; colours are worked out in light and kept as a screen wants
/// them.
namespace app::draw::shaders {

inline constexpr char solid_vertex[] = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 direction;
uniform mat4 clip_from_world, model;
out vec3 world, normal;
void main() {
    world = (model * vec4(position, 1)).xyz;
    normal = mat3(model) * direction;
    gl_Position = clip_from_world * vec4(world, 1);
})";

inline constexpr char nothing_fragment[] = "void main() {}";

inline constexpr char solid_fragment[] = R"(
in vec3 world, normal;
out vec4 color;
uniform vec3 eye, to_key, to_fill, to_rim, camera_up, base;
uniform float gloss, sharpness, wrap, texel;  // wrap: light goes a little way round through flesh
// texel: width of one of the shadow's [m]
uniform bool sheet;
uniform mat4 shadow_from_world;
uniform sampler2DShadow shadow;
#ifdef FLESH
const float in_shadow = 0.3;  // light comes through flesh
#else
const float in_shadow = 0.12;
#endif

float hash(vec3 p) {
    p = fract(p * vec3(0.1031, 0.1030, 0.0973));
    p += dot(p, p.yxz + 33.33);
    return fract((p.x + p.y) * p.z);
}
float noise(vec3 p) {  // values at whole numbers, blended
    vec3 i = floor(p), f = fract(p);
    f = f * f * (3.0 - 2.0 * f);
    vec4 low = vec4(hash(i), hash(i + vec3(1, 0, 0)), hash(i + vec3(0, 1, 0)), hash(i + vec3(1, 1, 0)));
    vec4 high = vec4(hash(i + vec3(0, 0, 1)), hash(i + vec3(1, 0, 1)),
                     hash(i + vec3(0, 1, 1)), hash(i + vec3(1, 1, 1)));
    vec4 v = mix(low, high, f.z);
    return mix(mix(v.x, v.y, f.x), mix(v.z, v.w, f.x), f.y);
}
float tissue(vec3 p) { return noise(p * vec3(0.7, 1.6, 1.6)) + 0.5 * noise(p * 3.1) + 0.25 * noise(p * 7.3); }

float lit_by_key(vec3 n) {
    vec4 p = shadow_from_world * vec4(world + n * 2.0 * texel, 1);
    vec3 at = 0.5 * p.xyz + 0.5;
    if (any(lessThan(at, vec3(0))) || any(greaterThan(at, vec3(1)))) return 1.0;
    float sum = 0.0;
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) sum += texture(shadow, at + vec3(vec2(x, y) * 1.6 / 2048.0, 0));
    return sum / 9.0;
}

float highlight(vec3 n, vec3 v, vec3 l) { return pow(max(dot(n, normalize(v + l)), 0.0), sharpness) * gloss; }

// The theatre as steel mirrors it: a bright ceiling of lamps, a soft wall, a dark floor.
float surroundings(vec3 r) {
    float h = dot(r, camera_up), key = dot(r, to_key);
    return 0.16 + 0.55 * smoothstep(-0.25, 0.75, h) + 0.5 * smoothstep(0.55, 0.95, key) -
           0.12 * smoothstep(0.35, 0.0, abs(h + 0.15)) + 0.22 * smoothstep(0.6, 0.95, dot(r, to_rim));
}

void main() {
    vec3 n = normalize(normal), v = normalize(eye - world), albedo = base;
#ifdef FLESH
    // A face that folds over in a crease keeps the light of its surroundings; of a sheet both sides are seen.
    if (sheet && !gl_FrontFacing) n = -n;
    n = normalize(n - min(dot(n, v), 0.0) * v);
#endif
#ifdef FLESH
    {
        vec3 mm = world * 1000.0;
        const float h = 0.06;
        float t = tissue(mm);
        vec3 slope = vec3(tissue(mm + vec3(h, 0, 0)), tissue(mm + vec3(0, h, 0)), tissue(mm + vec3(0, 0, h))) - t;
        n = normalize(n - 0.03 / h * (slope - dot(slope, n) * n));
        albedo *= mix(vec3(0.72, 0.55, 0.55), vec3(1.25, 1.2, 1.15), t / 1.75);
    }
#endif
    float facing = dot(n, to_key), open = lit_by_key(n);
    float key = max((facing + wrap) / (1.0 + wrap), 0.0) * mix(in_shadow, 1.0, open);
    float fill = 0.5 + 0.5 * dot(n, to_fill), sky = 0.5 + 0.5 * dot(n, camera_up);
    vec3 matt = albedo * (vec3(1.0, 0.97, 0.92) * key * 0.95 + vec3(0.80, 0.90, 1.0) * (0.20 * fill + 0.16 * sky));
    float edge = pow(1.0 - max(dot(n, v), 0.0), 4.0);
    vec3 shine = vec3(highlight(n, v, to_key) * open + 0.2 * highlight(n, v, to_fill)) +
                 (0.25 * gloss + 0.05) * edge * max(dot(n, to_rim) + 0.4, 0.0);
#ifdef STEEL
    vec3 mirror = albedo * surroundings(reflect(-v, n)) * mix(0.62, 1.0, open) + vec3(0.3 * edge);
    matt = 0.25 * matt + 0.85 * mirror;
#endif
    vec3 light = matt + shine;
    light = light * (1.0 + 0.15 * light) / (1.0 + 0.35 * light);  // highlights bend over instead of burning out
    color = vec4(pow(clamp(light, 0.0, 1.0), vec3(1.0 / 2.2)), 1);
})";

// A tool that is not there: its outline, so that what lies behind is seen.
inline constexpr char ghost_fragment[] = R"(
in vec3 world, normal;
out vec4 color;
uniform vec3 eye;
void main() {
    float edge = 1.0 - abs(dot(normalize(normal), normalize(eye - world)));
    color = vec4(mix(vec3(0.34, 0.71, 0.91), vec3(0.92, 0.98, 1.0), edge), 0.22 + 0.6 * edge * edge);
})";

// Marks that lamps do not light, at both levels.
inline constexpr char mark_fragment[] = R"(
in vec3 world, normal;
out vec4 color;
uniform vec3 eye;
uniform vec4 tint;
uniform float soft;
void main() {
    float facing = abs(dot(normalize(normal), normalize(eye - world)));
    color = vec4(tint.rgb, tint.a * mix(1.0, facing * facing * facing, soft));
})";

inline constexpr char screen_vertex[] = R"(
out vec2 place;  // 0 to 1 from the lower left
void main() {  // one triangle that covers the picture, at the far end
    place = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);
    gl_Position = vec4(place * 2.0 - 1.0, 1, 1);
})";

inline constexpr char background_fragment[] = R"(
in vec2 place;
out vec4 color;
void main() {
    float from_lamp = length((place - vec2(0.45, 0.62)) * vec2(1.0, 0.8));
    color = vec4(mix(vec3(0.80, 0.855, 0.85), vec3(0.44, 0.545, 0.555), smoothstep(0.0, 0.85, from_lamp)), 0);
})";

// Mean of the fine pixels, darkened where near surfaces stand close in front of one (Alchemy's ambient obscurance,
// McGuire et al. 2011, equation 10).
inline constexpr char final_fragment[] = R"(
out vec4 color;
uniform sampler2D fine, fine_depth;
uniform vec3 lens;    // tan of half the field, across and up
uniform vec3 planes;  // near, far [m]; reach [m]
uniform ivec2 corner; // of the picture in what is drawn on

float depth_at(ivec2 p) {
    float d = texelFetch(fine_depth, p, 0).x * 2.0 - 1.0;
    return 2.0 * planes.x * planes.y / (planes.y + planes.x - d * (planes.y - planes.x));
}
vec3 point_at(ivec2 p, vec2 size) {
    float d = depth_at(p);
    return vec3(((vec2(p) + 0.5) / size * 2.0 - 1.0) * lens.xy * d, -d);
}
vec3 shorter(vec3 a, vec3 b) { return dot(a, a) < dot(b, b) ? a : b; }

float openness(ivec2 p, ivec2 last) {
    vec2 size = vec2(last + 1);
    vec3 c = point_at(p, size);
    vec3 right = shorter(point_at(min(p + ivec2(1, 0), last), size) - c,
                         c - point_at(max(p - ivec2(1, 0), ivec2(0)), size));
    vec3 up = shorter(point_at(min(p + ivec2(0, 1), last), size) - c,
                      c - point_at(max(p - ivec2(0, 1), ivec2(0)), size));
    vec3 n = normalize(cross(right, up));
    float sum = 0.0, reach = planes.z * size.y / (2.0 * lens.y * -c.z);  // [fine pixels]
    for (int i = 0; i < 18; ++i) {
        float turn = 2.399963 * float(i), far = sqrt((float(i) + 0.5) / 18.0);  // sunflower
        ivec2 q = p + ivec2(vec2(cos(turn), sin(turn)) * far * reach);
        if (any(lessThan(q, ivec2(0))) || any(greaterThan(q, last))) continue;
        vec3 to = point_at(q, size) - c;
        float near = max(1.0 - dot(to, to) / (4.0 * planes.z * planes.z), 0.0);
        sum += near * max(dot(to, n) / (length(to) + 0.02 * planes.z) - 0.3, 0.0);
    }
    return clamp(1.0 - 1.3 * sum / 18.0, 0.45, 1.0);
}

void main() {
    ivec2 p = (ivec2(gl_FragCoord.xy) - corner) * 2, last = textureSize(fine, 0) - 1;
    vec3 mean = vec3(0);
    bool solid = true;  // cloth and background have no corners; alpha tells
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 2; ++x) {
            vec4 sample = texelFetch(fine, p + ivec2(x, y), 0);
            mean += 0.25 * sample.rgb;
            solid = solid && sample.a > 0.5;
        }
    if (solid) mean *= openness(p, last);
    color = vec4(mean, 1);
})";

}  // namespace app::draw::shaders
