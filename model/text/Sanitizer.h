// Whether the compiler watches memory: limits on it, and counting it, have no sense then.
#pragma once

// GCC says so by a macro, clang by a feature.
#if defined(__SANITIZE_ADDRESS__)
#define BOLSTER_ADDRESS_SANITIZER 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define BOLSTER_ADDRESS_SANITIZER 1
#endif
#endif
