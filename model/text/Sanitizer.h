// What the compiler watches. With AddressSanitizer limits on memory, and counting it, have no sense; with either,
// code is many times slower.
#pragma once

// GCC says so by a macro, clang by a feature.
#if defined(__SANITIZE_ADDRESS__)
#define BOLSTER_ADDRESS_SANITIZER 1
#elif defined(__SANITIZE_THREAD__)
#define BOLSTER_THREAD_SANITIZER 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define BOLSTER_ADDRESS_SANITIZER 1
#elif __has_feature(thread_sanitizer)
#define BOLSTER_THREAD_SANITIZER 1
#endif
#endif
