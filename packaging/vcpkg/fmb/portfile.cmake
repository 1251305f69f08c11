# The library for vcpkg, as an overlay port that builds the tree that it lies in:
# vcpkg install fmb --overlay-ports=packaging/vcpkg
get_filename_component(SOURCE_PATH "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)
vcpkg_check_linkage(ONLY_DYNAMIC_LIBRARY)

vcpkg_configure_meson(
  SOURCE_PATH "${SOURCE_PATH}"
  OPTIONS -Dapps=disabled -Dpython=disabled -Dstudy=disabled -Dnauty=disabled -Dthreemf=disabled -Dmpi=disabled -Dbench=disabled -Dtests=disabled)
vcpkg_install_meson()
vcpkg_fixup_pkgconfig()

# fmbConfig.cmake finds the library from where it stands, beside it.
set(VCPKG_POLICY_SKIP_LIB_CMAKE_MERGE_CHECK enabled)
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share"
  "${CURRENT_PACKAGES_DIR}/debug/lib/cmake")
file(REMOVE "${CURRENT_PACKAGES_DIR}/lib/libfmb.a" "${CURRENT_PACKAGES_DIR}/debug/lib/libfmb.a")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE"
  "${SOURCE_PATH}/packaging/licenses/LGPL-3.0-or-later.txt" "${SOURCE_PATH}/packaging/licenses/GPL-3.0-or-later.txt")
