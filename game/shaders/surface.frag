#version 330 core
uniform sampler2DArray u_materials;
uniform sampler2DShadow u_shadow_map;
uniform sampler2D u_shadow_depth;
uniform sampler2D u_contact;
uniform sampler2D u_occlusion;
uniform vec3 u_eye;
uniform vec3 u_to_light;
uniform vec3 u_key;
uniform vec3 u_sky;
uniform vec3 u_ground;
uniform vec3 u_fill;
uniform vec3 u_to_fill;
uniform vec3 u_rim;
uniform vec4 u_lamp[LAMPS];        // position, radius
uniform vec3 u_lamp_colour[LAMPS];
uniform vec2 u_occlusion_scale; // 1 / size of the picture
uniform float u_ambient_occlusion;
uniform float u_shadow_texel;
uniform vec4 u_floor;           // centre x, y and 1 / extent of the contact map
in vec3 v_position;
in vec3 v_normal;
in vec3 v_shadow;
in vec2 v_uv;
flat in vec4 v_colour;
flat in vec3 v_stuff;
layout(location = 0) out vec4 f_colour;

#include "shadow.glsl"

void main() {
    vec3 normal = normalize(v_normal);
    vec3 view = normalize(u_eye - v_position);
    float facing = max(dot(normal, view), 0.0);
    float grazing = 1.0 - facing;
#ifdef GHOST
    float edge = grazing * grazing;
    vec3 lit = v_colour.rgb * (0.55 + 0.35 * normal.z + 1.6 * edge);
    f_colour = vec4(lit, v_colour.a * (0.35 + 0.65 * edge));
#else
    vec4 stuff = texture(u_materials, vec3(v_uv, v_stuff.z));
    vec3 albedo = v_colour.rgb * stuff.rgb * stuff.rgb;
    float roughness = clamp(v_stuff.x * stuff.a * 2.0, 0.08, 1.0);

    vec4 plan = texture(u_contact, (v_position.xy - u_floor.xy) * u_floor.z + 0.5);
    float open = mix(plan.a, 1.0, clamp(v_position.z * 4.0, 0.0, 1.0));
#if OCCLUSION
    open *= texture(u_occlusion, gl_FragCoord.xy * u_occlusion_scale).r;
#endif
    open = mix(1.0, open, u_ambient_occlusion);

    float toward = max(dot(normal, u_to_light), 0.0);
    float sun = toward > 0.0 ? shadow_light(toward) : 0.0;
    vec3 light = u_key * (toward * sun) * mix(1.0, open, 0.35);
    light += (mix(u_ground, u_sky, normal.z * 0.5 + 0.5) + u_fill * (0.55 + 0.45 * dot(normal, u_to_fill))) * open;
#if GLOSS
    for (int i = 0; i < LAMPS; ++i) {
        vec3 way = u_lamp[i].xyz - v_position;
        float square = dot(way, way);
        float wrapped = max(dot(normal, way) * inversesqrt(square) * 0.7 + 0.3, 0.0);
        light += u_lamp_colour[i] * (wrapped * open / (square + u_lamp[i].w));
    }
#else
    light += plan.rgb * (2.4 - 0.7 * abs(v_position.z - 1.2));
#endif
    vec3 colour = albedo * light;

    float grazing5 = grazing * grazing; grazing5 *= grazing5 * grazing;
    float smooth_part = 1.0 - roughness;
#if GLOSS
    vec3 half_way = normalize(view + u_to_light);
    float spread = roughness * roughness;
    float spread2 = spread * spread;
    float peak = max(dot(normal, half_way), 0.0);
    float bend = max(dot(u_to_light, half_way), 0.1);
    float lobe = peak * peak * (spread2 - 1.0) + 1.0;
    float shine = spread2 / (lobe * lobe * bend * bend * (roughness * 4.0 + 2.0));
    colour += u_key * (min(shine, 12.0) * 0.04 * toward * sun);
#endif
    vec3 mirrored = reflect(-view, normal);
    vec3 around = mix(u_ground, u_sky, mirrored.z * 0.5 + 0.5);
#if GLOSS
    for (int i = 0; i < LAMPS; ++i) {  // soft images of the lamps in whatever is smooth
        vec3 way = u_lamp[i].xyz - v_position;
        float along = max(dot(way, mirrored), 0.0);
        vec3 miss = way - mirrored * along;
        float blur = 0.02 + spread * along * along;
        around += u_lamp_colour[i] * exp(-dot(miss, miss) / (u_lamp[i].w + blur)) / (1.0 + 6.0 * blur);
    }
#endif
    colour += around * ((0.04 + smooth_part * smooth_part * grazing5) * smooth_part * open * 1.2);
    colour += u_rim * (grazing * grazing * grazing * (0.35 + 0.65 * max(normal.z, 0.0)) * open) * (0.25 + albedo);
    colour += albedo * v_stuff.y;
    f_colour = vec4(colour, 1.0);
#endif
}
