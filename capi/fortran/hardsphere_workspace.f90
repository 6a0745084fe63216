! hardsphere with memory that grows: a type that owns a handle of each kind in allocatable memory.
!
!   use hardsphere_workspace
!   type(hsp_workspace), target :: work
!   status = work%set(n, xyz, radius)
!   if (status == HSP_OK) status = work%compute_boundary()
!   if (status == HSP_OK) status = hsp_boundary_measure(work%boundary, totals=totals, area=area, capacity=n)
!
! It may be used for any number of sets of balls, one after the other, and keeps the memory of the largest. Read results
! through its handles by the functions of the module hardsphere, which this one passes on. Handles move when they grow:
! take them from the workspace after each call. Declare it with TARGET, and do not assign it to another: the handles of a
! copy are those of the original. Memory is given back when the workspace goes out of scope.
!
! A row with a name, such as `---- model.h`, begins what is for that header. Where a component was left out of the
! library, what is for its headers is left out, too.
!
! STATUS: that of the function of the module hardsphere that fails, and HSP_E_MEMORY where an allocation fails.
module hardsphere_workspace
  use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_int32_t, c_int8_t, c_loc, c_null_ptr, c_ptr, c_size_t, &
    c_sizeof
  use hardsphere
  implicit none
  public ! with c_double and c_int32_t, which callers need

  type, private :: memory_block
    integer(c_int8_t), allocatable :: bytes(:)
  end type

  type :: hsp_workspace
    type(c_ptr) :: model = c_null_ptr
    type(c_ptr) :: boundary = c_null_ptr
    type(c_ptr) :: topology = c_null_ptr
    type(c_ptr) :: view = c_null_ptr ! hardsphere/view.h
    type(c_ptr) :: surface = c_null_ptr ! hardsphere/surface.h
    type(c_ptr) :: mesh = c_null_ptr ! hardsphere/mesh.h
    type(c_ptr) :: map = c_null_ptr ! hardsphere/map.h
    type(c_ptr) :: contacts = c_null_ptr
    type(c_ptr) :: cells = c_null_ptr ! hardsphere/cells.h
    type(c_ptr) :: paths = c_null_ptr ! hardsphere/paths.h
    type(c_ptr) :: gate = c_null_ptr ! hardsphere/paths.h
    type(c_ptr) :: moving = c_null_ptr
    integer(c_int32_t), private :: most_balls = 0
    type(memory_block), private :: memory(12)
    type(hsp_boundary_limits), private :: boundary_limits
    type(hsp_topology_limits), private :: topology_limits
    type(hsp_view_limits), private :: view_limits ! hardsphere/view.h
    type(hsp_surface_limits), private :: surface_limits ! hardsphere/surface.h
    type(hsp_mesh_limits), private :: mesh_limits ! hardsphere/mesh.h
    type(hsp_map_limits), private :: map_limits ! hardsphere/map.h
    type(hsp_contacts_limits), private :: contacts_limits
    type(hsp_cells_limits), private :: cells_limits ! hardsphere/cells.h
    type(hsp_paths_limits), private :: paths_limits ! hardsphere/paths.h
    type(hsp_gate_limits), private :: gate_limits ! hardsphere/paths.h
    type(hsp_moving_limits), private :: moving_limits
  contains
    procedure :: set => set_balls
    procedure :: compute_boundary
    procedure :: compute_topology
    procedure :: compute_view ! hardsphere/view.h
    procedure :: compute_surface ! hardsphere/surface.h
    procedure :: compute_mesh ! hardsphere/mesh.h
    procedure :: compute_map ! hardsphere/map.h
    procedure :: compute_contacts
    procedure :: compute_cells ! hardsphere/cells.h
    procedure :: find_path ! hardsphere/paths.h
    procedure :: compute_gate ! hardsphere/paths.h
    procedure :: set_moving
    procedure, private :: make_boundary
    procedure, private :: make_topology
    procedure, private :: make_view ! hardsphere/view.h
    procedure, private :: make_surface ! hardsphere/surface.h
    procedure, private :: make_mesh ! hardsphere/mesh.h
    procedure, private :: raise_mesh_limits ! hardsphere/mesh.h
    procedure, private :: make_map ! hardsphere/map.h
    procedure, private :: make_contacts
    procedure, private :: make_cells ! hardsphere/cells.h
    procedure, private :: make_paths ! hardsphere/paths.h
    procedure, private :: make_gate ! hardsphere/paths.h
    procedure, private :: make_moving
  end type

  private :: set_balls, compute_boundary, compute_topology, compute_contacts, set_moving, make_boundary, make_topology, &
    make_contacts, make_moving, allocated_to
  private :: compute_view, make_view ! hardsphere/view.h
  private :: compute_map, make_map ! hardsphere/map.h
  private :: compute_surface, make_surface ! hardsphere/surface.h
  private :: compute_mesh, make_mesh, raise_mesh_limits ! hardsphere/mesh.h
  private :: compute_cells, make_cells ! hardsphere/cells.h
  private :: find_path, compute_gate, make_paths, make_gate ! hardsphere/paths.h

