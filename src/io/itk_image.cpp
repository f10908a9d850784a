// ITK's readers, of which dicom_compressed.cpp uses one more. They are asked one by one, without its registry of
// factories, and read straight into our memory.
#include "base/error.hpp"
#include "io/atomic_file.hpp"
#include "io/file_name.hpp"
#include "io/image_readers.hpp"

#include <itkBMPImageIO.h>
#include <itkGiplImageIO.h>
#include <itkJPEGImageIO.h>
#include <itkMRCImageIO.h>
#include <itkMetaImageIO.h>
#include <itkNiftiImageIO.h>
#include <itkNrrdImageIO.h>
#include <itkPNGImageIO.h>
#include <itkTIFFImageIO.h>
#include <itkVTKImageIO.h>
#include <algorithm>
#include <cstring>
#include <regex>

namespace cleft::io
{

namespace
{

using Reader = itk::ImageIOBase::Pointer;

// What ITK says, without its name, class names, addresses and line ends.
std::string sentence_of(const itk::ExceptionObject& error)
{
    std::string text = error.GetDescription();
    std::replace(text.begin(), text.end(), '\n', ' ');
    text = std::regex_replace(text, std::regex("^(itk::)?(ITK )?ERROR: |[A-Za-z0-9]+\\(0x[0-9a-f]+\\): "), "");
    return text.substr(0, text.find_last_not_of(' ') + 1);
}

// ITK writes warnings to the terminal unless told not to, for the whole process.
class Quiet
{
public:
    Quiet() : before_(itk::Object::GetGlobalWarningDisplay()) { itk::Object::GlobalWarningDisplayOff(); }
    ~Quiet() { itk::Object::SetGlobalWarningDisplay(before_); }
    Quiet(const Quiet&) = delete;
    Quiet& operator=(const Quiet&) = delete;

private:
    bool before_;
};

// Runs `body` and turns ITK's exceptions into ours.
template <class Body>
auto with_itk(const Body& body)
{
    const Quiet quiet;
    try {
        return body();
    } catch (const itk::MemoryAllocationError&) {
        throw std::bad_alloc();
    } catch (const itk::ExceptionObject& error) {
        throw Error(CLEFT_ERROR_FILE, sentence_of(error));
    }
}

std::vector<Reader> all_readers()
{
    return {Reader(itk::NrrdImageIO::New()), Reader(itk::NiftiImageIO::New()), Reader(itk::MetaImageIO::New()),
            Reader(itk::TIFFImageIO::New()), Reader(itk::PNGImageIO::New()),   Reader(itk::JPEGImageIO::New()),
            Reader(itk::BMPImageIO::New()),  Reader(itk::VTKImageIO::New()),   Reader(itk::GiplImageIO::New()),
            Reader(itk::MRCImageIO::New())};
}

Reader reader_of(const std::string& path)
{
    for (const Reader& reader : all_readers())
        if (reader->CanReadFile(path.c_str()))
            return reader;
    throw Error(CLEFT_ERROR_FILE, "it is in no format of volumes that can be read, or it is damaged");
}

Component component_of(const itk::ImageIOBase& reader)
{
    using Type = itk::ImageIOBase::IOComponentEnum;
    const size_t size = reader.GetComponentSize();
    switch (reader.GetComponentType()) {
        case Type::UCHAR:
            return Component::uint8;
        case Type::CHAR:
            return Component::int8;
        case Type::USHORT:
            return Component::uint16;
        case Type::SHORT:
            return Component::int16;
        case Type::UINT:
            return Component::uint32;
        case Type::INT:
            return Component::int32;
        case Type::ULONG:
        case Type::ULONGLONG:
            return size == 8 ? Component::uint64 : Component::uint32;
        case Type::LONG:
        case Type::LONGLONG:
            return size == 8 ? Component::int64 : Component::int32;
        case Type::FLOAT:
            return Component::float32;
        case Type::DOUBLE:
            return Component::float64;
        default:
            throw Error(CLEFT_ERROR_FORMAT, "its type of voxels, " +
                                                reader.GetComponentTypeAsString(reader.GetComponentType()) +
                                                ", cannot be read");
    }
}

// These tell at most how to print a picture, and nothing of the third axis.
bool knows_geometry(const std::string& io_class)
{
    return io_class != "TIFFImageIO" && io_class != "PNGImageIO" && io_class != "JPEGImageIO" &&
           io_class != "BMPImageIO";
}

void read_geometry(const itk::ImageIOBase& reader, Image& image)
{
    const unsigned axes = std::min(reader.GetNumberOfDimensions(), 3u);
    for (unsigned axis = 0; axis < axes; ++axis) {
        image.spacing[axis] = reader.GetSpacing(axis);
        image.origin[axis] = reader.GetOrigin(axis);
        const std::vector<double> column = reader.GetDirection(axis);
        std::copy_n(column.begin(), axes, image.directions[axis].begin());
    }
    if (axes == 2)
        image.spacing[2] = image.spacing[0];
}

void set_region(itk::ImageIOBase& io)
{
    itk::ImageIORegion region(io.GetNumberOfDimensions());
    for (unsigned axis = 0; axis < io.GetNumberOfDimensions(); ++axis) {
        region.SetIndex(axis, 0);
        region.SetSize(axis, io.GetDimensions(axis));
    }
    io.SetIORegion(region);
}

Reader writer_of(const std::string& extension)
{
    if (extension == ".nrrd")
        return Reader(itk::NrrdImageIO::New());
    if (extension == ".nii" || extension == ".nii.gz")
        return Reader(itk::NiftiImageIO::New());
    if (extension == ".mha")
        return Reader(itk::MetaImageIO::New());
    if (extension == ".vtk")
        return Reader(itk::VTKImageIO::New());
    throw Error(CLEFT_ERROR_ARGUMENT,
                "a field can be written as .nrrd, .nii, .nii.gz, .mha or .vtk, not as '" + extension + "'");
}

void check_geometry(const Image& image, const std::string& extension)
{
    constexpr double tolerance = 1e-6;
    bool turned = false;
    bool sheared = false;
    for (size_t axis = 0; axis < 3; ++axis) {
        turned = turned || image.directions[axis][axis] < 1 - tolerance;
        sheared = sheared || std::abs(dot(image.directions[axis], image.directions[(axis + 1) % 3])) > tolerance;
    }
    turned = turned || sheared;
    if ((extension == ".vtk" && turned) || (extension != ".nrrd" && sheared))
        throw Error(CLEFT_ERROR_UNSUPPORTED, "a " + extension + " file cannot hold a grid that is " +
                                                 (sheared ? "sheared" : "turned") + ": use .nrrd");
}

}  // namespace

// ITK's own readers say, in read_itk_image(), whether one of them takes the file.
bool is_itk_format(const FileHead&) { return true; }

Image read_itk_image(const std::string& path, const FileHead&)
{
    return with_itk([&] {
        const Reader reader = reader_of(path);
        reader->SetFileName(path);
        reader->SetExpandRGBPalette(false);  // the number of a colour in a palette is its label
        reader->ReadImageInformation();
        if (reader->GetNumberOfComponents() != 1)
            throw Error(CLEFT_ERROR_FORMAT, "it has " + std::to_string(reader->GetNumberOfComponents()) +
                                                " numbers a voxel (colours or vectors); one is wanted");
        Image image;
        image.component = component_of(*reader);
        for (unsigned axis = 0; axis < reader->GetNumberOfDimensions(); ++axis)
            (axis < 3 ? image.dims[axis] : image.fields) *= static_cast<int64_t>(reader->GetDimensions(axis));
        if (knows_geometry(reader->GetNameOfClass()))
            read_geometry(*reader, image);
        allocate_voxels(image);
        set_region(*reader);
        reader->Read(image.voxels.get());
        return image;
    });
}

void write_itk_image(const std::string& path, const Image& image)
{
    const std::string extension = extension_of(path);
    with_itk([&] {
        const Reader writer = writer_of(extension);
        check_geometry(image, extension);
        AtomicPath file(path, extension);
        writer->SetNumberOfDimensions(3);
        for (unsigned axis = 0; axis < 3; ++axis) {
            const Vector3& direction = image.directions[axis];
            writer->SetDimensions(axis, static_cast<itk::SizeValueType>(image.dims[axis]));
            writer->SetSpacing(axis, image.spacing[axis]);
            writer->SetOrigin(axis, image.origin[axis]);
            writer->SetDirection(axis, std::vector<double>(direction.begin(), direction.end()));
        }
        writer->SetPixelType(itk::IOPixelEnum::SCALAR);
        writer->SetComponentType(itk::IOComponentEnum::FLOAT);
        writer->SetNumberOfComponents(1);
        writer->SetFileName(file.path());
        writer->SetUseCompression(extension != ".nii" && extension != ".vtk");
        set_region(*writer);
        writer->Write(image.voxels.get());
        // Not every writer of ITK notices a full disk.
        const Image written = read_image(file.path());
        if (written.bytes() != image.bytes() ||
            std::memcmp(written.voxels.get(), image.voxels.get(), image.bytes()) != 0)
            throw Error(CLEFT_ERROR_FILE, "the file could not be written completely: is the disk full?");
        file.commit();
    });
}

}  // namespace cleft::io
