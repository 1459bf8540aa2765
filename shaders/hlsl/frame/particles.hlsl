// The particles as shaded spheres: one camera-facing triangle each, on which every pixel meets the
// exact sphere, in perspective.
#pragma vertex ParticlesVertex
#pragma fragment ParticlesFragment
#pragma multi_compile _ COLOR_FLUID

#include "../shared/layout.hlsl"
#include "camera.hlsl"
#include "environment.hlsl"
#include "palette.hlsl"

StructuredBuffer<Position> positions;
#if !defined(COLOR_FLUID)
StructuredBuffer<Velocity> velocities;
#endif
Texture2D<float> shadow_map;
ConstantBuffer<FrameView> view;
ConstantBuffer<FrameLight> light;
ConstantBuffer<FrameStyle> style;

struct Varyings
{
    float4 position : SV_Position;
    [[vk::location(0)]] float2 disc : TEXCOORD0;            // the sphere's outline is |disc| = 1
    [[vk::location(1)]] float3 ray : TEXCOORD1;             // from the eye, length 1 along the axis
    [[vk::location(2)]] nointerpolation float3 center_m : TEXCOORD2;    // relative to the eye
    [[vk::location(3)]] nointerpolation float2 shape : TEXCOORD3;       // distance; tan^2 of the half angle
    [[vk::location(4)]] nointerpolation float4 color : TEXCOORD4;       // and the sun's share that arrives
};

// Share of the sun that reaches a particle: it fades with the depth of fluid in front of it, as
// light does in water, rather than stopping at the first particle.
float sun_reaching(float3 world_m)
{
    float3 at = shadow_position(light, world_m);
    float own_radius = style.radius_m / light.shadow_range_m;
    float reach = 2.2 * style.radius_m / (light.shadow_texel_m * light.shadow_texels);
    const float2 taps[5] = { float2(0.0, 0.0), float2(0.9, 0.4), float2(-0.4, 0.9), float2(-0.9, -0.4), float2(0.4, -0.9) };
    float sum = 0.0;
    [unroll]
    for (uint i = 0; i < 5; i++)
    {
        float front = shadow_load(shadow_map, light, at.xy + reach * taps[i]);
        float depth_m = max(0.0, front - at.z - 2.0 * own_radius) * light.shadow_range_m;
        sum += exp(-depth_m / style.light_depth_m);
    }
    return sum / 5.0;
}

Varyings ParticlesVertex(uint vertex : SV_VertexID, uint instance : SV_InstanceID)
{
    Position particle = positions[instance];
    float3 world_m = particle.position_m;
    float3 center = world_m - view.eye_m;
    float distance_m = length(center);
    float3 axis = center / distance_m;
    // Any two directions across the axis do; the camera's own keep the corners screen-aligned.
    float3 across = normalize(cross(axis, view.up));
    float3 upward = cross(across, axis);

    float radius2 = style.radius_m * style.radius_m;
    float tan2 = radius2 / (distance_m * distance_m - radius2);
    float2 corner = disc_corner(vertex);
    float3 ray = axis + sqrt(tan2) * (corner.x * across + corner.y * upward);

    Varyings output;
    // The triangle stands at the sphere's nearest point, so the depth written is never nearer
    // than its own: hidden spheres can be rejected before they are shaded (SV_DepthLessEqual).
    output.position = clip_from_offset(view, ray * (distance_m - style.radius_m));
    output.disc = corner;
    output.ray = ray;
    output.center_m = center;
    output.shape = float2(distance_m, tan2);
#if defined(COLOR_FLUID)
    float3 albedo = fluid_color((particle.tag >> 24) & 127u);
#else
    float3 albedo = speed_color(length(velocities[instance].velocity_m_s) * style.inverse_speed_scale_s_m);
#endif
    output.color = float4(albedo, sun_reaching(world_m));

    bool drawn = (particle.tag >> 31) == 0 && distance_m > style.radius_m;
    if (!drawn)
        output.position = float4(0.0, 0.0, 0.0, 1.0);   // every corner in one point: nothing is drawn
    return output;
}

struct Shaded
{
    float4 color : SV_Target0;
    float depth : SV_DepthLessEqual;
};

float3 shade(float3 normal, float3 to_eye, float3 albedo, float sun)
{
    float n_dot_l = dot(normal, light.to_sun);
    // Wrapped diffuse: light that enters the drop leaves it beyond the terminator.
    float wrapped = saturate((n_dot_l + 0.35) / 1.35);
    float3 color = albedo * (wrapped * wrapped * sun * light.sun_color * 0.9
        + ambient_light(light, style.floor_color, normal) * (0.45 + 0.55 * sun));
    // Water glows a little where the sun comes through from behind.
    float through = saturate(-dot(to_eye, light.to_sun)) * saturate(0.6 - n_dot_l);
    color += sqrt(albedo) * float3(0.10, 0.32, 0.36) * through * sun * light.sun_color * 0.35;
    float f = fresnel(0.02, dot(normal, to_eye));
    color += f * sky_gradient(light, reflect(-to_eye, normal)) * (0.25 + 0.45 * sun);
    float3 halfway = normalize(light.to_sun + to_eye);
    color += power64(saturate(dot(normal, halfway))) * 0.45 * sun * light.sun_color;
    return color;
}

Shaded ParticlesFragment(Varyings input)
{
    float s = dot(input.disc, input.disc);
    if (s > 1.0)
        discard;
    // Ray against sphere with the outline at |disc| = 1: the discriminant is r^2 (1 - s) / (1 + s tan^2),
    // free of the cancellation that D^2 - r^2 would bring far away.
    float3 hit_m = input.ray * ((input.shape.x - style.radius_m * sqrt(1.0 - s)) / (1.0 + s * input.shape.y));
    float3 normal = (hit_m - input.center_m) / style.radius_m;
    float3 to_eye = -normalize(hit_m);
    float3 color = shade(normal, to_eye, input.color.rgb, input.color.a);
    Shaded output;
    output.color = float4(color, 1.0);
    output.depth = view.near_m / dot(hit_m, view.forward);
    return output;
}
