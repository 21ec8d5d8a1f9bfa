// GoogleTest's main with what extensions/ adds to the library.
#include <gmock/gmock.h>

#include <ringwatch/extensions/extensions.h>

int main(int argc, char** argv) {
  ringwatch::registerExtensions();
  ::testing::InitGoogleMock(&argc, argv);
  return RUN_ALL_TESTS();
}
