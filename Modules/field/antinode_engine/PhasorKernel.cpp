#include "PhasorKernel.h"

#include <limits>

// Highway includes this file once a target, each time with another HWY_NAMESPACE.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "antinode_engine/PhasorKernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace antinode::HWY_NAMESPACE
{
namespace
{
namespace hn = hwy::HWY_NAMESPACE;

HWY_INLINE void findStripPhasors (const SoundingOscillation& oscillation, int strip, double* phasors)
{
    constexpr hn::CappedTag<double, synthesisStrip> tag;
    const auto minimum = hn::Set (tag, std::numeric_limits<double>::min() / std::numeric_limits<double>::epsilon());
    const auto* turns = oscillation.turns + strip * 2 * synthesisStrip;
    const auto anchorReal = hn::Set (tag, oscillation.anchorReal);
    const auto anchorImaginary = hn::Set (tag, oscillation.anchorImaginary);

    for (int t = 0; t < synthesisStrip; t += static_cast<int> (hn::MaxLanes (tag)))
    {
        const auto turnReal = hn::Load (tag, turns + t);
        const auto turnImaginary = hn::Load (tag, turns + synthesisStrip + t);
        const auto real = hn::NegMulAdd (anchorImaginary, turnImaginary, hn::Mul (anchorReal, turnReal));
        const auto imaginary = hn::MulAdd (anchorImaginary, turnReal, hn::Mul (anchorReal, turnImaginary));
        const auto audible = hn::Ge (hn::Max (hn::Abs (real), hn::Abs (imaginary)), minimum);
        hn::StoreU (hn::IfThenElseZero (audible, real), tag, phasors + t);
        hn::StoreU (hn::IfThenElseZero (audible, imaginary), tag, phasors + synthesisStrip + t);
    }
}

/** In a loop of its own: what is stored here must have reached the cache before single numbers are read from it. */
void findPhasors (SynthesisChunk& chunk, int strip)
{
    for (int c = 0; c < chunk.count; ++c)
        findStripPhasors (chunk.sounding[c], strip, chunk.phasors + c * 2 * synthesisStrip);
}
} // namespace

PhasorKernel phasorKernelOfTarget()
{
    return &findPhasors;
}
} // namespace antinode::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace antinode
{
namespace
{
HWY_EXPORT (phasorKernelOfTarget);
} // namespace

PhasorKernel phasorKernel()
{
    return HWY_DYNAMIC_DISPATCH (phasorKernelOfTarget)();
}
} // namespace antinode
#endif
