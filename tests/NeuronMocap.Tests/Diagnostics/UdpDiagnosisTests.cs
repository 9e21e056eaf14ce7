using System.Net;
using System.Net.Sockets;
using NeuronMocap.Diagnostics;
using NeuronMocap.Tests.Network;
using NeuronMocap.Transport;

namespace NeuronMocap.Tests.Diagnostics;

public sealed class UdpDiagnosisTests
{
    private readonly int _port = FreePort.Next();

    [Fact]
    public async Task Split_frames_are_joined_and_their_sender_is_named()
    {
        using var sender = new DatagramSender();
        StreamDiagnosis diagnosis = await sender.SendUntilAsync(RunAsync(Diagnosing.Patient), _port, static i => Halves(TestPackets.Motion(i)));

        Assert.True(diagnosis.IsReceiving);
        Assert.Contains($"{sender.EndPoint}", diagnosis.Step("first bytes").Detail, StringComparison.Ordinal);
        Assert.Contains("up to 1024 bytes", diagnosis.Step("first bytes").Detail, StringComparison.Ordinal);
        Assert.Contains($"Transport = TransportKind.Udp, Port = {_port}", diagnosis.SampleCode, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_small_receive_buffer_is_a_warning()
    {
        StreamDiagnosis diagnosis = await RunAsync(Diagnosing.Silent);
        Assert.Contains("KiB of datagrams", diagnosis.Step("buffer").Detail, StringComparison.Ordinal);

        StepLog log = new(progress: null);
        ReceiveBufferStep.Add(log, 4 * 1024 * 1024);
        ReceiveBufferStep.Add(log, 212_992);
        ReceiveBufferStep.Add(log, granted: null);
        Assert.Equal([StepOutcome.Ok, StepOutcome.Warning], log.Steps.Select(static step => step.Outcome));
        Assert.Contains("keeps 208 KiB of datagrams until they are read, of the requested 4096 KiB", log.Steps[1].Detail, StringComparison.Ordinal);
        Assert.EndsWith("sysctl -w net.core.rmem_max=4194304", ReceiveBufferStep.Describe(212_992, "net.core.rmem_max=4194304"), StringComparison.Ordinal);
        Assert.DoesNotContain("sysctl", ReceiveBufferStep.Describe(212_992, setting: null), StringComparison.Ordinal);
        Assert.Equal(OperatingSystem.IsLinux(), UdpSocket.BufferSetting?.StartsWith("net.core.rmem_max", StringComparison.Ordinal) ?? false);
    }

    [Fact]
    public async Task First_halves_alone_are_reported_as_cut()
    {
        using var sender = new DatagramSender();
        StreamDiagnosis diagnosis = await sender.SendUntilAsync(
            RunAsync(Diagnosing.Patient with { OtherPorts = 0.002 }), _port, static i => Halves(TestPackets.Motion(i)).Take(1));
        diagnosis.AssertFault(DiagnosisVerdict.IncompletePackets, "format", "choose TCP", "Displacement");
    }

    [Fact]
    public async Task Two_senders_are_reported()
    {
        using var sender = new DatagramSender();
        using var other = new DatagramSender();

        // A busy machine may delay one of the senders.
        Task<StreamDiagnosis> diagnosing = RunAsync(Diagnosing.Patient with { Measuring = 0.03 });
        Task<StreamDiagnosis> both = other.SendUntilAsync(diagnosing, _port, static i => [TestPackets.Motion(i)]);
        StreamDiagnosis diagnosis = await sender.SendUntilAsync(both, _port, static i => [TestPackets.Motion(i)]);

        Assert.True(diagnosis.IsReceiving);
        Assert.Contains(DiagnosisVerdict.SeveralSenders, diagnosis.Verdicts);
    }

    [Fact]
    public async Task Blocked_senders_are_named()
    {
        using var sender = new DatagramSender();
        var options = new NeuronReaderOptions { Transport = TransportKind.Udp, Port = _port, AllowedSenders = [IPAddress.Parse("192.0.2.1")] };

        // Long enough for a datagram on a busy machine.
        DiagnosisOptions how = Diagnosing.With(Diagnosing.Silent with { Silence = 0.03 });
        StreamDiagnosis diagnosis = await sender.SendUntilAsync(
            Diagnosing.RunAsync(options, how), _port, static i => [TestPackets.Motion(i)]);
        diagnosis.AssertFault(DiagnosisVerdict.SenderNotAllowed, "first bytes", "127.0.0.1", "AllowedSenders");
    }

    [Fact]
    public async Task Silence_names_the_destination_and_the_firewall()
    {
        StreamDiagnosis diagnosis = await RunAsync(Diagnosing.Silent);
        diagnosis.AssertFault(DiagnosisVerdict.Silent, "first bytes", "Destination Address", $":{_port}", "firewall", "choose UDP");
    }

    [Fact]
    public async Task A_port_in_use_is_reported()
    {
        using var socket = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
        socket.Bind(new IPEndPoint(IPAddress.Any, 0));
        int port = ((IPEndPoint)socket.LocalEndPoint!).Port;
        StreamDiagnosis diagnosis = await Diagnosing.RunAsync(
            new NeuronReaderOptions { Transport = TransportKind.Udp, Port = port }, Diagnosing.With(Diagnosing.Silent));
        diagnosis.AssertFault(DiagnosisVerdict.PortInUse, "port", $"UDP port {port}", "Close that program");
    }

    [Fact]
    public async Task A_foreign_local_address_is_reported()
    {
        var options = new NeuronReaderOptions { Transport = TransportKind.Udp, Port = _port, LocalAddress = IPAddress.Parse("192.0.2.77") };
        StreamDiagnosis diagnosis = await Diagnosing.RunAsync(options, Diagnosing.With(Diagnosing.Silent));
        diagnosis.AssertFault(DiagnosisVerdict.LocalAddressUnavailable, "port", "192.0.2.77");
    }

    // Datagrams to other addresses of this computer do not arrive.
    [Fact]
    public async Task With_a_local_address_only_that_one_is_named()
    {
        var options = new NeuronReaderOptions { Transport = TransportKind.Udp, Port = _port, LocalAddress = IPAddress.Loopback };
        StreamDiagnosis diagnosis = await Diagnosing.RunAsync(options, Diagnosing.With(Diagnosing.Silent));
        Assert.Equal("only programs on this computer can send here, to 127.0.0.1", diagnosis.Step("route").Detail);
        diagnosis.AssertFault(DiagnosisVerdict.Silent, "first bytes", $"Destination Address to 127.0.0.1:{_port}", $"A server on this computer sends to 127.0.0.1:{_port}.");
        foreach (IPAddress other in LocalNetwork.ReachableAddresses())
            Assert.DoesNotContain($"{other}", diagnosis.Summary, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_TCP_server_is_found()
    {
        using ScriptedServer server = ScriptedServer.Streaming();
        DiagnosisOptions how = Diagnosing.With(Diagnosing.Patient with { Silence = 0.002 });
        how.UsualTcpPorts = [server.Port];
        StreamDiagnosis diagnosis = await Diagnosing.RunAsync(new NeuronReaderOptions { Transport = TransportKind.Udp, Port = _port }, how);

        diagnosis.AssertFault(DiagnosisVerdict.OfferedOverTcp, "first bytes", $"TCP port {server.Port}", "choose UDP on the server");
        Assert.DoesNotContain("TransportKind.Udp", diagnosis.SampleCode, StringComparison.Ordinal);
    }

    [Fact]
    public async Task Datagrams_on_another_usual_port_are_found()
    {
        using var sender = new DatagramSender();
        int other = FreePort.Next();
        DiagnosisOptions how = Diagnosing.With(Diagnosing.Patient with { Silence = 0.002 });
        how.UsualUdpPorts = [other];
        var options = new NeuronReaderOptions { Transport = TransportKind.Udp, Port = _port };
        StreamDiagnosis diagnosis = await sender.SendUntilAsync(Diagnosing.RunAsync(options, how), other, static i => [TestPackets.Motion(i)]);

        diagnosis.AssertFault(DiagnosisVerdict.OtherPort, "first bytes", $"Use port {other} here");
        Assert.Contains($"Port = {other}", diagnosis.SampleCode, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_shared_port_keeps_its_datagrams()
    {
        using var socket = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
        socket.SetSocketOption(SocketOptionLevel.Socket, SocketOptionName.ReuseAddress, optionValue: true);
        socket.Bind(new IPEndPoint(IPAddress.Any, 0));
        int port = ((IPEndPoint)socket.LocalEndPoint!).Port;
        DiagnosisOptions how = Diagnosing.With(Diagnosing.Silent);
        how.UsualUdpPorts = [port];
        StreamDiagnosis diagnosis =
            await Diagnosing.RunAsync(new NeuronReaderOptions { Transport = TransportKind.Udp, Port = _port, SharePort = true }, how);
        Assert.Contains($"in use by another program: {port}", diagnosis.Step("other ports").Detail, StringComparison.Ordinal);
    }

    // Both receive more than the system buffers, before they look.
    [Fact]
    public async Task A_diagnosis_uses_the_readers_receive_buffer()
    {
        var options = new LinkOptions("127.0.0.1", 0) { LocalAddress = IPAddress.Loopback };
        using var link = new UdpLink(options, new SenderFilter([]));
        var ofReader = new StreamSample(PacketKind.Calculation);
        await link.OpenAsync(CancellationToken.None).Soon();
        int port = ((IPEndPoint)link.LocalEndPoint!).Port;
        long waiting = await CountWaitingAsync(port, ofReader, () => link.ReceiveAsync(ofReader, listener: null), link.Close);

        var ofDiagnosis = new StreamSample(PacketKind.Calculation);
        using var listener = new UdpListener(options, new SenderFilter([]), ofDiagnosis);
        Assert.Equal(ConnectionReason.None, listener.Open());
        long found = await CountWaitingAsync(listener.Port, ofDiagnosis, listener.ReceiveAsync, listener.Dispose);
        Assert.InRange(found, waiting * 9 / 10, waiting * 11 / 10);
    }

    // The sample ends with the first calculation frame, which nothing overtakes.
    private static async Task<long> CountWaitingAsync(int port, StreamSample sample, Func<Task> receive, Action close)
    {
        using var sender = new DatagramSender();
        using var socket = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
        for (int i = 0; i < 5000; i++)
            socket.SendTo(TestPackets.Motion(i), new IPEndPoint(IPAddress.Loopback, port));

        Task receiving = receive();
        async Task<bool> IsEmptyAsync()
        {
            await sample.WantedFrame;
            return true;
        }

        await sender.SendUntilAsync(IsEmptyAsync(), port, static i => [TestPackets.Calculation(i)]);
        close();
        await receiving.Soon();
        return sample.Avatars.Single(static avatar => avatar.Kind == PacketKind.Motion).Frames;
    }

    private static byte[][] Halves(byte[] packet) => [packet[..1024], packet[1024..]];

    private Task<StreamDiagnosis> RunAsync(DiagnosisBudget budget) =>
        Diagnosing.RunAsync(new NeuronReaderOptions { Transport = TransportKind.Udp, Port = _port }, Diagnosing.With(budget));
}
