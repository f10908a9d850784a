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

// cleft_io.h includes cleft.h, which SWIG does not follow. What it takes from there is repeated
// here.
#define CLEFT_NOEXCEPT
#define CLEFT_NODISCARD
typedef int32_t cleft_status;
typedef int32_t cleft_type;
%include "cleft/cleft_io.h"
