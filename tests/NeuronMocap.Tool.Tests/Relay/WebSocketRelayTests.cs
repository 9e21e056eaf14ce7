using System.Net;
using System.Net.Sockets;
using System.Security.Cryptography;
using System.Security.Cryptography.X509Certificates;
using System.Text;
using Microsoft.AspNetCore.Builder;
using Microsoft.AspNetCore.Hosting;
using NeuronMocap.Server;
using NeuronMocap.Tests.Network;
using NeuronMocap.Tool.Terminal;
using NeuronMocap.Tool.Tests.Files;
using NeuronMocap.Tool.Tests.Infrastructure;

namespace NeuronMocap.Tool.Tests.Relay;

// ws:// as a destination and as a source, and tls:// as a source.
public sealed class WebSocketRelayTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public async Task A_relay_serves_watch_and_another_relay_over_WebSockets()
    {
        using var output = new MemoryStream();
        using var error = new StringWriter();
        using var streams = new StandardStreams(output, error, IsTerminal: false);
        using var stop = CancellationTokenSource.CreateLinkedTokenSource(TestContext.Current.CancellationToken);
        string address = $"ws://127.0.0.1:{FreePort.Next()}";
        Task<int> relay = CommandLine.RunAsync(["relay", "demo", address, "--token", "word"], streams, stop.Token);

        ToolResult watch = await ToolRunner.RunAsync("watch", $"{address}?token=word", "--json", "--frames", "20");
        Assert.Equal(0, watch.ExitCode);
        Assert.Equal(20, watch.OfType("frame").Length);
        Assert.Contains($"\"source\":\"{address}\"", watch.Output[0], StringComparison.Ordinal);
        Assert.DoesNotContain(watch.Output, static line => line.Contains("word", StringComparison.Ordinal));
        Assert.Contains("\"skippedBytes\":0,", watch.Output[^1], StringComparison.Ordinal);

        string[] copy = ["relay", $"{address}?token=word", _folder["copy.nmrec"], "--overwrite", "--duration"];
        ToolResult second = await ToolRunner.RunAsync([.. copy, "1"]);

        // On a busy computer, no frame may arrive in a second.
        if (second.ExitCode != 0)
            second = await ToolRunner.RunAsync([.. copy, "30"]);

        Assert.Equal(0, second.ExitCode);
        Assert.NotEmpty(RelayRunTests.ReadBytes(_folder["copy.nmrec"]));

        ToolResult refused = await ToolRunner.RunAsync("watch", $"{address}?token=other", "--once", "--quiet");
        Assert.Equal(1, refused.ExitCode);
        Assert.Equal($"neuron-mocap: Opening {address} failed: The token is wrong.", Assert.Single(refused.Error).TrimEnd());

        await stop.CancelAsync();
        Assert.Equal(0, await relay.Soon());
        string text = Encoding.UTF8.GetString(output.ToArray());
        Assert.Contains($"Listening on {address}\n", text, StringComparison.Ordinal);
        Assert.Contains($"\n{address}: ", text, StringComparison.Ordinal);
        Assert.Empty(error.ToString());
    }

    [Fact]
    public async Task An_open_port_without_a_token_is_mentioned()
    {
        // On a busy computer, no frame may arrive in this time.
        ToolResult result = await ToolRunner.RunAsync("relay", "demo", "ws://0.0.0.0:0", "ws://:0", "--duration", "0.5");
        Assert.Contains(result.Output, static line => line.StartsWith("Listening on ws://0.0.0.0:", StringComparison.Ordinal) && line.EndsWith(": anybody who reaches this port may connect; --token WORD limits it", StringComparison.Ordinal));
        Assert.Contains(result.Output, static line => line.StartsWith("Listening on ws://127.0.0.1:", StringComparison.Ordinal) && !line.Contains("anybody", StringComparison.Ordinal));
    }

    [Fact]
    public async Task A_port_in_use_is_one_line_that_names_the_destination()
    {
        using var other = new TcpListener(IPAddress.Loopback, 0);
        other.Start();
        ToolResult result = await ToolRunner.RunAsync("relay", "demo", $"ws://{other.LocalEndpoint}");
        Assert.Equal(1, result.ExitCode);
        Assert.StartsWith($"neuron-mocap: ws://{other.LocalEndpoint}: port {((IPEndPoint)other.LocalEndpoint).Port} on 127.0.0.1 is in use", Assert.Single(result.Error), StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("--token needs a destination ws://:PORT", "relay", "demo", "tcp://:0", "--token", "word")]
    [InlineData("--allow-origin needs a destination ws://:PORT", "relay", "demo", "tcp://:0", "--allow-origin", "*")]
    [InlineData("--allow-origin: 'show.example' is not an origin.", "relay", "demo", "ws://:0", "--allow-origin", "show.example")]
    [InlineData("--token: the word is empty", "relay", "demo", "ws://:0", "--token", "")]
    [InlineData("--token: the word is empty, or has a line break or spaces around it.", "relay", "demo", "ws://:0", "--token", "word ")]
    [InlineData("--tls-name: the name is empty. Give the name in the server's certificate, or leave the option out.", "watch", "tls://studio:1", "--tls-name", "")]
    [InlineData("'tls://' is not an address.", "watch", "tls://")]
    [InlineData("'ws://studio' has no port to listen on. Use ws://:PORT", "relay", "demo", "ws://studio")]
    [InlineData("A destination ws:// listens on an address of this computer; without one, on 127.0.0.1.", "relay", "demo", "ws://studio:7100")]
    [InlineData("tcp://:7001 and ws://:7001 need different ports.", "relay", "demo", "tcp://:7001", "ws://:7001")]
    [InlineData("ws://:7001 and ws://127.0.0.1:7001 are the same destination.", "relay", "demo", "ws://:7001", "ws://127.0.0.1:7001")]
    [InlineData("--commands and ws://:8013 need different ports.", "relay", "studio", "ws://:8013", "--commands", "tcp://:8013")]
    [InlineData("would send the source ws://localhost:7100 to itself.", "relay", "ws://localhost:7100", "ws://:7100")]
    [InlineData("--trust needs a source tls://HOST:PORT", "watch", "studio", "--tls-name", "x", "--trust", "README.md")]
    [InlineData("--trust: there is no file 'missing.pem'.", "watch", "tls://studio:1", "--trust", "missing.pem")]
    [InlineData("--command-port needs a source HOST or tcp://HOST:PORT", "watch", "ws://studio:7100", "--command-port", "8013")]
    public async Task A_contradiction_is_one_line(string expected, params string[] args)
    {
        if (args.Contains("README.md", StringComparer.Ordinal))
            args[Array.IndexOf(args, "README.md")] = WriteCertificate(CreateCertificate());

        ToolResult result = await ToolRunner.RunAsync(args);
        Assert.Equal(2, result.ExitCode);
        Assert.Contains(expected, Assert.Single(result.Error), StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_file_that_is_no_certificate_is_named()
    {
        _folder.Write("note.txt", "no certificate");
        ToolResult result = await ToolRunner.RunAsync("watch", "tls://studio:1", "--trust", _folder["note.txt"]);
        Assert.Equal(2, result.ExitCode);
        Assert.Contains("note.txt' is not a certificate in PEM or DER form.", Assert.Single(result.Error), StringComparison.Ordinal);
    }

    [Fact]
    public async Task An_encrypted_stream_needs_a_certificate_that_is_trusted()
    {
        using X509Certificate2 certificate = CreateCertificate();
        await using Broadcaster broadcaster = new(new BroadcasterOptions { Sources = [new SyntheticSource()], Port = null });
        broadcaster.Start();
        WebApplicationBuilder builder = WebApplication.CreateEmptyBuilder(new WebApplicationOptions());
        builder.WebHost.UseKestrelCore().UseKestrelHttpsConfiguration()
            .ConfigureKestrel(kestrel => kestrel.Listen(IPAddress.Loopback, 0, listen => listen.UseHttps(certificate).UseNeuronBroadcast(broadcaster)));
        await using WebApplication application = builder.Build();
        await application.StartAsync(TestContext.Current.CancellationToken).Soon();
        string source = $"tls://127.0.0.1:{new Uri(application.Urls.Single()).Port}";

        ToolResult trusted = await ToolRunner.RunAsync("watch", source, "--trust", WriteCertificate(certificate), "--quiet", "--frames", "5");
        Assert.Equal((0, string.Empty), (trusted.ExitCode, string.Join('\n', trusted.Error)));
        Assert.Contains("\"frames\":5,", Assert.Single(trusted.Output), StringComparison.Ordinal);

        ToolResult unknown = await ToolRunner.RunAsync("watch", source, "--once", "--json");
        Assert.Equal(1, unknown.ExitCode);
        Assert.Equal(
            $"neuron-mocap: The certificate of {source[6..]} is self-signed, and this computer does not trust it. If it is yours, set --trust.", Assert.Single(unknown.Error).TrimEnd());
        Assert.Contains(unknown.OfType("status"), static line => line.Contains("\"reason\":\"certificate-rejected\"", StringComparison.Ordinal));

        ToolResult diagnosis = await ToolRunner.RunAsync("diagnose", source, "--trust", WriteCertificate(certificate), "--duration", "10");
        Assert.Equal(0, diagnosis.ExitCode);
        Assert.Contains(diagnosis.Output, line => line.StartsWith($"Looking for frames from {source[6..]} over TLS.", StringComparison.Ordinal));
    }

    private string WriteCertificate(X509Certificate2 certificate)
    {
        _folder.Write("server.pem", certificate.ExportCertificatePem());
        return _folder["server.pem"];
    }

    private static X509Certificate2 CreateCertificate()
    {
        using var key = ECDsa.Create(ECCurve.NamedCurves.nistP256);
        using X509Certificate2 certificate = new CertificateRequest("CN=stage.example", key, HashAlgorithmName.SHA256)
            .CreateSelfSigned(DateTimeOffset.UtcNow.AddDays(-1), DateTimeOffset.UtcNow.AddYears(1));
        return X509CertificateLoader.LoadPkcs12(certificate.Export(X509ContentType.Pkcs12), password: null);
    }
}
