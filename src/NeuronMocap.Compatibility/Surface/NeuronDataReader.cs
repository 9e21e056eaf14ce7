using NeuronMocap.Compatibility;

namespace NeuronDataReaderWraper;

/// <summary>
/// The functions of the vendor's C# wrappers of b10 to b15 and of the Unity integration, on top of NeuronMocap; docs/reference/compatibility.md lists what behaves otherwise
/// than in the vendor's library. All functions may be called from any thread, callbacks included, and none throws.
/// <para>
/// There is one callback of each kind. It may be registered, replaced and, with null, unregistered at any time, from the next call on.
/// Callbacks are kept alive here; a field for the delegate is not needed. The other namespace has callbacks of its own: it
/// behaves as a second library.
/// </para>
/// </summary>
public partial class NeuronDataReader
{
    /// <summary>The callback of BVH frames, as registered. May be set or added to; the object of the last registration is passed.</summary>
    public static FrameDataReceived? frameDataReceivedCallback;

    /// <summary>The callback of status changes, as registered. May be set or added to; the object of the last registration is passed.</summary>
    public static SocketStatusChanged? socketStatusChangedCallback;

    private static readonly RegisteredCallbacks Callbacks = new();
    private static readonly VendorFunctions Functions = new(Callbacks);

    /// <summary>Registers the callback of BVH frames (manual section 2.3.1).</summary>
    /// <param name="customedObj">Passed to the callback.</param>
    /// <param name="handle">The callback, or null for none.</param>
    public static void BRRegisterFrameDataCallback(IntPtr customedObj, FrameDataReceived? handle) =>
        Callbacks.SetFrame(customedObj, handle);

    /// <summary>Registers the callback of calculation frames (manual section 2.3.2). It gets its own object.</summary>
    /// <param name="customedObj">Passed to the callback.</param>
    /// <param name="handle">The callback, or null for none.</param>
    public static void BRRegisterCalculationDataCallback(IntPtr customedObj, FrameDataReceived? handle) =>
        Callbacks.SetCalculation(customedObj, handle);

    /// <summary>Registers the callback of status changes (manual section 2.3.3).</summary>
    /// <param name="customedObj">Passed to the callback.</param>
    /// <param name="handle">The callback, or null for none.</param>
    public static void BRRegisterSocketStatusCallback(IntPtr customedObj, SocketStatusChanged? handle) =>
        Callbacks.SetStatus(customedObj, handle);

    /// <summary>Registers the callback of answers to commands on the data connection (protocol.md section 7).</summary>
    /// <param name="customedObj">Passed to the callback.</param>
    /// <param name="handle">The callback, or null for none.</param>
    public static void BRRegisterCommandDataCallback(IntPtr customedObj, CommandDataReceived? handle) =>
        Callbacks.SetCommand(customedObj, handle);

    /// <summary>Connects to a server over TCP (manual section 2.3.4) and returns when the connection stands, or after about 5 s.</summary>
    /// <param name="serverIP">The server's address or name.</param>
    /// <param name="nPort">The server's port.</param>
    /// <returns>
    /// The connection, or zero: <see cref="strBRGetLastErrorMessage"/> tells why. Where there is a living connection to the same address and
    /// port, that one.
    /// </returns>
    public static IntPtr BRConnectTo(string serverIP, int nPort) => Functions.Connect(serverIP, nPort);

    /// <summary>Receives over UDP (manual section 2.3.5). The port is shared with other programs that share it.</summary>
    /// <param name="nPort">The port to receive on.</param>
    /// <returns>The service, a new one with every call, or zero: <see cref="strBRGetLastErrorMessage"/> tells why.</returns>
    public static IntPtr BRStartUDPServiceAt(int nPort) => Functions.StartUdpService(nPort);

    /// <summary>Looks at a connection or service (manual section 2.3.7).</summary>
    /// <param name="sockRef">A handle.</param>
    /// <returns><see cref="SocketStatus.CS_OffWork"/> for zero, for what was closed, and once the server has gone.</returns>
    public static SocketStatus BRGetSocketStatus(IntPtr sockRef) => (SocketStatus)VendorFunctions.GetStatus(sockRef);

    /// <summary>
    /// Closes a connection or service (manual section 2.3.6). Once it has returned, no callback for it begins. It waits 75 ms at most for one
    /// that runs, which may wait for the thread that closes; the memory that it was given stays valid until it ends. Zero, and closing again,
    /// do nothing.
    /// </summary>
    /// <param name="sockRef">A handle.</param>
    public static void BRCloseSocket(IntPtr sockRef) => VendorFunctions.Close(sockRef);

    /// <summary>
    /// The last error as C text (manual section 2.3.8): ends with a zero byte, UTF-8. The memory is always the same and is never freed;
    /// the next error overwrites it. <see cref="strBRGetLastErrorMessage"/> is the same as a string.
    /// </summary>
    /// <returns>A pointer, never zero.</returns>
    public static IntPtr BRGetLastErrorMessage() => LastError.Pointer;

    /// <summary>The last error of the process: "No error." at first, and never cleared by a success.</summary>
    /// <returns>The text.</returns>
    public static string strBRGetLastErrorMessage() => LastError.Text;
}
