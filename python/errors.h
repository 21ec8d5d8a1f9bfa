#pragma once

namespace ringwatch::python {

/// Makes this extension's InputError and NumericalError those of the package, with the same line.
void translateErrors();

}  // namespace ringwatch::python
