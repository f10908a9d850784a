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
// Structs that the library fills in. Each language has records of its own, which the hand-written
// classes fill from these.
CLEFT_STRUCT(cleft_option_description, NativeOptionDescription)
CLEFT_STRUCT(cleft_quality, NativeQuality)
CLEFT_STRUCT(cleft_metric_quality, NativeMetricQuality)
CLEFT_STRUCT(cleft_validation, NativeValidation)
CLEFT_STRUCT(cleft_label_report, NativeLabelReport)
CLEFT_STRUCT(cleft_contact, NativeContact)
CLEFT_STRUCT(cleft_distance, NativeDistance)
CLEFT_STRUCT(cleft_estimate, NativeEstimate)
// SWIG would wrap the array as a bare pointer, of which no language knows the length. Single bins
// cost a call each, and there are 36.
%ignore cleft_quality::dihedral_histogram;
%extend cleft_quality {
    int64_t histogram_bin(int32_t bin) { return $self->dihedral_histogram[bin]; }
}
%ignore cleft_metric_quality::dihedral_histogram;
%extend cleft_metric_quality {
    int64_t histogram_bin(int32_t bin) { return $self->dihedral_histogram[bin]; }
}

// The headers themselves and no copy of their declarations: what is added to them is wrapped by the
// next build.
%include "cleft/cleft_status.h"
%include "cleft/cleft.h"
