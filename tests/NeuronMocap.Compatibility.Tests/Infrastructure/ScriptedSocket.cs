using NeuronMocap.Compatibility.Callbacks;
using NeuronMocap.Compatibility.Sockets;

namespace NeuronMocap.Compatibility.Tests.Infrastructure;

/// <summary>A socket of the table that a test controls. The table treats sockets with the same name as equal.</summary>
internal sealed class ScriptedSocket(string name) : VendorSocket
{
    public Action? Opening { get; init; }

    public Action? Releasing { get; init; }

    public Action? AskingForState { get; set; }

    public int Released { get; private set; }

    public override SocketState State
    {
        get
        {
            AskingForState?.Invoke();
            return base.State;
        }
    }

    public override bool IsTo(VendorSocket other) => other is ScriptedSocket scripted && scripted.Name == Name;

    protected override bool TryOpen()
    {
        Opening?.Invoke();
        SetOpen();
        return true;
    }

    protected override void BeginRelease()
    {
        Released++;
        Releasing?.Invoke();
    }

    protected override void WaitUntilReleased()
    {
    }

    private string Name { get; } = name;
}
