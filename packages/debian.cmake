# Debian packages, by `cpack -G DEB` or the target `debian`: the components of an installation, each with what it depends on.
#   seamount           the program, the studio's page, recipes, data, networks
#   seamount-training  the part of it that trains networks, where libtorch is there
#   seamount-ranks     the part of it that runs a recipe on several processes or machines, where MPI is there
#   python3-seamount   `import seamount` for the system's Python
#   libseamount-dev    headers and static libraries, with a package file for CMake
# What is linked is found by dpkg-shlibdeps; what is opened by name, or needed by a compiler, is said here.
set(CPACK_PACKAGE_VENDOR "The Seamount authors")
set(CPACK_PACKAGE_CONTACT "The Seamount authors")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(same_version "(= ${PROJECT_VERSION})")

set(CPACK_COMPONENTS_ALL program library)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME seamount)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS fonts-dejavu-core)  # letters on pictures
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "xdg-utils, seamount-training ${same_version}, seamount-ranks ${same_version}, python3-seamount ${same_version}")
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION
    "${PROJECT_DESCRIPTION}
A few strokes, contours or a real coastline become islands, mountain ranges,
canyons and living reefs; real elevation data becomes something to edit. Out
come height fields in metres, labels, contours, masks, meshes, and files for
game engines and geographic information systems. With the studio, a page that
the program serves to a browser, with example recipes and trained networks.")

# What the headers include and the static libraries link: the libraries of run.txt.
file(STRINGS packages/run.txt linked REGEX "^[^#].*-dev$")
list(REMOVE_ITEM linked libcli11-dev)  # the command line's alone
list(JOIN linked ", " linked)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME libseamount-dev)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_DEPENDS "${linked}")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_RECOMMENDS "seamount ${same_version}")  # its networks
set(CPACK_DEBIAN_LIBRARY_DESCRIPTION "Terrain authoring: headers and static libraries
Everything that the program seamount does as a C++20 library of pure functions,
for find_package(seamount) of CMake.")

if(TARGET seamount_training)
  list(APPEND CPACK_COMPONENTS_ALL training)
  set(CPACK_DEBIAN_TRAINING_PACKAGE_NAME seamount-training)
  set(CPACK_DEBIAN_TRAINING_PACKAGE_SECTION science)
  set(CPACK_DEBIAN_TRAINING_PACKAGE_DEPENDS "seamount ${same_version}")
  set(CPACK_DEBIAN_TRAINING_DESCRIPTION "Terrain authoring: training of networks
With it `seamount train` trains the networks of learned operators, by libtorch.")
endif()

if(TARGET seamount_ranks)
  list(APPEND CPACK_COMPONENTS_ALL ranks)
  set(CPACK_DEBIAN_RANKS_PACKAGE_NAME seamount-ranks)
  set(CPACK_DEBIAN_RANKS_PACKAGE_SECTION science)
  set(CPACK_DEBIAN_RANKS_PACKAGE_DEPENDS "seamount ${same_version}")
  set(CPACK_DEBIAN_RANKS_PACKAGE_RECOMMENDS openmpi-bin)
  set(CPACK_DEBIAN_RANKS_DESCRIPTION "Terrain authoring: worlds on several machines
With it `mpirun -n 4 seamount run RECIPE --tiles 4096` spreads a recipe over
processes, by Open MPI.")
endif()

if(TARGET seamount_python)
  string(REGEX REPLACE "^3\\." "" minor ${SEAMOUNT_PYTHON_VERSION})
  math(EXPR minor "${minor} + 1")
  list(APPEND CPACK_COMPONENTS_ALL python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-seamount)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
      "seamount ${same_version}, python3 (>= ${SEAMOUNT_PYTHON_VERSION}), python3 (<< 3.${minor}), python3-numpy")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-xarray, python3-rasterio, python3-geopandas")
  set(CPACK_DEBIAN_PYTHON_DESCRIPTION "Terrain authoring: Python module
Every operator of seamount as a function, rasters as NumPy arrays, recipes that
are edited and run.")
endif()

foreach(component ${CPACK_COMPONENTS_ALL})
  string(TOUPPER ${component} upper)
  set(optional "")
  if(component STREQUAL python)
    set(optional EXCLUDE_FROM_ALL)
  endif()
  install(FILES packages/copyright DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${CPACK_DEBIAN_${upper}_PACKAGE_NAME}
          COMPONENT ${component} ${optional})
endforeach()
include(CPack)

# All packages into the build folder: ninja -C build/dev debian.
get_property(modules GLOBAL PROPERTY SEAMOUNT_MODULES)
set(packaged ${modules})
foreach(target seamount seamount_training seamount_ranks seamount_python_types)
  if(TARGET ${target})
    list(APPEND packaged ${target})
  endif()
endforeach()
add_custom_target(debian COMMAND ${CMAKE_CPACK_COMMAND} -G DEB DEPENDS ${packaged} USES_TERMINAL VERBATIM)
