// Gmsh 2.2 and 4.1, text and binary. The label of a tetrahedron is what the name "material_<label>" of its physical
// group says, else the number of the group, else that of its entity.
#include "io/gmsh_numbering.hpp"
#include "io/label_names.hpp"
#include "io/mesh_data.hpp"
#include "io/text_scanner.hpp"

#include <array>
#include <map>
#include <optional>
#include <utility>

namespace cleft::io
{

namespace
{

// The type with four corners, the only one that is read.
constexpr int64_t kTetrahedron = 4;

// What is needed to pass over an element: how many points it has, and whether it may be skipped.
struct ElementType {
    int dimension;
    int points;
};

// Types 1 .. 31 of the manual.
constexpr std::array<ElementType, 32> kElementTypes = {{
    {0, 0},  {1, 2},  {2, 3},  {2, 4},  {3, 4}, {3, 8}, {3, 6},  {3, 5},  {1, 3},  {2, 6},  {2, 9},
    {3, 10}, {3, 27}, {3, 18}, {3, 14}, {0, 1}, {2, 8}, {3, 20}, {3, 15}, {3, 13}, {2, 9},  {2, 10},
    {2, 12}, {2, 15}, {2, 15}, {2, 21}, {1, 4}, {1, 5}, {1, 6},  {3, 20}, {3, 35}, {3, 56},
}};

class GmshReader
{
public:
    // The whole file is read into memory first. Positions in binary sections are then plain
    // pointers.
    explicit GmshReader(const std::string& path) : in_(path) {}

    MeshData read()
    {
        if (in_.at_end() || in_.word() != "$MeshFormat")
            in_.fail("a Gmsh file begins with $MeshFormat");
        in_.skip_line();
        read_format();
        // Sections may come in any order and number, and unknown ones are skipped: $Periodic,
        // $NodeData, $Comments.
        while (!in_.at_end())
            read_section(std::string(in_.word()));
        if (!has_elements_)
            in_.fail("the file ends before its elements");
        return std::move(mesh_);
    }

private:
    void read_format();
    void read_section(const std::string& section);
    void read_physical_names();
    void name_group(int64_t group, const std::string& text);
    void read_entities(bool are_parts);
    void read_entity(int dimension, bool is_part);
    int64_t group_of_parent();
    void read_parts();
    void read_nodes_22();
    void read_nodes_41();
    void read_elements_22();
    void read_element_22(const ElementType& type, int64_t tags);
    void read_elements_41();

    // Numbers of the body of a section, in either form.
    int64_t small() { return binary_ ? in_.binary<int32_t>() : in_.integer(); }
    int64_t large() { return binary_ ? in_.binary<int64_t>() : in_.integer(); }
    double real();
    int64_t large_count(int64_t least_bytes, const char* what);

    const ElementType& type_of(int64_t type);
    void add_point(int64_t number);
    void add_tetrahedron(const std::array<int64_t, 4>& numbers, int32_t label);
    int32_t label_of_group(int64_t group) const;

