#version 330 core
// What the lamps give to the middle height of the room, seen from above: one look-up for all lamps, where every pixel counts.
uniform vec4 u_lamp[LAMPS];         // position, squared radius
uniform vec3 u_lamp_colour[LAMPS];
uniform vec4 u_floor;
in vec2 v_uv;
layout(location = 0) out vec4 f_plan;

void main() {
    vec3 place = vec3((v_uv - 0.5) / u_floor.z + u_floor.xy, 0.9);
    vec3 light = vec3(0.0);
    for (int i = 0; i < LAMPS; ++i) {
        vec3 way = u_lamp[i].xyz - place;
        light += u_lamp_colour[i] * (0.5 / (dot(way, way) + u_lamp[i].w));
    }
    f_plan = vec4(light * 0.5, 1.0);  // rgb: half the light; a: how open the floor is
}
