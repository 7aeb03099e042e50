// Precompiled for the tests that need no JUCE.
#include "Documents.h"

// Listeners, for who needs them.
#define CATCH_CONFIG_EXTERNAL_INTERFACES
#define CATCH_CONFIG_FAST_COMPILE
#include <catch2/catch.hpp>
