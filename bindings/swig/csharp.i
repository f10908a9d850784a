// How the kinds of kinds.i pass from and to C#. Handles are SafeHandles, which the runtime holds during a call; arrays are
// arrays of C#, which it pins. Nothing of this is public: the classes on top are.

%pragma(csharp) moduleclassmodifiers="internal class"
%pragma(csharp) imclassclassmodifiers="internal class"
%typemap(csclassmodifiers) SWIGTYPE "internal class"
// Constants become constants of C#, so that enumerations can be made of them at compile time.
%csconst(1);
// SWIG takes int64_t for `long` of C, which it maps to `int` of C#: the upper half would be lost.
%apply long long { int64_t };

// CLEFT_CSHARP_TYPES(TYPE IN C#, HOW IT IS GIVEN, KIND OF PARAMETER...)
%define CLEFT_CSHARP_TYPES(cs_type, given, kinds...)
%typemap(ctype) kinds "void *"
%typemap(imtype) kinds #cs_type
%typemap(cstype) kinds #cs_type
%typemap(csin) kinds #given
%typemap(in) kinds "$1 = ($1_ltype)$input;"
%typemap(argout) kinds ""
%typemap(freearg) kinds ""
%enddef

CLEFT_CSHARP_TYPES(NativeHandle, $csinput, void* HANDLE)
CLEFT_CSHARP_TYPES(out global::System.IntPtr, out $csinput, void** OUT_HANDLE)
CLEFT_CSHARP_TYPES(global::System.IntPtr, $csinput, const void* ARRAY_IN)
CLEFT_CSHARP_TYPES(long[], $csinput, const int64_t* ARRAY_IN)
CLEFT_CSHARP_TYPES(int[], $csinput, const int32_t* ARRAY_IN)
CLEFT_CSHARP_TYPES(double[], $csinput, const double* ARRAY_IN)
CLEFT_CSHARP_TYPES(byte[], $csinput, const char* PATH)
CLEFT_CSHARP_TYPES(long[], $csinput, int64_t* ARRAY_OUT)
CLEFT_CSHARP_TYPES(int[], $csinput, int32_t* ARRAY_OUT)
CLEFT_CSHARP_TYPES(double[], $csinput, double* ARRAY_OUT)
CLEFT_CSHARP_TYPES(float[], $csinput, float* ARRAY_OUT)
// The runtime may copy an array instead of pinning it, and by default towards C alone. The library
// writes into these.
%typemap(imtype, inattributes="[global::System.Runtime.InteropServices.In, global::System.Runtime.InteropServices.Out]")
    int64_t* ARRAY_OUT "long[]"
%typemap(imtype, inattributes="[global::System.Runtime.InteropServices.In, global::System.Runtime.InteropServices.Out]")
    int32_t* ARRAY_OUT "int[]"
%typemap(imtype, inattributes="[global::System.Runtime.InteropServices.In, global::System.Runtime.InteropServices.Out]")
    double* ARRAY_OUT "double[]"
%typemap(imtype, inattributes="[global::System.Runtime.InteropServices.In, global::System.Runtime.InteropServices.Out]")
    float* ARRAY_OUT "float[]"
CLEFT_CSHARP_TYPES(out global::System.IntPtr, out $csinput, const char** OUT_NAME)

// Arrays of addresses, with their number as an argument of its own.
CLEFT_CSHARP_TYPES(global::System.IntPtr[], $csinput, const void* const* fields)
CLEFT_CSHARP_TYPES(global::System.IntPtr[], $csinput, const char* const* paths)

// A borrowed array stays in the library's memory. A view over its address keeps the owner alive.
%typemap(ctype) const void* ADDRESS "void *"
%typemap(imtype) const void* ADDRESS "global::System.IntPtr"
%typemap(cstype) const void* ADDRESS "global::System.IntPtr"
%typemap(out) const void* ADDRESS "$result = (void*)$1;"
%typemap(csout, excode=SWIGEXCODE) const void* ADDRESS { return $imcall; }

// Texts are UTF-8. One that is returned is copied, for its owner may be collected before it is read: Utf8.Take() frees it.
%{
// malloc(), as Utf8.Take() gives the copy back by cleft_text_free(), which calls free() of the same
// C library.
static void* cleft_csharp_text(const char* text)
{
    const size_t size = text ? strlen(text) + 1 : 0;
    void* copy = size ? malloc(size) : NULL;
    return copy ? memcpy(copy, text, size) : NULL;
}
%}
%typemap(ctype) const char* "void *"
%typemap(imtype, out="global::System.IntPtr") const char* "byte[]"
%typemap(cstype) const char* "string"
%typemap(csin) const char* "Utf8.Write($csinput, \"$csinput\")"
%typemap(in) const char* "$1 = (char*)$input;"
%typemap(argout) const char* ""
%typemap(freearg) const char* ""
%typemap(out, canthrow=1) const char* %{
    $result = cleft_csharp_text($1);
    if ($1 && !$result) {
        SWIG_CSharpSetPendingException(SWIG_CSharpOutOfMemoryException, "there is not enough memory");
        return 0;
    } %}
// $excode throws what is pending. Without it the exception would wait, and come out of the next call that looks for one.
%typemap(csout, excode=SWIGEXCODE) const char* {
    global::System.IntPtr text = $imcall;$excode
    return Utf8.Take(text);
  }
%typemap(csvarout, excode=SWIGEXCODE2) const char* %{
    get {
      global::System.IntPtr text = $imcall;$excode
      return Utf8.Take(text);
    } %}

#ifndef CLEFT_IO_MODULE
// A delegate passes as a pointer to a function. The class on top keeps it, as the collector sees no
// use of it in C.
CLEFT_CSHARP_TYPES(NativeProgress, $csinput, cleft_progress_callback callback)
CLEFT_CSHARP_TYPES(NativeLog, $csinput, cleft_log_callback callback)
CLEFT_CSHARP_TYPES(global::System.IntPtr, $csinput, void* user, void* address)

// A SafeHandle that is being released cannot be passed as one: its address is.
%ignore cleft_context_destroy;
%ignore cleft_options_destroy;
%ignore cleft_volume_destroy;
%ignore cleft_sizing_destroy;
%ignore cleft_mesh_destroy;
%ignore cleft_surface_destroy;
%ignore cleft_report_destroy;
%rename(cleft_text_free) free_text;
%rename(cleft_context_destroy) destroy_context;
%rename(cleft_options_destroy) destroy_options;
%rename(cleft_volume_destroy) destroy_volume;
%rename(cleft_sizing_destroy) destroy_sizing;
%rename(cleft_mesh_destroy) destroy_mesh;
%rename(cleft_surface_destroy) destroy_surface;
%rename(cleft_report_destroy) destroy_report;
// Each takes an address, since a SafeHandle calls them while it is being released and cannot pass
// itself.
%inline %{
static void free_text(void* address) { free(address); }
static void destroy_context(void* address) { cleft_context_destroy((cleft_context*)address); }
static void destroy_options(void* address) { cleft_options_destroy((cleft_options*)address); }
static void destroy_volume(void* address) { cleft_volume_destroy((cleft_volume*)address); }
static void destroy_sizing(void* address) { cleft_sizing_destroy((cleft_sizing*)address); }
static void destroy_mesh(void* address) { cleft_mesh_destroy((cleft_mesh*)address); }
static void destroy_surface(void* address) { cleft_surface_destroy((cleft_surface*)address); }
static void destroy_report(void* address) { cleft_report_destroy((cleft_report*)address); }
%}
#else
CLEFT_CSHARP_TYPES(global::System.IntPtr, $csinput, void* array)
#endif
