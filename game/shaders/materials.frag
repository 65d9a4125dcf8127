#version 330 core
// Paints one sheet of each material (see MATERIALS in game/drawables.py), one above the other.
// rgb: square root of the albedo; a: half of what multiplies the roughness. Every sheet repeats at its edges.
uniform float u_sheets;
in vec2 v_uv;
layout(location = 0) out vec4 f_stuff;

float scatter(vec2 p) { return fract(sin(dot(p, vec2(12.9898, 78.233))) * 43758.5453); }

float noise(vec2 p, vec2 period) {
    vec2 cell = floor(p), t = fract(p);
    t = t * t * (3.0 - 2.0 * t);
    vec2 a = mod(cell, period), b = mod(cell + 1.0, period);
    return mix(mix(scatter(a), scatter(vec2(b.x, a.y)), t.x), mix(scatter(vec2(a.x, b.y)), scatter(b), t.x), t.y);
}

float cloud(vec2 uv, vec2 period) {
    float sum = 0.0, weight = 0.5;
    for (int i = 0; i < 4; ++i) {
        sum += weight * noise(uv * period, period);
        period *= 2.0;
        weight *= 0.5;
    }
    return sum / 0.9375;
}

vec4 grain(vec2 uv, vec2 period, vec3 dark, vec3 light) {
    float streak = cloud(uv, period) * 0.65 + cloud(uv.xy, period * vec2(0.5, 4.0)) * 0.35;
    return vec4(mix(dark, light, smoothstep(0.25, 0.75, streak)), 0.42 + 0.16 * streak);
}

vec4 planks(vec2 uv) {
    const float ROWS = 16.0;
    float row = floor(uv.y * ROWS);
    float along = fract(uv.x + scatter(vec2(row, 3.0))) * 2.0;
    float plank = floor(along);
    float tone = scatter(vec2(row, plank + 7.0));
    vec4 wood = grain(uv + vec2(tone, 0.0), vec2(6.0, 96.0), vec3(0.30, 0.165, 0.08), vec3(0.50, 0.30, 0.16));
    wood.rgb *= 0.78 + 0.44 * tone;
    wood.rgb = mix(wood.rgb, wood.rgb * vec3(1.12, 0.96, 0.84), scatter(vec2(tone, row)));
    vec2 edge = vec2(abs(fract(along) - 0.5) * 1.2, abs(fract(uv.y * ROWS) - 0.5) * 2.4 / ROWS);
    float gap = smoothstep(0.0, 0.004, min(0.6 - edge.x, 1.2 / ROWS - edge.y));
    wood.rgb *= mix(0.35, 1.0, gap);
    wood.a += 0.2 * (1.0 - gap);
    return wood;
}

vec4 rug(vec2 uv) {
    vec2 at = abs(uv - 0.5) * 2.0;
    float border = max(at.x, at.y);
    const vec3 CREAM = vec3(0.76, 0.66, 0.52), RUST = vec3(0.50, 0.15, 0.07), TEAL = vec3(0.05, 0.19, 0.21), NIGHT = vec3(0.045, 0.06, 0.10);
    vec3 colour = CREAM;
    vec2 tile = fract(uv * 5.0) - 0.5;
    float diamond = abs(tile.x) + abs(tile.y);
    vec3 inner = mod(floor(uv.x * 5.0) + floor(uv.y * 5.0), 2.0) > 0.5 ? RUST : TEAL;
    colour = mix(colour, inner, 1.0 - smoothstep(0.37, 0.385, diamond));
    colour = mix(colour, CREAM, 1.0 - smoothstep(0.23, 0.245, diamond));
    colour = mix(colour, mix(RUST, vec3(0.60, 0.33, 0.07), 0.7), 1.0 - smoothstep(0.13, 0.145, diamond));
    colour = mix(colour, NIGHT, smoothstep(0.80, 0.805, border));
    colour = mix(colour, CREAM, smoothstep(0.83, 0.835, border) * (1.0 - smoothstep(0.855, 0.86, border)));
    colour = mix(colour, RUST, smoothstep(0.90, 0.905, border));
    float weave = noise(uv * 256.0, vec2(256.0)) * 0.22 + cloud(uv, vec2(12.0)) * 0.3;
    return vec4(colour * (0.74 + weave), 0.5);
}

