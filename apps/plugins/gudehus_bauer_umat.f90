! Gudehus-Bauer hypoplasticity as a UMAT for Abaqus: equations (A1) to (A10) of Krzyzanowski, Wojcik & Tejchman (2020),
! with h_i of Bauer (1996), as in docs/theory/gudehus_bauer.md.
!   PROPS   1 phi_c [rad], 2 h_s [Pa], 3 n, 4 e_i0, 5 e_d0, 6 e_c0, 7 alpha, 8 beta, 9 longest strain of a sub-step,
!           10 minimum mean pressure [Pa], 11 not 0: the norm of the strain increment is DPRED(1), its non-local average
!   STATEV  1 void ratio
module gudehus_bauer
  implicit none
  private
  public :: sand, sand_of, rate

  type sand
    double precision :: c1, c2, h_s, n, e_i0, e_d0, e_c0, alpha, beta, f_s0
  end type sand

contains

  pure function sand_of(props) result(s)
    double precision, intent(in) :: props(:)
    type(sand) :: s
    double precision :: sine, h_i
    s%h_s = props(2); s%n = props(3); s%e_i0 = props(4); s%e_d0 = props(5); s%e_c0 = props(6)
    s%alpha = props(7); s%beta = props(8)
    sine = sin(props(1))
    s%c1 = sqrt(3d0 / 8) * (3 - sine) / sine
    s%c2 = 3d0 / 8 * (3 + sine) / sine
    h_i = 1 / s%c1**2 + 1d0 / 3 - ((s%e_i0 - s%e_d0) / (s%e_c0 - s%e_d0))**s%alpha / (s%c1 * sqrt(3d0))
    s%f_s0 = s%h_s / (s%n * h_i)
  end function sand_of

  ! Stress per strain increment `de` (tensor shear) whose norm, or its average, is d; L and N separately on request.
  pure subroutine rate(s, sigma, e, de, d, dsigma, L, N)
    type(sand), intent(in) :: s
    double precision, intent(in) :: sigma(3, 3), e, de(3, 3), d
    double precision, intent(out) :: dsigma(3, 3)
    double precision, intent(out), optional :: L(3, 3, 3, 3), N(3, 3)
    double precision :: hat(3, 3), dev(3, 3), P, e_i, e_d, e_c, f_s, f_d, a, x, cosine, radial(3, 3)
    integer :: i, j, k, m
    P = -(sigma(1, 1) + sigma(2, 2) + sigma(3, 3))
    hat = sigma / (-P)
    dev = hat
    do i = 1, 3
      dev(i, i) = dev(i, i) - 1d0 / 3
    end do
    e_i = s%e_i0 * exp(-(P / s%h_s)**s%n)
    e_d = s%e_d0 * exp(-(P / s%h_s)**s%n)
    e_c = s%e_c0 * exp(-(P / s%h_s)**s%n)
    f_s = s%f_s0 * (1 + e_i) / e_i * (e_i / e)**s%beta * (P / s%h_s)**(1 - s%n)
    f_d = max(0d0, (e - e_d) / (e_c - e_d))**s%alpha
    x = sqrt(sum(dev * dev))
    a = 1 / s%c1
    if (x > 1d-15) then
      cosine = max(-1d0, min(1d0, -sqrt(6d0) * sum(matmul(dev, dev) * dev) / x**3))
      a = 1 / (s%c1 + s%c2 * x * (1 + cosine))
    end if
    radial = f_s * f_d * a * (hat + dev)
    dsigma = f_s * (a**2 * de + hat * sum(hat * de)) + radial * d
    if (.not. present(L)) return
    N = radial
    do concurrent (i = 1:3, j = 1:3, k = 1:3, m = 1:3)
      L(i, j, k, m) = f_s * hat(i, j) * hat(k, m)
      if (i == k .and. j == m) L(i, j, k, m) = L(i, j, k, m) + f_s * a**2
    end do
  end subroutine rate

end module gudehus_bauer

