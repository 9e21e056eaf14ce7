using NeuronMocap.Compatibility;

namespace NeuronDataReaderWraper;

/// <summary>
/// The functions of the vendor's C# wrappers of b10 to b15 and of the Unity integration, on top of NeuronMocap.
/// </summary>
/// <remarks>
/// The page docs/reference/compatibility.md lists the differences from the vendor's library. All functions are thread-safe and may be called from
/// callbacks. They do not throw.
/// <para>
/// There is one callback of each kind. It can be registered, replaced and, with null, unregistered at any time. The change takes effect at the next
/// call. Registered callbacks are kept alive; you do not need a field for the delegate.
/// </para>
/// <para>The other namespace has its own callbacks and behaves as a second library.</para>
/// </remarks>
public partial class NeuronDataReader
{
    /// <summary>The registered callback of BVH frames. You may set it or add to it. It receives the object of the last registration.</summary>
    public static FrameDataReceived? frameDataReceivedCallback;

    /// <summary>The registered callback of status changes. You may set it or add to it. It receives the object of the last registration.</summary>
    public static SocketStatusChanged? socketStatusChangedCallback;

    private static readonly RegisteredCallbacks Callbacks = new();
    private static readonly VendorFunctions Functions = new(Callbacks);

    /// <summary>Registers the callback of BVH frames (manual section 2.3.1).</summary>
    /// <param name="customedObj">The object to pass to the callback.</param>
    /// <param name="handle">The callback, or null for none.</param>
    public static void BRRegisterFrameDataCallback(IntPtr customedObj, FrameDataReceived? handle) =>
        Callbacks.SetFrame(customedObj, handle);

    /// <summary>Registers the callback of calculation frames (manual section 2.3.2). It has its own object.</summary>
    /// <param name="customedObj">The object to pass to the callback.</param>
    /// <param name="handle">The callback, or null for none.</param>
    public static void BRRegisterCalculationDataCallback(IntPtr customedObj, FrameDataReceived? handle) =>
        Callbacks.SetCalculation(customedObj, handle);

    /// <summary>Registers the callback of status changes (manual section 2.3.3).</summary>
    /// <param name="customedObj">The object to pass to the callback.</param>
    /// <param name="handle">The callback, or null for none.</param>
    public static void BRRegisterSocketStatusCallback(IntPtr customedObj, SocketStatusChanged? handle) =>
        Callbacks.SetStatus(customedObj, handle);

    /// <summary>Registers the callback of answers to commands on the data connection (protocol.md section 7).</summary>
    /// <param name="customedObj">The object to pass to the callback.</param>
    /// <param name="handle">The callback, or null for none.</param>
    public static void BRRegisterCommandDataCallback(IntPtr customedObj, CommandDataReceived? handle) =>
        Callbacks.SetCommand(customedObj, handle);

    /// <summary>Connects to a server over TCP (manual section 2.3.4). Returns when the connection is open, or after about 5 s.</summary>
    /// <param name="serverIP">Address or name of the server.</param>
    /// <param name="nPort">Port of the server.</param>
    /// <returns>
    /// The connection, or an existing open connection to the same address and port. Zero on failure; <see cref="strBRGetLastErrorMessage"/> then
    /// gives the reason.
    /// </returns>
    public static IntPtr BRConnectTo(string serverIP, int nPort) => Functions.Connect(serverIP, nPort);

    /// <summary>Starts to receive over UDP (manual section 2.3.5). Other programs that share the port can receive on it, too.</summary>
    /// <param name="nPort">The port to receive on.</param>
    /// <returns>
    /// The service; every call starts a new one. Zero on failure; <see cref="strBRGetLastErrorMessage"/> then gives the reason.
    /// </returns>
    public static IntPtr BRStartUDPServiceAt(int nPort) => Functions.StartUdpService(nPort);

    /// <summary>Gets the status of a connection or service (manual section 2.3.7).</summary>
    /// <param name="sockRef">A handle.</param>
    /// <returns>
    /// The status. It is <see cref="SocketStatus.CS_OffWork"/> for zero, for a closed handle, and after the server has ended the connection.
    /// </returns>
    public static SocketStatus BRGetSocketStatus(IntPtr sockRef) => (SocketStatus)VendorFunctions.GetStatus(sockRef);

    /// <summary>Closes a connection or service (manual section 2.3.6). After it returns, no callback starts for the handle.</summary>
    /// <remarks>
    /// It waits at most 75 ms for a running callback, because the callback may wait for the thread that closes. The memory that such a callback
    /// received stays valid until the callback ends. Closing zero or a closed handle does nothing.
    /// </remarks>
    /// <param name="sockRef">A handle.</param>
    public static void BRCloseSocket(IntPtr sockRef) => VendorFunctions.Close(sockRef);

    /// <summary>Gets the last error as C text: UTF-8, with a zero byte at the end (manual section 2.3.8).</summary>
    /// <remarks>
    /// The memory is always the same and is never freed. The next error overwrites it. <see cref="strBRGetLastErrorMessage"/> returns the same text
    /// as a string.
    /// </remarks>
    /// <returns>A pointer, never zero.</returns>
    public static IntPtr BRGetLastErrorMessage() => LastError.Pointer;

    /// <summary>Gets the last error of the process. It is "No error." at first, and a success does not clear it.</summary>
    /// <returns>The text.</returns>
    public static string strBRGetLastErrorMessage() => LastError.Text;
}
