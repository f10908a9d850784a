// The low level of the Java, C# and Python bindings: cleft_io.h. A module of its own, loaded when a file is first read
// or written, since it brings GDCM and others with it.
#if defined(SWIGPYTHON)
%module(package="cleft") native_io
#else
%module CleftIoNative
#endif

%{
#include "cleft/cleft_io.h"

#include <stdlib.h>
#include <string.h>
%}

#define CLEFT_IO_MODULE
%include "kinds.i"

CLEFT_STRUCT(cleft_io_format_description, NativeFormatDescription)
// Pointers into the library's table: an assignment would free memory that is not SWIG's.
%immutable cleft_io_format_description::name;
%immutable cleft_io_format_description::extensions;
%immutable cleft_io_format_description::text;
CLEFT_STRUCT(cleft_io_reading, NativeReading)
CLEFT_STRUCT(cleft_io_raw, NativeRaw)
// Arrays in structs are set number by number: SWIG would want an array type of its own for each.
%ignore cleft_io_reading::spacing;
%extend cleft_io_reading {
    void set_spacing(int32_t axis, double length) { $self->spacing[axis] = length; }
}
%ignore cleft_io_raw::dims;
%ignore cleft_io_raw::spacing;
%extend cleft_io_raw {
    void set_axis(int32_t axis, int64_t voxels, double length)
    {
        $self->dims[axis] = voxels;
        $self->spacing[axis] = length;
    }
}

CLEFT_STRUCT(cleft_io_picture, NativePicture)
%ignore cleft_io_picture::cut;
%ignore cleft_io_picture::view;
%ignore cleft_io_picture::up;
%ignore cleft_io_picture::range;
%extend cleft_io_picture {
    void set_cut(int32_t axis, double share) { $self->cut[axis] = share; }
    void set_view(int32_t axis, double part) { $self->view[axis] = part; }
    void set_up(int32_t axis, double part) { $self->up[axis] = part; }
    void set_range(int32_t end, double measure) { $self->range[end] = measure; }
}

// A view has texts, which live as long as the call: they are its arguments. "" is none.
%ignore cleft_io_view;
%ignore cleft_io_write_view;
%rename(cleft_io_write_view) cleft_write_view_of;
%apply const char* PATH {
    const char* title, const char* report, const char* names, const char* other_title, const char* other_report
};
%inline %{
static int32_t cleft_write_view_of(cleft_context* context, const cleft_mesh* mesh, int64_t max_tets, double goal,
                                   const char* title, const char* report, const char* names, const cleft_mesh* other,
                                   const char* other_title, const char* other_report, const char* path)
{
    cleft_io_view view = {0};
    view.struct_size = sizeof view;
    view.max_tets = max_tets;
    view.goal = goal;
    view.title = title;
    view.report = report;
    view.names = names && *names ? names : NULL;
    view.other = other;
    view.other_title = other_title;
    view.other_report = other_report;
    return cleft_io_write_view(context, mesh, &view, path);
}
%}

// cleft_io.h includes cleft.h, which SWIG does not follow. What it takes from there is repeated
// here.
#define CLEFT_NOEXCEPT
#define CLEFT_NODISCARD
typedef int32_t cleft_status;
typedef int32_t cleft_type;
%include "cleft/cleft_io.h"
