// VTK XML: .vtu (the tetrahedra, cell array "material") and .vtp (the surfaces inside the box, cell arrays "material_1"
// and "material_2"). Arrays are appended, raw, in blocks compressed in zlib's format.
#include "io/atomic_file.hpp"
#include "io/compressed_blocks.hpp"
#include "io/inner_surface.hpp"
#include "io/label_names.hpp"
#include "io/writers.hpp"
#include "io/xml_scanner.hpp"

#include <limits>
#include <vector>

namespace cleft::io
{

namespace
{

template <class T>
// Arrays are of the four types below; the names are those of VTK.
constexpr const char* kVtkType = nullptr;
template <>
constexpr const char* kVtkType<double> = "Float64";
template <>
constexpr const char* kVtkType<int64_t> = "Int64";
template <>
constexpr const char* kVtkType<int32_t> = "Int32";
template <>
constexpr const char* kVtkType<uint8_t> = "UInt8";

// Gathers the compressed arrays, as their places must be known before the first byte is written.
class AppendedArrays
{
public:
    explicit AppendedArrays(int threads) : threads_(threads) {}

    // The element that declares the array.
    template <class T>
    std::string add(const std::string& name, const T* values, int64_t count, int components = 1)
    {
        std::string element = std::string("<DataArray type=\"") + kVtkType<T> + "\" Name=\"" + name +
                              "\" NumberOfComponents=\"" + std::to_string(components) +
                              "\" format=\"appended\" offset=\"" + std::to_string(offset_) + "\"/>\n";
        arrays_.push_back(compress_blocks(values, static_cast<size_t>(count) * sizeof(T), threads_));
        // Offsets count from the first byte behind the underscore.
        offset_ += arrays_.back().size();
        return element;
    }

    void write(AtomicFile& file) const
    {
        // Raw bytes are a third smaller than base64. The newline and "_" in front belong to the
        // format.
        file.print("<AppendedData encoding=\"raw\">\n_");
        for (const std::string& array : arrays_)
            file.print(array);
        file.print("\n</AppendedData>\n");
    }

private:
    int threads_;
    size_t offset_ = 0;
    std::vector<std::string> arrays_;
};

// Where the list of corners of each cell ends.
template <class T>
std::string add_offsets(AppendedArrays& arrays, int64_t cells, int corners)
{
    std::vector<T> offsets(static_cast<size_t>(cells));
    for (size_t c = 0; c < offsets.size(); ++c)
        offsets[c] = static_cast<T>((c + 1) * static_cast<size_t>(corners));
    return arrays.add("offsets", offsets.data(), cells);
}

std::string add_cells(AppendedArrays& arrays, const int32_t* corners, int64_t cells, int corners_each)
{
    // 32 bits for the offsets where they suffice: half of the bytes to compress.
    const bool small = cells <= std::numeric_limits<int32_t>::max() / corners_each;
    std::string elements = arrays.add("connectivity", corners, corners_each * cells);
    elements +=
        small ? add_offsets<int32_t>(arrays, cells, corners_each) : add_offsets<int64_t>(arrays, cells, corners_each);
    return elements;
}

// For each label with a name a number, the label, called "material_3 right lung". An array of strings could say it, but
// meshio reads no file that has one.
std::string field_data(const MeshView& mesh)
{
    std::string elements;
    for (size_t l = 0; l < mesh.labels.size(); ++l)
        if (!mesh.names[l].empty())
            elements += "<DataArray type=\"Int32\" Name=\"" + to_xml(material_title(mesh.labels[l], mesh.names[l])) +
                        "\" NumberOfTuples=\"1\" format=\"ascii\">" + std::to_string(mesh.labels[l]) + "</DataArray>\n";
    return elements.empty() ? "" : "<FieldData>\n" + elements + "</FieldData>\n";
}

void write_file(const std::string& path, const std::string& type, const std::string& piece,
                const AppendedArrays& arrays)
{
    AtomicFile file(path);
    file.print("<?xml version=\"1.0\"?>\n<VTKFile type=\"", type,
               "\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\" "
               "compressor=\"vtkZLibDataCompressor\">\n<",
               type, ">\n", piece, "</", type, ">\n");
    arrays.write(file);
    file.print("</VTKFile>\n");
    file.commit();
}

}  // namespace

void write_vtu(const MeshView& mesh, const std::string& path, int threads)
{
    constexpr uint8_t kVtkTetra = 10;
    const std::vector<uint8_t> types(static_cast<size_t>(mesh.tet_count), kVtkTetra);
    AppendedArrays arrays(threads);
    std::string piece = "<Piece NumberOfPoints=\"" + std::to_string(mesh.point_count) + "\" NumberOfCells=\"" +
                        std::to_string(mesh.tet_count) + "\">\n";
    piece += "<Points>\n" + arrays.add("Points", mesh.points, 3 * mesh.point_count, 3) + "</Points>\n";
    piece += "<Cells>\n" + add_cells(arrays, mesh.tets, mesh.tet_count, 4);
    piece += arrays.add("types", types.data(), mesh.tet_count) + "</Cells>\n";
    // The active scalars, by which ParaView colours the mesh when it is opened.
    piece += "<CellData Scalars=\"material\">\n" + arrays.add("material", mesh.tet_labels, mesh.tet_count) +
             "</CellData>\n</Piece>\n";
    write_file(path, "UnstructuredGrid", field_data(mesh) + piece, arrays);
}

void write_vtp(const MeshView& mesh, const std::string& path, int threads)
{
    const InnerSurface surface = inner_surface(mesh);
    std::vector<double> points;
    points.reserve(3 * surface.points.size());
    for (const int32_t p : surface.points)
        points.insert(points.end(), mesh.points + 3 * int64_t{p}, mesh.points + 3 * int64_t{p} + 3);
    std::vector<int32_t> labels[2];
    for (size_t t = 0; t < surface.labels.size(); ++t)
        labels[t % 2].push_back(surface.labels[t]);

    AppendedArrays arrays(threads);
    std::string piece = "<Piece NumberOfPoints=\"" + std::to_string(surface.points.size()) + "\" NumberOfPolys=\"" +
                        std::to_string(surface.count()) + "\">\n";
    piece += "<Points>\n" + arrays.add("Points", points.data(), static_cast<int64_t>(points.size()), 3) + "</Points>\n";
    piece += "<Polys>\n" + add_cells(arrays, surface.corners.data(), surface.count(), 3) + "</Polys>\n";
    piece += "<CellData Scalars=\"material_1\">\n" + arrays.add("material_1", labels[0].data(), surface.count());
    piece += arrays.add("material_2", labels[1].data(), surface.count()) + "</CellData>\n</Piece>\n";
    write_file(path, "PolyData", field_data(mesh) + piece, arrays);
}

}  // namespace cleft::io
