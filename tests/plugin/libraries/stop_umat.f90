! An elastic UMAT that gives a reason and ends by STOP when straining has lasted PROPS(1) seconds.
subroutine umat(stress, statev, ddsdde, sse, spd, scd, rpl, ddsddt, drplde, drpldt, stran, dstran, time, dtime, temp, &
                dtemp, predef, dpred, cmname, ndi, nshr, ntens, nstatv, props, nprops, coords, drot, pnewdt, celent, &
                dfgrd0, dfgrd1, noel, npt, layer, kspt, kstep, kinc)
  implicit none
  character(len=80) :: cmname
  integer :: ndi, nshr, ntens, nstatv, nprops, noel, npt, layer, kspt, kstep, kinc, i
  double precision :: stress(ntens), statev(nstatv), ddsdde(ntens, ntens), sse, spd, scd, rpl, ddsddt(ntens), &
                      drplde(ntens), drpldt, stran(ntens), dstran(ntens), time(2), dtime, temp, dtemp, predef, dpred, &
                      props(nprops), coords(3), drot(3, 3), pnewdt, celent, dfgrd0(3, 3), dfgrd1(3, 3)
  double precision, parameter :: e = 1d7
  ddsdde = 0
  do i = 1, ntens
    ddsdde(i, i) = merge(e, e / 2, i <= 3)
  end do
  if (any(dstran /= 0) .and. time(2) >= props(1)) then
    write (*, *) 'written by the UMAT'
    stop 'friction angle out of range'
  end if
  stress = stress + matmul(ddsdde, dstran)
end subroutine
