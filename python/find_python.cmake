# What the Python package is built with: Python_* and pybind11::headers, where they are found.
# Debian's own Python is asked before any other, for its packages bring NumPy. Cross-built,
# the target's headers are found through its compiler.
find_program(STICKBAND_PYTHON_PROGRAM python3 HINTS /usr/bin NO_DEFAULT_PATH
             DOC "Python that the package is for")
if(STICKBAND_PYTHON_PROGRAM)
  set(Python_EXECUTABLE ${STICKBAND_PYTHON_PROGRAM})
endif()
find_package(Python 3.9 COMPONENTS Interpreter QUIET)
if(Python_FOUND AND CMAKE_CROSSCOMPILING)
  set(Python_INCLUDE_DIRS /usr/include/python${Python_VERSION_MAJOR}.${Python_VERSION_MINOR})
  set(Python_SOABI
      cpython-${Python_VERSION_MAJOR}${Python_VERSION_MINOR}-${CMAKE_LIBRARY_ARCHITECTURE})
  if(EXISTS /usr/include/${CMAKE_LIBRARY_ARCHITECTURE}/python${Python_VERSION_MAJOR}.${Python_VERSION_MINOR}/pyconfig.h)
    set(Python_Development.Module_FOUND TRUE)
  endif()
elseif(Python_FOUND)
  find_package(Python 3.9 COMPONENTS Interpreter Development.Module QUIET)
endif()
set(PYBIND11_NOPYTHON ON)
find_package(pybind11 2.10 CONFIG QUIET)
