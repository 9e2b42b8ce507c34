# The ISAs of the build, best first: one row each, "name|processor|registers|flags". Each becomes an OBJECT library with
# flags of its own, whose objects go into the static library; the rest of the library has the baseline flags. Its
# registers are those of kernels/registers/<registers>.hpp.

set(swivel_isa_rows
    "avx512|x86_64|x86_512|-mavx512f -mavx512cd -mavx512dq -mavx512bw -mavx512vl -mfma"
    "avx2|x86_64|x86_256|-mavx2 -mfma"
    "sse2|x86_64|x86_128|-msse2"
    "neon64|aarch64|neon|")
set(SWIVEL_ISAS "" CACHE STRING "ISAs to build kernels for besides the baseline; empty: all")
set(swivel_baseline sse2 neon64)

string(TOLOWER "${CMAKE_SYSTEM_PROCESSOR}" swivel_processor)
if(swivel_processor MATCHES "^(amd64|x64)$")
    set(swivel_processor x86_64)
elseif(swivel_processor MATCHES "^arm64$")
    set(swivel_processor aarch64)
endif()

# Both are said here rather than found by the first call, or by numbers that differ.
set(swivel_known "")
set(swivel_processors "")
foreach(row IN LISTS swivel_isa_rows)
    string(REPLACE "|" ";" row "${row}")
    list(GET row 0 isa)
    list(GET row 1 processor)
    list(APPEND swivel_processors ${processor})
    if(swivel_processor STREQUAL processor)
        list(APPEND swivel_known ${isa})
    endif()
endforeach()
list(REMOVE_DUPLICATES swivel_processors)
list(JOIN swivel_processors ", " swivel_processors)
if(NOT swivel_known OR NOT CMAKE_SIZEOF_VOID_P EQUAL 8)
    math(EXPR swivel_bits "8 * ${CMAKE_SIZEOF_VOID_P}")
    message(FATAL_ERROR "swivel has no kernels for ${swivel_processor} in ${swivel_bits} bits, expected a processor of "
        "64 bits out of: ${swivel_processors}")
endif()
foreach(isa IN LISTS SWIVEL_ISAS)
    if(NOT isa IN_LIST swivel_known)
        list(JOIN swivel_known ";" swivel_known)
        message(FATAL_ERROR "SWIVEL_ISAS: '${isa}' is no ISA of ${swivel_processor}, expected some of: ${swivel_known}")
    endif()
endforeach()

# xsimd is header only, and Debian's CMake target for it asks for a library that is not there. Naming its folder as
# an include directory would put all of /usr/include in front of the compiler's own headers, so a folder with
# nothing but a link to xsimd is used.
find_path(SWIVEL_XSIMD_INCLUDE_DIR xsimd/xsimd.hpp
    PATHS /usr/include NO_CMAKE_FIND_ROOT_PATH DOC "Folder that contains xsimd/xsimd.hpp (libxsimd-dev)")
if(NOT SWIVEL_XSIMD_INCLUDE_DIR)
    message(FATAL_ERROR "xsimd/xsimd.hpp not found: install libxsimd-dev, or set SWIVEL_XSIMD_INCLUDE_DIR")
endif()
set(swivel_xsimd "${CMAKE_CURRENT_BINARY_DIR}/xsimd_only")
file(MAKE_DIRECTORY "${swivel_xsimd}")
file(CREATE_LINK "${SWIVEL_XSIMD_INCLUDE_DIR}/xsimd" "${swivel_xsimd}/xsimd" SYMBOLIC)

# gcc 12 warns of the uninitialised operand that its own AVX-512 intrinsics use on purpose (GCC bug 105593).
set(swivel_kernel_warnings "")
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    set(swivel_kernel_warnings -Wno-uninitialized -Wno-maybe-uninitialized)
endif()

# Adds the kernels of every ISA that the processor has to the target. Every source kernels/<family>/<name>.cpp is
# compiled once for each, by way of a file that names the ISA: the objects have names of their own, by which they are
# told apart in the archive.
function(swivel_add_kernels target)
    file(GLOB sources RELATIVE ${PROJECT_SOURCE_DIR} CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/kernels/*/*.cpp)
    set(compiled "")
    foreach(row IN LISTS swivel_isa_rows)
        string(REPLACE "|" ";" row "${row}")
        list(GET row 0 isa)
        list(GET row 1 processor)
        list(GET row 2 registers)
        list(GET row 3 flags)
        if(NOT swivel_processor STREQUAL processor OR (SWIVEL_ISAS AND NOT isa IN_LIST SWIVEL_ISAS AND NOT isa IN_LIST swivel_baseline))
            continue()
        endif()
        separate_arguments(flags)
        set(stubs "")
        foreach(source IN LISTS sources)
            get_filename_component(name ${source} NAME_WE)
            set(stub ${CMAKE_CURRENT_BINARY_DIR}/kernels/${name}.${isa}.cpp)
            file(CONFIGURE OUTPUT ${stub} @ONLY
                CONTENT "#include \"@source@\"  // NOLINT(bugprone-suspicious-include): once for each ISA\n")
            list(APPEND stubs ${stub})
        endforeach()
        add_library(swivel_${isa} OBJECT ${stubs})
        target_compile_features(swivel_${isa} PRIVATE cxx_std_20)
        target_compile_definitions(swivel_${isa} PRIVATE
            SWIVEL_KERNEL_ISA=${isa} SWIVEL_KERNEL_REGISTERS="kernels/registers/${registers}.hpp")
        target_include_directories(swivel_${isa} PRIVATE ${PROJECT_SOURCE_DIR})
        target_include_directories(swivel_${isa} SYSTEM PRIVATE "${swivel_xsimd}")
        # Always -O2, also in a debug build: without inlining, functions of xsimd are emitted under names that two
        # ISAs share, and the linker keeps either. No exceptions and no link-time optimisation for the same reason.
        # Sections for each function and table, so that a program can leave out what it does not call. No debug
        # information: everything is inlined, and following each value takes the compiler gigabytes.
        target_compile_options(swivel_${isa} PRIVATE
            ${swivel_warnings} ${swivel_kernel_warnings} ${flags} -O2 -g0 -ffp-contract=off -fno-exceptions -fno-rtti
            -fno-math-errno -fno-lto -ffunction-sections -fdata-sections)
        # Parsed once for each ISA: that is half of what a source of kernels takes.
        target_precompile_headers(swivel_${isa} PRIVATE <xsimd/xsimd.hpp>)
        if(SWIVEL_SANITIZE)
            target_compile_options(swivel_${isa} PRIVATE -fno-sanitize=all)
        endif()
        set_target_properties(swivel_${isa} PROPERTIES
            POSITION_INDEPENDENT_CODE ON CXX_EXTENSIONS OFF INTERPROCEDURAL_OPTIMIZATION OFF
            CXX_VISIBILITY_PRESET hidden)
        target_sources(${target} PRIVATE $<TARGET_OBJECTS:swivel_${isa}>)
        list(APPEND compiled ${isa})
    endforeach()
    list(JOIN compiled "," compiled)
    target_compile_definitions(${target} PRIVATE "SWIVEL_COMPILED_ISAS=${compiled}")
endfunction()
