#include <antinode_session/NoteBank.h>

#include <catch2/catch.hpp>

#include <cmath>

using namespace antinode;

namespace
{
std::vector<int> takeAll (BankOrder order, std::span<const int> urgent = {})
{
    std::vector<int> places;

    while (! order.isEmpty())
        places.push_back (order.take (urgent).place);

    return places;
}
} // namespace

TEST_CASE ("Wanted places come first, the others outward from the first of them", "[graph]")
{
    CHECK (takeAll ({ {}, 4 }) == std::vector { 0, 1, 2, 3 });
    CHECK (takeAll ({ { 2 }, 5 }) == std::vector { 2, 1, 3, 0, 4 });
    CHECK (takeAll ({ { 1, 5 }, 6 }) == std::vector { 1, 5, 0, 2, 3, 4 });
    CHECK (takeAll ({ { 60 }, 3 }) == std::vector { 2, 1, 0 }); // Beyond the bank: passed over.
    CHECK (takeAll ({ { 60 }, 0 }).empty());
}

TEST_CASE ("An urgent place comes before the wanted ones, and both are awaited", "[graph]")
{
    BankOrder order ({ 1 }, 6);
    const std::vector urgent { 4, 9 };
    CHECK (order.take (urgent).place == 4);
    const auto wanted = order.take (urgent), other = order.take (urgent);
    CHECK (wanted.place == 1);
    CHECK (wanted.isAwaited);
    CHECK (other.place == 0);
    CHECK_FALSE (other.isAwaited);
}

TEST_CASE ("Velocities of notes are even steps of level from the threshold on where a focus has a level", "[session]")
{
    const auto decibels = [] (int velocity) { return 20 * std::log10 (noteAmplitude (velocity / 127.0, 25)); };
    CHECK (decibels (127) == Approx (0).margin (1e-9));
    CHECK (decibels (1) == Approx (-25)); // at the threshold
    CHECK (decibels (64) == Approx (-12.5));
    CHECK (noteAmplitude (64 / 127.0, 0) == 64 / 127.0);
    CHECK (noteAmplitude (0, 25) == 0);
}
