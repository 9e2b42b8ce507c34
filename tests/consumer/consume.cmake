# Builds the program decompose_one the way a user would (`kind`), runs it, and checks that nothing of the library's
# own build is asked of the user: none of its flags, and no xsimd.

cmake_minimum_required(VERSION 3.20)

function(run)
    execute_process(COMMAND ${ARGN} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

function(check_command command)
    foreach(own IN ITEMS "${flags}" "${prefix}" "${binary}" "${source}")
        string(REPLACE "${own}" "" command "${command}")
    endforeach()
    if(command MATCHES "-W[a-z]|-ffp-contract|-fno-exceptions|-fno-rtti|-fno-math-errno|-m(sse|avx|fma)|xsimd")
        message(FATAL_ERROR "a flag of the library's own build reached the user (${CMAKE_MATCH_0}): ${command}")
    endif()
endfunction()

if(kind STREQUAL "pkg_config")
    if(NOT pkg_config)
        message("SKIPPED: pkg-config is not installed")
        return()
    endif()
    file(MAKE_DIRECTORY ${binary})
    set(ENV{PKG_CONFIG_LIBDIR} ${prefix}/${libdir}/pkgconfig)
    execute_process(COMMAND ${pkg_config} --cflags --libs swivel
        OUTPUT_VARIABLE package_flags OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
    check_command("${package_flags}")
    separate_arguments(package_flags UNIX_COMMAND "${package_flags}")
    separate_arguments(flags UNIX_COMMAND "${flags}")
    run(${compiler} -std=c++20 ${flags} ${source}/decompose_one.cpp ${package_flags} -o ${binary}/decompose_one)
else()
    file(REMOVE_RECURSE ${binary})
    set(options "-DCMAKE_CXX_COMPILER=${compiler}" "-DCMAKE_CXX_FLAGS=${flags}" -DCMAKE_BUILD_TYPE=Release
        -DCMAKE_EXPORT_COMPILE_COMMANDS=ON)
    if(toolchain)
        list(APPEND options "-DCMAKE_TOOLCHAIN_FILE=${toolchain}")
    endif()
    if(kind STREQUAL "find_package")
        list(APPEND options "-DCMAKE_PREFIX_PATH=${prefix}")
    else()
        list(APPEND options "-DSWIVEL_SOURCE_DIR=${swivel}" "-DSWIVEL_XSIMD_INCLUDE_DIR=${xsimd}"
            # The baseline alone, for the sake of time; and as users who debug build it, where nothing is inlined
            # that could hide what one ISA takes from another.
            "-DSWIVEL_ISAS=${baseline}" -DCMAKE_BUILD_TYPE=Debug)
    endif()
    run(${CMAKE_COMMAND} -S ${source}/${kind} -B ${binary} -G ${generator} ${options})
    run(${CMAKE_COMMAND} --build ${binary} --parallel 2)

    file(READ ${binary}/compile_commands.json commands)
    string(JSON count LENGTH "${commands}")
    math(EXPR last "${count} - 1")
    set(checked OFF)
    foreach(i RANGE ${last})
        string(JSON file GET "${commands}" ${i} file)
        if(file MATCHES "decompose_one")
            string(JSON command GET "${commands}" ${i} command)
            check_command("${command}")
            set(checked ON)
        endif()
    endforeach()
    if(NOT checked)
        message(FATAL_ERROR "no command line of decompose_one.cpp in compile_commands.json")
    endif()
endif()

run(${emulator} ${binary}/decompose_one)
