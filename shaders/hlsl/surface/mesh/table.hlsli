// Triangles of a cell. For each of the 256 ways in which its corners are inside triangle_table has up to five triangles,
// four bits a corner, an edge of the cell each; 15 where there is none. Made by the twin's two rules, under which the mesh
// is closed (reference/src/surface/marching_cubes_table.rs).
#ifndef BROOKLET_MESH_TABLE
#define BROOKLET_MESH_TABLE

static const uint MOST_TRIANGLES = 5;

// The k-th corner of the cell's triangles, an edge of the cell; 15: there are no more.
uint EdgeOf(uint2 triangles, uint k)
{
    return (k < 8 ? triangles.x >> 4 * k : triangles.y >> 4 * (k - 8)) & 15;
}

uint TriangleCount(uint2 triangles)
{
    uint count = 0;
    [unroll]
    for (uint t = 0; t < MOST_TRIANGLES; ++t)
        count += EdgeOf(triangles, 3 * t) != 15 ? 1 : 0;
    return count;
}

#endif
