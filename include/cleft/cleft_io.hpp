/*
 * The interface of cleft_io.h for C++11 and later: files of volumes, sizing fields and meshes. Header only.
 */
#ifndef CLEFT_IO_HPP
#define CLEFT_IO_HPP

#include "cleft/cleft.hpp"
#include "cleft/cleft_io.h"

#include <string>
#include <vector>

namespace cleft
{
inline namespace cpp
{

/** Returns the default cleft_io_reading. */
inline cleft_io_reading default_reading()
{
    cleft_io_reading reading{};
    reading.struct_size = sizeof reading;
    return reading;
}

/** Reads a volume from one file, or from several files with one mask or function each: cleft_io_read_volume(). */
inline Volume read_volume(const Context& context, const std::vector<std::string>& paths,
                          const cleft_io_reading& reading = default_reading(), const Options& options = Options())
{
    std::vector<const char*> texts;
    for (const std::string& path : paths)
        texts.push_back(path.c_str());
    return made<Volume, cleft_volume>(context, [&](cleft_volume** out) {
        return cleft_io_read_volume(context.get(), options.get(), texts.data(), static_cast<int64_t>(texts.size()),
                                    &reading, out);
    });
}

inline Sizing read_sizing(const Context& context, const Volume& volume, const std::string& path, bool combine = false,
                          const cleft_io_reading& reading = default_reading(), const Options& options = Options())
{
    return made<Sizing, cleft_sizing>(context, [&](cleft_sizing** out) {
        return cleft_io_read_sizing(context.get(), volume.get(), path.c_str(), &reading, combine, options.get(), out);
    });
}

/** Reads a metric: cleft_io_read_metric(). Without a volume, the field has the voxels of the file. */
inline Sizing read_metric(const Context& context, const Volume* volume, const std::string& path,
                          cleft_io_tensor_order order = CLEFT_IO_ORDER_FILE, bool combine = false,
                          const cleft_io_reading& reading = default_reading(), const Options& options = Options())
{
    return made<Sizing, cleft_sizing>(context, [&](cleft_sizing** out) {
        return cleft_io_read_metric(context.get(), volume ? volume->get() : nullptr, path.c_str(), &reading, order,
                                    combine, options.get(), out);
    });
}

inline void write_sizing(const Context& context, const Sizing& sizing, const std::string& path,
                         cleft_io_world world = CLEFT_IO_WORLD_LPS)
{
    context.check(cleft_io_write_sizing(context.get(), sizing.get(), path.c_str(), world));
}

inline Mesh read_mesh(const Context& context, const std::string& path)
{
    return made<Mesh, cleft_mesh>(
        context, [&](cleft_mesh** out) { return cleft_io_read_mesh(context.get(), path.c_str(), out); });
}

inline void write_mesh(const Context& context, const Mesh& mesh, const std::string& path,
                       cleft_io_format format = CLEFT_FORMAT_BY_NAME)
{
    context.check(cleft_io_write_mesh(context.get(), mesh.get(), path.c_str(), format));
}

/** Names the labels of a volume by a table: cleft_io_read_volume_names(). */
inline void read_names(const Context& context, const std::string& path, Volume& volume)
{
    context.check(cleft_io_read_volume_names(context.get(), path.c_str(), volume.get()));
}

/** Names the labels of a mesh by a table: cleft_io_read_mesh_names(). */
inline void read_names(const Context& context, const std::string& path, Mesh& mesh)
{
    context.check(cleft_io_read_mesh_names(context.get(), path.c_str(), mesh.get()));
}

/** Returns the default cleft_io_picture. */
inline cleft_io_picture default_picture()
{
    cleft_io_picture picture{};
    picture.struct_size = sizeof picture;
    return picture;
}

/** Draws a mesh as PNG: cleft_io_write_picture(). The labels of `strip` are not drawn, those of `whole` not cut. */
inline void write_picture(const Context& context, const Mesh& mesh, const std::string& path,
                          const cleft_io_picture& picture = default_picture(), const std::vector<int32_t>& strip = {},
                          const std::vector<int32_t>& whole = {})
{
    context.check(cleft_io_write_picture(context.get(), mesh.get(), strip.data(), static_cast<int64_t>(strip.size()),
                                         whole.data(), static_cast<int64_t>(whole.size()), &picture, path.c_str()));
}

/** Returns the default cleft_io_view. */
inline cleft_io_view default_view()
{
    cleft_io_view view{};
    view.struct_size = sizeof view;
    return view;
}

/** Writes a page that shows a mesh in any browser: cleft_io_write_view(). */
inline void write_view(const Context& context, const Mesh& mesh, const std::string& path,
                       const cleft_io_view& view = default_view())
{
    context.check(cleft_io_write_view(context.get(), mesh.get(), &view, path.c_str()));
}

}  // namespace cpp
}  // namespace cleft

#endif
