// Every parameter of the C interface is of one of a few kinds. Here the parameters are sorted into kinds, by their names
// and types; each language tells in its own file how a kind passes:
//
//   HANDLE       an opaque handle, or none
//   OUT_HANDLE   where a new handle goes
//   ARRAY_IN     an array that is read, or none
//   ARRAY_OUT    an array that is written to (also single numbers: arrays of one), or none
//   FIELDS       an array of arrays, and their number
//   PATHS        texts and their number, given as bytes that are each closed by a zero
//   PATH         one text, given as bytes closed by a zero
//   OUT_NAME     where a borrowed text goes
//   ADDRESS      a borrowed array that is returned: its address, for a view that keeps the owner alive
//   callbacks    switched on or off; the language's own function waits on its own side
//
// Statuses are returned as numbers. The classes on top turn them into exceptions, for they know whose sentence to ask.

%include "stdint.i"

// Paths pass as one array of bytes, since arrays of strings differ in each language. C# passes
// addresses instead.
#if defined(CLEFT_IO_MODULE) && !defined(SWIGCSHARP)
%{
// Splits texts that are each closed by a zero. `pointers` must have room for one pointer a text.
// `size` is the number of bytes with all zeros. Every text ends within it, as the callers put a
// zero behind each.
static int64_t cleft_split_texts(const char* bytes, size_t size, const char** pointers)
{
    int64_t count = 0;
    size_t at = 0;
    for (; at < size; at += strlen(bytes + at) + 1)
        pointers[count++] = bytes + at;
    return count;
}
%}
#endif

#if defined(SWIGJAVA)
%include "java.i"
#elif defined(SWIGCSHARP)
%include "csharp.i"
#elif defined(SWIGPYTHON)
%include "python.i"
#endif

// Structs of plain numbers: made with their size in them, all else zero. CLEFT_NO_MEMORY, of each language, leaves the
// function with the exception for want of memory.
// struct_size is that of the header which this module was compiled with, and is hidden, so that no
// caller sets a wrong one. Nothing in these structs owns memory.
%define CLEFT_STRUCT(type, name)
#if defined(SWIGCSHARP)
%exception type::type() {
    $action
    if (!result) {
        SWIG_CSharpSetPendingException(SWIG_CSharpOutOfMemoryException, "there is not enough memory");  // SWIG looks for it
        return 0;
    }
}
#else
%exception type::type() { $action if (!result) { CLEFT_NO_MEMORY } }
#endif
%rename(name) type;
%ignore type::struct_size;
%ignore type::reserved;
%extend type {
    type()
    {
        struct type* made = (struct type*)calloc(1, sizeof(struct type));
        if (made)
            made->struct_size = sizeof(struct type);
        return made;
    }
    ~type() { free($self); }
}
%enddef

// One kind for all handles: classes of each language keep them apart.
%define CLEFT_HANDLE(type)
%apply void* HANDLE { type*, const type* };
%apply void** OUT_HANDLE { type** out };
#if defined(SWIGPYTHON)
%typemap(freearg) type** out { type##_destroy((type*)made$argnum); }
#endif
%enddef
CLEFT_HANDLE(cleft_context)
CLEFT_HANDLE(cleft_options)
CLEFT_HANDLE(cleft_volume)
CLEFT_HANDLE(cleft_sizing)
CLEFT_HANDLE(cleft_mesh)
CLEFT_HANDLE(cleft_surface)
CLEFT_HANDLE(cleft_report)

%apply const void* ARRAY_IN { const void* voxels, const void* values, const void* tensors };
%apply const int64_t* ARRAY_IN { const int64_t dims[3] };
%apply const double* ARRAY_IN { const double affine[12], const double point[3], const double tensor[6], const double* points };
%apply const int32_t* ARRAY_IN {
    const int32_t* labels, const int32_t* tets, const int32_t* strip, const int32_t* whole
};
#if !defined(SWIGCSHARP)  // where an array and its number are two arguments
%apply (const void* const* FIELDS, int64_t COUNT) { (const void* const* fields, int64_t count) };
%apply (const char* const* PATHS, int64_t COUNT) { (const char* const* paths, int64_t count) };
#endif

%apply int32_t* ARRAY_OUT { int32_t* major, int32_t* minor, int32_t* patch, int32_t* tets, int32_t* labels };
%apply int64_t* ARRAY_OUT { int64_t dims[3], int64_t* counts, int64_t* value, int64_t* point_count };
%apply double* ARRAY_OUT { double affine[12], double* points, double* value, double* size };
%apply float* ARRAY_OUT { float* tensors };
%apply const char** OUT_NAME { const char** name };
%apply const void* ADDRESS { const double*, const int32_t*, const float* };

%apply const char* PATH { const char* path };
%apply void** OUT_HANDLE { double** values };  // given back to cleft_io_free()
#if !defined(SWIGCSHARP)
%apply void* HANDLE { void* array };
#endif
#if defined(SWIGPYTHON)
%typemap(freearg) double** values "cleft_io_free(made$argnum);"
#endif

// Sentences for the context come from components written in C.
%ignore cleft_context_set_error;
// They belong to components written in C, such as libcleft_io. Another language would have to pair
// begin and end on all ways out.
%ignore cleft_context_begin;
%ignore cleft_context_end;
%ignore cleft_context_log;
