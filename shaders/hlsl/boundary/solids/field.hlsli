// Solids that are a mesh: distances on a grid, interpolated linearly along each axis. Includers declare `solid_fields`, of
// each node its distance from the surface, m, and that of the plane beyond which as much of the kernel lies as in the solid,
// in h: beside a flat face the interpolation is exact, of the distance and of the share.
//
// An interpolated distance is larger than the true one by half of a cell's diagonal at most, and changes no faster than
// FIELD_STEEPNESS: a path that goes on by as much less never steps over a surface of the field. It rises to what particles keep
// from surfaces nowhere on a wall that is thick enough for its cells; thinner ones are refused (scene/check/meshes.rs).
#ifndef BROOKLET_FIELD
#define BROOKLET_FIELD

#include "layout.hlsli"

// Along each axis the difference of two nodes is their distance at most.
static const float FIELD_STEEPNESS = 1.7320508;

struct FieldSample
{
    float2 value;           // of the place, or of the nearest in the grid
    float3 distance_slope;  // over the position
    float3 plane_slope;     // of h, 1/m
    float3 outside_m;       // from the grid to the place
};

FieldSample SampleField(Solid solid, float3 place_m)
{
    float3 last = float3(solid.field_nodes - 1);
    float3 in_grid_m = clamp(place_m, solid.field_min_m, solid.field_min_m + last * solid.field_cell_m);
    float3 at = (in_grid_m - solid.field_min_m) / solid.field_cell_m;
    float3 cell = clamp(floor(at), 0.0, last - 1.0);
    float3 part = at - cell;
    uint row = solid.field_nodes.x;
    uint slab = row * solid.field_nodes.y;
    uint first = solid.first_field_node + uint(cell.x) + row * uint(cell.y) + slab * uint(cell.z);
    float2 v000 = solid_fields[first];
    float2 v100 = solid_fields[first + 1];
    float2 v010 = solid_fields[first + row];
    float2 v110 = solid_fields[first + row + 1];
    float2 v001 = solid_fields[first + slab];
    float2 v101 = solid_fields[first + slab + 1];
    float2 v011 = solid_fields[first + slab + row];
    float2 v111 = solid_fields[first + slab + row + 1];
    float2 x00 = v000 + part.x * (v100 - v000);
    float2 x10 = v010 + part.x * (v110 - v010);
    float2 x01 = v001 + part.x * (v101 - v001);
    float2 x11 = v011 + part.x * (v111 - v011);
    float2 xy0 = x00 + part.y * (x10 - x00);
    float2 xy1 = x01 + part.y * (x11 - x01);
    float2 slope_x0 = v100 - v000 + part.y * (v110 - v010 - v100 + v000);
    float2 slope_x1 = v101 - v001 + part.y * (v111 - v011 - v101 + v001);
    float2 slope_x = slope_x0 + part.z * (slope_x1 - slope_x0);
    float2 slope_y = x10 - x00 + part.z * (x11 - x01 - x10 + x00);
    float2 slope_z = xy1 - xy0;
    FieldSample field;
    field.value = xy0 + part.z * slope_z;
    field.distance_slope = float3(slope_x.x, slope_y.x, slope_z.x) / solid.field_cell_m;
    field.plane_slope = float3(slope_x.y, slope_y.y, slope_z.y) / solid.field_cell_m;
    field.outside_m = place_m - in_grid_m;
    return field;
}

#endif
