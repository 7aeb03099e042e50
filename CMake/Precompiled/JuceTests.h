// Precompiled for the tests that use JUCE.
#include "Juce.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
