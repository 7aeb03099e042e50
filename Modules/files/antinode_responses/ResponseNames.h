#pragma once

#include "MeasuredResponse.h"

namespace antinode
{
/** All responses of several files with names of point and reference. Points without names are numbered within their
   file where it has several for a reference; what is then not named is numbered by the files where these differ in
   nothing else, else it is 1. [worker] Docs/FileFormats.md. */
std::vector<MeasuredResponse> namedResponses (const std::vector<MeasurementFile>&);
} // namespace antinode
