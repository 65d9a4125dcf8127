#version 330 core
// One vertex a depth pixel: its code is looked up, placed in the room, and lit by the slope of its neighbours. No attributes.
uniform usampler2D u_codes;
uniform sampler2D u_metres;       // one row, metres of each code, 0 nothing seen
uniform int u_stride;
uniform vec3 u_lens;              // focal length, centre u, centre v, pixels
uniform mat4 u_place;             // camera to world
uniform mat4 u_view_projection;
uniform float u_diameter;         // metres
uniform float u_lines;            // height of the picture times 1 / tan of half the field of view, pixels
uniform float u_reach;
uniform vec3 u_near_colour;
flat out vec4 v_colour;

const vec3 MIDDLE = vec3(0.16, 0.62, 0.48), FAR = vec3(0.08, 0.2, 0.7);

float depth_at(ivec2 pixel) {
    ivec2 size = textureSize(u_codes, 0);
    if (any(lessThan(pixel, ivec2(0))) || any(greaterThanEqual(pixel, size))) return 0.0;
    int code = int(texelFetch(u_codes, pixel, 0).r);
    return code < textureSize(u_metres, 0).x ? texelFetch(u_metres, ivec2(code, 0), 0).r : 0.0;
}

vec3 camera_point(ivec2 pixel, float z) {
    return vec3((u_lens.yz - vec2(pixel)) * z / u_lens.x, z);
}

void main() {
    ivec2 size = textureSize(u_codes, 0);
    int across = (size.x + u_stride - 1) / u_stride;
    ivec2 pixel = ivec2(gl_VertexID % across, gl_VertexID / across) * u_stride;
    float z = depth_at(pixel);
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    gl_PointSize = 1.0;
    v_colour = vec4(0.0);
    if (z <= 0.0 || z > u_reach) return;
    vec3 here = camera_point(pixel, z);

    const int step = 8;           // the codes are coarse: neighbours are too near to show a slope
    float right = depth_at(pixel + ivec2(step, 0)), left = depth_at(pixel - ivec2(step, 0));
    float below = depth_at(pixel + ivec2(0, step)), above = depth_at(pixel - ivec2(0, step));
    float jump = 0.04 * z;
    float lit = 0.8;
    if (right > 0.0 && left > 0.0 && below > 0.0 && above > 0.0 && abs(right - left) < 2.0 * jump && abs(below - above) < 2.0 * jump) {
        vec3 du = camera_point(pixel + ivec2(step, 0), right) - camera_point(pixel - ivec2(step, 0), left);
        vec3 dv = camera_point(pixel + ivec2(0, step), below) - camera_point(pixel - ivec2(0, step), above);
        vec3 normal = normalize(cross(du, dv));
        lit = 0.5 + 0.5 * abs(dot(normal, normalize(vec3(0.35, 0.55, -0.75))));
    }
    float away = clamp((z - 0.8) / 3.2, 0.0, 1.0);
    vec3 colour = away < 0.5 ? mix(u_near_colour, MIDDLE, 2.0 * away) : mix(MIDDLE, FAR, 2.0 * away - 1.0);

    gl_Position = u_view_projection * (u_place * vec4(here, 1.0));
    gl_PointSize = clamp(u_diameter * u_lines / max(gl_Position.w, 0.05), 1.0, 24.0);
    v_colour = vec4(colour * lit, 1.0);
}
