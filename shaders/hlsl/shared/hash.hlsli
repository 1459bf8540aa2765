// Random numbers of a counter, the same in every run.
#ifndef BROOKLET_HASH
#define BROOKLET_HASH

// Wellons' lowbias32 (2018): every bit of the input changes each of the output with the same chance, nearly.
uint Hash(uint x)
{
    x = (x ^ (x >> 16)) * 0x7feb352du;
    x = (x ^ (x >> 15)) * 0x846ca68bu;
    return x ^ (x >> 16);
}

// Evenly from 0 to below 1.
float Share(uint seed)
{
    return float(Hash(seed) >> 8) / 16777216.0;
}

#endif
