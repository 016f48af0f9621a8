// The light of a small photo studio, the same as in pictures: sky, floor, a key light beside the camera, a rim light.
// Colours are linear. Directions are in eye coordinates.
uniform vec3 keyDirection;
uniform vec3 rimDirection;
uniform bool perspectiveView;

const vec3 keyColor = vec3(1.02, 0.98, 0.92);
const vec3 skyColor = vec3(0.50, 0.52, 0.56);
const vec3 floorColor = vec3(0.25, 0.235, 0.22);
const vec3 rimColor = vec3(0.20, 0.22, 0.26);

vec3 towardsEye(vec3 position)
{
    return perspectiveView ? normalize(-position) : vec3(0.0, 0.0, 1.0);
}

// `up` is the upward part of the normal in the world; `open` the share of the sky that is seen.
vec3 studio(vec3 color, vec3 n, float up, vec3 toEye, float gloss, float open)
{
    float facing = max(0.0, dot(n, keyDirection));
    float facingRim = max(0.0, dot(n, rimDirection));
    float grazing = pow(1.0 - clamp(dot(n, toEye), 0.0, 1.0), 4.0);
    float highlight = pow(max(0.0, dot(n, normalize(keyDirection + toEye))), 28.0);
    float sky = 0.5 + 0.5 * up;
    vec3 direct = (color * facing + gloss * highlight) * keyColor;
    vec3 ambient = color * mix(floorColor, skyColor, sky) + (color * facingRim + 3.0 * gloss * grazing * sky) * rimColor;
    return direct * (0.4 + 0.6 * smoothstep(0.0, 0.7, open)) + ambient * open;
}

vec3 displayed(vec3 light)
{
    const float shoulder = 0.75;
    vec3 over = max(light - shoulder, 0.0) / (1.0 - shoulder);
    vec3 bent = min(light, vec3(shoulder)) + (1.0 - shoulder) * (1.0 - exp(-over));
    return mix(12.92 * bent, 1.055 * pow(max(bent, vec3(1e-5)), vec3(1.0 / 2.4)) - 0.055, step(0.0031308, bent));
}
