#include "FailingMemory.h"

#include "Sanitizer.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>

namespace {

std::atomic<bool> armed = false;
std::atomic<std::int64_t> left = 0; // before one fails
std::atomic<std::int64_t> made = 0;
std::atomic<std::thread::id> sparedThread;

bool failsNow()
{
    if (!armed.load(std::memory_order_acquire) ||
        std::this_thread::get_id() == sparedThread.load(std::memory_order_relaxed))
        return false;
    ++made;
    return left.fetch_sub(1) == 0;
}

/// Null when it fails.
void* tryAllocate(std::size_t size, std::size_t alignment) noexcept
{
    const std::size_t whole = (std::max<std::size_t>(size, 1) + alignment - 1) / alignment * alignment;
    return failsNow() ? nullptr : std::aligned_alloc(alignment, whole);
}

void* allocate(std::size_t size, std::size_t alignment)
{
    if (void* memory = tryAllocate(size, alignment))
        return memory;
    throw std::bad_alloc();
}

} // namespace

namespace bolster::test {

FailingMemory::FailingMemory(std::int64_t n, std::thread::id spared)
{
    sparedThread = spared;
    left = n;
    made = 0;
    armed.store(true, std::memory_order_release);
}

FailingMemory::~FailingMemory()
{
    armed = false;
}

std::int64_t FailingMemory::allocations() const
{
    return made;
}

} // namespace bolster::test

#if defined(BOLSTER_ADDRESS_SANITIZER)
// CGAL's Compact_container loses a block when there is no memory to note it down with.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions()
{
    return "leak:CGAL/Compact_container.h\n";
}
#endif

void* operator new(std::size_t size)
{
    return allocate(size, alignof(std::max_align_t));
}

void* operator new(std::size_t size, std::align_val_t alignment)
{
    return allocate(size, static_cast<std::size_t>(alignment));
}

void* operator new(std::size_t size, const std::nothrow_t&) noexcept
{
    return tryAllocate(size, alignof(std::max_align_t));
}

void* operator new(std::size_t size, std::align_val_t alignment, const std::nothrow_t&) noexcept
{
    return tryAllocate(size, static_cast<std::size_t>(alignment));
}

void operator delete(void* memory) noexcept
{
    std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept
{
    std::free(memory);
}

void operator delete(void* memory, std::align_val_t) noexcept
{
    std::free(memory);
}

void operator delete(void* memory, std::size_t, std::align_val_t) noexcept
{
    std::free(memory);
}

void operator delete(void* memory, const std::nothrow_t&) noexcept
{
    std::free(memory);
}

void operator delete(void* memory, std::align_val_t, const std::nothrow_t&) noexcept
{
    std::free(memory);
}
