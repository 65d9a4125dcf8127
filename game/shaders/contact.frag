#version 330 core
in vec2 v_at;
flat in vec3 v_extent;
flat in float v_strength;
layout(location = 0) out vec4 f_light;

float covered(float at, float half_size, float soft) {
    return smoothstep(-soft, soft, at + half_size) - smoothstep(-soft, soft, at - half_size);
}

void main() {
    float shade = covered(v_at.x, v_extent.x, v_extent.z) * covered(v_at.y, v_extent.y, v_extent.z);
    f_light = vec4(1.0 - v_strength * shade);
}
