#version 330 core
// Screen-space ambient occlusion from depth alone (after McGuire et al., Scalable Ambient Obscurance, 2012).
uniform sampler2D u_depth;
uniform vec4 u_lens;   // tan of half the field of view (x, y), near, far
uniform vec2 u_texel;
in vec2 v_uv;
layout(location = 0) out vec4 f_open;

const float RADIUS_M = 0.35;

float away(vec2 uv) {
    float z = texture(u_depth, uv).r * 2.0 - 1.0;
    return 2.0 * u_lens.z * u_lens.w / (u_lens.w + u_lens.z - z * (u_lens.w - u_lens.z));
}

vec3 place(vec2 uv) {
    float d = away(uv);
    return vec3((uv * 2.0 - 1.0) * u_lens.xy * d, d);
}

void main() {
    vec3 here = place(v_uv);
    vec3 right = place(v_uv + vec2(u_texel.x, 0.0)) - here, left = here - place(v_uv - vec2(u_texel.x, 0.0));
    vec3 above = place(v_uv + vec2(0.0, u_texel.y)) - here, below = here - place(v_uv - vec2(0.0, u_texel.y));
    vec3 across = abs(right.z) < abs(left.z) ? right : left, up = abs(above.z) < abs(below.z) ? above : below;
    vec3 normal = normalize(cross(up, across));
    float turn = 6.2831853 * fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
    vec2 reach = min(RADIUS_M / (here.z * u_lens.xy) * 0.5, vec2(0.2));
    float closed = 0.0;
    for (int i = 0; i < OCCLUSION_TAPS; ++i) {
        float part = (float(i) + 0.5) / float(OCCLUSION_TAPS);
        float angle = turn + part * 6.2831853 * 3.0;
        vec3 way = place(v_uv + vec2(cos(angle), sin(angle)) * reach * part) - here;
        float square = dot(way, way);
        float near = max(1.0 - square / (RADIUS_M * RADIUS_M), 0.0);
        closed += near * max(dot(way, normal) - 0.012 - 0.002 * here.z, 0.0) * inversesqrt(square + 1e-4);
    }
    f_open = vec4(clamp(1.0 - 1.9 * closed / float(OCCLUSION_TAPS), 0.0, 1.0), here.z, 0.0, 1.0);
}
