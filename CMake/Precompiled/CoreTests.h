// Precompiled for the tests that need no JUCE.
#include "Documents.h"

#include <catch2/catch.hpp>
