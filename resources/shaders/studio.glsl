// The light of a small photo studio: a bright room with a lamp above, a large soft box beside the camera, a strip of
// light behind the model; the same as StudioLight has for pictures. Colours are linear. Directions are in eye
// coordinates.
uniform vec3 keyDirection;
uniform vec3 rimDirection;
uniform vec3 upDirection;
uniform bool perspectiveView;

const vec3 keyColor = vec3(1.02, 0.98, 0.92);
const vec3 skyColor = vec3(0.50, 0.52, 0.56);
const vec3 floorColor = vec3(0.25, 0.235, 0.22);
const vec3 rimColor = vec3(0.30, 0.32, 0.37);
const vec3 lampColor = vec3(1.30, 1.28, 1.24); // it shines in what is smooth
const float keySize = 0.14; // what the soft box adds to a highlight's width (alpha of GGX)
const float rimSize = 0.12;

struct Cloth {
    vec3 color;
    float roughness; // perceptual; its square is alpha
    float sheen;     // of fibres, 0 to 1
    float specular;  // reflected straight on; 0.04 for leather and lacquer
};

vec3 towardsEye(vec3 position)
{
    return perspectiveView ? normalize(-position) : vec3(0.0, 0.0, 1.0);
}

// Light from an area goes a little round the edge.
float wrapped(float cosine, float by)
{
    return max(0.0, cosine + by) / ((1.0 + by) * (1.0 + by));
}

// GGX for an area light by a wider lobe (B. Karis, "Real shading in Unreal Engine 4", 2013), with the visibility term
// of the same course.
float highlight(vec3 n, vec3 light, vec3 toEye, float alpha, float roughness)
{
    vec3 h = normalize(light + toEye);
    float nh = max(0.0, dot(n, h)), lh = max(0.0, dot(light, h));
    float a2 = alpha * alpha;
    float d = nh * nh * (a2 - 1.0) + 1.0;
    return max(0.0, dot(n, light)) * a2 / (d * d * max(0.1, lh * lh) * (4.0 * roughness + 2.0));
}

// The room in the mirror: sky over floor, and the lamp, blurred, times what GGX reflects of it (Karis' fit).
vec3 mirrored(vec3 n, vec3 toEye, float nv, float specular, float roughness)
{
    float up = dot(reflect(-toEye, n), upDirection);
    float blur = 0.15 + 0.85 * roughness;
    vec3 room = mix(floorColor, skyColor, smoothstep(-blur, blur, up)) +
                smoothstep(0.6 - blur, 0.6 + blur, up) * lampColor;
    vec4 r = roughness * vec4(-1.0, -0.0275, -0.572, 0.022) + vec4(1.0, 0.0425, 1.04, -0.04);
    float a = min(r.x * r.x, exp2(-9.28 * nv)) * r.x + r.y;
    return specular > 0.0 ? room * max(0.0, specular * (-1.04 * a + r.z) + 1.04 * a + r.w) : vec3(0.0);
}

// `open`: the share of the sky that is seen.
vec3 studio(Cloth cloth, vec3 n, vec3 toEye, float open)
{
    float nv = clamp(dot(n, toEye), 0.03, 1.0);
    float alpha = cloth.roughness * cloth.roughness;
    float key = dot(n, keyDirection), rim = dot(n, rimDirection), up = dot(n, upDirection);
    vec3 sky = mix(floorColor, skyColor, 0.5 + 0.5 * up);
    vec3 fuzz = cloth.sheen * pow(1.0 - nv, 3.0) * mix(cloth.color, vec3(1.0), 0.25);

    vec3 fromKey = cloth.color * wrapped(key, 0.15) + fuzz * wrapped(key, 0.5) +
                   cloth.specular * highlight(n, keyDirection, toEye, min(1.0, alpha + keySize), cloth.roughness);
    vec3 fromRim = cloth.color * wrapped(rim, 0.1) + fuzz * wrapped(rim, 0.5) +
                   6.0 * cloth.specular * highlight(n, rimDirection, toEye, min(1.0, alpha + rimSize), cloth.roughness);
    vec3 fromRoom = (cloth.color + fuzz) * sky + mirrored(n, toEye, nv, cloth.specular, cloth.roughness);
    float shade = 0.4 + 0.6 * smoothstep(0.0, 0.7, open);
    return fromKey * keyColor * shade + fromRim * rimColor * open + fromRoom * open;
}

vec3 displayed(vec3 light)
{
    const float shoulder = 0.75;
    vec3 over = max(light - shoulder, 0.0) / (1.0 - shoulder);
    vec3 bent = min(light, vec3(shoulder)) + (1.0 - shoulder) * (1.0 - exp(-over));
    return mix(12.92 * bent, 1.055 * pow(max(bent, vec3(1e-5)), vec3(1.0 / 2.4)) - 0.055, step(0.0031308, bent));
}
