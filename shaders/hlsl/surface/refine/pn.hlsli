// PN triangles (Vlachos, Peters, Boyd & Mitchell 2001, sections 3.1 to 3.3). Twin: reference/src/surface/subdivide.rs.
#ifndef BROOKLET_REFINE_PN
#define BROOKLET_REFINE_PN

// The tangent control point near a on the edge to b: a third of the way, in the plane of a's normal.
float3 TangentPoint(MeshVertex a, MeshVertex b)
{
    float3 along_m = b.position_m - a.position_m;
    return a.position_m + (along_m - dot(along_m, a.normal) * a.normal) / 3.0;
}

float3 UnitOr(float3 v, float3 instead)
{
    float squared = dot(v, v);
    return squared > 0.0 ? v / sqrt(squared) : instead;
}

// The normal half-way along an edge: the ends' mean, mirrored at the plane across the edge.
float3 MiddleNormal(MeshVertex a, MeshVertex b)
{
    float3 along_m = b.position_m - a.position_m;
    float size_m = length(along_m);
    float3 along = size_m > 0.0 ? along_m / size_m : 0.0;
    float3 both = a.normal + b.normal;
    return UnitOr(both - 2.0 * dot(along, both) * along, a.normal);
}

MeshVertex VertexOf(float3 position_m, float3 normal)
{
    MeshVertex result;
    result.position_m = position_m;
    result.reserved0 = 0.0;
    result.normal = normal;
    result.reserved1 = 0.0;
    return result;
}

// The point a share t of the way from a to b along their edge.
MeshVertex OnEdge(MeshVertex a, MeshVertex b, float t)
{
    float s = 1.0 - t;
    float3 near_m = 3.0 * s * t * (s * TangentPoint(a, b) + t * TangentPoint(b, a));
    float3 normal = s * s * a.normal + t * t * b.normal + s * t * MiddleNormal(a, b);
    return VertexOf(s * s * s * a.position_m + near_m + t * t * t * b.position_m, UnitOr(normal, a.normal));
}

// The point in the middle of a triangle: a 27th of its corners, 3 of each tangent point and 6 of b111 = E + (E - V) / 2.
MeshVertex InMiddle(MeshVertex a, MeshVertex b, MeshVertex c)
{
    float3 tangents_m = TangentPoint(a, b) + TangentPoint(b, a) + TangentPoint(b, c) + TangentPoint(c, b) +
                        TangentPoint(c, a) + TangentPoint(a, c);
    float3 corners_m = a.position_m + b.position_m + c.position_m;
    float3 middle_m = tangents_m / 4.0 - corners_m / 6.0;
    float3 normal = a.normal + b.normal + c.normal + MiddleNormal(a, b) + MiddleNormal(b, c) + MiddleNormal(c, a);
    return VertexOf((corners_m + 3.0 * tangents_m + 6.0 * middle_m) / 27.0, UnitOr(normal, a.normal));
}

#endif
