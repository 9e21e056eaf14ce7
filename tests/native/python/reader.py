"""A typical Python program: frames, status and commands through ctypes. Arguments: the library, receive or wait, ports."""
import ctypes
import signal
import sys
import threading
import time
from ctypes import (CFUNCTYPE, POINTER, Structure, byref, c_bool, c_char, c_char_p, c_float, c_int, c_uint8, c_uint16, c_uint32, c_void_p,
                    create_string_buffer, sizeof)


class DataVersion(Structure):
    _pack_ = 1
    _fields_ = [("BuildNumb", c_uint8), ("Revision", c_uint8), ("Minor", c_uint8), ("Major", c_uint8)]


class BvhDataHeader(Structure):
    _pack_ = 1
    _fields_ = [("Token1", c_uint16), ("DataVersion", DataVersion), ("DataCount", c_uint16), ("WithDisp", c_uint8), ("WithReference", c_uint8),
                ("AvatarIndex", c_uint32), ("AvatarName", c_char * 32), ("FrameIndex", c_uint32), ("Reserved", c_uint32),
                ("Reserved1", c_uint32), ("Reserved2", c_uint32), ("Token2", c_uint16)]


class CalcDataHeader(Structure):
    _pack_ = 1
    _fields_ = [("Token1", c_uint16), ("DataVersion", DataVersion), ("DataCount", c_uint32), ("AvatarIndex", c_uint32), ("AvatarName", c_char * 32),
                ("FrameIndex", c_uint32), ("Reserved1", c_uint32), ("Reserved2", c_uint32), ("Reserved3", c_uint32), ("Token2", c_uint16)]


class CommandPack(Structure):
    _pack_ = 1
    _fields_ = [("Token1", c_uint16), ("DataVersion", c_uint32), ("DataLength", c_uint32), ("DataCount", c_uint32), ("CommandId", c_int),
                ("CmdParaments", c_uint8 * 40), ("Reserved1", c_uint32), ("Token2", c_uint16)]


class BoneDimension(Structure):
    _pack_ = 1
    _fields_ = [(name, c_float) for name in ("Head", "Neck", "Body", "ShoulderWidth", "UpperArm", "Forearm", "Palm", "HipWidth", "UpperLeg",
                                             "LowerLeg", "HeelHeight", "FootLength")]


FrameDataReceived = CFUNCTYPE(None, c_void_p, c_void_p, POINTER(BvhDataHeader), POINTER(c_float))
CalculationDataReceived = CFUNCTYPE(None, c_void_p, c_void_p, POINTER(CalcDataHeader), POINTER(c_float))
SocketStatusChanged = CFUNCTYPE(None, c_void_p, c_void_p, c_int, c_char_p)
CommandDataReceived = CFUNCTYPE(None, c_void_p, c_void_p, POINTER(CommandPack), c_void_p)

# Writes a line with one call: print writes word by word, so the words of other threads could come in between.
def say(*words):
    sys.stdout.write(" ".join(map(str, words)) + "\n")


# Whether to print frames, and the number of frames received on each connection.
verbose = True
counts = {}


def load(path):
    library = ctypes.CDLL(path)
    for name in ("BRConnectTo", "BRStartUDPServiceAt", "BRConnectCmd"):
        getattr(library, name).restype = c_void_p
    library.BRConnectTo.argtypes = library.BRConnectCmd.argtypes = [c_char_p, c_int]
    library.BRGetLastErrorMessage.restype = c_char_p
    library.BRCloseSocket.argtypes = library.BRGetSocketStatus.argtypes = [c_void_p]
    library.BRRegisterFrameDataCallback.argtypes = [c_void_p, FrameDataReceived]
    library.BRRegisterCalculationDataCallback.argtypes = [c_void_p, CalculationDataReceived]
    library.BRRegisterSocketStatusCallback.argtypes = [c_void_p, SocketStatusChanged]
    library.BRRegisterCommandDataCallback.argtypes = [c_void_p, CommandDataReceived]
    library.BRCommandFetchDataFromServer.argtypes = [c_void_p, c_int]
    library.ZeroOut.argtypes = [c_void_p, c_int]
    library.ZeroOut.restype = library.GetBvhRotation.restype = library.GetBoneSize.restype = library.GetBvhHeader.restype = c_bool
    library.GetBvhRotation.argtypes = [c_void_p, POINTER(c_int)]
    library.GetBoneSize.argtypes = [c_void_p, c_int, POINTER(BoneDimension)]
    library.GetBvhHeader.argtypes = [c_void_p, c_int, c_char_p, c_int]
    return library


