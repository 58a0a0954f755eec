"""A recorded mission through libnpsee and ctypes alone: recording.py LIBRARY RECORDING TIME prints what `c_consumer recording` prints."""

import ctypes
import sys

HANDLE, SIZE, DOUBLE, TEXT = ctypes.c_void_p, ctypes.c_size_t, ctypes.c_double, ctypes.c_char_p


class Vehicle(ctypes.Structure):
    _fields_ = [("id", TEXT), ("type", TEXT), ("position_m", DOUBLE * 3), ("heading_rad", DOUBLE), ("speed_mps", DOUBLE), ("destroyed", ctypes.c_int)]


class Shell(ctypes.Structure):
    _fields_ = [("number", ctypes.c_int), ("fired_s", DOUBLE), ("burst_s", DOUBLE), ("burst_m", DOUBLE * 3), ("position_m", DOUBLE * 3), ("velocity_mps", DOUBLE * 3), ("in_air", ctypes.c_int)]


SIGNATURES = {
    "npsee_last_error": (TEXT,),
    "npsee_recording_open": (ctypes.c_int, TEXT, ctypes.POINTER(HANDLE)),
    "npsee_recording_duration_s": (DOUBLE, HANDLE),
    "npsee_recording_hash": (TEXT, HANDLE),
    "npsee_recording_seek": (ctypes.c_int, HANDLE, DOUBLE, ctypes.POINTER(SIZE)),
    "npsee_recording_events": (SIZE, HANDLE),
    "npsee_recording_event": (ctypes.c_int, HANDLE, SIZE, TEXT, SIZE, ctypes.POINTER(SIZE)),
    "npsee_recording_vehicles": (SIZE, HANDLE),
    "npsee_recording_vehicle": (ctypes.c_int, HANDLE, SIZE, DOUBLE, ctypes.POINTER(Vehicle)),
    "npsee_recording_height": (ctypes.c_int, HANDLE, DOUBLE, DOUBLE, ctypes.POINTER(DOUBLE)),
    "npsee_recording_shells": (SIZE, HANDLE),
    "npsee_recording_shell": (ctypes.c_int, HANDLE, SIZE, DOUBLE, ctypes.POINTER(Shell)),
    "npsee_recording_burst": (ctypes.c_int, HANDLE, SIZE, ctypes.POINTER(TEXT), ctypes.POINTER(ctypes.c_uint64)),
    "npsee_recording_free": (None, HANDLE),
}


def main():
    library = ctypes.CDLL(sys.argv[1])
    for name, (result, *arguments) in SIGNATURES.items():
        getattr(library, name).restype, getattr(library, name).argtypes = result, arguments

    def need(status):
        if status != 0:
            sys.exit(library.npsee_last_error().decode())

    recording, t_s, first, length = HANDLE(), float(sys.argv[3]), SIZE(), SIZE()
    need(library.npsee_recording_open(sys.argv[2].encode(), recording))
    print("duration_s %.17g" % library.npsee_recording_duration_s(recording))
    print("hash", library.npsee_recording_hash(recording).decode())
    need(library.npsee_recording_seek(recording, t_s, first))
    print("first", first.value)
    for index in range(first.value, library.npsee_recording_events(recording)):
        need(library.npsee_recording_event(recording, index, None, 0, length))
        text = ctypes.create_string_buffer(length.value + 1)
        need(library.npsee_recording_event(recording, index, text, length.value + 1, None))
        print("event", text.value.decode())
    vehicle, shell, height_m, preset, seed = Vehicle(), Shell(), DOUBLE(), TEXT(), ctypes.c_uint64()
    for index in range(library.npsee_recording_vehicles(recording)):
        need(library.npsee_recording_vehicle(recording, index, t_s, vehicle))
        need(library.npsee_recording_height(recording, vehicle.position_m[0], vehicle.position_m[2], height_m))
        print("vehicle", vehicle.id.decode(), *("%.17g" % number for number in (*vehicle.position_m, height_m.value)))
    for index in range(library.npsee_recording_shells(recording)):
        need(library.npsee_recording_shell(recording, index, t_s, shell))
        need(library.npsee_recording_burst(recording, index, preset, seed))
        if shell.in_air:
            print("shell", shell.number, *("%.17g" % number for number in shell.position_m))
        print("burst", shell.number, "%.17g" % shell.burst_s, seed.value, preset.value.decode())
    library.npsee_recording_free(recording)


main()
