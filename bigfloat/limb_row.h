/* limb_row.h: the inner loops of long multiplication on x86-64 with ADX and BMI2: z (+)= a b for a word b.

   mulx leaves the flags alone, adcx carries in CF and adox in OF: one chain adds the halves of neighbouring word
   products, the other adds z.  Both chains end inside a block of four limbs: the carry between blocks is a word, at
   most 2^64 - 1, because a 4-limb a times b plus z plus a word is below 2^320. */
#ifndef BIGFLOAT_LIMB_ROW_H
#define BIGFLOAT_LIMB_ROW_H

#include "limb.h"

#if LIMB_INT128 && defined(__x86_64__) && defined(__GNUC__)
#define LIMB_HAVE_ADX 1

/* Does the processor have both extensions?  (Every processor with AVX-512 does.) */
static inline bool limb_processor_has_adx(void)
{
#if defined(__ADX__) && defined(__BMI2__)
    return true;
#elif defined(__clang__)
    return __builtin_cpu_supports("bmi2") && __builtin_cpu_supports("avx512f");
#else
    return __builtin_cpu_supports("bmi2") && __builtin_cpu_supports("adx");
#endif
}

static inline limb_t limb_addmul_1_adx(limb_t *z, const limb_t *a, size_t n, limb_t b)
{
    limb_t carry = 0;
    for (; n % 4; n--, z++, a++)
        *z = limb_muladd(*a, b, *z, &carry);
    for (; n; n -= 4, z += 4, a += 4) {
        limb_t low, high, zero;
        __asm__("xorl %k[zero], %k[zero]\n\t" /* clears CF and OF */
                "mulx 0(%[a]), %[low], %[high]\n\t"
                "adcx %[carry], %[low]\n\t"
                "adox 0(%[z]), %[low]\n\t"
                "movq %[low], 0(%[z])\n\t"
                "mulx 8(%[a]), %[low], %[carry]\n\t"
                "adcx %[high], %[low]\n\t"
                "adox 8(%[z]), %[low]\n\t"
                "movq %[low], 8(%[z])\n\t"
                "mulx 16(%[a]), %[low], %[high]\n\t"
                "adcx %[carry], %[low]\n\t"
                "adox 16(%[z]), %[low]\n\t"
                "movq %[low], 16(%[z])\n\t"
                "mulx 24(%[a]), %[low], %[carry]\n\t"
                "adcx %[high], %[low]\n\t"
                "adox 24(%[z]), %[low]\n\t"
                "movq %[low], 24(%[z])\n\t"
                "adcx %[zero], %[carry]\n\t"
                "adox %[zero], %[carry]\n\t"
                : [carry] "+&r"(carry), [low] "=&r"(low), [high] "=&r"(high), [zero] "=&r"(zero)
                : [a] "r"(a), [z] "r"(z), "d"(b)
                : "cc", "memory");
    }
    return carry;
}

static inline limb_t limb_mul_1_adx(limb_t *z, const limb_t *a, size_t n, limb_t b)
{
    limb_t carry = 0;
    for (; n % 4; n--, z++, a++)
        *z = limb_muladd(*a, b, 0, &carry);
    for (; n; n -= 4, z += 4, a += 4) {
        limb_t low, high;
        __asm__("mulx 0(%[a]), %[low], %[high]\n\t"
                "addq %[carry], %[low]\n\t"
                "movq %[low], 0(%[z])\n\t"
                "mulx 8(%[a]), %[low], %[carry]\n\t"
                "adcq %[high], %[low]\n\t"
                "movq %[low], 8(%[z])\n\t"
                "mulx 16(%[a]), %[low], %[high]\n\t"
                "adcq %[carry], %[low]\n\t"
                "movq %[low], 16(%[z])\n\t"
                "mulx 24(%[a]), %[low], %[carry]\n\t"
                "adcq %[high], %[low]\n\t"
                "movq %[low], 24(%[z])\n\t"
                "adcq $0, %[carry]\n\t"
                : [carry] "+&r"(carry), [low] "=&r"(low), [high] "=&r"(high)
                : [a] "r"(a), [z] "r"(z), "d"(b)
                : "cc", "memory");
    }
    return carry;
}
#else
#define LIMB_HAVE_ADX 0
#endif

#endif
