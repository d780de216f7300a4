#pragma once

#include <boost/multiprecision/cpp_int.hpp>

namespace xnewell {

/// A 128-bit integer for compilers that have none, on 32-bit processors. What int128.h says of Int128 holds
/// for it.
using WideInt128 = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<
    128, 128, boost::multiprecision::signed_magnitude, boost::multiprecision::unchecked, void>>;

}  // namespace xnewell
