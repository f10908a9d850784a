// What the file of each rank is called, for formats that have one a rank.
#pragma once

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <string>

namespace cleft::mpi
{

inline std::string with_zeros(int32_t rank, std::size_t digits)
{
    const std::string number = std::to_string(rank);
    return std::string(digits - std::min(digits, number.size()), '0') + number;
}

// "mesh_0003.vtu" of "mesh.pvtu".
inline std::string name_of_vtu_piece(const std::filesystem::path& list, int32_t rank)
{
    return list.stem().string() + "_" + with_zeros(rank, 4) + ".vtu";
}

// "mesh.mfem.000003" of "mesh.mfem", as MFEM's MakeParFilename() has it.
inline std::string name_of_mfem_part(const std::filesystem::path& mesh, int32_t rank)
{
    return mesh.filename().string() + "." + with_zeros(rank, 6);
}

}  // namespace cleft::mpi