subroutine umat(stress, statev, ddsdde, sse, spd, scd, rpl, ddsddt, drplde, drpldt, stran, dstran, time, dtime, &
                temp, dtemp, predef, dpred, cmname, ndi, nshr, ntens, nstatv, props, nprops, coords, drot, pnewdt, &
                celent, dfgrd0, dfgrd1, noel, npt, layer, kspt, kstep, kinc)
  use gudehus_bauer
  implicit none
  integer :: ndi, nshr, ntens, nstatv, nprops, noel, npt, layer, kspt, kstep, kinc
  double precision :: stress(ntens), statev(nstatv), ddsdde(ntens, ntens), ddsddt(ntens), drplde(ntens)
  double precision :: stran(ntens), dstran(ntens), time(2), predef(1), dpred(1), props(nprops), coords(3)
  double precision :: drot(3, 3), dfgrd0(3, 3), dfgrd1(3, 3)
  double precision :: sse, spd, scd, rpl, drpldt, dtime, temp, dtemp, pnewdt, celent
  character(len=80) :: cmname
  integer, parameter :: row(6) = [1, 2, 3, 1, 1, 2], column(6) = [1, 2, 3, 2, 3, 3]
  type(sand) :: s
  double precision :: sigma(3, 3), e, de(3, 3), d, grow, length
  integer :: parts, i

  if (ntens /= 6 .or. nprops < 11 .or. nstatv < 1) call xit
  s = sand_of(props)
  e = statev(1)
  do i = 1, 6
    sigma(row(i), column(i)) = stress(i)
    sigma(column(i), row(i)) = stress(i)
    de(row(i), column(i)) = merge(1d0, 0.5d0, i <= 3) * dstran(i)
    de(column(i), row(i)) = de(row(i), column(i))
  end do
  length = sqrt(sum(de * de))
  d = merge(dpred(1), length, abs(props(11)) > 0)
  parts = max(1, ceiling(max(length, d) / props(9)))
  grow = (de(1, 1) + de(2, 2) + de(3, 3)) / parts
  do i = 1, parts
    call runge_kutta(s, sigma, e, de / parts, d / parts, grow)
    call keep_pressure(sigma, props(10))
  end do
  call tangent(s, sigma, e, de, d, ddsdde)
  do i = 1, 6
    stress(i) = sigma(row(i), column(i))
  end do
  statev(1) = e

contains

  ! Classical Runge-Kutta; the void ratio grows as exp(tr D t) does.
  subroutine runge_kutta(s, sigma, e, de, d, grow)
    type(sand), intent(in) :: s
    double precision, intent(inout) :: sigma(3, 3), e
    double precision, intent(in) :: de(3, 3), d, grow
    double precision :: k1(3, 3), k2(3, 3), k3(3, 3), k4(3, 3), middle, last
    middle = (1 + e) * exp(grow / 2) - 1
    last = (1 + e) * exp(grow) - 1
    call rate(s, sigma, e, de, d, k1)
    call rate(s, sigma + k1 / 2, middle, de, d, k2)
    call rate(s, sigma + k2 / 2, middle, de, d, k3)
    call rate(s, sigma + k3, last, de, d, k4)
    sigma = sigma + (k1 + 2 * k2 + 2 * k3 + k4) / 6
    e = last
  end subroutine runge_kutta

  ! A point that falls below the minimum pressure returns to it, in the direction of its stress.
  subroutine keep_pressure(sigma, least)
    double precision, intent(inout) :: sigma(3, 3)
    double precision, intent(in) :: least
    double precision :: p
    integer :: i
    p = -(sigma(1, 1) + sigma(2, 2) + sigma(3, 3)) / 3
    if (p >= least) return
    if (p > 0.1d0 * least) then
      sigma = sigma * (least / p)
    else
      sigma = 0
      do i = 1, 3
        sigma(i, i) = -least
      end do
    end if
  end subroutine keep_pressure

  ! L + N n for an increment with the direction n, L without one.
  subroutine tangent(s, sigma, e, de, d, ddsdde)
    type(sand), intent(in) :: s
    double precision, intent(in) :: sigma(3, 3), e, de(3, 3), d
    double precision, intent(out) :: ddsdde(6, 6)
    double precision :: unused(3, 3), L(3, 3, 3, 3), N(3, 3), n_i(3, 3)
    integer :: i, j
    call rate(s, sigma, e, de, d, unused, L, N)
    n_i = 0
    if (length > 0) n_i = de / length
    do j = 1, 6
      do i = 1, 6 ! a unit of engineering shear is half a unit in both places of the tensor
        ddsdde(i, j) = (L(row(i), column(i), row(j), column(j)) + L(row(i), column(i), column(j), row(j))) / 2 &
                       + N(row(i), column(i)) * n_i(row(j), column(j))
      end do
    end do
  end subroutine tangent

end subroutine umat
