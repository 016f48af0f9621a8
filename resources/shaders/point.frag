#version 330 core
flat in vec4 pointShade; // premultiplied
out vec4 color;

void main()
{
    color = pointShade;
}
