using System.Net;
using NeuronMocap.Diagnostics;
using NeuronMocap.Reader;

namespace NeuronMocap.Tests.Diagnostics;

public sealed class SampleProgramTests
{
    [Fact]
    public void The_sample_program_keeps_other_options()
    {
        var options = new NeuronReaderOptions { LocalAddress = IPAddress.Loopback, SharePort = true, RotationOrder = RotationOrder.XYZ };
        string code = SampleProgram.For(options, new StreamEndpoint(TransportKind.Udp, "studio", 7012), PacketKind.Calculation);
        Assert.Equal(
            """
            await using var reader = new NeuronReader(new NeuronReaderOptions { Transport = TransportKind.Udp, Port = 7012, LocalAddress = IPAddress.Parse("127.0.0.1"), SharePort = true, RotationOrder = RotationOrder.XYZ });
            await foreach (var frame in reader.ReadCalculationAsync())
                Console.WriteLine(frame.AvatarName);
            """,
            code);
    }

    [Fact]
    public void A_plain_server_uses_the_short_form()
    {
        string code = SampleProgram.For(new NeuronReaderOptions(), new StreamEndpoint(TransportKind.Tcp, "studio", 7003), PacketKind.Motion);
        Assert.StartsWith("await using var reader = new NeuronReader(\"studio\", 7003);", code, StringComparison.Ordinal);
    }
}
