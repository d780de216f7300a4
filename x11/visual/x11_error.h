#pragma once

#include <stdexcept>

namespace xnewell {

/// What the X server, or its absence, made impossible. The text is one line that can be shown as it is:
/// "X_CreatePixmap: BadAlloc (insufficient resources for operation)". This header does not include Xlib, so
/// main() may include it.
class X11Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The server has no room for another colormap.
class NoColormapError : public X11Error {
 public:
  using X11Error::X11Error;
};

}  // namespace xnewell
