# What `cmake --install` puts where, and the Debian package that `./run package` makes of it.

install(TARGETS vigil RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY ${CMAKE_SOURCE_DIR}/baseq2 DESTINATION ${CMAKE_INSTALL_DATADIR}/vigil)
install(FILES ${CMAKE_SOURCE_DIR}/README.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES ${CMAKE_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright)
install(DIRECTORY ${CMAKE_SOURCE_DIR}/docs DESTINATION ${CMAKE_INSTALL_DOCDIR}
  PATTERN "*.json" EXCLUDE)
install(FILES ${CMAKE_SOURCE_DIR}/tools/package/vigil.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME vigil)
set(CPACK_PACKAGE_VENDOR "The authors of Vigil")
set(CPACK_PACKAGE_CONTACT "The authors of Vigil <vigil@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Path-traced Quake II levels")
set(CPACK_PACKAGE_DESCRIPTION
  "Vigil path-traces Quake II levels with Vulkan and learns where light comes from. It comes with levels of its own.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PACKAGE_DIRECTORY ${CMAKE_BINARY_DIR}/package)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION games)
# The libraries that the program is linked to, by dpkg-shlibdeps; any Vulkan driver will do.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "mesa-vulkan-drivers | vulkan-icd")
include(CPack)