contains

  ! Takes n balls into the model; arguments and statuses as hsp_model_set. Boundary, topology, view, surface, mesh, map,
  ! contacts, cells, paths and gate hold no results of other balls then; balls that move stay as they are.
  function set_balls(self, n, xyz, radius, options, first_bad) result(status)
    class(hsp_workspace), intent(inout), target :: self
    integer(c_int32_t), intent(in) :: n
    real(c_double), intent(in) :: xyz(3, *), radius(*)
    type(hsp_model_options), intent(in), optional :: options
    integer(c_int32_t), intent(inout), optional :: first_bad
    integer(c_int32_t) :: status
    integer(c_size_t) :: bytes
    if (.not. c_associated(self%model) .or. n > self%most_balls) then
      status = hsp_model_bytes(n, bytes)
      if (status /= HSP_OK) return
      ! Memory is given back, of the model and then of the boundary: what was computed from them must not look there.
      self%model = c_null_ptr
      self%most_balls = 0
      if (c_associated(self%boundary)) status = self%make_boundary()
      if (status == HSP_OK .and. c_associated(self%topology)) status = self%make_topology()
      if (status == HSP_OK .and. c_associated(self%view)) status = self%make_view() ! hardsphere/view.h
      if (status == HSP_OK .and. c_associated(self%surface)) status = self%make_surface() ! hardsphere/surface.h
      if (status == HSP_OK .and. c_associated(self%mesh)) status = self%make_mesh() ! hardsphere/mesh.h
      if (status == HSP_OK .and. c_associated(self%map)) status = self%make_map() ! hardsphere/map.h
      if (status == HSP_OK .and. c_associated(self%contacts)) status = self%make_contacts()
      if (status == HSP_OK .and. c_associated(self%cells)) status = self%make_cells() ! hardsphere/cells.h
      if (status == HSP_OK .and. c_associated(self%paths)) status = self%make_paths() ! hardsphere/paths.h
      if (status == HSP_OK .and. c_associated(self%gate)) status = self%make_gate() ! hardsphere/paths.h
      if (status == HSP_OK) status = allocated_to(self%memory(1), bytes)
      if (status == HSP_OK) status = hsp_model_init(c_loc(self%memory(1)%bytes), bytes, n, self%model)
      if (status /= HSP_OK) return
      self%most_balls = n
    end if
    status = hsp_model_set(self%model, n, xyz, radius, options, first_bad)
  end function

  ! Computes the boundary of the union of the balls. HSP_E_ARGUMENT: no balls were set.
  function compute_boundary(self) result(status)
    class(hsp_workspace), intent(inout), target :: self
    type(hsp_boundary_limits) :: limits
    integer(c_int32_t) :: status
    if (.not. c_associated(self%boundary)) then
      status = hsp_boundary_limits_init(self%boundary_limits, int(c_sizeof(limits), c_int32_t), self%most_balls)
      if (status == HSP_OK) status = self%make_boundary()
      if (status /= HSP_OK) return
    end if
    ! After success the limits are what was needed; the memory stays as it is.
    limits = self%boundary_limits
    do
      status = hsp_boundary_compute(self%boundary, self%model, limits)
      if (status /= HSP_E_CAPACITY) return
      self%boundary_limits = limits
      ! The same where the boundary's memory is given back.
      status = HSP_OK
      if (c_associated(self%topology)) status = self%make_topology()
      if (status == HSP_OK .and. c_associated(self%surface)) status = self%make_surface() ! hardsphere/surface.h
      if (status == HSP_OK .and. c_associated(self%mesh)) status = self%make_mesh() ! hardsphere/mesh.h
      if (status == HSP_OK .and. c_associated(self%contacts)) status = self%make_contacts()
      if (status == HSP_OK) status = self%make_boundary()
      if (status /= HSP_OK) return
    end do
  end function

  ! Computes the topology of the boundary that compute_boundary has computed.
  function compute_topology(self) result(status)
    class(hsp_workspace), intent(inout), target :: self
    type(hsp_topology_limits) :: limits
    integer(c_int32_t) :: status
    if (.not. c_associated(self%topology)) then
      status = hsp_topology_limits_init(self%topology_limits, int(c_sizeof(limits), c_int32_t), self%boundary)
      if (status == HSP_OK) status = self%make_topology()
      if (status /= HSP_OK) return
    end if
    limits = self%topology_limits
    do
      status = hsp_topology_compute(self%topology, self%boundary, limits)
      if (status /= HSP_E_CAPACITY) return
      self%topology_limits = limits
      status = self%make_topology()
      if (status /= HSP_OK) return
    end do
  end function

  ! ---- view.h

  ! Computes a view of the model alone or, if use_boundary is there and true, of the boundary that compute_boundary has
  ! computed; options as for hsp_view_compute. HSP_E_ARGUMENT: no balls were set, or compute_boundary was never called.
  function compute_view(self, options, use_boundary) result(status)
    class(hsp_workspace), intent(inout), target :: self
    type(hsp_view_options), intent(in), optional :: options
    logical, intent(in), optional :: use_boundary
    type(hsp_view_limits) :: limits
    type(c_ptr) :: boundary
    integer(c_int32_t) :: status
    if (.not. c_associated(self%view)) then
      status = hsp_view_limits_init(self%view_limits, int(c_sizeof(limits), c_int32_t), self%most_balls)
      if (status == HSP_OK) status = self%make_view()
      if (status /= HSP_OK) return
    end if
    boundary = c_null_ptr
    if (present(use_boundary)) then
      if (use_boundary) boundary = self%boundary
      if (use_boundary .and. .not. c_associated(boundary)) then
        status = hsp_view_compute(self%view, c_null_ptr, boundary, options)
        return
      end if
    end if
    limits = self%view_limits
    do
      status = hsp_view_compute(self%view, self%model, boundary, options, limits)
      if (status /= HSP_E_CAPACITY) return
      self%view_limits = limits
      status = self%make_view()
      if (status /= HSP_OK) return
    end do
  end function

  ! ---- surface.h

  ! Computes the solvent-excluded surface over the boundary that compute_boundary has computed.
  function compute_surface(self) result(status)
    class(hsp_workspace), intent(inout), target :: self
    type(hsp_surface_limits) :: limits
    integer(c_int32_t) :: status
    if (.not. c_associated(self%surface)) then
      status = hsp_surface_limits_init(self%surface_limits, int(c_sizeof(limits), c_int32_t), self%boundary)
      if (status == HSP_OK) status = self%make_surface()
      if (status /= HSP_OK) return
    end if
    limits = self%surface_limits
    do
      status = hsp_surface_compute(self%surface, self%boundary, limits)
      if (status /= HSP_E_CAPACITY) return
      self%surface_limits = limits
      status = self%make_surface()
      if (status /= HSP_OK) return
    end do
  end function

  ! ---- mesh.h

  ! Computes triangles with edges of about the given length for the boundary that compute_boundary has computed or, if
  ! use_surface is there and true, for the smooth surface over it that compute_surface has computed.
  function compute_mesh(self, edge, use_surface) result(status)
    class(hsp_workspace), intent(inout), target :: self
    real(c_double), intent(in) :: edge
    logical, intent(in), optional :: use_surface
    type(hsp_mesh_limits) :: limits
    integer(c_int32_t) :: status
    logical :: smooth
    smooth = .false.
    if (present(use_surface)) smooth = use_surface
    if (.not. c_associated(self%mesh)) then
      status = hsp_mesh_limits_init(self%mesh_limits, int(c_sizeof(limits), c_int32_t), self%boundary, edge)
      if (status == HSP_OK) status = self%raise_mesh_limits(edge, smooth)
      if (status == HSP_OK) status = self%make_mesh()
      if (status /= HSP_OK) return
    end if
    do
      limits = self%mesh_limits
      if (smooth) then
        status = hsp_mesh_compute_surface(self%mesh, self%surface, edge, limits)
      else
        status = hsp_mesh_compute(self%mesh, self%boundary, edge, limits)
      end if
      if (status /= HSP_E_CAPACITY) return
      self%mesh_limits = limits
      status = self%raise_mesh_limits(edge, smooth)
      if (status == HSP_OK) status = self%make_mesh()
      if (status /= HSP_OK) return
    end do
  end function

  ! ---- map.h

  ! Computes the visibility map of the model; options as for hsp_map_compute.
  function compute_map(self, options) result(status)
    class(hsp_workspace), intent(inout), target :: self
    type(hsp_view_options), intent(in), optional :: options
    type(hsp_map_limits) :: limits
    integer(c_int32_t) :: status
    if (.not. c_associated(self%map)) then
      status = hsp_map_limits_init(self%map_limits, int(c_sizeof(limits), c_int32_t), self%most_balls)
      if (status == HSP_OK) status = self%make_map()
      if (status /= HSP_OK) return
    end if
    limits = self%map_limits
    do
      status = hsp_map_compute(self%map, self%model, options, limits)
      if (status /= HSP_E_CAPACITY) return
      self%map_limits = limits
      status = self%make_map()
      if (status /= HSP_OK) return
    end do
  end function

  ! ---- contacts.h

  ! Computes the contacts of the balls of the boundary that compute_boundary has computed.
  function compute_contacts(self) result(status)
    class(hsp_workspace), intent(inout), target :: self
    type(hsp_contacts_limits) :: limits
    integer(c_int32_t) :: status
    if (.not. c_associated(self%contacts)) then
      status = hsp_contacts_limits_init(self%contacts_limits, int(c_sizeof(limits), c_int32_t), self%boundary)
      if (status == HSP_OK) status = self%make_contacts()
      if (status /= HSP_OK) return
    end if
    limits = self%contacts_limits
    do
      status = hsp_contacts_compute(self%contacts, self%boundary, limits)
      if (status /= HSP_E_CAPACITY) return
      self%contacts_limits = limits
      status = self%make_contacts()
      if (status /= HSP_OK) return
    end do
  end function

  ! ---- cells.h

  ! Cuts the free space of the model into cells.
  function compute_cells(self) result(status)
    class(hsp_workspace), intent(inout), target :: self
    type(hsp_cells_limits) :: limits
    integer(c_int32_t) :: status
    if (.not. c_associated(self%cells)) then
      status = hsp_cells_limits_init(self%cells_limits, int(c_sizeof(limits), c_int32_t), self%most_balls)
      if (status == HSP_OK) status = self%make_cells()
      if (status /= HSP_OK) return
    end if
    limits = self%cells_limits
    do
      status = hsp_cells_compute(self%cells, self%model, limits)
      if (status /= HSP_E_CAPACITY) return
      self%cells_limits = limits
      status = self%make_cells()
      if (status /= HSP_OK) return
    end do
  end function

  ! ---- paths.h

  ! Finds a path from one point to another through the free space of the model; arguments and statuses as
  ! hsp_paths_find. What only depends on the model is computed the first time.
  function find_path(self, from, to, path) result(status)
    class(hsp_workspace), intent(inout), target :: self
    real(c_double), intent(in) :: from(3), to(3)
    type(hsp_path), intent(inout) :: path
    type(hsp_paths_limits) :: limits
    integer(c_int32_t) :: status
    if (.not. c_associated(self%paths)) then
      status = hsp_paths_limits_init(self%paths_limits, int(c_sizeof(limits), c_int32_t), self%most_balls)
      if (status == HSP_OK) status = self%make_paths()
      if (status /= HSP_OK) return
    end if
    limits = self%paths_limits
    do
      status = hsp_paths_find(self%paths, from, to, path, limits)
      if (status == HSP_E_STATE) then
        status = hsp_paths_compute(self%paths, self%model, limits)
        if (status == HSP_OK) cycle
      end if
      if (status /= HSP_E_CAPACITY) return
      self%paths_limits = limits
      status = self%make_paths()
      if (status /= HSP_OK) return
    end do
  end function

  ! Finds the widest probe from one point to another, or to the outside without `to`; arguments and statuses as
  ! hsp_gate_compute.
  function compute_gate(self, from, to) result(status)
    class(hsp_workspace), intent(inout), target :: self
    real(c_double), intent(in) :: from(3)
    real(c_double), intent(in), optional :: to(3)
    type(hsp_gate_limits) :: limits
    integer(c_int32_t) :: status
    if (.not. c_associated(self%gate)) then
      status = hsp_gate_limits_init(self%gate_limits, int(c_sizeof(limits), c_int32_t), self%most_balls)
      if (status == HSP_OK) status = self%make_gate()
      if (status /= HSP_OK) return
    end if
    limits = self%gate_limits
    do
      status = hsp_gate_compute(self%gate, self%model, from, to, limits)
      if (status /= HSP_E_CAPACITY) return
      self%gate_limits = limits
      status = self%make_gate()
      if (status /= HSP_OK) return
    end do
  end function

  ! ---- mesh.h

  ! Limits of the mesh that suffice for edges of this length, too.
  function raise_mesh_limits(self, edge, smooth) result(status)
    class(hsp_workspace), intent(inout), target :: self
    real(c_double), intent(in) :: edge
    logical, intent(in) :: smooth
    type(hsp_mesh_limits) :: wanted
    integer(c_int32_t) :: status
    if (smooth) then
      status = hsp_mesh_limits_init_surface(wanted, int(c_sizeof(wanted), c_int32_t), self%surface, edge)
    else
      status = hsp_mesh_limits_init(wanted, int(c_sizeof(wanted), c_int32_t), self%boundary, edge)
    end if
    if (status /= HSP_OK) return
    self%mesh_limits%balls = max(self%mesh_limits%balls, wanted%balls)
    self%mesh_limits%curves = max(self%mesh_limits%curves, wanted%curves)
    self%mesh_limits%vertices = max(self%mesh_limits%vertices, wanted%vertices)
    self%mesh_limits%triangles = max(self%mesh_limits%triangles, wanted%triangles)
    self%mesh_limits%points = max(self%mesh_limits%points, wanted%points)
  end function

  ! ---- moving.h

  ! Takes the balls of the model as balls that move; arguments and statuses as hsp_moving_set. There is room for 256
  ! neighbours of each at least, or for all balls.
  function set_moving(self, tension, pressure, tangency, sigma, first_bad) result(status)
    class(hsp_workspace), intent(inout), target :: self
    real(c_double), intent(in) :: tension, pressure
    integer(c_int32_t), intent(in) :: tangency
    real(c_double), intent(in), optional :: sigma(*)
    integer(c_int32_t), intent(inout), optional :: first_bad
    type(hsp_moving_limits) :: limits
    integer(c_int32_t) :: status
    if (.not. c_associated(self%moving)) then
      status = hsp_moving_limits_init(self%moving_limits, int(c_sizeof(limits), c_int32_t), self%most_balls)
      if (status == HSP_OK) status = self%make_moving()
      if (status /= HSP_OK) return
    end if
    limits = self%moving_limits
    do
      status = hsp_moving_set(self%moving, self%model, sigma, tension, pressure, tangency, limits, first_bad)
      if (status /= HSP_E_CAPACITY) return
      ! Moves need room as well.
      limits%neighbours = max(limits%neighbours, min(limits%balls, 256_c_int32_t))
      self%moving_limits = limits
      status = self%make_moving()
      if (status /= HSP_OK) return
    end do
  end function

  ! Handles of the current limits, without results.

  function make_boundary(self) result(status)
    class(hsp_workspace), intent(inout), target :: self
    integer(c_int32_t) :: status
    integer(c_size_t) :: bytes
    self%boundary = c_null_ptr
    status = hsp_boundary_bytes(self%boundary_limits, bytes)
    if (status == HSP_OK) status = allocated_to(self%memory(2), bytes)
    if (status == HSP_OK) status = hsp_boundary_init(c_loc(self%memory(2)%bytes), bytes, self%boundary_limits, self%boundary)
  end function

  function make_topology(self) result(status)
    class(hsp_workspace), intent(inout), target :: self
    integer(c_int32_t) :: status
    integer(c_size_t) :: bytes
    self%topology = c_null_ptr
    status = hsp_topology_bytes(self%topology_limits, bytes)
    if (status == HSP_OK) status = allocated_to(self%memory(3), bytes)
    if (status == HSP_OK) status = hsp_topology_init(c_loc(self%memory(3)%bytes), bytes, self%topology_limits, self%topology)
  end function

  ! ---- view.h

  function make_view(self) result(status)
    class(hsp_workspace), intent(inout), target :: self
    integer(c_int32_t) :: status
    integer(c_size_t) :: bytes
    self%view = c_null_ptr
    status = hsp_view_bytes(self%view_limits, bytes)
    if (status == HSP_OK) status = allocated_to(self%memory(4), bytes)
    if (status == HSP_OK) status = hsp_view_init(c_loc(self%memory(4)%bytes), bytes, self%view_limits, self%view)
  end function

  ! ---- surface.h

  function make_surface(self) result(status)
    class(hsp_workspace), intent(inout), target :: self
    integer(c_int32_t) :: status
    integer(c_size_t) :: bytes
    self%surface = c_null_ptr
    status = hsp_surface_bytes(self%surface_limits, bytes)
    if (status == HSP_OK) status = allocated_to(self%memory(5), bytes)
    if (status == HSP_OK) status = hsp_surface_init(c_loc(self%memory(5)%bytes), bytes, self%surface_limits, self%surface)
  end function

  ! ---- mesh.h

  function make_mesh(self) result(status)
    class(hsp_workspace), intent(inout), target :: self
    integer(c_int32_t) :: status
    integer(c_size_t) :: bytes
    self%mesh = c_null_ptr
    status = hsp_mesh_bytes(self%mesh_limits, bytes)
    if (status == HSP_OK) status = allocated_to(self%memory(6), bytes)
    if (status == HSP_OK) status = hsp_mesh_init(c_loc(self%memory(6)%bytes), bytes, self%mesh_limits, self%mesh)
  end function

  ! ---- map.h

  function make_map(self) result(status)
    class(hsp_workspace), intent(inout), target :: self
    integer(c_int32_t) :: status
    integer(c_size_t) :: bytes
    self%map = c_null_ptr
    status = hsp_map_bytes(self%map_limits, bytes)
    if (status == HSP_OK) status = allocated_to(self%memory(7), bytes)
    if (status == HSP_OK) status = hsp_map_init(c_loc(self%memory(7)%bytes), bytes, self%map_limits, self%map)
  end function

  ! ---- contacts.h

  function make_contacts(self) result(status)
    class(hsp_workspace), intent(inout), target :: self
    integer(c_int32_t) :: status
    integer(c_size_t) :: bytes
    self%contacts = c_null_ptr
    status = hsp_contacts_bytes(self%contacts_limits, bytes)
    if (status == HSP_OK) status = allocated_to(self%memory(8), bytes)
    if (status == HSP_OK) status = hsp_contacts_init(c_loc(self%memory(8)%bytes), bytes, self%contacts_limits, self%contacts)
  end function

  ! ---- paths.h

  function make_paths(self) result(status)
    class(hsp_workspace), intent(inout), target :: self
    integer(c_int32_t) :: status
    integer(c_size_t) :: bytes
    self%paths = c_null_ptr
    status = hsp_paths_bytes(self%paths_limits, bytes)
    if (status == HSP_OK) status = allocated_to(self%memory(10), bytes)
    if (status == HSP_OK) status = hsp_paths_init(c_loc(self%memory(10)%bytes), bytes, self%paths_limits, self%paths)
  end function

  function make_gate(self) result(status)
    class(hsp_workspace), intent(inout), target :: self
    integer(c_int32_t) :: status
    integer(c_size_t) :: bytes
    self%gate = c_null_ptr
    status = hsp_gate_bytes(self%gate_limits, bytes)
    if (status == HSP_OK) status = allocated_to(self%memory(11), bytes)
    if (status == HSP_OK) status = hsp_gate_init(c_loc(self%memory(11)%bytes), bytes, self%gate_limits, self%gate)
  end function

  ! ---- moving.h

  function make_moving(self) result(status)
    class(hsp_workspace), intent(inout), target :: self
    integer(c_int32_t) :: status
    integer(c_size_t) :: bytes
    self%moving = c_null_ptr
    status = hsp_moving_bytes(self%moving_limits, bytes)
    if (status == HSP_OK) status = allocated_to(self%memory(12), bytes)
    if (status == HSP_OK) status = hsp_moving_init(c_loc(self%memory(12)%bytes), bytes, self%moving_limits, self%moving)
  end function

  ! ---- cells.h

  function make_cells(self) result(status)
    class(hsp_workspace), intent(inout), target :: self
    integer(c_int32_t) :: status
    integer(c_size_t) :: bytes
    self%cells = c_null_ptr
    status = hsp_cells_bytes(self%cells_limits, bytes)
    if (status == HSP_OK) status = allocated_to(self%memory(9), bytes)
    if (status == HSP_OK) status = hsp_cells_init(c_loc(self%memory(9)%bytes), bytes, self%cells_limits, self%cells)
  end function

  ! ---- model.h

  ! Memory of another size, without its contents.
  function allocated_to(memory, bytes) result(status)
    type(memory_block), intent(inout) :: memory
    integer(c_size_t), intent(in) :: bytes
    integer(c_int32_t) :: status
    integer :: failed
    if (allocated(memory%bytes)) deallocate (memory%bytes)
    allocate (memory%bytes(bytes), stat=failed)
    status = merge(HSP_OK, HSP_E_MEMORY, failed == 0)
  end function
end module
