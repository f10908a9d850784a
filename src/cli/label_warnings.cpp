// Says in one sentence of each kind which labels were lost, broke or touch, however many there are.
#include "label_warnings.hpp"

#include "text.hpp"

#include <string>

namespace cleft_cli
{
namespace
{

// The things that a warning is about: some of them by name, and how many more there are.
class ShortList
{
public:
    void add(const std::string& name)
    {
        if (++count_ <= kNamed)
            names_ += (count_ == 1 ? "" : ", ") + name;
    }
    bool empty() const { return count_ == 0; }
    int64_t count() const { return count_; }
    std::string text() const { return names_ + (count_ > kNamed ? " and " + grouped(count_ - kNamed) + " more" : ""); }

private:
    // More make a warning unreadable. All of them are in the JSON report.
    static constexpr int64_t kNamed = 5;
    int64_t count_ = 0;
    std::string names_;
};

std::string with_label(int32_t label, const std::string& what)
{
    return "label " + std::to_string(label) + " (" + what + ")";
}

// Each kind of loss in one sentence, however many labels it befalls.
void warn_of_lost_labels(Session& session, const std::vector<LabelFindings>& rows,
                         const std::function<bool(int32_t label)>& left_out)
{
    ShortList lost, pieces_lost, broken;
    for (const LabelFindings& row : rows) {
        if (left_out(row.label))
            continue;
        const std::string of_pieces = " of " + plural(row.large_components, "piece");
        if (row.lost != 0)
            lost.add(with_label(row.label, plural(row.voxels, "voxel")));
        // A lost label has lost its pieces, too; one warning suffices.
        else if (row.large_components_lost > 0)
            pieces_lost.add(with_label(row.label, grouped(row.large_components_lost) + of_pieces));
        if (row.large_components_broken > 0)
            broken.add(with_label(row.label, grouped(row.large_components_broken) + of_pieces));
    }
    if (!lost.empty())
        session.warn("the mesh lacks " + plural(lost.count(), "label") + " of the volume: " + lost.text());
    if (!pieces_lost.empty())
        session.warn("the mesh lacks pieces of more than 30 voxels of " + plural(pieces_lost.count(), "label") + ": " +
                     pieces_lost.text());
    if (!broken.empty())
        session.warn("pieces of more than 30 voxels of " + plural(broken.count(), "label") +
                     " broke where they are thinner than the tetrahedra: " + broken.text() +
                     " (--size-min, --label-size)");
}

void warn_of_contacts(Session& session, const std::vector<cleft_contact>& contacts)
{
    ShortList pairs;
    for (const cleft_contact& contact : contacts)
        pairs.add(std::to_string(contact.first) + " and " + std::to_string(contact.second) + " (" +
                  plural(contact.triangles, "triangle") + ")");
    if (pairs.empty())
        return;
    session.warn(plural(pairs.count(), "pair") +
                 " of labels meet in the mesh, though no two of their voxels share a face or an edge: " + pairs.text() +
                 "; a smaller size opens the gap (--size-min, --label-size)");
}

}  // namespace

void warn_of_labels(Session& session, const ReportFindings& report, const std::function<bool(int32_t label)>& left_out)
{
    warn_of_lost_labels(session, report.labels, left_out);
    warn_of_contacts(session, report.contacts);
}

}  // namespace cleft_cli
