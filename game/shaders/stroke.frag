#version 330 core
flat in vec4 v_colour;
in vec2 v_across;
flat in float v_length;
layout(location = 0) out vec4 f_colour;

void main() {
    vec2 from_axis = vec2(v_across.x - clamp(v_across.x, 0.0, v_length), v_across.y);
    float distance = length(from_axis);
    float cover = 1.0 - smoothstep(1.0 - fwidth(distance) * 1.2, 1.0, distance);
    if (cover <= 0.0) discard;
    f_colour = vec4(v_colour.rgb, v_colour.a * cover);
}
