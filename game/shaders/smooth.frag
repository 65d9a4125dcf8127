#version 330 core
// Averages the speckle of the occlusion over 4 x 4 pixels of about the same depth.
uniform sampler2D u_picture;
uniform vec2 u_texel;
in vec2 v_uv;
layout(location = 0) out vec4 f_open;

void main() {
    float here = texture(u_picture, v_uv).g;
    float sum = 0.0, weights = 1e-4;
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x) {
            vec2 near = texture(u_picture, v_uv + (vec2(x, y) - 1.5) * u_texel).rg;
            float weight = max(1.0 - abs(near.g - here) * 8.0 / here, 0.02);
            sum += near.r * weight;
            weights += weight;
        }
    f_open = vec4(sum / weights);
}
