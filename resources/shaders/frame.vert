#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
uniform mat4 view;
uniform vec4 section; // what lies beyond normal . p = w is cut away
uniform mat4 projection;
uniform bool perspectiveView;
uniform float push; // mm away from the eye
out vec3 eyePosition;
out vec3 eyeNormal;
out float gl_ClipDistance[1];

void main()
{
    gl_ClipDistance[0] = section.w - dot(section.xyz, position);
    vec4 p = view * vec4(position, 1.0);
    eyePosition = p.xyz;
    eyeNormal = mat3(view) * normal;
    p.xyz -= push * (perspectiveView ? normalize(-p.xyz) : vec3(0.0, 0.0, 1.0));
    gl_Position = projection * p;
}
