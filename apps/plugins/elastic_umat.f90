! Hooke's law as a UMAT for Abaqus. PROPS: Young's modulus [Pa], Poisson's ratio [-].
subroutine umat(stress, statev, ddsdde, sse, spd, scd, rpl, ddsddt, drplde, drpldt, stran, dstran, time, dtime, &
                temp, dtemp, predef, dpred, cmname, ndi, nshr, ntens, nstatv, props, nprops, coords, drot, pnewdt, &
                celent, dfgrd0, dfgrd1, noel, npt, layer, kspt, kstep, kinc)
  implicit none
  integer :: ndi, nshr, ntens, nstatv, nprops, noel, npt, layer, kspt, kstep, kinc, i
  double precision :: stress(ntens), statev(nstatv), ddsdde(ntens, ntens), ddsddt(ntens), drplde(ntens)
  double precision :: stran(ntens), dstran(ntens), time(2), predef(1), dpred(1), props(nprops), coords(3)
  double precision :: drot(3, 3), dfgrd0(3, 3), dfgrd1(3, 3)
  double precision :: sse, spd, scd, rpl, drpldt, dtime, temp, dtemp, pnewdt, celent, lambda, mu
  character(len=80) :: cmname

  mu = props(1) / (2 * (1 + props(2)))
  lambda = 2 * mu * props(2) / (1 - 2 * props(2))
  ddsdde = 0
  ddsdde(1:ndi, 1:ndi) = lambda
  do i = 1, ndi
    ddsdde(i, i) = lambda + 2 * mu
  end do
  do i = ndi + 1, ntens
    ddsdde(i, i) = mu ! shear strains are engineering ones
  end do
  stress = stress + matmul(ddsdde, dstran)
end subroutine umat
