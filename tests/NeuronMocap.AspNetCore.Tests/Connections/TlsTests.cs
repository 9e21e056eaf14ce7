using System.Security.Cryptography.X509Certificates;
using Microsoft.AspNetCore.Hosting;
using NeuronMocap.AspNetCore.Tests.Infrastructure;
using NeuronMocap.Server;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.AspNetCore.Tests.Connections;

// A reader that encrypts, against the TLS of Kestrel.
public sealed class TlsTests
{
    [Fact]
    public async Task Frames_and_requests_pass_through_TLS()
    {
        using X509Certificate2 certificate = Certificates.SelfSigned("stage.example");

        // A client that does not run for seconds loses nothing.
        await using var broadcaster = new Broadcaster(new BroadcasterOptions { Sources = [new SyntheticSource()], Port = null, WaitForClient = true, QueueCapacity = 4096 });
        broadcaster.Start();
        await using WebServer web = await WebServer.StartAsync(listen => listen.UseHttps(certificate).UseNeuronBroadcast(broadcaster));
        await using var reader = new NeuronReader(Options(web, new() { TrustedCertificate = certificate }));
        reader.Start();
        await reader.WaitForFramesAsync(3);
        Assert.Equal((ConnectionState.Receiving, ReceiveThread.Dedicated), (reader.Status.State, reader.Status.ReceiveThread));
        Assert.Equal(1, await reader.DataCommands.GetAvatarCountAsync(TestContext.Current.CancellationToken).Soon());
        Assert.Equal((0, 0), (reader.GetStatistics().Lost, reader.GetStatistics().BytesSkipped));

        await reader.DisposeAsync();
        await Limits.UntilAsync(() => broadcaster.GetStatistics().Clients == 0);
    }

    [Fact]
    public async Task Every_packet_of_a_relay_arrives_through_TLS()
    {
        using X509Certificate2 certificate = Certificates.SelfSigned("localhost");
        using var server = new TestServer();
        await using var source = new NeuronReader(server.Options());
        await using var relay = new Broadcaster(new BroadcasterOptions { Reader = source, Port = null, QueueCapacity = 1024 });
        relay.Start();
        source.Start();
        using TestConnection motion = await server.AcceptAsync();
        await using WebServer web = await WebServer.StartAsync(listen => listen.UseHttps(certificate).UseNeuronBroadcast(relay));
        await using var reader = new NeuronReader(Options(web, new() { TrustedCertificate = certificate }));
        var packets = new List<byte[]>();
        reader.MotionReceived += frame => packets.Add(frame.Packet.ToArray());
        reader.Start();
        await Limits.UntilAsync(() => relay.GetStatistics().Clients == 1);
        await motion.SendAsync(TestPackets.Motions(1, 500));
        await reader.WaitForFramesAsync(500);
        Assert.Equal(TestPackets.Motions(1, 500), packets.SelectMany(static packet => packet));

        // The server ends first, which is an ordinary end.
        await source.DisposeAsync();
        await reader.Completion.Soon();
        Assert.Equal((ConnectionState.Stopped, ConnectionReason.ClosedByPeer), (reader.Status.State, reader.Status.Reason));
    }

    [Fact]
    public async Task Calculation_data_has_an_encrypted_port_of_its_own()
    {
        using X509Certificate2 certificate = Certificates.SelfSigned("localhost");
        await using var broadcaster = new Broadcaster(new BroadcasterOptions { Sources = [new SyntheticSource()], Calculation = CalculationSynthesizer.Write, Port = null, CalculationPort = 0 });
        broadcaster.Start();
        await using WebServer motion = await WebServer.StartAsync(listen => listen.UseHttps(certificate).UseNeuronBroadcast(broadcaster));
        await using WebServer calculation = await WebServer.StartAsync(listen => listen.UseHttps(certificate).UseNeuronBroadcast(broadcaster, calculation: true));
        NeuronReaderOptions options = Options(motion, new() { TrustedCertificate = certificate });
        options.CalculationPort = calculation.Port;
        await using var reader = new NeuronReader(options);
        reader.Start();
        await Limits.UntilAsync(() => reader.GetStatistics() is { MotionFrames: > 2, CalculationFrames: > 2 });
        Assert.Equal((2, 1), (broadcaster.GetStatistics().Clients, broadcaster.GetStatistics().CalculationClients));
    }

