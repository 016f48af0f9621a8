#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 shade; // premultiplied
uniform mat4 view;
uniform mat4 projection;
uniform float size; // pixels
flat out vec4 pointShade;

void main()
{
    pointShade = shade;
    gl_Position = projection * view * vec4(position, 1.0);
    gl_PointSize = size;
}
