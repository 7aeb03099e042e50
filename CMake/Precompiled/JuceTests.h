// Precompiled for the tests that use JUCE.
#include "Juce.h"

// Listeners, for who needs them.
#define CATCH_CONFIG_EXTERNAL_INTERFACES
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
