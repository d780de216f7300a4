#pragma once

#include <string>

namespace xnewell {

/// The keys of all views as tables of a manual, in Markdown. They come from the tables that the window acts
/// by (x11/kit/key_table.h), with the teapot in a window of the default size. `xnewell keys` prints them.
[[nodiscard]] std::string keyLists();

}  // namespace xnewell
