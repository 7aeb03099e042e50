// Precompiled for the rooms that read and write documents.
#include "Core.h"

#include <nlohmann/json.hpp>
