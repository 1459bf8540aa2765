// Triangles go where there is room for them.
#ifndef BROOKLET_STORE_TRIANGLE
#define BROOKLET_STORE_TRIANGLE

// Stores the triangle with this number. One that has no place, or a vertex that has none, becomes one in a point, of which
// nothing is drawn, and is counted as lost if `counts_if_lost`; nothing is written beyond the buffer's end.
void StoreTriangle(RWStructuredBuffer<uint> indices, RWStructuredBuffer<MeshCounts> counts, uint number, uint3 corners,
                   uint most_triangles, uint most_vertices, bool counts_if_lost)
{
    bool has_place = number < most_triangles;
    if (any(corners >= most_vertices) || !has_place)
    {
        uint before;
        InterlockedAdd(counts[0].lost_triangles, counts_if_lost ? 1u : 0u, before);
        corners = 0;
    }
    if (has_place)
    {
        indices[3 * number] = corners.x;
        indices[3 * number + 1] = corners.y;
        indices[3 * number + 2] = corners.z;
    }
}

#endif
