namespace NeuronMocap.Compatibility.Callbacks;

// The registered callbacks of one of the two namespaces. The methods call them, and throw what they throw.
internal interface IVendorCallbacks
{
    // The layout of the headers that OnFrame is given, in whatever layout frames came: one struct then fits every frame.
    HeaderLayout FrameHeaders { get; }

    bool WantsFrames { get; }

    bool WantsCalculation { get; }

    bool WantsCommands { get; }

    void OnFrame(IntPtr socket, IntPtr header, IntPtr data);

    void OnCalculation(IntPtr socket, IntPtr header, IntPtr data);

    void OnStatus(IntPtr socket, SocketState status, string message);

    void OnCommand(IntPtr socket, IntPtr header, IntPtr data);
}

// The vendor's SocketStatus, which exists once in each namespace; the numbers are the same.
internal enum SocketState
{
    Running,
    Starting,
    OffWork,
}
