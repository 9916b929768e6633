# find_package(seamount): what its libraries link, then the libraries themselves.
include(CMakeFindDependencyMacro)
foreach(package TBB GDAL OpenEXR Freetype PNG SQLite3 fmt nlohmann_json)
  find_dependency(${package})
endforeach()
include(${CMAKE_CURRENT_LIST_DIR}/seamountTargets.cmake)
