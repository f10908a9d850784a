! Without `stat`, a failure stops the program: the test looks for its sentence and its exit code.
program stops
  use cleft
  implicit none
  type(cleft_options) :: options
  call options%set('gradation', 7d0)
  print '(a)', 'went on'
end program
