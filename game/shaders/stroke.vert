#version 330 core
// A line as a screen-space quad; a point is a line of no length.
in vec3 i_start;
in vec3 i_end;
in vec4 i_colour;
in float i_width;
uniform mat4 u_view_projection;
uniform vec2 u_size;
flat out vec4 v_colour;
out vec2 v_across;  // along and across, two units a pixel
flat out vec2 v_size;  // length, half width

void main() {
    vec4 a = u_view_projection * vec4(i_start, 1.0), b = u_view_projection * vec4(i_end, 1.0);
    float nearest = 0.05;  // clip behind the camera before the division
    if (a.w < nearest && b.w > nearest) a = mix(b, a, (b.w - nearest) / (b.w - a.w));
    else if (b.w < nearest && a.w > nearest) b = mix(a, b, (a.w - nearest) / (a.w - b.w));
    bool end = gl_VertexID % 2 == 1;
    float side = gl_VertexID / 2 == 0 ? -1.0 : 1.0;
    vec2 pa = a.xy / a.w * u_size, pb = b.xy / b.w * u_size;
    vec2 way = pb - pa;
    float span = length(way);
    way = span > 1e-4 ? way / span : vec2(1.0, 0.0);
    float half_width = max(i_width * u_size.y / 720.0, 1.0) + 1.0;  // two units a pixel, half a pixel of soft edge
    vec2 shift = (vec2(-way.y, way.x) * side + way * (end ? 1.0 : -1.0)) * half_width;
    vec4 p = end ? b : a;
    p.xy += shift / u_size * p.w;
    p.z -= 0.002 * p.w;
    gl_Position = a.w < nearest && b.w < nearest ? vec4(2.0, 2.0, 2.0, 1.0) : p;
    v_colour = i_colour;
    v_size = vec2(span, half_width);
    v_across = vec2(end ? span + half_width : -half_width, side * half_width);
}
