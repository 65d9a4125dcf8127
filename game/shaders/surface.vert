#version 330 core
#include "solid.glsl"
in vec4 i_colour;
in vec2 i_stuff;  // emission, material
uniform mat4 u_view_projection;
uniform mat4 u_light;
uniform float u_inflate;
uniform float u_shadow_texel;
out vec3 v_position;
out vec3 v_normal;
out vec3 v_shadow;
out vec2 v_uv;
flat out vec4 v_colour;
flat out vec3 v_stuff;  // roughness, emission, material

// metres that one repeat of planks, wood, plaster, fabric covers
const float REPEAT[5] = float[5](1.0, 2.4, 1.2, 1.6, 0.3);

float scatter(vec3 p) { return fract(sin(dot(p, vec3(12.9898, 78.233, 37.719))) * 43758.5453); }

vec2 surface_coordinates(vec3 p) {
    vec3 face = abs(in_face);
    vec3 size = abs(i_half.xyz);
    vec2 at = face.x > 0.5 ? p.yz : face.y > 0.5 ? p.xz : p.xy;
    vec2 extent = face.x > 0.5 ? size.yz : face.y > 0.5 ? size.xz : size.xy;
    int material = int(i_stuff.y + 0.5);
    if (material > 4) {
        vec2 uv = at / extent * 0.5 + 0.5;
        if (face.x > 0.5 && in_face.x * i_half.x > 0.0) uv.x = 1.0 - uv.x;
        if (material == 6) {  // four paintings on one sheet
            float pick = mod(floor(dot(abs(i_place.xyz), vec3(3.0, 7.0, 5.0))), 4.0);
            uv = (clamp(uv, 0.01, 0.99) + vec2(mod(pick, 2.0), floor(pick / 2.0))) * 0.5;
        }
        return uv;
    }
    if (material == 2 && extent.y > extent.x) at = at.yx;  // the grain runs along the board
    float shift = material == 1 ? 0.0 : scatter(i_place.xyz);
    return at / REPEAT[material] + shift * vec2(1.0, 1.618);
}

void main() {
    vec3 p = local_position(u_inflate);
    v_position = i_place.xyz + turned(p);
    v_normal = turned(in_way);
    vec4 in_light = u_light * vec4(v_position + v_normal * 0.012, 1.0);
    v_shadow = vec3(in_light.xy * (0.5 - u_shadow_texel), in_light.z * 0.5) + 0.5;  // the rim of the map stays empty
    v_uv = surface_coordinates(p);
    v_colour = i_colour;
    v_stuff = vec3(i_half.w, i_stuff);
    gl_Position = u_view_projection * vec4(v_position, 1.0);
}
