#pragma once

#include "IdentificationReport.h"

#include <Eigen/Core>

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace antinode
{
/** A page to work with an identification in a browser: stabilisation diagram with zoom, candidates to pick and reject,
   the option of `antinode identify` that says so, mode indicator, each response against its synthesis with the error,
   moving shapes. One HTML file with its script, no network. Its state is in the address after #: Docs/Manual,
   identification.
    @param reportName  the file of the static report in the same folder; none if empty
    [worker] */
std::string identificationDiagram (const IdentificationResult&, const std::string& reportName);

/** What the script of an identification's diagram draws: poles, candidates, modes with shapes, mode indicator, and what
   the modes leave of each response. Large arrays are base64. Resources/Diagram reads it. [worker] */
nlohmann::json diagramData (const IdentificationResult&);

/** Numbers as base64 of 8-byte or 4-byte floating point, little-endian, for scripts of pages. [any] */
std::string compactDoubles (const Eigen::VectorXd&);
std::string compactFloats (const Eigen::VectorXd&);

/** Small whole numbers as base64 of one byte each. Values: 0 to 255. [any] */
std::string compactBytes (const Eigen::VectorXi&);

/** Complex numbers as base64 of two bytes each: a level in half decibels, 254 for the largest, 0 for 0 and what lies
   more than 126 dB below it, 255 where a number is not finite; and an angle in 256 parts of a turn. Exact to 0.25 dB
   and 0.7 degrees.
    @param largest  the largest absolute value [any] */
std::string compactComplex (const Eigen::VectorXcd&, double largest);
} // namespace antinode
