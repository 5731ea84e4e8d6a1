// SPDX-License-Identifier: MIT
#pragma once
// Memory for what is large and read in no order: in pages of 2 MiB where the system has them.

#include <cstddef>
#include <cstdlib>
#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace lantern {

/// For std::vector. A processor remembers where some two thousand pages are; pages of 4 KiB make that eight megabytes, and
/// beyond that each access looks two addresses up. It asks for large pages (madvise(2)); whether it gets them is up to the
/// system. Small requests are served as usual. Elements are left as they are: `vector(n)` writes no zeros.
template <class T>
struct large_page_allocator {
    using value_type = T;

    large_page_allocator() = default;
    template <class U>
    large_page_allocator(const large_page_allocator<U>&) {}  // NOLINT: allocators convert

    [[nodiscard]] T* allocate(std::size_t count) {
        if (count > static_cast<std::size_t>(-1) / sizeof(T)) throw std::bad_array_new_length();
        const std::size_t bytes = count * sizeof(T);
        if (bytes < worthwhile) return static_cast<T*>(::operator new(bytes, std::align_val_t{alignof(T)}));
        void* const memory = std::aligned_alloc(page, (bytes + page - 1) / page * page);
        if (memory == nullptr) throw std::bad_alloc();
#if defined(__linux__) && defined(MADV_HUGEPAGE)
        (void)madvise(memory, bytes / page * page, MADV_HUGEPAGE);  // advice: if it is not taken, nothing is lost
#endif
        return static_cast<T*>(memory);
    }
    void deallocate(T* memory, std::size_t count) noexcept {
        if (count * sizeof(T) < worthwhile)
            ::operator delete(memory, std::align_val_t{alignof(T)});
        else
            std::free(memory);  // NOLINT: aligned_alloc's counterpart
    }
    template <class U>
    void construct(U* at) noexcept {
        ::new (static_cast<void*>(at)) U;
    }
    template <class U, class... Values>
    void construct(U* at, Values&&... values) {
        ::new (static_cast<void*>(at)) U(static_cast<Values&&>(values)...);
    }
    friend bool operator==(const large_page_allocator&, const large_page_allocator&) { return true; }

private:
    static constexpr std::size_t page = std::size_t{1} << 21, worthwhile = 2 * page;
};

}  // namespace lantern
