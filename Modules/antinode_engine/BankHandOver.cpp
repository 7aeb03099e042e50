#include "BankHandOver.h"

namespace antinode
{
BankHandOver::~BankHandOver()
{
    collect();
    delete next.load();
}

void BankHandOver::give (std::unique_ptr<const FocusBank> bank)
{
    collect();
    delete next.exchange (bank.release(), std::memory_order_acq_rel);
}

void BankHandOver::collect()
{
    auto at = read.load (std::memory_order_relaxed);

    for (const auto end = written.load (std::memory_order_acquire); at != end; ++at)
        delete returned[at % capacity];

    read.store (at, std::memory_order_release);
}

bool BankHandOver::canGiveBack() const
{
    return written.load (std::memory_order_relaxed) - read.load (std::memory_order_acquire) < capacity;
}

void BankHandOver::giveBack (const FocusBank* bank)
{
    const auto at = written.load (std::memory_order_relaxed);
    returned[at % capacity] = bank;
    written.store (at + 1, std::memory_order_release);
}
} // namespace antinode
