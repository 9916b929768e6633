// Hot elementwise loops are compiled once for each vector width and chosen when the program starts. Without fused
// multiply-add (-ffp-contract=off) every version gives the same bits. g++ only; clang builds the plain version.
#pragma once

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
/// Put before a free function whose loops the compiler can vectorise. What the loop calls must be inlined: give helpers
/// SEAMOUNT_INLINE, and use no lambdas (they are not cloned).
#define SEAMOUNT_VECTORISED __attribute__((target_clones("default", "avx2", "avx512f")))
#define SEAMOUNT_INLINE inline __attribute__((always_inline))
#else
#define SEAMOUNT_VECTORISED
#define SEAMOUNT_INLINE inline
#endif
