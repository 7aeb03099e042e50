// Precompiled for the command line.
#include "Documents.h"

#include <CLI/CLI.hpp>
