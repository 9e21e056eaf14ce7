using System.Net;
using System.Net.Sockets;

namespace NeuronMocap.Server.Tests.Osc;

/// <summary>A UDP port of loopback that receives bundles.</summary>
internal sealed class PoseReceiver : IDisposable
{
    private readonly Socket _socket = new(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp) { ReceiveBufferSize = 4_000_000 };
    private readonly byte[] _buffer = new byte[65_536];

    public PoseReceiver() => _socket.Bind(new IPEndPoint(IPAddress.Loopback, 0));

    public int Port => ((IPEndPoint)_socket.LocalEndPoint!).Port;

    /// <summary>Number of bytes that wait.</summary>
    public int Available => _socket.Available;

    public void Dispose() => _socket.Dispose();

    /// <summary>Receives the messages of one frame, up to its last message.</summary>
    public async Task<List<OscMessage>> ReceiveFrameAsync()
    {
        List<OscMessage> messages = [];
        do
        {
            int length = await _socket.ReceiveAsync(_buffer.AsMemory(), TestContext.Current.CancellationToken).Soon();
            messages.AddRange(OscMessage.ReadBundle(_buffer[..length]));
        }
        while (messages[^1].Address is not "/VMC/Ext/T" && !messages[^1].Address.EndsWith("/frame", StringComparison.Ordinal));
        return messages;
    }

    public async Task<VmcModel> ReceiveModelAsync()
    {
        var model = new VmcModel();
        foreach (OscMessage message in await ReceiveFrameAsync())
            model.Receive(message);

        return model;
    }
}
