{ lib, stdenv, meson, ninja, pkg-config, python3, gmp, jansson }:

stdenv.mkDerivation {
  pname = "fmb";
  version = "0.3.0";
  src = lib.cleanSource ../..;

  nativeBuildInputs = [ meson ninja pkg-config python3 ];
  buildInputs = [ jansson ];
  propagatedBuildInputs = [ gmp ]; # its header is seen by who uses <fmb/gmp.h>

  mesonFlags = [
    "-Dapps=enabled"
    "-Dpython=disabled"
    "-Dstudy=disabled"
    "-Dnauty=disabled"
    "-Dthreemf=disabled"
    "-Dmpi=disabled"
    "-Dbench=disabled"
    "-Dtests=disabled"
  ];

  doInstallCheck = true;
  installCheckPhase = ''
    printf 'x + y <= 3\n2y < x - 4\n' | $out/bin/fmb solve - | grep -x feasible
  '';

  meta = {
    description = "Systems of linear inequalities, exactly and with proofs";
    license = with lib.licenses; [ lgpl3Plus gpl3Plus ];
    platforms = lib.platforms.linux;
    mainProgram = "fmb";
  };
}
