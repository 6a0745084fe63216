! Checks of the Fortran tests: conditions and statuses are counted, those that do not hold are printed.
module fortran_checks
  use, intrinsic :: iso_c_binding, only: c_double, c_int32_t
  use hardsphere, only: hsp_status_message
  implicit none
  private
  public :: check, expect, near, report_checks

  integer :: checks = 0, failures = 0

contains

  subroutine check(holds, what)
    logical, intent(in) :: holds
    character(len=*), intent(in) :: what
    checks = checks + 1
    if (holds) return
    failures = failures + 1
    print '(a, a)', 'failed: ', what
  end subroutine

  subroutine expect(status, expected, what)
    integer(c_int32_t), intent(in) :: status, expected
    character(len=*), intent(in) :: what
    call check(status == expected, what//': '//hsp_status_message(status)//', expected '//hsp_status_message(expected))
  end subroutine

  logical function near(a, b)
    real(c_double), intent(in) :: a, b
    near = abs(a - b) <= 1e-12_c_double*max(1.0_c_double, abs(b))
  end function

  ! The last call of a test: it fails if anything did not hold, or nothing was checked.
  subroutine report_checks()
    print '(i0, a, i0, a)', checks, ' checks, ', failures, ' failed'
    if (failures > 0 .or. checks == 0) stop 1
  end subroutine
end module fortran_checks
