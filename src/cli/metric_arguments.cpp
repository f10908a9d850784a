// Reads --metric, and measures meshes by it.
#include "metric_arguments.hpp"

#include "exit_code.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <sstream>
#include <vector>

namespace cleft_cli
{
namespace
{

using SixNumbers = std::array<double, 6>;

// MEDIT and mmg write what NIfTI does.
const std::map<std::string, cleft_io_tensor_order> kTensorOrders = {{"file", CLEFT_IO_ORDER_FILE},
                                                                    {"nrrd", CLEFT_IO_ORDER_NRRD},
                                                                    {"vtk", CLEFT_IO_ORDER_VTK},
                                                                    {"nifti", CLEFT_IO_ORDER_NIFTI},
                                                                    {"mmg", CLEFT_IO_ORDER_NIFTI}};

// Six numbers with commas between them.
std::optional<SixNumbers> tensor_in(const std::string& text)
{
    std::istringstream words(text);
    std::vector<double> numbers;
    for (std::string word; std::getline(words, word, ',');) {
        double number = 0;
        if (!CLI::detail::lexical_cast(word, number))
            return {};
        numbers.push_back(number);
    }
    SixNumbers six{};
    if (numbers.size() != six.size())
        return {};
    std::copy(numbers.begin(), numbers.end(), six.begin());
    return six;
}

CLI::Validator tensor_or_file()
{
    return {[](std::string& text) { return tensor_in(text) ? std::string() : CLI::ExistingFile(text); }, ""};
}

// A place for a tensor that holds everywhere: the metric beyond the volume is that of its outermost voxels.
Volume one_voxel(const Session& session)
{
    const int64_t dims[3] = {1, 1, 1};
    const uint8_t label = 0;
    return session.make<Volume>(EXIT_MESHING_FAILED, [&](cleft_volume** out) {
        return cleft_volume_create_labels(session.context(), CLEFT_TYPE_UINT8, &label, dims, nullptr, nullptr, out);
    });
}

Sizing sizing_of_tensor(const Session& session, const cleft_volume* volume, const SixNumbers& tensor, bool combine,
                        const cleft_options* options)
{
    int64_t dims[3] = {};
    session.check(cleft_volume_dims(volume, dims), EXIT_MESHING_FAILED);
    std::vector<double> tensors;
    // At each voxel, as bounds, a wanted number and the computed field change it.
    for (int64_t voxel = 0; voxel < dims[0] * dims[1] * dims[2]; ++voxel)
        tensors.insert(tensors.end(), tensor.begin(), tensor.end());
    return session.make<Sizing>(EXIT_CANNOT_READ, [&](cleft_sizing** out) {
        return cleft_sizing_create_metric(session.context(), volume, CLEFT_TYPE_FLOAT64, tensors.data(),
                                          combine ? 1 : 0, options, out);
    });
}

}  // namespace

std::string MetricArguments::file() const { return tensor_in(metric) ? "" : metric; }

void MetricArguments::add_to(CLI::App& app, const std::string& text, const std::string& group)
{
    CLI::Option* option = app.add_option("--metric", metric, text)
                              ->check(tensor_or_file())
                              ->type_name("FILE|XX,XY,XZ,YY,YZ,ZZ")
                              ->group(group);
    app.add_option("--metric-order", order,
                   "Order of six numbers of which the file says nothing:\n"
                   "nrrd: xx xy xz yy yz zz, vtk: xx yy zz xy yz xz,\n"
                   "nifti, mmg: xx xy yy xz yz zz (default file)")
        ->check(CLI::IsMember({"file", "nrrd", "vtk", "nifti", "mmg"}).description(""))
        ->type_name("file|nrrd|vtk|nifti|mmg")
        ->needs(option)
        ->group(group);
}

Sizing MetricArguments::read(const Session& session, const cleft_volume* volume, const cleft_io_reading& reading,
                             bool combine, const cleft_options* options) const
{
    if (const auto tensor = tensor_in(metric)) {
        const Volume place = volume ? Volume() : one_voxel(session);
        return sizing_of_tensor(session, volume ? volume : place.get(), *tensor, combine, options);
    }
    return session.make<Sizing>(EXIT_CANNOT_READ, [&](cleft_sizing** out) {
        return cleft_io_read_metric(session.context(), volume, metric.c_str(), &reading, kTensorOrders.at(order),
                                    combine ? 1 : 0, options, out);
    });
}

std::optional<cleft_metric_quality> look_at_metric(const Session& session, const cleft_mesh* mesh,
                                                   const cleft_sizing* sizing)
{
    cleft_metric_quality quality{};
    quality.struct_size = sizeof quality;
    const cleft_status status = cleft_mesh_metric_quality(session.context(), mesh, sizing, &quality);
    if (status == CLEFT_ERROR_INVALID_MESH)
        return {};
    session.check(status, EXIT_MESHING_FAILED);
    return quality;
}

}  // namespace cleft_cli
