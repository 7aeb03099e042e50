#pragma once

#include <antinode_model/ModalModel.h>

#include <utility>
#include <vector>

namespace antinode::test
{
/** A simply supported aluminium plate of 200 x 150 x 2 mm in closed form: shapes sin (m pi x / a) sin (n pi y / b),
   omega = pi^2
    ((m/a)^2 + (n/b)^2) sqrt (D / mu), 340 Hz the lowest. Blevins 1979, table 11-4. */
struct SinePlate
{
    double lengthX = 0.2, lengthY = 0.15, thickness = 0.002;          // m
    double young = 70e9, poisson = 0.33, density = 2700;              // Pa, 1, kg/m^3
    double momentPerVolt = -0.044;                                    // N / V, of a ceramic of some 0.5 mm
    int segments = 4, placesPerSegment = 12, columns = 4, rows = 3;   // of the grid along either side; of the ceramics
    double ceramicLength = 0.022, ceramicWidth = 0.018, quality = 60; // m, m, 1

    double massPerArea() const { return density * thickness; }

    /** The lowest modes: pairs of half waves in x and y, ascending in frequency. */
    std::vector<std::pair<int, int>> halfWaves (int modes) const;

    /** A grid of ceramics, shifted unevenly, so that no mode is blind to all of them. */
    std::vector<Ceramic> ceramics() const;

    /** alpha = kappa times the integral of the shape's Laplacian over the patch. */
    double participation (const Ceramic&, std::pair<int, int> half) const;

    /** The largest value of every mass-normalised shape, kg^-1/2. */
    double amplitude() const;

    Surface surface() const;

    ModalModel model (int modes) const;
};

/** The same plate as measured: points scattered evenly without a grid. */
ModalModel scatteredPlate (int modes, int points);
} // namespace antinode::test
