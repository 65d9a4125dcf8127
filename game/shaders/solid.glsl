// One instance of a rounded box: see game/render/meshes.py for the vertex, game/render/instances.py for the row.
layout(location = 0) in vec3 in_sign;
layout(location = 1) in vec3 in_way;
layout(location = 2) in vec3 in_face;
in vec4 i_place;        // position, bevel
in vec4 i_orientation;  // w, x, y, z
in vec4 i_half;         // half size, roughness

vec3 turned(vec3 v) {
    vec3 axis = i_orientation.yzw;
    return v + 2.0 * cross(axis, cross(axis, v) + i_orientation.x * v);
}

vec3 local_position(float inflate) {
    float bevel = min(i_place.w, min(abs(i_half.x), min(abs(i_half.y), abs(i_half.z)))) * sign(i_half.x);
    return in_sign * (i_half.xyz - bevel) + (bevel + inflate) * in_way;
}