    [Fact]
    public async Task A_broadcaster_without_separate_calculation_data_is_refused()
    {
        await using Broadcaster broadcaster = Start();
        await Assert.ThrowsAsync<ArgumentException>("calculation", () => WebServer.StartAsync(listen => listen.UseNeuronBroadcast(broadcaster, calculation: true)));
    }

    [Theory]
    [InlineData("localhost", null)]
    [InlineData("stage.example", "stage.example")]
    public async Task A_certificate_of_a_trusted_authority_needs_the_right_name(string name, string? target)
    {
        using X509Certificate2 authority = Certificates.Authority();
        using X509Certificate2 certificate = Certificates.SignedBy(authority, name);
        await using Broadcaster broadcaster = Start();
        await using WebServer web = await WebServer.StartAsync(listen => listen.UseHttps(certificate).UseNeuronBroadcast(broadcaster));
        await using var reader = new NeuronReader(Options(web, new() { TrustedCertificate = authority, TargetHost = target }, "localhost"));
        reader.Start();
        await reader.WaitForFramesAsync(1);

        string message = await FailAsync(Options(web, new() { TrustedCertificate = authority, TargetHost = "other.example" }, "localhost"), ConnectionReason.CertificateRejected);
        Assert.Equal($"The certificate of localhost:{web.Port} is for another name: {name}. Connect by that name, or set Tls.TargetHost to it.", message);
    }

    [Fact]
    public async Task A_certificate_that_nobody_trusts_is_rejected_with_the_reason()
    {
        using X509Certificate2 authority = Certificates.Authority();
        using X509Certificate2 other = Certificates.Authority();
        using X509Certificate2 signed = Certificates.SignedBy(authority, "localhost");
        using X509Certificate2 self = Certificates.SelfSigned("localhost");
        await using Broadcaster broadcaster = Start();
        await using WebServer web = await WebServer.StartAsync(listen => listen.UseHttps(signed).UseNeuronBroadcast(broadcaster));
        await using WebServer selfSigned = await WebServer.StartAsync(listen => listen.UseHttps(self).UseNeuronBroadcast(broadcaster));

        Assert.Equal(
            $"The certificate of localhost:{web.Port} was issued by Studio authority, which this computer does not trust. If it is yours, set Tls.TrustedCertificate.",
            await FailAsync(Options(web, new(), "localhost"), ConnectionReason.CertificateRejected));
        Assert.Contains(
            "was issued by Studio authority", await FailAsync(Options(web, new() { TrustedCertificate = other }, "localhost"), ConnectionReason.CertificateRejected), StringComparison.Ordinal);
        Assert.Equal(
            $"The certificate of localhost:{selfSigned.Port} is self-signed, and this computer does not trust it. If it is yours, set Tls.TrustedCertificate.",
            await FailAsync(Options(selfSigned, new(), "localhost"), ConnectionReason.CertificateRejected));
    }

    [Fact]
    public async Task An_old_certificate_is_rejected_even_if_it_is_the_trusted_one()
    {
        using X509Certificate2 certificate = Certificates.SelfSigned("localhost", new DateTimeOffset(2024, 5, 6, 12, 0, 0, TimeSpan.Zero));
        await using Broadcaster broadcaster = Start();
        await using WebServer web = await WebServer.StartAsync(listen => listen.UseHttps(certificate).UseNeuronBroadcast(broadcaster));
        Assert.Equal(
            $"The certificate of localhost:{web.Port} expired on 2024-05-06. Renew it on the server, or check the clock of this computer.",
            await FailAsync(Options(web, new() { TrustedCertificate = certificate }, "localhost"), ConnectionReason.CertificateRejected));
    }

    [Fact]
    public async Task A_server_without_TLS_is_named_as_such()
    {
        using var server = new TestServer();
        NeuronReaderOptions options = server.Options();
        options.Tls = new NeuronTlsOptions();
        Task<string> failing = FailAsync(options, ConnectionReason.TlsFailed);
        using TestConnection connection = await server.AcceptAsync();
        await connection.SendAsync(TestPackets.Motions(1, 3));
        Assert.StartsWith($"127.0.0.1:{server.Port} does not speak TLS", await failing, StringComparison.Ordinal);

        // One that says nothing.
        options.ConnectTimeout = TimeSpan.FromSeconds(2);
        failing = FailAsync(options, ConnectionReason.TimedOut);
        using TestConnection silent = await server.AcceptAsync();
        Assert.StartsWith($"127.0.0.1:{server.Port} did not answer with TLS within 2 s.", await failing, StringComparison.Ordinal);

        // And one that closes at once.
        options.ConnectTimeout = Limits.Unexpected;
        failing = FailAsync(options, ConnectionReason.TlsFailed);
        using (TestConnection closing = await server.AcceptAsync())
            closing.Close();

        Assert.StartsWith($"127.0.0.1:{server.Port} does not speak TLS", await failing, StringComparison.Ordinal);
    }

