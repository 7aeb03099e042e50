#pragma once

#include <cstddef>

namespace antinode
{
/** A matrix in memory: entry (i, j) at data[i rowStep + j columnStep]. */
struct MatrixInMemory
{
    const double* data;
    std::ptrdiff_t rowStep, columnStep;
};

/** What becomes of a product: entry (i, j) at data[i + j stride]. */
struct ProductTarget
{
    double* data;
    std::ptrdiff_t stride, rows, columns;
    bool isLowerOnly; ///< Only i >= j is written.
};

/** target += factor a b, a with `depth` columns, by the widest vectors of the processor. Panels of both are copied so
   that the innermost loop reads memory in order: 3 vectors by 4 columns (8 with 32 registers) are summed in registers.
   Threads may call at once. [worker] Docs/Design/engine.md. */
void addProductInMemory (const ProductTarget&, std::ptrdiff_t depth, double factor, const MatrixInMemory& a,
                         const MatrixInMemory& b);

/** Columns `column` and the next become cosine x - sine y and sine x + cosine y. */
struct PlaneRotation
{
    std::ptrdiff_t column;
    double cosine, sine;
};

/** Rows of a strip; its columns lie one after the other. */
inline constexpr std::ptrdiff_t rotationRows = 32;

/** Applies rotations, one after the other, to a strip of rows. [worker] */
void rotateColumns (double* strip, const PlaneRotation*, std::ptrdiff_t count);
} // namespace antinode
