#version 330 core
// A wide soft blur in steps: each step samples the last picture around every pixel.
uniform sampler2D u_picture;
uniform vec2 u_step;
in vec2 v_uv;
layout(location = 0) out vec4 f_colour;

void main() {
    vec3 sum = texture(u_picture, v_uv).rgb * 0.2;
    for (int i = 0; i < 4; ++i) {
        vec2 way = vec2(i < 2 ? -1.0 : 1.0, i % 2 == 0 ? -1.0 : 1.0);
        sum += texture(u_picture, v_uv + way * u_step).rgb * 0.2;
    }
    f_colour = vec4(min(sum, vec3(8.0)), 1.0);
}
