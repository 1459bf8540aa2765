// How hard a body is to move and to turn. Includers declare `bodies` and `body_states`.
#ifndef BROOKLET_BODY_INERTIA
#define BROOKLET_BODY_INERTIA

#include "../solids/pose.hlsli"
#include "layout.hlsli"

// A symmetric tensor: xx, yy, zz and xy, yz, zx.
struct Tensor
{
    float3 moments;
    float3 products;
};

float3 Times(Tensor t, float3 v)
{
    return float3(t.moments.x * v.x + t.products.x * v.y + t.products.z * v.z,
                  t.products.x * v.x + t.moments.y * v.y + t.products.y * v.z,
                  t.products.z * v.x + t.products.y * v.y + t.moments.z * v.z);
}

// Its inverse times a vector, by Cramer's rule; of a tensor whose trace is 1, so that no product of three leaves the numbers.
float3 Over(Tensor t, float3 v)
{
    float scale = 1.0 / (t.moments.x + t.moments.y + t.moments.z);
    float3 m = t.moments * scale;
    float3 p = t.products * scale;
    float3 x = float3(m.x, p.x, p.z);
    float3 y = float3(p.x, m.y, p.y);
    float3 z = float3(p.z, p.y, m.z);
    float3 yz = cross(y, z);
    return float3(dot(yz, v), dot(cross(z, x), v), dot(cross(x, y), v)) * (scale / dot(x, yz));
}

// Of a body's frame that is turned.
float3 TimesTurned(Tensor t, float4 rotation, float3 v)
{
    return Turned(rotation, Times(t, Turned(Inverse(rotation), v)));
}

float3 OverTurned(Tensor t, float4 rotation, float3 v)
{
    return Turned(rotation, Over(t, Turned(Inverse(rotation), v)));
}

Tensor InertiaOf(RigidBody body)
{
    Tensor t;
    t.moments = body.inertia_kg_m2;
    t.products = body.products_kg_m2;
    return t;
}

bool IsHinged(RigidBody body)
{
    return body.hinge_inertia_kg_m2 > 0.0;
}

// The spin that an impulse at a place gives a body.
float3 SpinBy(RigidBody body, BodyState state, float3 at_m, float3 impulse_kg_m_s)
{
    if (IsHinged(body))
    {
        float moment_kg_m2_s = dot(body.hinge_axis, cross(at_m - body.hinge_m, impulse_kg_m_s));
        return body.hinge_axis * (moment_kg_m2_s / body.hinge_inertia_kg_m2);
    }
    return OverTurned(InertiaOf(body), state.rotation, cross(at_m - state.position_m, impulse_kg_m_s));
}

// The velocity of its centre of mass, with that spin.
float3 VelocityBy(RigidBody body, BodyState state, float3 spin_rad_s, float3 impulse_kg_m_s)
{
    if (IsHinged(body))
        return cross(spin_rad_s, state.position_m - body.hinge_m);
    return body.inverse_mass_per_kg * impulse_kg_m_s;
}

// By how much a unit impulse at a place changes the velocity there along itself, 1/kg.
float MobilityOf(RigidBody body, BodyState state, float3 at_m, float3 direction)
{
    float3 spin_rad_s = SpinBy(body, state, at_m, direction);
    float3 there_m_s = VelocityBy(body, state, spin_rad_s, direction) + cross(spin_rad_s, at_m - state.position_m);
    return dot(there_m_s, direction);
}

#endif
