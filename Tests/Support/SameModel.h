#pragma once

#include <antinode_model/ModalModel.h>

#include <algorithm>
#include <cstring>

namespace antinode::test
{
/** True where both have the same size and the same bits: -0 is not 0. */
template <typename Derived>
bool isSameToTheBit (const Eigen::PlainObjectBase<Derived>& a, const Eigen::PlainObjectBase<Derived>& b)
{
    const auto bytes = static_cast<std::size_t> (a.size()) * sizeof (typename Derived::Scalar);
    return a.rows() == b.rows() && a.cols() == b.cols() && (bytes == 0 || std::memcmp (a.data(), b.data(), bytes) == 0);
}

inline bool isSameToTheBit (double a, double b)
{
    return std::memcmp (&a, &b, sizeof (double)) == 0;
}

inline bool isSameToTheBit (const GridAxis& a, const GridAxis& b)
{
    return isSameToTheBit (a.places, b.places) && isSameToTheBit (a.weights, b.weights)
           && isSameToTheBit (a.edges, b.edges) && isSameToTheBit (a.first, b.first);
}

inline bool isSameToTheBit (const PathPiece& a, const PathPiece& b)
{
    return isSameToTheBit (a.start, b.start) && isSameToTheBit (a.end, b.end) && isSameToTheBit (a.centre, b.centre)
           && isSameToTheBit (a.cosine, b.cosine) && isSameToTheBit (a.sine, b.sine) && isSameToTheBit (a.from, b.from)
           && isSameToTheBit (a.to, b.to) && a.isStraight == b.isStraight && a.edge == b.edge;
}

template <typename Value>
bool isSameToTheBit (const std::vector<Value>& a, const std::vector<Value>& b)
{
    return std::equal (a.begin(), a.end(), b.begin(), b.end(),
                       [] (const auto& left, const auto& right) { return isSameToTheBit (left, right); });
}

inline bool isSameToTheBit (const std::optional<SurfaceBoundary>& a, const std::optional<SurfaceBoundary>& b)
{
    return a.has_value() == b.has_value()
           && (! a || (isSameToTheBit (a->outline.paths, b->outline.paths) && isSameToTheBit (a->held, b->held)));
}

inline bool isSameToTheBit (const Surface& a, const Surface& b)
{
    const auto sameGrid =
        a.grid.has_value() == b.grid.has_value()
        && (! a.grid || (isSameToTheBit (a.grid->x, b.grid->x) && isSameToTheBit (a.grid->y, b.grid->y)));
    return sameGrid && a.kind == b.kind && isSameToTheBit (a.xMinimum, b.xMinimum)
           && isSameToTheBit (a.xMaximum, b.xMaximum) && isSameToTheBit (a.yMinimum, b.yMinimum)
           && isSameToTheBit (a.yMaximum, b.yMaximum) && isSameToTheBit (a.points, b.points)
           && isSameToTheBit (a.masses, b.masses) && isSameToTheBit (a.areas, b.areas) && a.held.left == b.held.left
           && a.held.right == b.held.right && a.held.bottom == b.held.bottom && a.held.top == b.held.top
           && isSameToTheBit (a.boundary, b.boundary);
}

inline bool isSameToTheBit (const Ceramic& a, const Ceramic& b)
{
    return a.name == b.name && isSameToTheBit (a.xMinimum, b.xMinimum) && isSameToTheBit (a.xMaximum, b.xMaximum)
           && isSameToTheBit (a.yMinimum, b.yMinimum) && isSameToTheBit (a.yMaximum, b.yMaximum)
           && isSameToTheBit (a.voltageLimit, b.voltageLimit) && isSameToTheBit (a.slewLimit, b.slewLimit)
           && isSameToTheBit (a.capacitance, b.capacitance) && isSameToTheBit (a.lossFactor, b.lossFactor)
           && isSameToTheBit (a.area, b.area) && isSameToTheBit (a.currentLimit, b.currentLimit)
           && isSameToTheBit (a.amplifierVoltage, b.amplifierVoltage)
           && isSameToTheBit (a.outline.paths, b.outline.paths);
}

inline bool isSameToTheBit (const ModalModel& a, const ModalModel& b)
{
    return a.name == b.name && isSameToTheBit (a.surface, b.surface)
           && isSameToTheBit (a.angularFrequencies, b.angularFrequencies)
           && isSameToTheBit (a.dampingRatios, b.dampingRatios) && isSameToTheBit (a.shapes, b.shapes)
           && isSameToTheBit (a.slopes, b.slopes) && isSameToTheBit (a.participation, b.participation)
           && isSameToTheBit (a.staticShare, b.staticShare)
           && std::equal (a.ceramics.begin(), a.ceramics.end(), b.ceramics.begin(), b.ceramics.end(),
                          [] (const auto& left, const auto& right) { return isSameToTheBit (left, right); })
           && isSameToTheBit (a.fullScaleVoltage, b.fullScaleVoltage) && a.coversWholeBody == b.coversWholeBody
           && a.rigidBodyModes == b.rigidBodyModes && a.unknowns == b.unknowns
           && isSameToTheBit (a.frequencyErrors, b.frequencyErrors);
}
} // namespace antinode::test
