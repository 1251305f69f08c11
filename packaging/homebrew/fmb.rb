# The library and the command for Homebrew on Linux, from the tarball that packaging/tarball makes:
# brew install --formula packaging/homebrew/fmb.rb
class Fmb < Formula
  desc "Systems of linear inequalities, exactly and with proofs"
  url "file://#{File.expand_path("../../dist/fmb-0.3.0.tar.xz", __dir__)}"
  version "0.3.0"
  license all_of: ["LGPL-3.0-or-later", "GPL-3.0-or-later"]

  depends_on "meson" => :build
  depends_on "ninja" => :build
  depends_on "pkgconf" => :build
  depends_on "gmp"
  depends_on "jansson"
  depends_on :linux

  def install
    options = %w[-Dapps=enabled -Dpython=disabled -Dstudy=disabled -Dnauty=disabled -Dthreemf=disabled -Dmpi=disabled -Dbench=disabled -Dtests=disabled]
    system "meson", "setup", "build", *std_meson_args, *options
    system "meson", "compile", "-C", "build"
    system "meson", "install", "-C", "build"
  end

  test do
    (testpath/"two.fmb").write "x + y <= 3\n2y < x - 4\n"
    assert_match "feasible", shell_output("#{bin}/fmb solve two.fmb")
  end
end
