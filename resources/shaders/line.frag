#version 330 core
noperspective in vec2 local;
flat in float along;
flat in float halfWidth;
flat in vec4 tone;
out vec4 color;

void main()
{
    float away = length(vec2(local.x - clamp(local.x, 0.0, along), local.y));
    float alpha = tone.a * clamp(halfWidth - away + 0.5, 0.0, 1.0) * min(1.0, 2.0 * halfWidth);
    if (alpha <= 0.0)
        discard;
    color = vec4(tone.rgb * alpha, alpha);
}
