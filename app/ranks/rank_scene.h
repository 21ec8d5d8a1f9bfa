#pragma once
#include <ringwatch/app/scene/scene.h>

namespace ringwatch {

/// Throws InputError that names the first thing in a scene that cannot be distributed over ranks (docs/cluster.md).
void requireDistributable(const Scene& scene);

}  // namespace ringwatch
