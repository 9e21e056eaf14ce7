using System.Runtime.InteropServices;

namespace NeuronDataReaderWraper;

/// <summary>Represents a callback that receives every frame of BVH or calculation data.</summary>
/// <remarks>
/// It is called on the receive thread of the connection. Callbacks of two connections may run at the same time. Exceptions of the callback go to
/// <see cref="NeuronMocap.Compatibility.CompatibilityEvents.CallbackFailed"/>.
/// </remarks>
/// <param name="customObject">The object that was registered with the callback.</param>
/// <param name="sockRef">The connection or service.</param>
/// <param name="header">Pointer to a <see cref="BvhDataHeader"/> or a <see cref="CalcDataHeader"/>, valid during the call.</param>
/// <param name="data">Pointer to the floats of the frame, valid during the call. DataCount in the header gives their number.</param>
[UnmanagedFunctionPointer(CallingConvention.StdCall)]
public delegate void FrameDataReceived(IntPtr customObject, IntPtr sockRef, IntPtr header, IntPtr data);

/// <summary>Represents a callback that receives status changes of TCP data connections.</summary>
/// <remarks>
/// The thread that connects or closes calls it. When the server ends the connection, a thread of the connection calls it. UDP services and command
/// connections do not call it.
/// </remarks>
/// <param name="customObject">The object that was registered with the callback.</param>
/// <param name="sockRef">The connection. While it is being opened, this is already the handle that BRConnectTo will return.</param>
/// <param name="status">The status.</param>
/// <param name="msg">A message in the vendor's words.</param>
[UnmanagedFunctionPointer(CallingConvention.StdCall)]
public delegate void SocketStatusChanged(
    IntPtr customObject, IntPtr sockRef, SocketStatus status, [MarshalAs(UnmanagedType.LPStr)] string msg);

/// <summary>Represents a callback that receives answers to commands on the data connection, on its receive thread.</summary>
/// <param name="customedObj">The object that was registered with the callback.</param>
/// <param name="sockRef">The connection.</param>
/// <param name="cmdHeader">Pointer to a <see cref="CommandPack"/>, valid during the call.</param>
/// <param name="cmdData">Pointer to the data after the header, valid during the call. Zero if nothing follows the header.</param>
[UnmanagedFunctionPointer(CallingConvention.StdCall)]
public delegate void CommandDataReceived(IntPtr customedObj, IntPtr sockRef, IntPtr cmdHeader, IntPtr cmdData);
