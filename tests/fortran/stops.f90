! What is written to the standard error: warnings until one listens, and the failure that stops a program without
! `stat`.
program stops
  use cleft
  use checks
  implicit none
  type(cleft_context) :: context
  type(cleft_options) :: options
  type(cleft_volume) :: volume
  type(cleft_mesh) :: mesh

  call options%set('background', 'lattice')
  call options%set('tets', 1)  ! which cannot be met, and is warned of
  call volume%create(context, two_balls())
  call mesh%create(context, volume, options)
  call context%set_log()
  call mesh%create(context, volume, options)
  call options%set('gradation', 7d0)
  print '(a)', 'went on'
end program
