// How the kinds of kinds.i pass from and to Python. Handles are objects with an attribute `address`; arrays are whatever
// offers a contiguous buffer. The interpreter's lock is let go around the calls that may take long.

%nothread;
// Only these let go of the lock. For short calls it would cost more than the call, and handles are
// not safe to be read while another thread destroys them.
%thread cleft_volume_create_labels;
%thread cleft_volume_create_indicators;
%thread cleft_volume_sample;
%thread cleft_sizing_create;
%thread cleft_sizing_create_values;
%thread cleft_sizing_create_metric;
%thread cleft_background_create;
%thread cleft_mesh_create;
%thread cleft_mesh_cleave;
%thread cleft_mesh_improve;
%thread cleft_mesh_strip;
%thread cleft_mesh_estimate;
%thread cleft_mesh_volume;
%thread cleft_mesh_copy_quadratic;
%thread cleft_mesh_quality;
%thread cleft_mesh_metric_quality;
%thread cleft_mesh_validate;
%thread cleft_surface_create;
%thread cleft_report_create;
%thread cleft_report_create_with_distances;
%thread cleft_io_read_volume;
%thread cleft_io_read_raw;
%thread cleft_io_write_sizing;
%thread cleft_io_read_field;
%thread cleft_io_read_sizing;
%thread cleft_io_read_metric;
%thread cleft_io_write_mesh;
%thread cleft_io_read_mesh;
%thread cleft_io_read_volume_names;
%thread cleft_io_read_mesh_names;
%thread cleft_io_write_picture;
%thread cleft_write_view_of;

%{
#define CLEFT_NO_MEMORY \
    PyErr_NoMemory();   \
    SWIG_fail;

// The address of a Handle, which lives as long as the call since the caller's arguments hold it. 0 on failure.
static int cleft_handle_address(PyObject* handle, void** address)
{
    *address = NULL;
    if (handle == Py_None)
        return 1;
    PyObject* number = PyObject_GetAttrString(handle, "address");
    if (!number)
        return 0;
    // NULL is also a valid answer, so an error is looked for by PyErr_Occurred().
    *address = PyLong_AsVoidPtr(number);
    Py_DECREF(number);
    return !PyErr_Occurred();
}

// A buffer with data == NULL stands for None. 0 on failure.
// The buffer is held until PyBuffer_Release(): meanwhile NumPy refuses to resize the array.
static int cleft_buffer_open(PyObject* array, Py_buffer* buffer, int flags)
{
    memset(buffer, 0, sizeof *buffer);
    return array == Py_None || PyObject_GetBuffer(array, buffer, flags) == 0;
}
%}

%typemap(in) void* HANDLE
{
    void* address;
    if (!cleft_handle_address($input, &address))
        SWIG_fail;
    $1 = ($1_ltype)address;
}
%typemap(in, numinputs=0) void** OUT_HANDLE (void* made = NULL) "$1 = ($1_ltype)&made;"
// A handle that is not passed on, for an exception came, is destroyed by the typemaps `freearg` in kinds.i.
%typemap(argout) void** OUT_HANDLE
{
    $result = SWIG_Python_AppendOutput($result, PyLong_FromVoidPtr(made$argnum));
    made$argnum = NULL;
}

// Texts are UTF-8, which the text itself keeps. SWIG would copy them, and writes through NULL where there is no memory.
%typemap(in) const char*
{
    if ($input != Py_None) {
        $1 = (char*)PyUnicode_AsUTF8($input);
        if (!$1)
            SWIG_fail;
    }
}
%typemap(freearg) const char* ""

%typemap(in) const void* ARRAY_IN (Py_buffer buffer = {0}), const int64_t* ARRAY_IN (Py_buffer buffer = {0}),
             const int32_t* ARRAY_IN (Py_buffer buffer = {0}), const double* ARRAY_IN (Py_buffer buffer = {0}),
             const char* PATH (Py_buffer buffer = {0})
{
    if (!cleft_buffer_open($input, &buffer, PyBUF_C_CONTIGUOUS))
        SWIG_fail;
    $1 = ($1_ltype)buffer.buf;
}
%typemap(in) int32_t* ARRAY_OUT (Py_buffer buffer = {0}), int64_t* ARRAY_OUT (Py_buffer buffer = {0}),
             double* ARRAY_OUT (Py_buffer buffer = {0}), float* ARRAY_OUT (Py_buffer buffer = {0})
{
    if (!cleft_buffer_open($input, &buffer, PyBUF_C_CONTIGUOUS | PyBUF_WRITABLE))
        SWIG_fail;
    $1 = ($1_ltype)buffer.buf;
}
%typemap(freearg) const void* ARRAY_IN, const int64_t* ARRAY_IN, const int32_t* ARRAY_IN, const double* ARRAY_IN,
                  const char* PATH, int32_t* ARRAY_OUT, int64_t* ARRAY_OUT, double* ARRAY_OUT, float* ARRAY_OUT
    "PyBuffer_Release(&buffer$argnum);"

