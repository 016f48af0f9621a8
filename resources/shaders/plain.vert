#version 330 core
layout(location = 0) in vec3 position;
uniform mat4 view;
uniform vec4 section; // what lies beyond normal . p = w is cut away
uniform mat4 projection;
out float gl_ClipDistance[1];

void main()
{
    gl_ClipDistance[0] = section.w - dot(section.xyz, position);
    gl_Position = projection * view * vec4(position, 1.0);
}
