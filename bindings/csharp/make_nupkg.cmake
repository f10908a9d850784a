# Lays out and zips a NuGet package: the assembly, the native libraries of one system, and the three files that make a
# zip archive a package.
file(REMOVE_RECURSE ${FOLDER})
foreach(file ${ASSEMBLY} ${DOCUMENTATION})
    file(COPY ${file} DESTINATION ${FOLDER}/lib/netstandard2.0)
endforeach()

# Under the names that the modules ask for, and as files, for an archive has no links.
file(GLOB_RECURSE libraries ${STAGE}/libcleft*_csharp.so ${STAGE}/libcleft*.so.[0-9])
set(NATIVE_ITEMS)
foreach(library ${libraries})
    get_filename_component(name ${library} NAME)
    string(APPEND NATIVE_ITEMS "
    <None Include=\"\$(MSBuildThisFileDirectory)../../runtimes/${RUNTIME}/native/${name}\">
      <Link>${name}</Link>
      <Visible>false</Visible>
      <CopyToOutputDirectory>PreserveNewest</CopyToOutputDirectory>
    </None>")
    file(REAL_PATH ${library} file)
    configure_file(${file} ${FOLDER}/runtimes/${RUNTIME}/native/${name} COPYONLY)
endforeach()

# NuGet shows one file as the licence: what the package is made of, and the text of Cleft's own licence.
file(GLOB_RECURSE licence_file ${STAGE}/LICENSE)
file(GLOB_RECURSE notice_file ${STAGE}/NOTICE)
file(READ ${licence_file} licence_text)
file(READ ${notice_file} notice_text)
string(REPLACE "the file LICENSE" "the second half of this file" notice_text "${notice_text}")
file(WRITE ${FOLDER}/LICENSE.txt "${notice_text}\n\n${licence_text}")
configure_file(${CMAKE_CURRENT_LIST_DIR}/Cleft.targets.in ${FOLDER}/build/netstandard2.0/Cleft.targets @ONLY)
configure_file(${CMAKE_CURRENT_LIST_DIR}/Cleft.nuspec.in ${FOLDER}/Cleft.nuspec @ONLY)
file(WRITE "${FOLDER}/[Content_Types].xml" [[<?xml version="1.0" encoding="utf-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">
  <Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml" />
  <Default Extension="nuspec" ContentType="application/octet" />
  <Default Extension="targets" ContentType="application/octet" />
  <Default Extension="txt" ContentType="application/octet" />
  <Default Extension="xml" ContentType="application/octet" />
  <Default Extension="dll" ContentType="application/octet" />
  <Default Extension="so" ContentType="application/octet" />
  <Default Extension="0" ContentType="application/octet" />
</Types>
]])
file(WRITE ${FOLDER}/_rels/.rels [[<?xml version="1.0" encoding="utf-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
  <Relationship Type="http://schemas.microsoft.com/packaging/2010/07/manifest" Target="/Cleft.nuspec" Id="manifest" />
</Relationships>
]])

execute_process(
    COMMAND ${CMAKE_COMMAND} -E tar cf ${OUTPUT} --format=zip [Content_Types].xml _rels Cleft.nuspec LICENSE.txt build
        lib runtimes
    WORKING_DIRECTORY ${FOLDER} COMMAND_ERROR_IS_FATAL ANY)
