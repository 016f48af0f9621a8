#version 330 core
uniform vec4 flatColor; // premultiplied
out vec4 color;

void main()
{
    color = flatColor;
}
