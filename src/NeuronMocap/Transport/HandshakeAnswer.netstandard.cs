using System.Diagnostics.CodeAnalysis;
using System.Net.WebSockets;

namespace NeuronMocap.Transport;

// On this target the status is only part of the text of the exception.
[SuppressMessage("Style", "IDE0060", Justification = "The parameters are those of the other target.")]
internal static class HandshakeAnswer
{
    public static int? Of(ClientWebSocket socket) => null;

    public static void Collect(ClientWebSocket socket)
    {
    }
}
