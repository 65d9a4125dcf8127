#version 330 core
// Draws, seen from above, the darkening that each solid near the floor casts on it.
in vec4 i_place;
in vec4 i_orientation;
in vec4 i_half;
uniform vec4 u_floor;
out vec2 v_at;
flat out vec3 v_extent;  // half sizes of the footprint, softness
flat out float v_strength;

vec3 turned(vec3 v) {
    vec3 axis = i_orientation.yzw;
    return v + 2.0 * cross(axis, cross(axis, v) + i_orientation.x * v);
}

void main() {
    vec3 x = turned(vec3(1, 0, 0)), y = turned(vec3(0, 1, 0)), z = turned(vec3(0, 0, 1));
    vec3 up = abs(vec3(x.z, y.z, z.z));
    float height = max(i_place.z - dot(up, i_half.xyz), 0.0);
    vec2 a = x.xy, b = y.xy, half_size = i_half.xy;
    float more = up.z;
    if (up.x > up.y && up.x > up.z) { a = y.xy; b = z.xy; half_size = i_half.yz; }
    else if (up.y > up.z) { a = z.xy; b = x.xy; half_size = i_half.zx; }
    a = normalize(a + vec2(1e-6, 0.0));
    b = vec2(-a.y, a.x);
    float soft = 0.05 + 0.55 * height;
    vec2 corner = vec2(gl_VertexID % 2, gl_VertexID / 2) * 2.0 - 1.0;
    v_extent = vec3(half_size, soft);
    v_at = corner * (half_size + 2.0 * soft);
    bool flat_thing = i_half.x < 0.0 || dot(up, i_half.xyz) < 0.02 || max(half_size.x, half_size.y) > 1.6;
    v_strength = flat_thing || height > 0.6 ? 0.0 : 0.8 / (1.0 + 14.0 * height * height + 3.0 * height);
    vec2 place = i_place.xy + a * v_at.x + b * v_at.y;
    gl_Position = v_strength > 0.0 ? vec4((place - u_floor.xy) * u_floor.z * 2.0, 0.0, 1.0) : vec4(2.0, 2.0, 2.0, 1.0);
}