    TextScanner in_;
    bool version_4_ = false;
    bool binary_ = false;
    bool has_elements_ = false;
    // A map, since group numbers are sparse: labels of an atlas have five digits.
    std::map<int64_t, int32_t> named_labels_;       // of physical groups whose name tells the label
    std::map<int64_t, int64_t> groups_of_volumes_;  // first physical group of each volume
    PointNumbers numbers_;
    MeshData mesh_;
};

double GmshReader::real() { return binary_ ? in_.binary<double>() : in_.real(); }

int64_t GmshReader::large_count(int64_t least_bytes, const char* what)
{
    const int64_t count = large();
    in_.check_count(count, least_bytes, what);
    return count;
}

const ElementType& GmshReader::type_of(int64_t type)
{
    if (type < 1 || type >= static_cast<int64_t>(kElementTypes.size()))
        in_.unsupported("elements of type " + std::to_string(type) + " are not known");
    const ElementType& found = kElementTypes[static_cast<size_t>(type)];
    // Skipping a prism or a second-order tetrahedron would leave a hole in the mesh, so they are
    // refused. Points, lines and plane elements are only the boundary.
    if (found.dimension == 3 && type != kTetrahedron)
        in_.unsupported("elements of type " + std::to_string(type) + " are no tetrahedra with four corners");
    return found;
}

void GmshReader::add_point(int64_t number)
{
    numbers_.add(number);
    for (int axis = 0; axis < 3; ++axis)
        mesh_.points.push_back(real());
}

void GmshReader::add_tetrahedron(const std::array<int64_t, 4>& numbers, int32_t label)
{
    for (const int64_t number : numbers) {
        const int32_t point = numbers_.find(number);
        if (point < 0)
            in_.fail("there is no point " + std::to_string(number));
        mesh_.tets.push_back(point);
    }
    mesh_.labels.push_back(label);
}

int32_t GmshReader::label_of_group(int64_t group) const
{
    const auto named = named_labels_.find(group);
    if (named != named_labels_.end())
        return named->second;
    // int64 to double is exact up to 2^53, and larger numbers are no labels either way.
    if (!is_label(static_cast<double>(group)))
        in_.fail("the number " + std::to_string(group) + " of a volume is not one of 32 bits");
    return static_cast<int32_t>(group);
}

void GmshReader::read_format()
{
    const std::string version(in_.word());
    // 4.0 orders the fields in another way, and was soon replaced by 4.1. Version 1 has other
    // keywords.
    version_4_ = version == "4.1";
    if (!version_4_ && version != "2.2" && version != "2")
        in_.unsupported("version " + version.substr(0, 10) + " cannot be read, only 2.2 and 4.1");
    // "file-type": 0 for text, 1 for binary. "data-size" is sizeof(size_t), always 8 in today's
    // files.
    binary_ = in_.integer() == 1;
    if (in_.integer() != 8)
        in_.unsupported("only numbers of 8 bytes can be read");
    in_.skip_line();
    // The number 1 behind the header line shows the order of bytes.
    if (binary_ && in_.binary<int32_t>() != 1)
        in_.unsupported("the file was written on a machine with another order of bytes");
    if (in_.word() != "$EndMeshFormat")
        in_.fail("$EndMeshFormat is missing");
}

void GmshReader::read_section(const std::string& section)
{
    in_.skip_line();
    if (section == "$PhysicalNames")
        read_physical_names();
    else if (section == "$Entities" && version_4_)
        read_entities(false);
    else if (section == "$PartitionedEntities" && version_4_)
        read_parts();
    else if (section == "$Nodes")
        version_4_ ? read_nodes_41() : read_nodes_22();
    else if (section == "$Elements")
        version_4_ ? read_elements_41() : read_elements_22();
    else if (section.size() < 2 || section[0] != '$')
        in_.fail("a section was expected, not '" + section.substr(0, 40) + "'");
    // The end mark is searched for, so that a section with further fields, or an unknown one, can
    // be passed over.
    in_.skip_past("$End" + section.substr(1));
}

void GmshReader::read_physical_names()
{
    // At least "2 1 \"\"" and an end of line for each name; four bytes are a safe lower bound.
    const int64_t count = in_.count(4, "physical names");
    for (int64_t i = 0; i < count; ++i) {
        const int64_t dimension = in_.integer();
        const int64_t group = in_.integer();
        const std::string line(in_.rest_of_line());
        const size_t begin = line.find('"');
        // From both ends of the line, as a name may have quotes in it.
        const size_t end = line.rfind('"');
        if (begin == std::string::npos || end == begin)
            in_.fail("a physical name must be in quotes");
        if (dimension == 3)
            name_group(group, line.substr(begin + 1, end - begin - 1));
    }
}

// "material_<label>", which may have a name behind it, tells the label; any other name is that of the group's number.
void GmshReader::name_group(int64_t group, const std::string& text)
{
    int32_t label = 0;
    std::string name;
    if (label_of_material_name(text, label, name)) {
        named_labels_[group] = label;
    } else if (is_label(static_cast<double>(group))) {
        label = static_cast<int32_t>(group);
        name = text;
    }
    if (!name.empty())
        mesh_.names.emplace(label, name);
}

void GmshReader::read_entities(bool are_parts)
{
    std::array<int64_t, 4> counts{};
    // Points, curves, surfaces and volumes. A point takes 36 bytes in binary, and 8 are a safe
    // lower bound in text, too.
    for (int64_t& count : counts)
        count = large_count(8, "entities");
    for (int dimension = 0; dimension < 4; ++dimension)
        for (int64_t i = 0; i < counts[static_cast<size_t>(dimension)]; ++i)
            read_entity(dimension, are_parts);
}

void GmshReader::read_entity(int dimension, bool is_part)
{
    const int64_t number = small();
    std::optional<int64_t> group;
    if (is_part)
        group = group_of_parent();
    // A point has its coordinates, everything else its bounding box.
    for (int b = 0; b < (dimension == 0 ? 3 : 6); ++b)
        real();
    const int64_t groups = large_count(1, "physical groups");
    for (int64_t g = 0; g < groups; ++g) {
        const int64_t own = small();
        // A tetrahedron has one label, so of several physical groups the first one decides.
        if (g == 0)
            group = own;
    }
    if (dimension == 3 && group)
        groups_of_volumes_[number] = *group;
    // Signed tags of the entities around this one. A mesh of tetrahedra does not need them.
    const int64_t boundaries = dimension > 0 ? large_count(1, "boundaries") : 0;
    for (int64_t b = 0; b < boundaries; ++b)
        small();
}

// Of the entity that a part belongs to: its physical group, or its own number where it has none.
int64_t GmshReader::group_of_parent()
{
    small();  // the dimension: a part that is a volume has a volume as its parent
    const int64_t parent = small();
    const int64_t partitions = large_count(1, "partitions");
    for (int64_t p = 0; p < partitions; ++p)
        small();
    const auto group = groups_of_volumes_.find(parent);
    return group != groups_of_volumes_.end() ? group->second : parent;
}

// In a partitioned mesh of version 4.1 the elements name parts of volumes. Parts are numbered anew, behind the volumes,
// so that their numbers are no labels. Version 2.2 keeps the volumes and names partitions among the tags.
void GmshReader::read_parts()
{
    large();  // the number of partitions
    const int64_t ghosts = large_count(2, "ghost entities");
    for (int64_t g = 0; g < 2 * ghosts; ++g)
        small();
    read_entities(true);
}

void GmshReader::read_nodes_22()
{
    const int64_t count = in_.count(8, "points");
    in_.skip_line();
    mesh_.points.reserve(static_cast<size_t>(3 * count));
    numbers_.reserve(static_cast<size_t>(count));
    for (int64_t i = 0; i < count; ++i)
        add_point(small());
    if (!numbers_.finish())
        in_.fail("a point has the number of another one");
}

void GmshReader::read_nodes_41()
{
    const int64_t blocks = large_count(4, "blocks of points");
    const int64_t count = large_count(6, "points");
    // The least and the greatest number of a point follow. They would only help to choose a table.
    large();
    large();
    mesh_.points.reserve(static_cast<size_t>(3 * count));
    numbers_.reserve(static_cast<size_t>(count));
    for (int64_t block = 0; block < blocks; ++block) {
        const int64_t dimension = small();
        small();
        // "parametric": then as many coordinates on the entity as it has dimensions follow each
        // point.
        const int64_t parameters = small() != 0 ? dimension : 0;
        const int64_t points = large_count(6, "points");
        // A block has all its numbers first and then all its points.
        std::vector<int64_t> numbers(static_cast<size_t>(points));
        for (int64_t& number : numbers)
            number = large();
        for (const int64_t number : numbers) {
            add_point(number);
            for (int64_t p = 0; p < parameters; ++p)
                real();
        }
    }
    if (!numbers_.finish())
        in_.fail("a point has the number of another one");
}

void GmshReader::read_elements_22()
{
    const int64_t count = in_.count(6, "elements");
    in_.skip_line();
    has_elements_ = true;
    for (int64_t done = 0; done < count;) {
        // Binary files have blocks of elements of one type; in text every element is a block, its number in front.
        if (!binary_)
            small();
        const int64_t type = small();
        const int64_t block = binary_ ? small() : 1;
        const int64_t tags = small();
        // A thousand tags are far more than physical group, entity and partitions need. A larger
        // number is damage and would cost time.
        if (block < 1 || block > count - done || tags < 0 || tags > 1000)
            in_.fail("the elements after the first " + std::to_string(done) + " are damaged");
        const ElementType& kind = type_of(type);
        for (int64_t i = 0; i < block; ++i, ++done) {
            if (binary_)
                small();
            read_element_22(kind, tags);
        }
    }
}

void GmshReader::read_element_22(const ElementType& type, int64_t tags)
{
    int64_t label = 0;
    for (int64_t t = 0; t < tags; ++t) {
        const int64_t tag = small();  // physical group, entity, partitions
        // Version 2.2: the first tag is the physical group, the second the entity. Group 0 means
        // that there is none.
        if (t == 0 || (t == 1 && label == 0))
            label = tag;
    }
    std::array<int64_t, 4> corners{};
    for (int p = 0; p < type.points; ++p) {
        const int64_t point = small();
        if (type.dimension == 3)
            corners[static_cast<size_t>(p)] = point;
    }
    if (type.dimension == 3)
        add_tetrahedron(corners, label_of_group(label));
}

void GmshReader::read_elements_41()
{
    const int64_t blocks = large_count(4, "blocks of elements");
    large();
    large();
    large();
    has_elements_ = true;
    for (int64_t block = 0; block < blocks; ++block) {
        small();
        const int64_t entity = small();
        const ElementType& type = type_of(small());
        // Number and corners of an element, each with a digit and a blank in text; binary has 8
        // bytes for each.
        const int64_t count = large_count(2 + 2 * type.points, "elements");
        const auto group = groups_of_volumes_.find(entity);
        const bool named = group != groups_of_volumes_.end();
        const int32_t label = type.dimension == 3 ? label_of_group(named ? group->second : entity) : 0;
        for (int64_t i = 0; i < count; ++i) {
            large();
            std::array<int64_t, 4> corners{};
            for (int p = 0; p < type.points; ++p) {
                const int64_t point = large();
                if (type.dimension == 3)
                    corners[static_cast<size_t>(p)] = point;
            }
            if (type.dimension == 3)
                add_tetrahedron(corners, label);
        }
    }
}

}  // namespace

MeshData read_gmsh(const std::string& path) { return GmshReader(path).read(); }

}  // namespace cleft::io
