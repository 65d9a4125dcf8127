#version 330 core
// From linear light to the screen: glow, exposure, film curve, vignette, sRGB.
uniform sampler2D u_picture;
uniform sampler2D u_glow;
uniform float u_exposure;
uniform float u_saturation;
uniform float u_vignette;
uniform float u_glow_strength;
uniform float u_aspect;
in vec2 v_uv;
layout(location = 0) out vec4 f_colour;

// Stephen Hill's fit of the ACES reference rendering
const mat3 INTO = mat3(0.59719, 0.07600, 0.02840, 0.35458, 0.90834, 0.13383, 0.04823, 0.01566, 0.83777);
const mat3 OUT_OF = mat3(1.60475, -0.10208, -0.00327, -0.53108, 1.10813, -0.07276, -0.07367, -0.00605, 1.07602);

vec3 film(vec3 colour) {
    vec3 v = INTO * colour;
    v = (v * (v + 0.0245786) - 0.000090537) / (v * (0.983729 * v + 0.4329510) + 0.238081);
    return clamp(OUT_OF * v, 0.0, 1.0);
}

// within 0.001 of the sRGB curve, without powers (after I. Taylor)
vec3 encoded(vec3 c) {
    vec3 s1 = sqrt(c), s2 = sqrt(s1), s3 = sqrt(s2);
    return 0.662002687 * s1 + 0.684122060 * s2 - 0.323583601 * s3 - 0.0225411470 * c;
}

void main() {
    vec3 colour = texture(u_picture, v_uv).rgb;
#if GLOW
    colour = mix(colour, texture(u_glow, v_uv).rgb, u_glow_strength);
#endif
    vec2 off = (v_uv - 0.5) * vec2(mix(1.0, u_aspect, 0.5), 1.0);
    colour *= u_exposure * (1.0 - u_vignette * dot(off, off) * 1.6);
    colour = film(colour);
    colour = mix(vec3(dot(colour, vec3(0.2126, 0.7152, 0.0722))), colour, u_saturation);
    colour = encoded(clamp(colour, 0.0, 1.0));
    float grain = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))) - 0.5;
    f_colour = vec4(colour + grain / 255.0, 1.0);
}
