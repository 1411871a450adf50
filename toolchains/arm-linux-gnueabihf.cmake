# Linux on armv7 with hard float. Packages and how to run: README.md.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR arm)
set(CMAKE_C_COMPILER arm-linux-gnueabihf-gcc)
set(CMAKE_CXX_COMPILER arm-linux-gnueabihf-g++)
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-arm -L /usr/arm-linux-gnueabihf)

# Notes on an ABI change that GCC made before every compiler in use here.
set(CMAKE_CXX_FLAGS_INIT -Wno-psabi)

# Libraries of the target only; packages of the host may be headers (host_headers.cmake).
set(CMAKE_FIND_ROOT_PATH /usr/arm-linux-gnueabihf ${STICKBAND_GPIOD})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE BOTH)
