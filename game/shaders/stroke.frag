#version 330 core
flat in vec4 v_colour;
in vec2 v_across;
flat in vec2 v_size;
layout(location = 0) out vec4 f_colour;

void main() {
    vec2 from_axis = vec2(v_across.x - clamp(v_across.x, 0.0, v_size.x), v_across.y);
    float cover = clamp((v_size.y - length(from_axis)) * 0.5, 0.0, 1.0);
    if (cover <= 0.0) discard;
    f_colour = vec4(v_colour.rgb, v_colour.a * cover);
}
