// A mesh's triangles as three vertices each.
#ifndef BROOKLET_REFINE_TRIANGLE
#define BROOKLET_REFINE_TRIANGLE

uint3 CornersOf(uint t)
{
    return uint3(mesh_indices[3 * t], mesh_indices[3 * t + 1], mesh_indices[3 * t + 2]);
}

// A triangle that found no place is all in one vertex.
bool IsLost(uint3 corners)
{
    return corners.x == corners.y;
}

#endif
