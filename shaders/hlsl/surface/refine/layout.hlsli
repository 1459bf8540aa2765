// What the host tells the stages that smooth and subdivide a mesh, and what they tell each other. The rule of
// shared/layout.hlsli holds: no hidden padding.
#ifndef BROOKLET_REFINE_LAYOUT
#define BROOKLET_REFINE_LAYOUT

struct RefineParams
{
    float distance_m;           // standard deviation of the weight over the distance of two vertices
    float difference;           // and over the difference of their normals
    uint parts;                 // of each side of a triangle: 1, 2 or 3
    uint most_coarse_vertices;  // as many as the mesh had room for
    uint most_vertices;         // there is room for when it is subdivided
    uint most_triangles;
};

// A mesh's size. Each set of groups is a VkDispatchIndirectCommand.
struct MeshSize
{
    uint3 vertex_groups;        // with a thread for each vertex
    uint vertices;
    uint3 triangle_groups;      // and one for each triangle
    uint triangles;
};

#endif
