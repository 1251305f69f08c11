"""What a program gets with libfmb: the C library, libm and GMP at run time, GMP's headers when it is
built. usage: needs.py READELF LIBRARY FMB_PC
"""

import pathlib
import re
import subprocess
import sys

readelf, library, pc = sys.argv[1:]
# A loader is named where thread-local variables are used; sanitizers are libraries of the compiler's.
ALLOWED = r"(libgmp|libm|libc|ld-linux[\w-]*|ld64|libasan|libubsan|libtsan|liblsan)\.so[.\d]*"

dynamic = subprocess.run([readelf, "-dW", library], env={"LC_ALL": "C"}, check=True,
                         capture_output=True, text=True).stdout
needed = re.findall(r"\(NEEDED\).*\[(.*)\]", dynamic)
assert "libgmp" in " ".join(needed), needed
more = [n for n in needed if not re.fullmatch(ALLOWED, n)]
assert not more, f"{library} needs {more}"

# --cflags asks for the headers of what is required privately, too.
required = re.findall(r"^Requires(?:\.private)?: *(.*)$", pathlib.Path(pc).read_text(), re.M)
assert required == ["gmp"], required
print(*needed)
