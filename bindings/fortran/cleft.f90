! Cleft from Fortran: conforming multi-material tetrahedral meshes from labelled volumes.
!
!   call volume%create(context, voxels, spacing=[1d0, 1d0, 1.5d0])
!   call mesh%create(context, volume, options)
!   points = mesh%points();  tets = mesh%tets();  labels = mesh%tet_labels()
!
! Points are numbered from 1. Procedures that can fail take the optional arguments `stat` (0, or a CLEFT_ERROR_...) and
! `errmsg`; without `stat`, a failure stops the program with its sentence. include/cleft/cleft.h says what the figures
! and options mean; docs/fortran.md leads through.
module cleft
  use cleft_c, only: &
    cleft_quality, cleft_metric_quality, cleft_validation, cleft_label_report, cleft_contact, cleft_distance, &
    cleft_estimate
  ! <numbers> made by tools/generate.py from include/cleft/cleft.h
  use cleft_c, only: CLEFT_OK, CLEFT_ERROR_INTERNAL, CLEFT_ERROR_OUT_OF_MEMORY, CLEFT_ERROR_CANCELLED, &
    CLEFT_ERROR_NULL, CLEFT_ERROR_ARGUMENT, CLEFT_ERROR_NOT_FINITE, CLEFT_ERROR_TOO_LARGE, CLEFT_ERROR_BUFFER, &
    CLEFT_ERROR_OPTION, CLEFT_ERROR_UNSUPPORTED, CLEFT_ERROR_INVALID_MESH, CLEFT_ERROR_LABEL_LOST, CLEFT_ERROR_FILE, &
    CLEFT_ERROR_FORMAT, CLEFT_ERROR_HANDLE, CLEFT_ERROR_BUSY, CLEFT_ERROR_EXCHANGE, CLEFT_LOG_WARNING, CLEFT_LOG_INFO, &
    CLEFT_LOG_DEBUG, CLEFT_SIDE_X_MIN, CLEFT_SIDE_X_MAX, CLEFT_SIDE_Y_MIN, CLEFT_SIDE_Y_MAX, CLEFT_SIDE_Z_MIN, &
    CLEFT_SIDE_Z_MAX, CLEFT_SIDE_OTHER
  ! </numbers>
  use cleft_support, only: cleft_library_version, cleft_can_make_particles
  use cleft_contexts
  use cleft_option_sets
  use cleft_volumes, only: cleft_volume
  use cleft_sizings
  use cleft_meshes
  use cleft_surfaces
  use cleft_reports
  implicit none
  public
end module
