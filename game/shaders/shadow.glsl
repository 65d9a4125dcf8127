// How much of the main light arrives, 0 to 1.
#if SHADOW_TAPS > 1
const vec2 SPIRAL[16] = vec2[16](
    vec2(0.177, 0.0), vec2(-0.226, 0.207), vec2(0.035, -0.394), vec2(0.285, 0.371),
    vec2(-0.522, -0.092), vec2(0.494, -0.315), vec2(-0.165, 0.615), vec2(-0.315, -0.607),
    vec2(0.683, 0.250), vec2(-0.712, 0.294), vec2(0.343, -0.734), vec2(0.252, 0.809),
    vec2(-0.757, -0.445), vec2(0.896, -0.197), vec2(-0.537, 0.779), vec2(-0.122, -0.977));

float speckle() { return fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))); }
#endif

float shadow_light(float toward) {
    float bias = u_shadow_texel * 0.6 * (1.5 - toward);
#if SHADOW_TAPS == 1
    return texture(u_shadow_map, vec3(v_shadow.xy, v_shadow.z - bias));
#else
    float turn = speckle() * 6.2831853;
    mat2 spin = mat2(cos(turn), sin(turn), -sin(turn), cos(turn));
    float reach = u_shadow_texel * 3.0;
#if SOFT_SHADOWS
    // percentage-closer soft shadows: the farther the blocker, the wider the penumbra
    float search = u_shadow_texel * 14.0;
    float blockers = 0.0, depth = 0.0;
    for (int i = 0; i < 16; i += 2) {
        float near = texture(u_shadow_depth, v_shadow.xy + spin * SPIRAL[i] * search).r;
        if (near < v_shadow.z - bias) { blockers += 1.0; depth += near; }
    }
    if (blockers < 0.5) return 1.0;
    reach = clamp((v_shadow.z - depth / blockers) * 0.10, u_shadow_texel * 1.5, u_shadow_texel * 26.0);
#endif
    float sum = 0.0;
    for (int i = 0; i < SHADOW_TAPS; ++i)
        sum += texture(u_shadow_map, vec3(v_shadow.xy + spin * SPIRAL[i] * reach, v_shadow.z - bias - reach * 0.25));
    return sum / float(SHADOW_TAPS);
#endif
}