    [Fact]
    public async Task Nothing_that_listens_is_refused_as_without_TLS()
    {
        var options = new NeuronReaderOptions { Port = FreePort.Next(), Tls = new NeuronTlsOptions() };
        Assert.Equal(
            $"127.0.0.1:{options.Port} refused the connection: nothing listens there. Check the address and the port of the server.", await FailAsync(options, ConnectionReason.Refused));
    }

    [Fact]
    public async Task A_reader_connects_again_when_the_server_is_back()
    {
        using X509Certificate2 certificate = Certificates.SelfSigned("localhost");
        await using Broadcaster broadcaster = Start();
        int port = FreePort.Next();
        NeuronReaderOptions options;
        await using (WebServer web = await WebServer.StartAsync(listen => listen.UseHttps(certificate).UseNeuronBroadcast(broadcaster), port: port))
            options = Options(web, new() { TrustedCertificate = certificate });

        options.Reconnect = new ReconnectPolicy { InitialDelay = TimeSpan.FromMilliseconds(1), MaxDelay = TimeSpan.FromMilliseconds(5) };
        await using var reader = new NeuronReader(options);
        reader.Start();
        await Limits.UntilAsync(() => reader.Status.Reason == ConnectionReason.Refused);
        await using WebServer again = await WebServer.StartAsync(listen => listen.UseHttps(certificate).UseNeuronBroadcast(broadcaster), port: port);
        await reader.WaitForFramesAsync(1);
    }

    [Fact]
    public void Wrong_options_are_named()
    {
        Assert.StartsWith("Tls is set and Transport is Udp; TLS needs TCP.", Fault(new() { Transport = TransportKind.Udp, Tls = new() }), StringComparison.Ordinal);
        Assert.StartsWith("Tls.TargetHost is empty", Fault(new() { Tls = new() { TargetHost = " " } }), StringComparison.Ordinal);

        static string Fault(NeuronReaderOptions options) => Assert.Throws<ArgumentException>(() => new NeuronReader(options)).Message;
    }

    [Fact]
    public void An_address_can_ask_for_TLS()
    {
        var options = NeuronReaderOptions.Parse(" TLS://stage:7443/");
        Assert.Equal(("stage", 7443), (options.Host, options.Port));
        Assert.NotNull(options.Tls);
        Assert.Null(NeuronReaderOptions.Parse("stage:7443").Tls);
        Assert.StartsWith("'tls://' is not an address.", Assert.Throws<FormatException>(() => NeuronReaderOptions.Parse("tls://")).Message, StringComparison.Ordinal);
        Assert.StartsWith("'x' in 'tls://stage:x' is not a port.", Assert.Throws<FormatException>(() => NeuronReaderOptions.Parse("tls://stage:x")).Message, StringComparison.Ordinal);
    }

    private static Broadcaster Start()
    {
        var broadcaster = new Broadcaster(new BroadcasterOptions { Sources = [new SyntheticSource()], Port = null, WaitForClient = true });
        broadcaster.Start();
        return broadcaster;
    }

    private static NeuronReaderOptions Options(WebServer web, NeuronTlsOptions tls, string host = "127.0.0.1") =>
        new() { Host = host, Port = web.Port, Tls = tls, ConnectTimeout = Limits.Unexpected, SilenceTimeout = Limits.Unexpected, Reconnect = { Enabled = false } };

    private static async Task<string> FailAsync(NeuronReaderOptions options, ConnectionReason reason)
    {
        options.Reconnect = new ReconnectPolicy { Enabled = false };
        await using var reader = new NeuronReader(options);
        NeuronConnectionException exception = await Assert.ThrowsAsync<NeuronConnectionException>(() => reader.StartAsync(TestContext.Current.CancellationToken).Soon());
        Assert.Equal(reason, exception.Reason);
        return exception.Message;
    }
}
