using System.Runtime.InteropServices;

namespace NeuronDataReaderWraper;

/// <summary>
/// Called with every frame, of BVH or of calculation data, on the receive thread of its connection. Callbacks of two connections may run at
/// the same time. What it throws goes to <see cref="NeuronMocap.Compatibility.CompatibilityEvents.CallbackFailed"/>.
/// </summary>
/// <param name="customObject">The object given with the callback.</param>
/// <param name="sockRef">The connection or service.</param>
/// <param name="header">Points to a <see cref="BvhDataHeader"/> or a <see cref="CalcDataHeader"/>, valid during the call.</param>
/// <param name="data">Points to as many floats as the header's DataCount says, valid during the call.</param>
[UnmanagedFunctionPointer(CallingConvention.StdCall)]
public delegate void FrameDataReceived(IntPtr customObject, IntPtr sockRef, IntPtr header, IntPtr data);

/// <summary>
/// Called with the course of TCP data connections: by the thread that connects or closes, and by one of the connection's when the server
/// ends it. UDP services and command connections do not call it.
/// </summary>
/// <param name="customObject">The object given with the callback.</param>
/// <param name="sockRef">The connection; while it is being made, already the handle that BRConnectTo will return.</param>
/// <param name="status">The status.</param>
/// <param name="msg">What happened, in the vendor's words.</param>
[UnmanagedFunctionPointer(CallingConvention.StdCall)]
public delegate void SocketStatusChanged(
    IntPtr customObject, IntPtr sockRef, SocketStatus status, [MarshalAs(UnmanagedType.LPStr)] string msg);

/// <summary>Called with the answers to commands on the data connection, on its receive thread.</summary>
/// <param name="customedObj">The object given with the callback.</param>
/// <param name="sockRef">The connection.</param>
/// <param name="cmdHeader">Points to a <see cref="CommandPack"/>, valid during the call.</param>
/// <param name="cmdData">Points to what follows the header, valid during the call; zero where nothing does.</param>
[UnmanagedFunctionPointer(CallingConvention.StdCall)]
public delegate void CommandDataReceived(IntPtr customedObj, IntPtr sockRef, IntPtr cmdHeader, IntPtr cmdData);
