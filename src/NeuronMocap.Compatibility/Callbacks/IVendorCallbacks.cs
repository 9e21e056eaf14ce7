namespace NeuronMocap.Compatibility.Callbacks;

// The registered callbacks of one of the two namespaces. The methods call them and let their exceptions through.
internal interface IVendorCallbacks
{
    // The header layout that OnFrame receives, whatever the layout of the stream. One struct therefore fits every frame.
    HeaderLayout FrameHeaders { get; }

    bool WantsFrames { get; }

    bool WantsCalculation { get; }

    bool WantsCommands { get; }

    void OnFrame(IntPtr socket, IntPtr header, IntPtr data);

    void OnCalculation(IntPtr socket, IntPtr header, IntPtr data);

    void OnStatus(IntPtr socket, SocketState status, string message);

    void OnCommand(IntPtr socket, IntPtr header, IntPtr data);
}

// The vendor's SocketStatus exists once in each namespace, with the same numbers.
internal enum SocketState
{
    Running,
    Starting,
    OffWork,
}
