// How the kinds of kinds.i pass from and to Java. Handles are longs; arrays are Java arrays of numbers, or direct buffers.
// Nothing of this is public: the classes on top are.

%pragma(java) moduleclassmodifiers="final class"
%pragma(java) jniclassclassmodifiers="final class"
%typemap(javaclassmodifiers) SWIGTYPE "final class"
%typemap(javafinalize) SWIGTYPE ""  // the classes on top close what they make
// Constants become `static final` numbers of Java and need no call to load them.
%javaconst(1);
// SWIG takes int64_t for `long` of C, which it maps to `int` of Java: the upper half would be lost.
%apply long long { int64_t };

%{
#include <stdint.h>

static void cleft_throw_no_memory(JNIEnv* env)
{
    (*env)->ThrowNew(env, (*env)->FindClass(env, "java/lang/OutOfMemoryError"), "there is not enough native memory");
}
// An exception of Java waits until the native function returns, so each way that throws returns at
// once.
#define CLEFT_NO_MEMORY          \
    cleft_throw_no_memory(jenv); \
    return 0;

// An array that Java gave, while C works on it: the elements of a Java array, or the memory of a direct buffer.
typedef struct CleftArray {
    jobject object;
    void* data;
    char kind;  // of the elements, as in the Java virtual machine; 0 for a buffer
} CleftArray;

// Local references are given back here: a call with many arrays would otherwise use up the table of
// the virtual machine.
static int cleft_is(JNIEnv* env, jobject object, const char* name)
{
    const jclass wanted = (*env)->FindClass(env, name);
    const int is = wanted && (*env)->IsInstanceOf(env, object, wanted);
    (*env)->DeleteLocalRef(env, wanted);
    return is;
}

// data == NULL stands for null. 0 with an exception on failure.
static int cleft_array_open(JNIEnv* env, jobject object, CleftArray* array)
{
    array->object = object;
    array->data = NULL;
    array->kind = 0;
    if (!object)
        return 1;
    // NULL for a buffer on Java's heap, which has no fixed address. It is refused below.
    if (cleft_is(env, object, "java/nio/Buffer"))
        array->data = (*env)->GetDirectBufferAddress(env, object);
// GetArrayElements may copy. GetPrimitiveArrayCritical would not, but the library may run for hours
// and call back into Java, which a critical region forbids.
#define CLEFT_ELEMENTS(KIND, Type)                                                    \
    else if (cleft_is(env, object, "[" #KIND))                                        \
    {                                                                                 \
        array->kind = #KIND[0];                                                       \
        array->data = (*env)->Get##Type##ArrayElements(env, (jarray)object, NULL);    \
    }
    CLEFT_ELEMENTS(B, Byte)
    CLEFT_ELEMENTS(S, Short)
    CLEFT_ELEMENTS(I, Int)
    CLEFT_ELEMENTS(J, Long)
    CLEFT_ELEMENTS(F, Float)
    CLEFT_ELEMENTS(D, Double)
#undef CLEFT_ELEMENTS
    if (!array->data && !(*env)->ExceptionCheck(env))
        (*env)->ThrowNew(env, (*env)->FindClass(env, "java/lang/IllegalArgumentException"),
                         "neither an array of numbers nor a direct buffer");
    return array->data != NULL;
}

// mode: 0 to copy what was written back, JNI_ABORT not to.
static void cleft_array_close(JNIEnv* env, CleftArray* array, jint mode)
{
    switch (array->kind) {
    case 'B': (*env)->ReleaseByteArrayElements(env, (jarray)array->object, (jbyte*)array->data, mode); break;
    case 'S': (*env)->ReleaseShortArrayElements(env, (jarray)array->object, (jshort*)array->data, mode); break;
    case 'I': (*env)->ReleaseIntArrayElements(env, (jarray)array->object, (jint*)array->data, mode); break;
    case 'J': (*env)->ReleaseLongArrayElements(env, (jarray)array->object, (jlong*)array->data, mode); break;
    case 'F': (*env)->ReleaseFloatArrayElements(env, (jarray)array->object, (jfloat*)array->data, mode); break;
    case 'D': (*env)->ReleaseDoubleArrayElements(env, (jarray)array->object, (jdouble*)array->data, mode); break;
    default: break;
    }
    array->kind = 0;
}

// The bytes of a text, UTF-8 as the library has it: JNI's own strings have another encoding.
// NewStringUTF() takes modified UTF-8, in which signs beyond 16 bits and zeros are written in
// another way. Text.java decodes the bytes.
static jbyteArray cleft_java_text(JNIEnv* env, const char* text)
{
    const jsize size = (jsize)strlen(text);
    const jbyteArray bytes = (*env)->NewByteArray(env, size);
    if (bytes)
        (*env)->SetByteArrayRegion(env, bytes, 0, size, (const jbyte*)text);
    return bytes;
}
%}

// CLEFT_JAVA_TYPES(KIND OF PARAMETER, TYPE IN JNI, TYPE IN JAVA)
%define CLEFT_JAVA_TYPES(jni_type, java_type, kinds...)
%typemap(jni) kinds #jni_type
%typemap(jtype) kinds #java_type
%typemap(jstype) kinds #java_type
%typemap(javain) kinds "$javainput"
%enddef

CLEFT_JAVA_TYPES(jlong, long, void* HANDLE)
%typemap(in) void* HANDLE "$1 = ($1_ltype)(intptr_t)$input;"
%typemap(freearg) void* HANDLE ""

CLEFT_JAVA_TYPES(jlongArray, long[], void** OUT_HANDLE)
%typemap(in) void** OUT_HANDLE (void* made = NULL) "$1 = ($1_ltype)&made;"
%typemap(argout) void** OUT_HANDLE
{
    const jlong address = (jlong)(intptr_t)made$argnum;
    (*jenv)->SetLongArrayRegion(jenv, $input, 0, 1, &address);
}
%typemap(freearg) void** OUT_HANDLE ""

%define CLEFT_JAVA_ARRAY(mode, pattern)
CLEFT_JAVA_TYPES(jobject, Object, pattern)
%typemap(in) pattern (CleftArray array = {0})
{
    if (!cleft_array_open(jenv, $input, &array))
        return $null;
    $1 = ($1_ltype)array.data;
}
%typemap(argout) pattern ""
%typemap(freearg) pattern { cleft_array_close(jenv, &array$argnum, mode); }
%enddef
// JNI_ABORT: what the library only reads need not be copied back.
CLEFT_JAVA_ARRAY(JNI_ABORT, const void* ARRAY_IN)
CLEFT_JAVA_ARRAY(JNI_ABORT, const int64_t* ARRAY_IN)
CLEFT_JAVA_ARRAY(JNI_ABORT, const int32_t* ARRAY_IN)
CLEFT_JAVA_ARRAY(JNI_ABORT, const double* ARRAY_IN)
CLEFT_JAVA_ARRAY(JNI_ABORT, const char* PATH)
// 0: the numbers that the library wrote are copied back, and the copy is freed.
CLEFT_JAVA_ARRAY(0, int32_t* ARRAY_OUT)
CLEFT_JAVA_ARRAY(0, int64_t* ARRAY_OUT)
CLEFT_JAVA_ARRAY(0, double* ARRAY_OUT)
CLEFT_JAVA_ARRAY(0, float* ARRAY_OUT)

%typemap(jni) (const void* const* FIELDS, int64_t COUNT) "jobjectArray"
%typemap(jtype) (const void* const* FIELDS, int64_t COUNT) "Object[]"
%typemap(jstype) (const void* const* FIELDS, int64_t COUNT) "Object[]"
%typemap(javain) (const void* const* FIELDS, int64_t COUNT) "$javainput"
%typemap(in) (const void* const* FIELDS, int64_t COUNT) (CleftArray* arrays = NULL, const void** pointers = NULL)
{
    const jsize count = (*jenv)->GetArrayLength(jenv, $input);
    arrays = (CleftArray*)calloc((size_t)count + 1, sizeof *arrays);
    pointers = (const void**)calloc((size_t)count + 1, sizeof *pointers);
    int opened = arrays && pointers;
    if (!opened)
        cleft_throw_no_memory(jenv);
    for (jsize i = 0; opened && i < count; ++i) {
        opened = cleft_array_open(jenv, (*jenv)->GetObjectArrayElement(jenv, $input, i), &arrays[i]);
        pointers[i] = arrays[i].data;
    }
    $1 = ($1_ltype)pointers;
    $2 = opened ? (int64_t)count : 0;  // without any the call fails, and the exception of the array comes out
}
%typemap(freearg) (const void* const* FIELDS, int64_t COUNT)
{
    for (jsize i = 0; arrays$argnum && i < (*jenv)->GetArrayLength(jenv, $input); ++i)
        cleft_array_close(jenv, &arrays$argnum[i], JNI_ABORT);
    free(arrays$argnum);
    free((void*)pointers$argnum);
}

%typemap(jni) (const char* const* PATHS, int64_t COUNT) "jbyteArray"
%typemap(jtype) (const char* const* PATHS, int64_t COUNT) "byte[]"
%typemap(jstype) (const char* const* PATHS, int64_t COUNT) "byte[]"
%typemap(javain) (const char* const* PATHS, int64_t COUNT) "$javainput"
%typemap(in) (const char* const* PATHS, int64_t COUNT) (CleftArray bytes = {0}, const char** texts = NULL)
{
    const size_t size = (size_t)(*jenv)->GetArrayLength(jenv, $input);
    if (!cleft_array_open(jenv, $input, &bytes))
        return $null;
    texts = (const char**)calloc(size + 1, sizeof *texts);
    $1 = ($1_ltype)texts;
    $2 = texts ? cleft_split_texts((const char*)bytes.data, size, texts) : 0;  // 0: the call fails, the exception comes out
    if (!texts)
        cleft_throw_no_memory(jenv);
}
%typemap(freearg) (const char* const* PATHS, int64_t COUNT)
{
    cleft_array_close(jenv, &bytes$argnum, JNI_ABORT);
    free((void*)texts$argnum);
}

CLEFT_JAVA_TYPES(jobjectArray, byte[][], const char** OUT_NAME)
%typemap(in) const char** OUT_NAME (char* name = NULL) "$1 = ($1_ltype)&name;"
%typemap(argout) const char** OUT_NAME
{
    if (name$argnum)
        (*jenv)->SetObjectArrayElement(jenv, $input, 0, cleft_java_text(jenv, name$argnum));
}
%typemap(freearg) const char** OUT_NAME ""

// Texts are bytes on their way, strings in Java: Text.java.
%typemap(jni) const char* "jbyteArray"
%typemap(jtype) const char* "byte[]"
%typemap(jstype) const char* "String"
%typemap(out) const char* "$result = $1 ? cleft_java_text(jenv, $1) : NULL;"
%typemap(javaout) const char* { return Text.of($jnicall); }
%typemap(javain) const char* "Text.bytes(\"$javainput\", $javainput)"
%typemap(in) const char* (CleftArray bytes = {0})
{
    if (!cleft_array_open(jenv, $input, &bytes))
        return $null;
    $1 = (char*)bytes.data;
}
%typemap(freearg) const char* { cleft_array_close(jenv, &bytes$argnum, JNI_ABORT); }

CLEFT_JAVA_TYPES(jlong, long, const void* ADDRESS)
%typemap(out) const void* ADDRESS "$result = (jlong)(intptr_t)$1;"
%typemap(javaout) const void* ADDRESS { return $jnicall; }

#ifndef CLEFT_IO_MODULE
%{
// The functions of the user wait in the class Callbacks, by the thread: the library calls on the thread that called it.
static JavaVM* cleft_vm;
// Looked up once, when the module is loaded: FindClass() in a callback might see another class
// loader.
static jclass cleft_callbacks;
static jmethodID cleft_callback_progress, cleft_callback_log;

JNIEXPORT jint JNICALL JNI_OnLoad(JavaVM* vm, void* reserved)
{
    (void)reserved;
    JNIEnv* env = NULL;
    cleft_vm = vm;
    if ((*vm)->GetEnv(vm, (void**)&env, JNI_VERSION_1_8) != JNI_OK)
        return JNI_ERR;
    const jclass local = (*env)->FindClass(env, "org/cleft/Callbacks");
    if (!local)
        return JNI_ERR;
    // A local reference ends with this call.
    cleft_callbacks = (jclass)(*env)->NewGlobalRef(env, local);
    cleft_callback_progress = (*env)->GetStaticMethodID(env, local, "progress", "(D[B)Z");
    cleft_callback_log = (*env)->GetStaticMethodID(env, local, "log", "(I[B)V");
    return cleft_callback_progress && cleft_callback_log ? JNI_VERSION_1_8 : JNI_ERR;
}

// The environment of this thread, ready for calls; NULL while an exception waits.
static JNIEnv* cleft_environment(void)
{
    JNIEnv* env = NULL;
    if ((*cleft_vm)->GetEnv(cleft_vm, (void**)&env, JNI_VERSION_1_8) != JNI_OK || (*env)->ExceptionCheck(env))
        return NULL;
    return env;
}

// 1 cancels. It is also the answer where the virtual machine cannot be asked or an exception waits,
// so that the call ends and the exception comes out.
static int cleft_java_progress(double fraction, const char* stage, void* user)
{
    (void)user;
    JNIEnv* env = cleft_environment();
    const jbyteArray words = env ? cleft_java_text(env, stage) : NULL;
    if (!words)
        return 1;
    const jboolean cancel =
        (*env)->CallStaticBooleanMethod(env, cleft_callbacks, cleft_callback_progress, fraction, words);
    if ((*env)->ExceptionCheck(env))
        return 1;
    (*env)->DeleteLocalRef(env, words);
    return cancel;
}

static void cleft_java_log(int32_t level, const char* sentence, void* user)
{
    (void)user;
    JNIEnv* env = cleft_environment();
    const jbyteArray words = env ? cleft_java_text(env, sentence) : NULL;
    if (!words)
        return;
    (*env)->CallStaticVoidMethod(env, cleft_callbacks, cleft_callback_log, (jint)level, words);
    if (!(*env)->ExceptionCheck(env))
        (*env)->DeleteLocalRef(env, words);
}
%}

%define CLEFT_JAVA_CALLBACK(type, function)
%typemap(jni) (type callback, void* user) "jboolean"
%typemap(jtype) (type callback, void* user) "boolean"
%typemap(jstype) (type callback, void* user) "boolean"
%typemap(javain) (type callback, void* user) "$javainput"
%typemap(in) (type callback, void* user)
{
    $1 = $input ? function : NULL;
    $2 = NULL;
}
%enddef
CLEFT_JAVA_CALLBACK(cleft_progress_callback, cleft_java_progress)
CLEFT_JAVA_CALLBACK(cleft_log_callback, cleft_java_log)

// A buffer over memory of the library, for the class that keeps its owner alive.
%typemap(jni) CleftMemory "jobject"
%typemap(jtype) CleftMemory "java.nio.ByteBuffer"
%typemap(jstype) CleftMemory "java.nio.ByteBuffer"
%typemap(javaout) CleftMemory { return $jnicall; }
%typemap(out) CleftMemory "$result = (*jenv)->NewDirectByteBuffer(jenv, $1.address, $1.bytes);"
%{
typedef struct CleftMemory {
    void* address;
    jlong bytes;
} CleftMemory;

// The buffer knows nothing of the memory's owner. The class that asked for it keeps both.
static CleftMemory memory_at(int64_t address, int64_t bytes)
{
    const CleftMemory memory = {(void*)(intptr_t)address, bytes};
    return memory;
}
%}
CleftMemory memory_at(int64_t address, int64_t bytes);
#endif
