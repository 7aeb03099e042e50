#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace antinode
{
/** Focus places of the paper: P1 to P5. */
inline constexpr std::size_t paperPlaces = 5;

/** One row of the paper's tables: a target shape on its five places. */
struct PaperRow
{
    std::string_view key;           ///< As in paper.json: "sinc25".
    std::string_view name;          ///< In words.
    int modes;                      ///< The number of modes that the paper controls.
    std::array<double, 5> captured; ///< Table C.1, sqrt (S/K).
    std::optional<std::array<double, 5>>
        vScore; ///< Table C.2, measured; none if the print repeats one number five times.
    double
        minimumPaperVScore; ///< The least score of the allocation by rows (29) in simulation: a lower one is an error.
};

/** Tables C.1 and C.2 of Enferad et al. 2019, places P1 to P5. */
inline constexpr std::array<PaperRow, 4> paperTables { {
    { "sinc25", "sinc 25 mm", 6, { .6831, .9418, .9755, .9359, .7124 }, std::nullopt, .999 },
    { "sinc18",
      "sinc 18 mm",
      9,
      { .8833, .9868, .9838, .9887, .9757 },
      { { .9792, .9885, .9902, .9611, .9945 } },
      .999 },
    { "sinc10",
      "sinc 10 mm",
      16,
      { .9521, .9948, .9897, .9928, .9981 },
      { { .8771, .9768, .9759, .9386, .9739 } },
      .997 },
    { "bump25",
      "bump 25 mm",
      7,
      { .8285, .9727, .9544, .9816, .8717 },
      { { .9877, .9953, .9911, .9609, .9973 } },
      .999 },
} };
} // namespace antinode
