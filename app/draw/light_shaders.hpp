#pragma once

/// The shaders of the light level, OpenGL 3.3 (GLSL 330): as little a pixel as looks right, since software runs both
/// branches of an if. Noise is worked out at the corners; gamma is 2, a square root.
namespace app::draw::light_shaders {

inline constexpr char vertex[] = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 direction;
uniform mat4 clip_from_world, shadow_from_world, model;
uniform float texel;
out vec3 world, normal, shade;
#ifdef FLESH
out float tone;  // blotches
float noise(vec3 p) {
    vec3 s = sin(p * vec3(1.7, 2.9, 2.3) + 1.3 * sin(p.yzx * vec3(2.1, 1.3, 1.9)));
    return 0.5 + (s.x + s.y + s.z) / 6.0;
}
#endif
void main() {
    world = (model * vec4(position, 1)).xyz;
    normal = mat3(model) * direction;
    shade = 0.5 * (shadow_from_world * vec4(world + normal * 2.0 * texel, 1)).xyz + 0.5;
#ifdef FLESH
    tone = 0.85 + 0.3 * noise(world * 700.0);
#endif
    gl_Position = clip_from_world * vec4(world, 1);
})";

/// Comes before each of the fragment shaders below.
inline constexpr char lamps[] = R"(
in vec3 world, normal, shade;
#ifdef FLESH
in float tone;
const float in_shadow = 0.3;  // light comes through flesh
#else
const float tone = 1.0, in_shadow = 0.12;
#endif
out vec4 color;
uniform vec3 eye, to_key, to_fill, camera_up, base;
uniform sampler2DShadow shadow;
vec3 matt(vec3 n, float key, float open) {
    float fill = 0.26 + 0.10 * dot(n, to_fill) + 0.08 * dot(n, camera_up);
    return base * tone * (vec3(0.95, 0.92, 0.87) * (key * mix(in_shadow, 1.0, open)) + vec3(0.85, 0.95, 1.0) * fill);
}
float highlight(vec3 n, vec3 v) {
    float s = max(dot(n, normalize(v + to_key)), 0.0);
    s *= s; s *= s; s *= s; s *= s; s *= s;
    return s * s;
}
vec4 shown(vec3 light) {
    return vec4(sqrt(clamp(light * (1.0 + 0.15 * light) / (1.0 + 0.35 * light), 0.0, 1.0)), 1);
}
)";

inline constexpr char matt_fragment[] = R"(
uniform float gloss, wrap;
uniform bool sheet;
void main() {
    vec3 n = normalize(normal), v = normalize(eye - world);
#ifdef FLESH
    n = sheet && !gl_FrontFacing ? -n : n;
    n = normalize(n - min(dot(n, v), 0.0) * v);
#endif
    float open = texture(shadow, shade), key = max((dot(n, to_key) + wrap) / (1.0 + wrap), 0.0);
    color = shown(matt(n, key, open) + gloss * open * highlight(n, v));
})";

// Cloth is lit at its corners, which lie close enough for its folds; each pixel only blends. Shadows on it are drawn as
// what casts them, laid flat along the key light (`flat_at`: the height of the cloth).
inline constexpr char cloth_vertex[] = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 direction;
uniform mat4 clip_from_world, model;
uniform vec3 to_key, to_fill, camera_up, base;
uniform float flat_at, vignette;
out vec3 shown;
void main() {
    vec3 world = (model * vec4(position, 1)).xyz;
    float above = world.z - flat_at, key = 0.88 * max(dot(direction, to_key), 0.0);
    vec3 n = direction;
#ifdef CASTS
    const float thin = 0.00005;  // [m]
    world -= to_key * max(above - thin, 0.0) / to_key.z;
    n = vec3(0, 0, 1);
    key = 0.12 * max(n.z * to_key.z, 0.0);
#else
    key += 0.12 * max(dot(n, to_key), 0.0);
#endif
    gl_Position = clip_from_world * vec4(world, 1);
    vec2 off = clamp(gl_Position.xy / max(gl_Position.w, 1e-6), -1.0, 1.0);
    vec3 light = base * (vec3(0.95, 0.92, 0.87) * key +
                         vec3(0.85, 0.95, 1.0) * (0.26 + 0.10 * dot(n, to_fill) + 0.08 * dot(n, camera_up)));
    shown = sqrt(max(light * (1.0 - vignette * dot(off, off)), 0.0));
})";

inline constexpr char cloth_fragment[] = R"(
in vec3 shown;
out vec4 color;
uniform float alpha;
void main() { color = vec4(shown, alpha); })";

inline constexpr char steel_fragment[] = R"(
void main() {
    vec3 n = normalize(normal), v = normalize(eye - world), r = reflect(-v, n);
    float open = texture(shadow, shade), h = dot(r, camera_up), lamp = clamp(2.5 * dot(r, to_key) - 1.4, 0.0, 1.0);
    float sky = clamp(h + 0.25, 0.0, 1.0), mirror = 0.14 + 0.55 * sky * (2.0 - sky) + 0.5 * lamp * lamp;
    color = shown(0.25 * matt(n, max(dot(n, to_key), 0.0), open) +
                  base * (0.85 * mirror * (0.62 + 0.38 * open)) + 0.4 * open * highlight(n, v));
})";

}  // namespace app::draw::light_shaders
