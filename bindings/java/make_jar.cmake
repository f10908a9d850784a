# Compiles the sources and packs classes and native libraries into OUTPUT.
function(run)
    execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE ${CLASSES})
file(GLOB sources ${SOURCES}/*.java ${GENERATED}/*.java)
run(${JAVAC} --release 17 -Xlint:all -Werror -encoding UTF-8 -d ${CLASSES} ${sources})

# Under the names that the modules ask for, and as files, for a jar has no links.
file(GLOB_RECURSE libraries ${STAGE}/libcleft*_java.so ${STAGE}/libcleft*.so.[0-9])
foreach(library ${libraries})
    get_filename_component(name ${library} NAME)
    file(REAL_PATH ${library} file)
    configure_file(${file} ${CLASSES}/org/cleft/native/${PLATFORM}/${name} COPYONLY)
endforeach()

file(GLOB_RECURSE licence ${STAGE}/LICENSE ${STAGE}/NOTICE)
file(COPY ${licence} DESTINATION ${CLASSES}/META-INF)
file(WRITE ${CLASSES}/../manifest.txt
    "Implementation-Title: Cleft\nImplementation-Version: ${VERSION}\n"
    "Automatic-Module-Name: org.cleft\nBundle-License: ${LICENCE}\n")
run(${JAR} --create --file ${OUTPUT} --manifest ${CLASSES}/../manifest.txt -C ${CLASSES} .)
