#version 330 core
#include "solid.glsl"
uniform mat4 u_view_projection;

void main() {
    gl_Position = u_view_projection * vec4(i_place.xyz + turned(local_position(0.0)), 1.0);
}
