// Precompiled for the tests that need no JUCE.
#include "Documents.h"

// Listeners, for who needs them.
#define CATCH_CONFIG_EXTERNAL_INTERFACES
#include <catch2/catch.hpp>
