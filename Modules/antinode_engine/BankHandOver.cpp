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
    while (const auto bank = returned.pop())
        delete *bank;
}

bool BankHandOver::canGiveBack() const
{
    return returned.size() < returned.capacity;
}

void BankHandOver::giveBack (const FocusBank* bank)
{
    returned.push (bank);
}
} // namespace antinode
