// The vertices within triangles cut into three parts a side: they come after those on the edges, in the triangles' order.
#ifndef BROOKLET_REFINE_MIDDLE
#define BROOKLET_REFINE_MIDDLE

uint MiddleOf(uint t)
{
    return mesh_size[0].vertices + (refine.parts - 1) * edge_starts[refine.most_coarse_vertices] + t;
}

#endif