// An array of addresses, and their number.
%typemap(in) (const void* const* FIELDS, int64_t COUNT) (Py_buffer buffer = {0})
{
    if (!cleft_buffer_open($input, &buffer, PyBUF_C_CONTIGUOUS))
        SWIG_fail;
    $1 = ($1_ltype)buffer.buf;
    $2 = (int64_t)(buffer.len / (Py_ssize_t)sizeof(void*));
}
%typemap(freearg) (const void* const* FIELDS, int64_t COUNT) "PyBuffer_Release(&buffer$argnum);"

%typemap(in) (const char* const* PATHS, int64_t COUNT) (Py_buffer buffer = {0}, const char** texts = NULL)
{
    if (!cleft_buffer_open($input, &buffer, PyBUF_C_CONTIGUOUS))
        SWIG_fail;
    texts = (const char**)calloc((size_t)buffer.len + 1, sizeof *texts);
    if (!texts) {
        PyErr_NoMemory();
        SWIG_fail;
    }
    $1 = ($1_ltype)texts;
    $2 = cleft_split_texts((const char*)buffer.buf, (size_t)buffer.len, texts);
}
%typemap(freearg) (const char* const* PATHS, int64_t COUNT)
{
    PyBuffer_Release(&buffer$argnum);
    free((void*)texts$argnum);
}

%typemap(in, numinputs=0) const char** OUT_NAME (char* name = NULL) "$1 = ($1_ltype)&name;"
%typemap(argout) const char** OUT_NAME
{
    $result = SWIG_Python_AppendOutput($result, PyUnicode_FromString(name$argnum ? name$argnum : ""));
}

%typemap(out) const void* ADDRESS "$result = PyLong_FromVoidPtr((void*)$1);"

// An exception that a callback left (or Ctrl-C) goes before the status.
%typemap(out) cleft_status
{
    if (PyErr_Occurred())
        SWIG_fail;
    $result = PyLong_FromLong($1);
}

#ifndef CLEFT_IO_MODULE
%{
// `user` is a function of (fraction, stage) or None. The library calls on the thread that called it, whose state is
// taken back for the while. Ctrl-C is looked for here, so that it stops a call even where there is no function.
static int cleft_python_progress(double fraction, const char* stage, void* user)
{
    const PyGILState_STATE state = PyGILState_Ensure();
    int cancel = PyErr_Occurred() || PyErr_CheckSignals() != 0;
    if (!cancel && user != (void*)Py_None) {
        PyObject* answer = PyObject_CallFunction((PyObject*)user, "ds", fraction, stage);
        cancel = !answer || (answer != Py_None && PyObject_IsTrue(answer) != 1);  // -1: its truth raised an exception
        Py_XDECREF(answer);
    }
    PyGILState_Release(state);
    return cancel;
}

// An exception that waits stays the first one: no Python code runs after it.
static void cleft_python_log(int32_t level, const char* sentence, void* user)
{
    const PyGILState_STATE state = PyGILState_Ensure();
    if (!PyErr_Occurred()) {
        PyObject* answer = PyObject_CallFunction((PyObject*)user, "is", (int)level, sentence);
        Py_XDECREF(answer);
    }
    PyGILState_Release(state);
}
%}

// The context borrows the function: the Mesher keeps it.
%typemap(in) (cleft_progress_callback callback, void* user)
{
    $1 = cleft_python_progress;
    $2 = (void*)$input;
}
%typemap(in) (cleft_log_callback callback, void* user)
{
    $1 = $input == Py_None ? NULL : cleft_python_log;
    $2 = (void*)$input;
}
#endif
