// The low level of the Java, C# and Python bindings: cleft.h, function by function, under the names of C.
// The classes that a programmer meets are written by hand on top, in bindings/LANGUAGE.
#if defined(SWIGPYTHON)
%module(package="cleft") native
#else
%module CleftNative
#endif

%{
#include "cleft/cleft.h"

#include <stdlib.h>
#include <string.h>
%}

%include "kinds.i"

%immutable;  // what the library answers is not changed
CLEFT_STRUCT(cleft_option_description, NativeOptionDescription)
CLEFT_STRUCT(cleft_quality, NativeQuality)
CLEFT_STRUCT(cleft_validation, NativeValidation)
CLEFT_STRUCT(cleft_label_report, NativeLabelReport)
CLEFT_STRUCT(cleft_contact, NativeContact)
CLEFT_STRUCT(cleft_estimate, NativeEstimate)
%ignore cleft_quality::dihedral_histogram;
%extend cleft_quality {
    int64_t histogram_bin(int32_t bin) { return $self->dihedral_histogram[bin]; }
}

%include "cleft/cleft_status.h"
%include "cleft/cleft.h"
