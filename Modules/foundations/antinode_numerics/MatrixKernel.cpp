#include "MatrixKernel.h"

#include <antinode_base/ThreadLocal.h>
#include <antinode_base/Watch.h>

#include <hwy/aligned_allocator.h>

#include <algorithm>

// Highway includes this file once a target, each time with another HWY_NAMESPACE.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "antinode_numerics/MatrixKernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace antinode::HWY_NAMESPACE
{
namespace
{
namespace hn = hwy::HWY_NAMESPACE;
using Tag = hn::ScalableTag<double>;
using Vector = hn::Vec<Tag>;

constexpr std::ptrdiff_t lanes = hn::MaxLanes (Tag());
constexpr std::ptrdiff_t vectors = 3;
constexpr std::ptrdiff_t tileRows = vectors * lanes;
constexpr std::ptrdiff_t tileColumns = lanes >= 8 ? 8 : 4;

// Parts of a, b that stay in the second and third cache.
constexpr std::ptrdiff_t maximumDepth = 256;
constexpr std::ptrdiff_t maximumRows = 96;
constexpr std::ptrdiff_t maximumColumns = 512;

// Up to so many columns of the target, copying panels of a costs more than it brings.
constexpr std::ptrdiff_t fewColumns = 16;

/** Panels of `height` rows, each depth by depth; rows beyond the last are 0. */
template <std::ptrdiff_t height>
void pack (const double* from, std::ptrdiff_t rowStep, std::ptrdiff_t depthStep, std::ptrdiff_t rows,
           std::ptrdiff_t depth, double* to)
{
    constexpr std::ptrdiff_t strip = 8; // of the depth: what is written stays in the first cache

    for (std::ptrdiff_t first = 0; first < rows; first += height)
    {
        const auto count = std::min (height, rows - first);
        const auto* panel = from + first * rowStep;

        if (count == height && rowStep == 1)
            for (std::ptrdiff_t k = 0; k < depth; ++k)
                for (std::ptrdiff_t r = 0; r < height; ++r)
                    to[k * height + r] = panel[k * depthStep + r];
        else
            for (std::ptrdiff_t start = 0; start < depth; start += strip)
                for (std::ptrdiff_t r = 0; r < height; ++r)
                    for (auto k = start; k < std::min (start + strip, depth); ++k)
                        to[k * height + r] = r < count ? panel[r * rowStep + k * depthStep] : 0;

        to += height * depth;
    }
}

/** Panels of two matrices, packed to a depth, and what their product is multiplied by. */
struct Panels
{
    const double* a;
    const double* b;
    std::ptrdiff_t depth;
    double factor;
};

/** One tile: to += factor (panel of a) (panel of b). */
HWY_INLINE void addTile (Panels panels, double* to, std::ptrdiff_t stride)
{
    const auto* a = panels.a;
    const auto* b = panels.b;
    const Tag tag;
    Vector sums[tileColumns][vectors];

#pragma GCC unroll 8
    for (std::ptrdiff_t j = 0; j < tileColumns; ++j)
#pragma GCC unroll 3
        for (std::ptrdiff_t v = 0; v < vectors; ++v)
            sums[j][v] = hn::Zero (tag);

    for (std::ptrdiff_t k = 0; k < panels.depth; ++k)
    {
        const auto a0 = hn::Load (tag, a), a1 = hn::Load (tag, a + lanes), a2 = hn::Load (tag, a + 2 * lanes);

#pragma GCC unroll 8
        for (std::ptrdiff_t j = 0; j < tileColumns; ++j)
        {
            const auto value = hn::Set (tag, b[j]);
            sums[j][0] = hn::MulAdd (a0, value, sums[j][0]);
            sums[j][1] = hn::MulAdd (a1, value, sums[j][1]);
            sums[j][2] = hn::MulAdd (a2, value, sums[j][2]);
        }

        a += tileRows;
        b += tileColumns;
    }

    const auto scale = hn::Set (tag, panels.factor);

#pragma GCC unroll 8
    for (std::ptrdiff_t j = 0; j < tileColumns; ++j)
#pragma GCC unroll 3
        for (std::ptrdiff_t v = 0; v < vectors; ++v)
        {
            auto* place = to + j * stride + v * lanes;
            hn::StoreU (hn::MulAdd (sums[j][v], scale, hn::LoadU (tag, place)), tag, place);
        }
}

/** A tile at the end of the matrix or across its diagonal: only what belongs there is written. */
void addPartOfTile (Panels panels, const ProductTarget& target, std::ptrdiff_t row, std::ptrdiff_t column)
{
    HWY_ALIGN double tile[tileRows * tileColumns] = {};
    addTile (panels, tile, tileRows);
    const auto rows = std::min (tileRows, target.rows - row), columns = std::min (tileColumns, target.columns - column);

    for (std::ptrdiff_t j = 0; j < columns; ++j)
        for (auto i = target.isLowerOnly ? std::max<std::ptrdiff_t> (0, column + j - row) : 0; i < rows; ++i)
            target.data[row + i + (column + j) * target.stride] += tile[i + j * tileRows];
}

struct Range
{
    std::ptrdiff_t start, end;
};

void addPanels (const ProductTarget& target, const Panels& all, Range rows, Range columns)
{
    auto panels = all;

    for (auto column = columns.start; column < columns.end; column += tileColumns, panels.b += tileColumns * all.depth)
    {
        panels.a = all.a;

        for (auto row = rows.start; row < rows.end; row += tileRows, panels.a += tileRows * all.depth)
        {
            if (target.isLowerOnly && row + tileRows <= column)
                continue;

            const auto isWhole = row + tileRows <= target.rows && column + tileColumns <= target.columns
                                 && (! target.isLowerOnly || row >= column + tileColumns);

            if (isWhole)
                addTile (panels, target.data + row + column * target.stride, target.stride);
            else
                addPartOfTile (panels, target, row, column);
        }
    }
}

void addProduct (const ProductTarget& target, std::ptrdiff_t depth, double factor, const MatrixInMemory& a,
                 const MatrixInMemory& b)
{
    constexpr auto rowRoom = (maximumRows + tileRows - 1) / tileRows * tileRows;
    ANTINODE_KEPT_BY_THREAD const auto packedA = hwy::AllocateAligned<double> (rowRoom * maximumDepth);
    ANTINODE_KEPT_BY_THREAD const auto packedB = hwy::AllocateAligned<double> (maximumColumns * maximumDepth);

    for (std::ptrdiff_t column = 0; column < target.columns; column += maximumColumns)
        for (std::ptrdiff_t k = 0; k < depth; k += maximumDepth)
        {
            const Range columns { column, std::min (column + maximumColumns, target.columns) };
            const auto part = std::min (maximumDepth, depth - k);
            pack<tileColumns> (b.data + k * b.rowStep + column * b.columnStep, b.columnStep, b.rowStep,
                               columns.end - column, part, packedB.get());
            const auto* across = a.data + k * a.columnStep;

            for (auto row = target.isLowerOnly ? column / rowRoom * rowRoom : 0; row < target.rows; row += rowRoom)
            {
                checkWatch();
                const Range rows { row, std::min (row + rowRoom, target.rows) };
                pack<tileRows> (across + row * a.rowStep, a.rowStep, a.columnStep, rows.end - row, part, packedA.get());
                addPanels (target, { packedA.get(), packedB.get(), part, factor }, rows, columns);
            }
        }
}

/** The same where both lie in memory along the depth and the target has few columns: sums of products of vectors,
    nothing is copied. */
void addDots (const ProductTarget& target, std::ptrdiff_t depth, double factor, const MatrixInMemory& a,
              const MatrixInMemory& b)
{
    constexpr std::ptrdiff_t dotRows = 4, dotColumns = lanes >= 8 ? 4 : 2;
    const Tag tag;
    const auto whole = depth / lanes * lanes;

    for (std::ptrdiff_t row = 0; row < target.rows; row += dotRows)
    {
        checkWatch();

        for (std::ptrdiff_t column = 0; column < target.columns; column += dotColumns)
        {
            // Beyond the last, the last once more.
            const double* left[dotRows];
            const double* right[dotColumns];
            Vector sums[dotRows][dotColumns];

            for (std::ptrdiff_t i = 0; i < dotRows; ++i)
                left[i] = a.data + std::min (row + i, target.rows - 1) * a.rowStep;

            for (std::ptrdiff_t j = 0; j < dotColumns; ++j)
                right[j] = b.data + std::min (column + j, target.columns - 1) * b.columnStep;

#pragma GCC unroll 4
            for (std::ptrdiff_t i = 0; i < dotRows; ++i)
#pragma GCC unroll 4
                for (std::ptrdiff_t j = 0; j < dotColumns; ++j)
                    sums[i][j] = hn::Zero (tag);

            for (std::ptrdiff_t k = 0; k < whole; k += lanes)
#pragma GCC unroll 4
                for (std::ptrdiff_t i = 0; i < dotRows; ++i)
                {
                    const auto value = hn::LoadU (tag, left[i] + k);

#pragma GCC unroll 4
                    for (std::ptrdiff_t j = 0; j < dotColumns; ++j)
                        sums[i][j] = hn::MulAdd (value, hn::LoadU (tag, right[j] + k), sums[i][j]);
                }

            for (std::ptrdiff_t i = 0; i < std::min (dotRows, target.rows - row); ++i)
                for (std::ptrdiff_t j = 0; j < std::min (dotColumns, target.columns - column); ++j)
                {
                    auto sum = hn::GetLane (hn::SumOfLanes (tag, sums[i][j]));

                    for (auto k = whole; k < depth; ++k)
                        sum += left[i][k] * right[j][k];

                    target.data[row + i + (column + j) * target.stride] += factor * sum;
                }
        }
    }
}

/** Rotations of neighbouring columns, in order, on a strip of rows that stays in the cache. */
void rotate (double* strip, const PlaneRotation* rotations, std::ptrdiff_t count)
{
    const Tag tag;

    for (std::ptrdiff_t n = 0; n < count; ++n)
    {
        const auto cosine = hn::Set (tag, rotations[n].cosine), sine = hn::Set (tag, rotations[n].sine);
        auto* first = strip + rotations[n].column * rotationRows;
        auto* second = first + rotationRows;

#pragma GCC unroll 4
        for (std::ptrdiff_t r = 0; r < rotationRows; r += lanes)
        {
            const auto x = hn::LoadU (tag, first + r), y = hn::LoadU (tag, second + r);
            hn::StoreU (hn::MulSub (cosine, x, hn::Mul (sine, y)), tag, first + r);
            hn::StoreU (hn::MulAdd (sine, x, hn::Mul (cosine, y)), tag, second + r);
        }
    }
}
} // namespace

void addProductByVectors (const ProductTarget& target, std::ptrdiff_t depth, double factor, const MatrixInMemory& a,
                          const MatrixInMemory& b)
{
    if (a.columnStep == 1 && a.rowStep != 1 && b.rowStep == 1 && target.columns <= fewColumns && ! target.isLowerOnly)
        addDots (target, depth, factor, a, b);
    else
        addProduct (target, depth, factor, a, b);
}

void rotateByVectors (double* strip, const PlaneRotation* rotations, std::ptrdiff_t count)
{
    rotate (strip, rotations, count);
}
} // namespace antinode::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace antinode
{
namespace
{
HWY_EXPORT (addProductByVectors);
HWY_EXPORT (rotateByVectors);
} // namespace

void addProductInMemory (const ProductTarget& target, std::ptrdiff_t depth, double factor, const MatrixInMemory& a,
                         const MatrixInMemory& b)
{
    HWY_DYNAMIC_DISPATCH (addProductByVectors) (target, depth, factor, a, b);
}

void rotateColumns (double* strip, const PlaneRotation* rotations, std::ptrdiff_t count)
{
    HWY_DYNAMIC_DISPATCH (rotateByVectors) (strip, rotations, count);
}
} // namespace antinode
#endif
