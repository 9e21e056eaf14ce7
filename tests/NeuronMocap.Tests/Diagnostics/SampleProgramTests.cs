using System.Net;
using NeuronMocap.Diagnostics;
using NeuronMocap.Reader;

namespace NeuronMocap.Tests.Diagnostics;

public sealed class SampleProgramTests
{
    [Fact]
    public void The_sample_program_keeps_other_options()
    {
        var options = new NeuronReaderOptions { LocalAddress = IPAddress.Loopback, AllowedSenders = [IPAddress.Parse("192.168.1.20")], SharePort = true, RotationOrder = RotationOrder.XYZ };
        string code = SampleProgram.For(options, new StreamEndpoint(TransportKind.Udp, "studio", 7012), PacketKind.Calculation);
        Assert.Equal(
            """
            await using var reader = new NeuronReader(new NeuronReaderOptions { Transport = TransportKind.Udp, Port = 7012, LocalAddress = System.Net.IPAddress.Parse("127.0.0.1"), AllowedSenders = [System.Net.IPAddress.Parse("192.168.1.20")], SharePort = true, RotationOrder = RotationOrder.XYZ });
            await foreach (var frame in reader.ReadCalculationAsync())
                Console.WriteLine(frame.AvatarName);
            """,
            code);
    }

    [Theory]
    [InlineData(null, "Tls = new NeuronTlsOptions()")]
    [InlineData("studio.example", "Tls = new NeuronTlsOptions { TargetHost = \"studio.example\" }")]
    public void An_encrypted_server_stays_encrypted(string? name, string expected)
    {
        var options = new NeuronReaderOptions { Tls = new NeuronTlsOptions { TargetHost = name } };
        string code = SampleProgram.For(options, new StreamEndpoint(TransportKind.Tcp, "studio", 7001), PacketKind.Motion);
        Assert.Contains($"Host = \"studio\", Port = 7001, {expected} }});", code, StringComparison.Ordinal);
    }

    [Fact]
    public void A_plain_server_uses_the_short_form()
    {
        string code = SampleProgram.For(new NeuronReaderOptions(), new StreamEndpoint(TransportKind.Tcp, "studio", 7003), PacketKind.Motion);
        Assert.StartsWith("await using var reader = new NeuronReader(\"studio\", 7003);", code, StringComparison.Ordinal);
    }
}
