#pragma once

namespace ringwatch {

/// Registers the handlers of this folder: a program that is to have them calls it when it starts, before it asks for
/// any.
void registerExtensions();

}  // namespace ringwatch
