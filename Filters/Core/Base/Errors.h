// SPDX-License-Identifier: GPL-3.0-or-later
/// The exceptions that Core throws. Every message names the cause, the offending vertex, face or loop,
/// and the remedy; the VTK classes report it word for word.
#pragma once

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

namespace flattening
{

/// A number as it stands in messages: six digits, and an exponent where it is very large or small. NaN
/// has no sign.
inline std::string formatted(double number)
{
  std::ostringstream text;
  text << (std::isnan(number) ? std::abs(number) : number);
  return text.str();
}

/// Base of all exceptions of this library.
struct FlatteningError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// The input has numbers that cannot be used: NaN, infinite coordinates, zero area, weights <= 0,
/// indices out of range.
struct InvalidInput : FlatteningError
{
  using FlatteningError::FlatteningError;
};

/// The surface does not have the topology that is needed: it is non-manifold, or its number of
/// components, handles or boundary loops is wrong.
struct TopologyError : FlatteningError
{
  using FlatteningError::FlatteningError;
};

/// An iteration ended before its tolerance was met.
struct ConvergenceError : FlatteningError
{
  using FlatteningError::FlatteningError;
};

/// The progress callback asked for a stop. This is no failure, and nothing is reported to the user.
struct Cancelled : FlatteningError
{
  Cancelled()
    : FlatteningError("cancelled")
  {
  }
};

} // namespace flattening
