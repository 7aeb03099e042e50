#pragma once

#include "MeasuredResponse.h"

#include <Eigen/Core>

namespace antinode
{
/** The meaning of pairs of columns in a table whose headings do not describe them. */
enum class CsvForm
{
    byHeadings, ///< Real and imaginary part where there are no headings.
    realImaginary,
    magnitudeDegrees,
    magnitudeRadians,
    decibelDegrees,
    decibelRadians
};

/** The interval of samples with these times, s. @throws InputError  source, where they are not even [worker] */
double samplingInterval (const Eigen::VectorXd& times, const std::string& source);

/** Frequency responses from a table: frequency first, then two columns a response. Headings tell what a column holds
   (real, imag; magnitude, dB, phase, deg, rad; coherence, which is left out), of which point and reference (P3 C1,
   "point 3 driver 1") and in which unit; units also stand in comments. Where the first column is a time the others are
   impulse responses.
    @param source  how errors and remarks name the file
    @throws InputError  source, place, what is wrong
    [worker] Docs/FileFormats.md. */
MeasurementFile measurementFromCsv (std::string_view text, const std::string& source, CsvForm);

/** The frequency response of an impulse response. N_f lines, from 0 Hz to half the sample rate. */
struct ImpulseSpectrum
{
    Eigen::VectorXd frequencies; ///< N_f: Hz
    Eigen::VectorXcd values;     ///< N_f, the samples' unit times s.
    double recordLength = 0; ///< s: T. What of the impulse response lies behind T is cut off, so that a pole s has its
                             ///< residue multiplied by 1 - e^{sT} on these lines.
};

/** The Fourier transform of samples with this interval, as far as their number has no prime factor above 5.
    @param samples   2 or more
    @param interval  s, more than 0
    [worker] Docs/Theory.md, section 8.1. */
ImpulseSpectrum impulseSpectrum (const Eigen::VectorXd& samples, double interval);
} // namespace antinode
