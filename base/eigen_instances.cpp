#include <ringwatch/base/eigen_instances.h>

RINGWATCH_EIGEN_INSTANCES()