vec4 painting(vec2 uv) {
    vec2 sheet = floor(uv * 2.0), at = fract(uv * 2.0);
    float which = sheet.x + 2.0 * sheet.y;
    vec3 paper = vec3(0.80, 0.74, 0.63), colour = paper;
    vec2 p = at - 0.5;
    if (which < 0.5) {  // sun over hills
        colour = mix(vec3(0.80, 0.42, 0.20), vec3(0.86, 0.70, 0.48), at.y);
        colour = mix(colour, vec3(0.75, 0.16, 0.07), 1.0 - smoothstep(0.17, 0.18, length(p - vec2(0.1, 0.12))));
        colour = mix(colour, vec3(0.07, 0.20, 0.22), step(at.y, 0.34 + 0.09 * sin(at.x * 6.0)));
        colour = mix(colour, vec3(0.03, 0.09, 0.13), step(at.y, 0.20 + 0.07 * sin(at.x * 5.0 + 2.0)));
    } else if (which < 1.5) {  // arches
        float ring = floor(length(p - vec2(0.0, -0.32)) * 9.0);
        vec3 stripes = mod(ring, 3.0) < 0.5 ? vec3(0.62, 0.22, 0.10) : mod(ring, 3.0) < 1.5 ? vec3(0.10, 0.24, 0.26) : vec3(0.72, 0.46, 0.16);
        colour = ring > 5.5 || ring < 0.5 || at.y < 0.18 ? paper : stripes;
    } else if (which < 2.5) {  // leaf
        float rib = abs(p.x) - 0.24 * sqrt(max(0.0, 1.0 - pow(abs(p.y) * 2.5, 2.0)));
        colour = mix(vec3(0.09, 0.22, 0.13), paper, step(0.0, rib));
        if (rib < 0.0 && abs(fract(at.y * 8.0 + abs(p.x) * 5.0) - 0.5) < 0.08) colour = paper;
    } else {  // blocks
        vec2 cell = floor(at * vec2(3.0, 4.0));
        float pick = scatter(cell + 4.0);
        colour = pick < 0.25 ? vec3(0.07, 0.17, 0.25) : pick < 0.5 ? vec3(0.68, 0.24, 0.10) : pick < 0.75 ? vec3(0.74, 0.52, 0.20) : paper;
    }
    vec2 mat = abs(p);
    if (max(mat.x, mat.y) > 0.42) colour = vec3(0.84, 0.81, 0.75);
    return vec4(colour, 0.4);
}

vec4 outdoors(vec2 uv) {
    vec3 sky = mix(vec3(0.72, 0.78, 0.80), vec3(0.30, 0.50, 0.72), smoothstep(0.3, 1.0, uv.y));
    sky = mix(sky, vec3(0.95), smoothstep(0.5, 0.85, cloud(uv, vec2(4.0, 7.0))) * 0.8);
    float hill = 0.34 + 0.08 * sin(uv.x * 6.2831853) + 0.03 * cloud(uv, vec2(16.0, 2.0));
    vec3 green = mix(vec3(0.10, 0.22, 0.06), vec3(0.30, 0.42, 0.14), cloud(uv, vec2(20.0)));
    float tree = cloud(uv, vec2(7.0)) + 0.35 - length((uv - vec2(0.78, 0.46)) * vec2(1.4, 1.0)) * 2.2;
    vec3 colour = uv.y < hill ? green * 1.2 : sky;
    return vec4(mix(colour, green * 0.7, smoothstep(0.3, 0.4, tree)), 0.5);
}

vec4 screen(vec2 uv) {
    vec2 p = (uv - 0.5) * vec2(1.78, 1.0);
    vec3 colour = mix(vec3(0.05, 0.32, 0.36), vec3(0.02, 0.06, 0.16), uv.y);
    float rays = step(0.5, fract(atan(p.y + 0.28, p.x) * 3.8197));
    colour += vec3(0.05, 0.10, 0.09) * rays * (1.0 - uv.y);
    colour = mix(colour, vec3(0.98, 0.52, 0.14), 1.0 - smoothstep(0.29, 0.30, length(p - vec2(0.0, -0.06))));
    colour = mix(colour, vec3(0.03, 0.05, 0.09), step(uv.y, 0.24));
    for (int i = 0; i < 2; ++i) {
        vec2 q = p - vec2(i == 0 ? -0.17 : 0.17, -0.26);
        float body = min(length(max(abs(q - vec2(0.0, 0.20)) - vec2(0.045, 0.09), 0.0)), length(max(abs(q - vec2(0.0, 0.37)) - vec2(0.033, 0.035), 0.0)));
        body = min(body, length(max(abs(abs(q.x) - 0.03) - 0.014, 0.0)) + max(abs(q.y - 0.05) - 0.07, 0.0));
        body = min(body, length(max(abs(q - vec2(i == 0 ? 0.08 : -0.08, 0.25)) - vec2(0.06, 0.014), 0.0)));
        colour = mix(colour, i == 0 ? vec3(0.9, 0.92, 0.86) : vec3(0.02, 0.14, 0.20), 1.0 - smoothstep(0.008, 0.014, body));
    }
    return vec4(colour, 0.25);
}

void main() {
    float sheet = floor(v_uv.y * u_sheets);
    vec2 uv = vec2(v_uv.x, fract(v_uv.y * u_sheets));
    vec4 stuff = vec4(1.0, 1.0, 1.0, 0.5);
    if (sheet < 0.5) stuff = vec4(vec3(1.0), 0.5);
    else if (sheet < 1.5) stuff = planks(uv);
    else if (sheet < 2.5) stuff = grain(uv, vec2(3.0, 40.0), vec3(0.62, 0.58, 0.54), vec3(1.0));
    else if (sheet < 3.5) stuff = vec4(vec3(0.90 + 0.10 * cloud(uv, vec2(24.0))), 0.5);
    else if (sheet < 4.5) {
        float warp = abs(sin(uv.x * 100.53)) * 0.5 + abs(sin(uv.y * 100.53)) * 0.5;
        stuff = vec4(vec3(0.76 + 0.16 * warp + 0.08 * cloud(uv, vec2(6.0))), 0.5);
    }
    else if (sheet < 5.5) stuff = rug(uv);
    else if (sheet < 6.5) stuff = painting(uv);
    else if (sheet < 7.5) stuff = outdoors(uv);
    else stuff = screen(uv);
    f_stuff = vec4(sqrt(max(stuff.rgb, 0.0)), stuff.a);
}
