#pragma once

/// 128-bit integers, a compiler extension of gcc and clang, for products of grid coordinates.
__extension__ using Int128 = __int128;
