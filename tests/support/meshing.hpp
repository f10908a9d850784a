// One mesh by the C interface, for tests over many volumes. Nothing is asserted here: tests look at what comes back.
#pragma once

#include "cleft/cleft.h"
#include "support/volumes.hpp"

#include <cstring>
#include <string>
#include <utility>
#include <vector>

namespace cleft_test
{

using OptionTexts = std::vector<std::pair<const char*, const char*>>;

struct Meshed {
    std::string failure;  // empty if there was none
    std::vector<std::array<int32_t, 4>> tets;
    std::vector<int32_t> labels;  // of the tetrahedra
    std::vector<cleft_label_report> rows;
    std::vector<std::pair<std::string, double>> metrics;

    double metric(const std::string& name) const
    {
        for (const auto& [known, value] : metrics)
            if (known == name)
                return value;
        return -1;
    }
};

class MeshingRun
{
public:
    ~MeshingRun()
    {
        cleft_report_destroy(report_);
        cleft_mesh_destroy(mesh_);
        cleft_volume_destroy(volume_);
        cleft_options_destroy(options_);
        cleft_context_destroy(context_);
    }

    Meshed mesh(const LabelVolume& labels, const OptionTexts& options)
    {
        Meshed out;
        if (!run(labels, options)) {
            out.failure = context_ ? cleft_context_last_error(context_) : "no context";
            if (out.failure.empty())
                out.failure = "failed without a sentence";
            return out;
        }
        out.tets.resize(static_cast<size_t>(cleft_mesh_tet_count(mesh_)));
        std::memcpy(out.tets.data(), cleft_mesh_tets(mesh_), out.tets.size() * sizeof(out.tets[0]));
        out.labels.assign(cleft_mesh_tet_labels(mesh_), cleft_mesh_tet_labels(mesh_) + out.tets.size());
        take_metrics(out);
        take_report(out);
        return out;
    }

private:
    bool run(const LabelVolume& labels, const OptionTexts& options)
    {
        bool done = cleft_context_create(&context_) == CLEFT_OK && cleft_options_create(&options_) == CLEFT_OK;
        for (const auto& [name, value] : options)
            done = done && cleft_options_set_text(options_, name, value) == CLEFT_OK;
        const int64_t dims[3] = {labels.dims[0], labels.dims[1], labels.dims[2]};
        return done &&
               cleft_volume_create_labels(context_, CLEFT_TYPE_UINT8, labels.voxels.data(), dims, nullptr, options_,
                                          &volume_) == CLEFT_OK &&
               cleft_mesh_volume(context_, volume_, nullptr, nullptr, options_, &mesh_) == CLEFT_OK;
    }

    void take_metrics(Meshed& out) const
    {
        for (int64_t i = 0; i < cleft_context_metric_count(context_); ++i) {
            const char* name = nullptr;
            double value = 0;
            if (cleft_context_metric(context_, i, &name, &value) == CLEFT_OK)
                out.metrics.emplace_back(name, value);
        }
    }

    void take_report(Meshed& out)
    {
        if (cleft_report_create(context_, volume_, mesh_, &report_) != CLEFT_OK) {
            out.failure = cleft_context_last_error(context_);
            return;
        }
        for (int64_t i = 0; i < cleft_report_count(report_); ++i) {
            cleft_label_report row{};
            row.struct_size = sizeof row;
            if (cleft_report_label(report_, i, &row) == CLEFT_OK)
                out.rows.push_back(row);
        }
    }

    cleft_context* context_ = nullptr;
    cleft_options* options_ = nullptr;
    cleft_volume* volume_ = nullptr;
    cleft_mesh* mesh_ = nullptr;
    cleft_report* report_ = nullptr;
};

inline Meshed mesh_of(const LabelVolume& labels, const OptionTexts& options)
{
    return MeshingRun().mesh(labels, options);
}

}  // namespace cleft_test
