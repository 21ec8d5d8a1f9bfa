# Turns CUDA on, or says in one line what is missing.
include(CheckLanguage)
check_language(CUDA)
if(NOT CMAKE_CUDA_COMPILER)
  message(FATAL_ERROR "RINGWATCH_WITH_CUDA needs the CUDA Toolkit, and no working nvcc was found: install it, name the "
    "compiler with -DCMAKE_CUDA_COMPILER=…/nvcc, or configure without (preset release)")
endif()
enable_language(CUDA)
set(CMAKE_CUDA_STANDARD 20)
set(CMAKE_CUDA_STANDARD_REQUIRED ON)
find_package(CUDAToolkit REQUIRED)
