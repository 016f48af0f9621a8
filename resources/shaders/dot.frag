#version 330 core
noperspective in vec2 local;
flat in float radius;
flat in vec4 fillColor;
flat in vec4 rimColor;
out vec4 color;

void main()
{
    float away = length(local);
    float whole = clamp(radius - away + 0.5, 0.0, 1.0);
    if (whole <= 0.0)
        discard;
    vec4 shown = mix(rimColor, fillColor, clamp(radius - 1.6 - away + 0.5, 0.0, 1.0));
    float alpha = shown.a * whole;
    color = vec4(shown.rgb * alpha, alpha);
}
