#version 330 core
// The finished picture onto the screen; the ordered offset hides the steps of gradients.
uniform sampler2D picture;
in vec2 place;
out vec4 color;

void main()
{
    ivec2 p = ivec2(gl_FragCoord.xy);
    int order = 0;
    for (int bit = 0; bit < 3; ++bit)
        order = order << 2 | (((p.x ^ p.y) >> bit) & 1) << 1 | ((p.y >> bit) & 1);
    color = vec4(texture(picture, place).rgb + (float(order) / 64.0 - 0.5) / 255.0, 1.0);
}