@FrameDataReceived
def on_frame(custom, sender, header, data):
    head = header.contents
    counts[sender] = counts.get(sender, 0) + 1
    if not verbose:
        return
    version = head.DataVersion
    values = data[:head.DataCount]
    say("frame", custom, head.Token1 == 0xDDFF and head.Token2 == 0xEEFF, f"{version.Major}.{version.Minor}.{version.Revision}.{version.BuildNumb}",
          head.AvatarIndex, head.AvatarName.decode(), head.FrameIndex, head.WithDisp, head.WithReference, len(values), values[0], values[-1])
    if head.FrameIndex == 13:
        raise ZeroDivisionError("of the callback")


@CalculationDataReceived
def on_calculation(custom, sender, header, data):
    head = header.contents
    say("calculation", custom, head.Token1 == 0x88FF and head.Token2 == 0x99FF, head.FrameIndex, head.DataCount, data[head.DataCount - 1])


@SocketStatusChanged
def on_status(custom, sender, status, message):
    if verbose:
        say("status", custom, status, message.decode().rstrip("\n"))


@CommandDataReceived
def on_command(custom, sender, pack, data):
    head = pack.contents
    say("answer", custom, head.CommandId, head.CmdParaments[0], data)


def register(library):
    library.BRRegisterFrameDataCallback(1, on_frame)
    library.BRRegisterCalculationDataCallback(2, on_calculation)
    library.BRRegisterSocketStatusCallback(3, on_status)
    library.BRRegisterCommandDataCallback(4, on_command)


def receive_in_a_thread(library, host, port, frames, results):
    connection = library.BRConnectTo(host, port)
    while counts.get(connection, 0) < frames:
        time.sleep(0.001)
    results.append((counts[connection], library.BRGetSocketStatus(connection)))
    library.BRCloseSocket(connection)


def receive(library, port, commands):
    global verbose
    say("sizes", sizeof(BvhDataHeader), sizeof(CalcDataHeader), sizeof(CommandPack), sizeof(BoneDimension))
    register(library)
    say("refused", library.BRConnectTo(b"127.0.0.1", 1), library.BRGetLastErrorMessage().decode())
    connection = library.BRConnectTo(b"127.0.0.1", port)
    say("connected", connection is not None, library.BRGetSocketStatus(connection), library.BRCommandFetchDataFromServer(connection, 5))
    sys.stdin.readline()

    pipe = library.BRConnectCmd(b"127.0.0.1", commands)
    order, size, text = c_int(), BoneDimension(), create_string_buffer(20000)
    say("commands", library.ZeroOut(pipe, 0), library.ZeroOut(pipe, 99), library.GetBvhRotation(pipe, byref(order)), order.value,
          library.GetBoneSize(pipe, 0, byref(size)), size.Head > 0, library.GetBvhHeader(pipe, 0, text, len(text)), text.value[:9].decode(),
          library.GetBvhHeader(None, 0, text, len(text)))

    verbose = False
    results = []
    threads = [threading.Thread(target=receive_in_a_thread, args=(library, host, port, 50, results)) for host in (b"localhost", b"127.1", b"127.0.1")]
    for thread in threads:
        thread.start()
    say("threads started")
    for thread in threads:
        thread.join()
    say("threads", sorted(results))
    say("ends without closing", library.BRGetSocketStatus(connection))


def wait(library, port):
    # A shell makes programs that it starts in the background ignore SIGINT.
    signal.signal(signal.SIGINT, signal.default_int_handler)
    register(library)
    connection = library.BRConnectTo(b"127.0.0.1", port)
    try:
        while True:
            time.sleep(60)
    except KeyboardInterrupt:
        say("interrupted")
        raise
    finally:
        # Close first: when the interpreter ends, it stops any thread that calls into it, even inside the library.
        library.BRCloseSocket(connection)


sys.stdout.reconfigure(line_buffering=True)
signal.alarm(120)
{"receive": receive, "wait": wait}[sys.argv[2]](load(sys.argv[1]), *map(int, sys.argv[3:]))
