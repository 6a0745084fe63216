! Surface areas in the shape in which codes of quantum chemistry call their quadrature of them: compute_numsa of xtb,
! getSASA of DFTB+, get_surface of numsa. xyz and radii, the probe's in them, are in bohr, areas in square bohr.
!
! These areas are exact, those of the quadratures are smoothed over a few tenths of an angstrom around each sphere, and
! surface tensions were fitted with them: an exact area is another model with, at least, other tensions. Theirs have
! derivatives where spheres touch, exact areas have one-sided ones there.
module exact_sasa
  use hardsphere_workspace
  implicit none
  private
  public :: compute_exact_sasa, add_exact_gradients
contains

  ! Area of each atom and, if asked for, its derivatives: dsdr(:, j, i) = d sasa(i) / d xyz(:, j).
  subroutine compute_exact_sasa(work, nat, xyz, vdwsa, sasa, status, dsdr)
    type(hsp_workspace), intent(inout), target :: work ! kept from step to step
    integer, intent(in) :: nat
    real(c_double), intent(in) :: xyz(3, nat), vdwsa(nat)
    real(c_double), intent(out), target :: sasa(nat)
    integer(c_int32_t), intent(out) :: status
    real(c_double), intent(out), optional :: dsdr(3, nat, nat)
    type(hsp_measure_outputs) :: outputs
    type(hsp_area_derivative), allocatable :: row(:)
    integer(c_int32_t) :: entries, i
    integer :: k
    sasa = 0
    if (present(dsdr)) dsdr = 0
    status = work%set(int(nat, c_int32_t), xyz, vdwsa)
    if (status == HSP_OK) status = work%compute_boundary()
    outputs%capacity = int(nat, c_int32_t)
    outputs%reserved = 0
    outputs%totals = c_null_ptr
    outputs%area = c_loc(sasa)
    outputs%volume_term = c_null_ptr
    if (status == HSP_OK) status = hsp_boundary_get_measures(work%boundary, outputs=outputs)
    if (status /= HSP_OK .or. .not. present(dsdr)) return
    allocate (row(64))
    do i = 0, int(nat, c_int32_t) - 1
      status = hsp_boundary_get_area_row(work%boundary, i, HSP_TANGENT_OVERLAP, row, int(size(row), c_int32_t), entries)
      if (status == HSP_E_CAPACITY) then
        deallocate (row)
        allocate (row(2*entries))
        status = hsp_boundary_get_area_row(work%boundary, i, HSP_TANGENT_OVERLAP, row, int(size(row), c_int32_t), entries)
      end if
      if (status /= HSP_OK) return
      do k = 1, entries
        dsdr(:, row(k)%ball + 1, i + 1) = row(k)%centre
      end do
    end do
  end subroutine

  ! Those codes make this of dsdr: gradients += sum over i of tension(i) d sasa(i) / d xyz, in memory for 3 nat numbers
  ! instead of 3 nat^2, and in the time of the areas. After compute_exact_sasa.
  subroutine add_exact_gradients(work, nat, tension, gradients, status)
    type(hsp_workspace), intent(inout), target :: work
    integer, intent(in) :: nat
    real(c_double), intent(in), target :: tension(nat)
    real(c_double), intent(inout) :: gradients(3, nat)
    integer(c_int32_t), intent(out) :: status
    type(hsp_gradient_request) :: request
    type(hsp_gradient_outputs) :: outputs
    real(c_double), target :: own(3, nat)
    status = hsp_gradient_request_init(request, request%struct_size)
    request%tension = 1
    request%sigma = c_loc(tension)
    outputs%capacity = int(nat, c_int32_t)
    outputs%energy = c_null_ptr
    outputs%d_centre = c_loc(own)
    outputs%d_radius = c_null_ptr
    outputs%flags = c_null_ptr
    if (status == HSP_OK) status = hsp_boundary_get_gradient(work%boundary, request, outputs)
    if (status == HSP_OK) gradients = gradients + own
  end subroutine
end module
