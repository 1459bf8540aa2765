// Which particle is seen in each pixel: one camera-facing triangle a particle, on which every pixel
// meets the exact sphere, in perspective. Shading follows in draw_shade, once a pixel: inside a
// fluid ten spheres cover a pixel and one is seen.
#pragma vertex ParticlesVertex
#pragma fragment ParticlesFragment

#include "../shared/layout.hlsli"
#include "../shared/tag.hlsli"
#include "camera.hlsli"

StructuredBuffer<Position> positions;
ConstantBuffer<FrameView> view;
ConstantBuffer<FrameStyle> style;

struct Varyings
{
    float4 position : SV_Position;
    // On the sphere's disc, whose outline is |xy| = 1; z is the ray's length along `forward` when
    // it is 1 along the line from the eye to the sphere's middle.
    [[vk::location(0)]] float3 disc : TEXCOORD0;
    // Distance of the middle, tan^2 of the half angle it is seen under, and index + 1.
    [[vk::location(1)]] nointerpolation float3 shape : TEXCOORD1;
};

Varyings ParticlesVertex(uint vertex : SV_VertexID, uint instance : SV_InstanceID)
{
    Position particle = positions[instance];
    float3 center = particle.position_m - view.eye_m;
    float distance_m = length(center);
    float3 axis = center / distance_m;
    // Any two directions across the axis do; the camera's own keep the corners screen-aligned.
    float3 across = normalize(cross(axis, view.up));
    float3 upward = cross(across, axis);

    float radius2 = style.radius_m * style.radius_m;
    float tan2 = radius2 / (distance_m * distance_m - radius2);
    float2 corner = DiscCorner(vertex);
    float3 ray = axis + sqrt(tan2) * (corner.x * across + corner.y * upward);

    Varyings output;
    // The triangle stands at the sphere's nearest point, so the depth written is never nearer
    // than its own: hidden spheres can be rejected early (SV_DepthLessEqual).
    output.position = ClipFromOffset(view, ray * (distance_m - style.radius_m));
    output.disc = float3(corner, dot(ray, view.forward));
    output.shape = float3(distance_m, tan2, float(instance + 1));

    bool drawn = IsSimulated(particle.tag) && distance_m > style.radius_m;
    if (!drawn)
        output.position = float4(0.0, 0.0, 0.0, 1.0);   // every corner in one point: nothing is drawn
    return output;
}

struct Seen
{
    float particle : SV_Target0;    // index + 1: exact in f32 to 2^24 particles, as many as there are ids
    float depth : SV_DepthLessEqual;
};

Seen ParticlesFragment(Varyings input)
{
    float s = dot(input.disc.xy, input.disc.xy);
    if (s > 1.0)
        discard;
    // Ray against sphere with the outline at |disc| = 1: the discriminant is r^2 (1 - s) / (1 + s tan^2),
    // free of the cancellation that D^2 - r^2 would bring far away.
    float along_m = (input.shape.x - style.radius_m * sqrt(1.0 - s)) / (1.0 + s * input.shape.y);
    Seen output;
    output.particle = input.shape.z;
    output.depth = view.near_m / (along_m * input.disc.z);
    return output;
}
