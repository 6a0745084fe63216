! Loops of executors, and a way to stop, of the Fortran tests: each counts in its context, an integer(c_int32_t), but the
! one that does nothing.
module fortran_loops
  use, intrinsic :: iso_c_binding, only: c_f_pointer, c_f_procpointer, c_funptr, c_int32_t, c_ptr
  use hardsphere, only: hsp_task
  implicit none
contains
  function run_backwards(context, tasks, task, data) result(failed) bind(C)
    type(c_ptr), value :: context, data
    integer(c_int32_t), value :: tasks
    type(c_funptr), value :: task
    procedure(hsp_task), pointer :: one
    integer(c_int32_t), pointer :: runs
    integer(c_int32_t) :: failed, k
    call c_f_pointer(context, runs)
    call c_f_procpointer(task, one)
    do k = tasks - 1, 0, -1
      call one(data, k)
    end do
    runs = runs + 1
    failed = 0
  end function

  function run_nothing(context, tasks, task, data) result(failed) bind(C)
    type(c_ptr), value :: context, data
    integer(c_int32_t), value :: tasks
    type(c_funptr), value :: task
    integer(c_int32_t) :: failed
    failed = 0
  end function

  function stop_at_once(context) result(stops) bind(C)
    type(c_ptr), value :: context
    integer(c_int32_t), pointer :: asked
    integer(c_int32_t) :: stops
    call c_f_pointer(context, asked)
    asked = asked + 1
    stops = 1
  end function
end module fortran_loops
