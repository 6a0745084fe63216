! The Fortran module of hardsphere: the C interface of include/hardsphere.h, name for name.
!
! EVERY ID IN THIS MODULE IS 0-BASED, AS IN C: OF BALLS, VERTICES, ARCS, CIRCLES, FACES, SHELLS, COMPONENTS, EDGES,
! QUARTER-EDGES, SIMPLE FACES, CELLS, PIECES AND LOOPS.
! THE FORTRAN ARRAY ELEMENT OF ID i IS THEREFORE i + 1; hsp_index(i) COMPUTES THAT.
!
! What each function does, its statuses and its costs are documented in hardsphere.h; nothing of that changes here. A
! row with a name, such as `---- model.h`, begins what include/hardsphere/model.h declares.
! How C maps to Fortran:
!   double xyz[n][3]             real(c_double) :: xyz(3, n)
!   uint32_t onext[edges][4]     integer(c_int32_t) :: onext(0:3, 0:edges - 1), and indices are ids
!   uint32_t                     integer(c_int32_t); values above huge() appear negative: HSP_NONE is -1
!   uint8_t selected[n]          integer(c_int8_t) :: selected(n), 0 or not 0
!   hsp_model *, other handles   type(c_ptr); where NULL is allowed, c_null_ptr
!   void *memory                 type(c_ptr) from c_loc of an array with the TARGET attribute; the handle lives in it,
!                                so the array must outlive the handle and must not be reallocated
!   T *out, uint32_t capacity    out(*) with capacity elements; other extents stand behind the declarations
!   a pointer that may be NULL   an optional argument that is left out
!   const char *title            character(kind=c_char) :: title(*); a string that ends with c_null_char may be passed
!   hsp_sink                     type(c_funptr) from c_funloc of a function with the interface hsp_sink
!   void *context                type(c_ptr), as it will be handed to the sink; c_null_ptr if the sink has no use for it
module hardsphere
  use, intrinsic :: iso_c_binding, only: c_char, c_double, c_f_pointer, c_funptr, c_int8_t, c_int32_t, c_int64_t, &
                                         c_null_char, c_ptr, c_size_t
  implicit none
  private :: quad_turned
  private :: c_char, c_double, c_f_pointer, c_funptr, c_int8_t, c_int32_t, c_int64_t, c_null_char, c_ptr, c_size_t

  ! <constants>

  ! <types>

  abstract interface
    function hsp_sink(context, bytes, count) result(stop) bind(C)
      import :: c_char, c_int32_t, c_ptr, c_size_t
      type(c_ptr), value :: context
      integer(c_size_t), value :: count
      character(kind=c_char), intent(in) :: bytes(count)
      integer(c_int32_t) :: stop
    end function
  end interface

  interface

    ! <functions>

  end interface

contains

  !> The element of a Fortran array (lower bound 1) that belongs to a 0-based id.
  elemental function hsp_index(id) result(index)
    integer(c_int32_t), intent(in) :: id
    integer(c_int32_t) :: index
    index = id + 1_c_int32_t
  end function

  ! ---- status.h

  !> hsp_status_text as a Fortran string.
  function hsp_status_message(status) result(message)
    integer(c_int32_t), intent(in) :: status
    character(len=:), allocatable :: message
    integer, parameter :: longest = 256
    character(kind=c_char), pointer :: text(:)
    integer :: i
    call c_f_pointer(hsp_status_text(status), text, [longest])
    message = ''
    do i = 1, longest
      if (text(i) == c_null_char) exit
      message = message//text(i)
    end do
  end function

  ! ---- topology.h

  !> HSP_QUAD_ROT of the header: from the right face to the left one. HSP_NONE yields HSP_NONE, here and below.
  elemental function hsp_quad_rot(q) result(turned)
    integer(c_int32_t), intent(in) :: q
    integer(c_int32_t) :: turned
    turned = quad_turned(q, 1_c_int32_t)
  end function

  !> HSP_QUAD_INVERSE_ROT of the header: from the left face to the right one.
  elemental function hsp_quad_inverse_rot(q) result(turned)
    integer(c_int32_t), intent(in) :: q
    integer(c_int32_t) :: turned
    turned = quad_turned(q, 3_c_int32_t)
  end function

  !> HSP_QUAD_SYM of the header: the same edge the other way.
  elemental function hsp_quad_sym(q) result(turned)
    integer(c_int32_t), intent(in) :: q
    integer(c_int32_t) :: turned
    turned = quad_turned(q, 2_c_int32_t)
  end function

  elemental function quad_turned(q, quarters) result(turned)
    integer(c_int32_t), intent(in) :: q, quarters
    integer(c_int32_t) :: turned
    turned = HSP_NONE
    if (q /= HSP_NONE) turned = ior(iand(q, not(3_c_int32_t)), iand(iand(q, 3_c_int32_t) + quarters, 3_c_int32_t))
  end function

  !> HSP_TOPOLOGY_OPREV of the header: the next edge clockwise about the origin of q.
  function hsp_topology_oprev(topology, q) result(found)
    type(c_ptr), intent(in) :: topology
    integer(c_int32_t), intent(in) :: q
    integer(c_int32_t) :: found
    found = hsp_topology_lnext(topology, hsp_quad_sym(q))
  end function

  !> HSP_TOPOLOGY_LPREV of the header: the previous edge about the left face of q.
  function hsp_topology_lprev(topology, q) result(found)
    type(c_ptr), intent(in) :: topology
    integer(c_int32_t), intent(in) :: q
    integer(c_int32_t) :: found
    found = hsp_quad_sym(hsp_topology_onext(topology, q))
  end function

  ! ---- surface.h

  !> HSP_SURFACE_TWIN of the header: the directed edge h the other way.
  elemental function hsp_surface_twin(h) result(turned)
    integer(c_int32_t), intent(in) :: h
    integer(c_int32_t) :: turned
    turned = HSP_NONE
    if (h /= HSP_NONE) turned = ieor(h, 1_c_int32_t)
  end function

  ! ---- map.h

  !> HSP_MAP_TWIN of the header: the directed edge h the other way.
  elemental function hsp_map_twin(h) result(turned)
    integer(c_int32_t), intent(in) :: h
    integer(c_int32_t) :: turned
    turned = HSP_NONE
    if (h /= HSP_NONE) turned = ieor(h, 1_c_int32_t)
  end function

  ! ---- sticks.h

  !> HSP_STICKS_HALF of the header: the number of a half of a stick in a map of so many balls; all 0-based.
  elemental function hsp_sticks_half(balls, stick, half) result(number)
    integer(c_int32_t), intent(in) :: balls, stick, half
    integer(c_int32_t) :: number
    number = balls + 2_c_int32_t*stick + half
  end function

  ! <bounds>

end module hardsphere
