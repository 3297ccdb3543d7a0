// Elementary functions made of +, -, *, / and sqrt only.
//
// IEEE 754 fixes the result of those five to the last bit; it does not fix log or the normal
// quantile, whose library versions differ between systems and even between processors.
#pragma once

namespace rupture {

/// Natural logarithm of x, for finite normal x > 0; within 1e-15 relative or 1e-16 absolute.
double exact_log(double x);

/// Quantile of the standard normal distribution for p in (0, 1), relative accuracy about 1e-15.
/// Rational approximations of Wichura, Appl. Stat. 37, 477 (1988), algorithm AS 241.
double normal_quantile(double p);

}  // namespace rupture
