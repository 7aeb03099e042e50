#pragma once

// Catch2 3 as the tests, written for version 2, name it.
#include <catch2/catch_all.hpp>

#include <string>

namespace Catch
{
using namespace Matchers;
using TestEventListenerBase = EventListenerBase;

/** A text within a text; version 3 has the name for elements of a range. */
inline auto Contains (const std::string& text, CaseSensitive sensitive = CaseSensitive::Yes)
{
    return ContainsSubstring (text, sensitive);
}
} // namespace Catch

using Catch::Approx;
