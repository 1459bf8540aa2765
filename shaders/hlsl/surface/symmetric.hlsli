// Eigenvalues and eigenvectors of a symmetric 3 x 3 matrix by Jacobi's rotations: it needs no case
// for equal eigenvalues, and its vectors stay at right angles whatever the matrix, where the closed
// form of the cubic loses both.
#ifndef BROOKLET_SYMMETRIC
#define BROOKLET_SYMMETRIC

// Rotations converge quadratically: f32 has no more to gain after the fourth sweep.
static const uint JACOBI_SWEEPS = 4;

struct Eigen
{
    float3 values;
    float3 vectors[3];
};

// Turns axes p and q so that a_pq is zero; r is the third (Golub & Van Loan, section 8.5). The
// smaller of the two angles, written so that nothing is divided by a_pq, which may be zero.
void Rotate(inout float pp, inout float qq, inout float pq, inout float pr, inout float qr,
            inout float3 p, inout float3 q)
{
    float apart = qq - pp;
    float toward = 2.0 * pq;
    float across = abs(apart) + sqrt(apart * apart + toward * toward);
    float tangent = (apart < 0.0 ? -toward : toward) / max(across, 1e-30);
    float c = 1.0 / sqrt(1.0 + tangent * tangent);
    float s = c * tangent;
    pp -= tangent * pq;
    qq += tangent * pq;
    pq = 0.0;
    float turned_r = c * pr - s * qr;
    qr = s * pr + c * qr;
    pr = turned_r;
    float3 turned = c * p - s * q;
    q = s * p + c * q;
    p = turned;
}

// `diagonal` is xx, yy, zz; `beside` is xy, xz, yz.
Eigen EigenOf(float3 diagonal, float3 beside)
{
    Eigen eigen;
    eigen.values = diagonal;
    eigen.vectors[0] = float3(1.0, 0.0, 0.0);
    eigen.vectors[1] = float3(0.0, 1.0, 0.0);
    eigen.vectors[2] = float3(0.0, 0.0, 1.0);
    for (uint sweep = 0; sweep < JACOBI_SWEEPS; ++sweep)
    {
        Rotate(eigen.values.x, eigen.values.y, beside.x, beside.y, beside.z, eigen.vectors[0], eigen.vectors[1]);
        Rotate(eigen.values.x, eigen.values.z, beside.y, beside.x, beside.z, eigen.vectors[0], eigen.vectors[2]);
        Rotate(eigen.values.y, eigen.values.z, beside.z, beside.x, beside.y, eigen.vectors[1], eigen.vectors[2]);
    }
    return eigen;
}

#endif
