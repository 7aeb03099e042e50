#include "SobolSequence.h"

#include <array>
#include <bit>
#include <stdexcept>

// The numbers of the table below are the first of new-joe-kuo-6.21201, https://web.maths.unsw.edu.au/~fkuo/sobol/:
//
// Copyright (c) 2008, Frances Y. Kuo and Stephen Joe. All rights reserved.
//
// Redistribution and use in source and binary forms, with or without modification, are permitted provided that the
// following conditions are met: Redistributions of source code must retain the above copyright notice, this list of
// conditions and the following disclaimer. Redistributions in binary form must reproduce the above copyright notice,
// this list of conditions and the following disclaimer in the documentation and/or other materials provided with the
// distribution. Neither the names of the copyright holders nor the names of the University of New South Wales and the
// University of Waikato and its contributors may be used to endorse or promote products derived from this software
// without specific prior written permission.
//
// THIS SOFTWARE IS PROVIDED BY THE COPYRIGHT HOLDERS "AS IS" AND ANY EXPRESS OR IMPLIED WARRANTIES, INCLUDING, BUT NOT
// LIMITED TO, THE IMPLIED WARRANTIES OF MERCHANTABILITY AND FITNESS FOR A PARTICULAR PURPOSE ARE DISCLAIMED. IN NO
// EVENT SHALL THE COPYRIGHT HOLDERS BE LIABLE FOR ANY DIRECT, INDIRECT, INCIDENTAL, SPECIAL, EXEMPLARY, OR
// CONSEQUENTIAL DAMAGES (INCLUDING, BUT NOT LIMITED TO, PROCUREMENT OF SUBSTITUTE GOODS OR SERVICES; LOSS OF USE, DATA,
// OR PROFITS; OR BUSINESS INTERRUPTION) HOWEVER CAUSED AND ON ANY THEORY OF LIABILITY, WHETHER IN CONTRACT, STRICT
// LIABILITY, OR TORT (INCLUDING NEGLIGENCE OR OTHERWISE) ARISING IN ANY WAY OUT OF THE USE OF THIS SOFTWARE, EVEN IF
// ADVISED OF THE POSSIBILITY OF SUCH DAMAGE.

namespace antinode
{
namespace
{
constexpr int bits = 32, mostNumbers = 7;

struct TableRow
{
    int degree;
    std::uint32_t coefficients;
    std::array<std::uint32_t, mostNumbers> numbers;
};

constexpr std::array<TableRow, sobolDimensions - 1> table { {
    { 1, 0, { 1 } },
    { 2, 1, { 1, 3 } },
    { 3, 1, { 1, 3, 1 } },
    { 3, 2, { 1, 1, 1 } },
    { 4, 1, { 1, 1, 3, 3 } },
    { 4, 4, { 1, 3, 5, 13 } },
    { 5, 2, { 1, 1, 5, 5, 17 } },
    { 5, 4, { 1, 1, 5, 5, 5 } },
    { 5, 7, { 1, 1, 7, 11, 19 } },
    { 5, 11, { 1, 1, 5, 1, 1 } },
    { 5, 13, { 1, 1, 1, 3, 11 } },
    { 5, 14, { 1, 3, 5, 5, 31 } },
    { 6, 1, { 1, 3, 3, 9, 7, 49 } },
    { 6, 13, { 1, 1, 1, 15, 21, 21 } },
    { 6, 16, { 1, 3, 1, 13, 27, 49 } },
    { 6, 19, { 1, 1, 1, 15, 7, 5 } },
    { 6, 22, { 1, 3, 1, 15, 13, 25 } },
    { 6, 25, { 1, 1, 5, 5, 19, 61 } },
    { 7, 1, { 1, 3, 7, 11, 23, 15, 103 } },
    { 7, 4, { 1, 3, 7, 13, 13, 15, 69 } },
    { 7, 7, { 1, 1, 3, 13, 7, 35, 63 } },
    { 7, 8, { 1, 3, 5, 9, 1, 25, 53 } },
    { 7, 14, { 1, 3, 1, 13, 9, 35, 107 } },
    { 7, 19, { 1, 3, 1, 5, 27, 61, 31 } },
    { 7, 21, { 1, 1, 5, 11, 19, 41, 61 } },
    { 7, 28, { 1, 3, 5, 3, 3, 13, 69 } },
    { 7, 31, { 1, 1, 7, 13, 1, 19, 1 } },
    { 7, 32, { 1, 3, 7, 5, 13, 19, 59 } },
    { 7, 37, { 1, 1, 3, 9, 25, 29, 41 } },
    { 7, 41, { 1, 3, 5, 13, 23, 1, 55 } },
    { 7, 42, { 1, 3, 7, 3, 13, 59, 17 } },
} };

using Directions = std::array<std::uint32_t, bits>;

/** The recurrence of Bratley and Fox. */
Directions directionsOf (int dimension)
{
    const auto [degree, coefficients, numbers] = sobolDirection (dimension);
    Directions directions {};

    for (int i = 0; i < bits; ++i)
    {
        auto& direction = directions[static_cast<std::size_t> (i)];
        const auto before = [&] (int back) { return directions[static_cast<std::size_t> (i - back)]; };

        if (i < degree || degree == 0)
        {
            direction = (degree == 0 ? 1 : numbers[static_cast<std::size_t> (i)]) << (bits - 1 - i);
            continue;
        }

        direction = before (degree) ^ (before (degree) >> degree);

        for (int k = 1; k < degree; ++k)
            if (((coefficients >> (degree - 1 - k)) & 1) != 0)
                direction ^= before (k);
    }

    return directions;
}
} // namespace

SobolDirection sobolDirection (int dimension)
{
    if (dimension < 0 || dimension >= sobolDimensions)
        throw std::logic_error ("Sobol's sequence has no such dimension");

    if (dimension == 0)
        return {};

    const auto& row = table[static_cast<std::size_t> (dimension - 1)];
    return { row.degree, row.coefficients, std::span (row.numbers).first (static_cast<std::size_t> (row.degree)) };
}

std::uint32_t sobolPoint (std::uint32_t index, int dimension)
{
    static const auto all = []
    {
        std::array<Directions, sobolDimensions> each {};

        for (int d = 0; d < sobolDimensions; ++d)
            each[static_cast<std::size_t> (d)] = directionsOf (d);

        return each;
    }();
    const auto& directions = all.at (static_cast<std::size_t> (dimension));
    std::uint32_t point = 0;

    for (auto gray = index ^ (index >> 1); gray != 0; gray &= gray - 1)
        point ^= directions[static_cast<std::size_t> (std::countr_zero (gray))];

    return point;
}
} // namespace antinode
