#version 330 core
flat in vec4 v_colour;
layout(location = 0) out vec4 f_colour;

void main() {
    f_colour = v_colour;
}
