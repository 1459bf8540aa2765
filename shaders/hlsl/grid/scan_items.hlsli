// What a thread of a group's scan takes and gives back: SCAN_ITEMS values in a row. For kernels that bind `values`,
// `scanned` and, with GROUP_OFFSETS, `group_offsets`, and sum up their threads' sums each in its own way.
#ifndef BROOKLET_SCAN_ITEMS
#define BROOKLET_SCAN_ITEMS

#include "../shared/dispatch.hlsli"

#define SCAN_THREADS 128
#define SCAN_GROUP (SCAN_THREADS * SCAN_ITEMS)

uint ValueOrZero(uint i, uint count)
{
    return i < count ? values[i] : 0u;
}

struct ScanItems
{
    uint first;
    uint count;                     // of all values
    uint before[SCAN_ITEMS];        // what the thread has before each
    uint sum;
};

ScanItems TakeItems(uint3 group, uint thread)
{
    ScanItems items;
    uint stride;
    values.GetDimensions(items.count, stride);
    items.first = LinearGroup(group) * SCAN_GROUP + thread * SCAN_ITEMS;
    items.sum = 0;
    [unroll]
    for (uint item = 0; item < SCAN_ITEMS; ++item)
    {
        items.before[item] = items.sum;
        items.sum += ValueOrZero(items.first + item, items.count);
    }
    return items;
}

// `before`: what the group has before the thread.
void GiveItems(ScanItems items, uint3 group, uint before)
{
#if defined(GROUP_OFFSETS)
    uint offsets, stride;
    group_offsets.GetDimensions(offsets, stride);
    before += LinearGroup(group) < offsets ? group_offsets[LinearGroup(group)] : 0u;
#endif
    [unroll]
    for (uint item = 0; item < SCAN_ITEMS; ++item)
    {
        if (items.first + item < items.count)
            scanned[items.first + item] = before + items.before[item];
    }
}

#endif
