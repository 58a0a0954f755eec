"""libnpsee called from Python by ctypes alone: particles.py LIBRARY PRESET TIME prints what `c_consumer particles` prints."""

import ctypes
import sys

DOUBLES = ("x", "y", "z", "vx", "vy", "vz", "size", "age", "r", "g", "b", "a", "qx", "qy", "qz", "qw")
COLUMNS = ("age", "x", "y", "z", "vx", "vy", "vz", "size", "r", "g", "b", "a")


class Frame(ctypes.Structure):
    _fields_ = [("capacity", ctypes.c_size_t), *((name, ctypes.POINTER(ctypes.c_double)) for name in DOUBLES),
                ("alive", ctypes.POINTER(ctypes.c_uint8)), ("bounces", ctypes.POINTER(ctypes.c_uint8))]


def main():
    library = ctypes.CDLL(sys.argv[1])
    library.npsee_last_error.restype = ctypes.c_char_p
    library.npsee_explosion_particles.restype = ctypes.c_size_t
    library.npsee_explosion_at.argtypes = [ctypes.c_void_p, ctypes.c_double, ctypes.POINTER(Frame), ctypes.c_int]

    def need(status):
        if status != 0:
            sys.exit(library.npsee_last_error().decode())

    if library.npsee_abi() != 1:
        sys.exit("another binary interface")
    preset, explosion = ctypes.c_void_p(), ctypes.c_void_p()
    need(library.npsee_preset_load(sys.argv[2].encode(), ctypes.byref(preset)))
    need(library.npsee_explosion_compile(preset, None, ctypes.byref(explosion)))
    library.npsee_preset_free(preset)
    count = library.npsee_explosion_particles(explosion)
    arrays = {name: (ctypes.c_double * count)() for name in COLUMNS}
    arrays.update({name: (ctypes.c_uint8 * count)() for name in ("alive", "bounces")})
    frame = Frame(capacity=count)
    for name, array in arrays.items():
        setattr(frame, name, ctypes.cast(array, dict(Frame._fields_)[name]))
    need(library.npsee_explosion_at(explosion, float(sys.argv[3]), ctypes.byref(frame), 1))
    for i in range(count):
        print(arrays["alive"][i], *("%.17g" % arrays[name][i] for name in COLUMNS), arrays["bounces"][i])
    library.npsee_explosion_free(explosion)


main()
