#version 330 core
uniform vec3 top;
uniform vec3 bottom;
in vec2 place;
out vec4 color;

void main()
{
    float t = smoothstep(0.0, 1.0, 1.0 - place.y);
    color = vec4(mix(top, bottom, t), 1.0);
}
