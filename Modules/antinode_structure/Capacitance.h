#pragma once

#include "DeviceDescription.h"

namespace antinode
{
/** The capacitance that an amplifier sees of a ceramic, or of a pair as it is wired. F.
    @return  0 where the material's permittivity is not known
    [any] Docs/Theory.md, section 1.10. */
double capacitance (const CeramicDescription&);

/** How fast the voltage of a ceramic may change, V/s: what its amplifier can, or what its current into the capacitance allows where
    that is less. 0: as fast as it likes.
    @param ceramic  its index
    @throws InputError  where the current is limited and the permittivity is not known
    [any] Docs/Theory.md, section 1.10. */
double slewLimit (const StructureCommon&, std::size_t ceramic);
} // namespace antinode
