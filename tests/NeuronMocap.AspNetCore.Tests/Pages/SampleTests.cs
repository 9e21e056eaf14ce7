using System.Globalization;
using System.Net.WebSockets;
using System.Security.Cryptography.X509Certificates;
using NeuronMocap.AspNetCore.Tests.Infrastructure;
using NeuronMocap.Tool.Tests.Infrastructure;

namespace NeuronMocap.AspNetCore.Tests.Pages;

public sealed class SampleTests
{
    [Fact]
    public async Task The_web_server_serves_browsers_and_encrypted_readers()
    {
        using var program = new ToolProcess("WebServer", "--web", "0", "--tls", "0");
        Task<string> error = program.ReadErrorAsync();
        int web = await FindPortAsync(program, "http://127.0.0.1:");
        int tls = await FindPortAsync(program, "https://0.0.0.0:");
        Task<string> rest = program.Output.ReadToEndAsync(TestContext.Current.CancellationToken);

        using var browser = new ClientWebSocket();
        await browser.ConnectAsync(new Uri($"ws://127.0.0.1:{web}"), TestContext.Current.CancellationToken).Soon();
        Assert.Equal("skeleton", (await browser.ReadJsonAsync()).GetProperty("type").GetString());

        // Where the program runs, which is here.
        using X509Certificate2 certificate = X509CertificateLoader.LoadCertificateFromFile("server.pem");
        await using var reader = new NeuronReader(new NeuronReaderOptions { Port = tls, Tls = new() { TrustedCertificate = certificate } });
        var arrived = new TaskCompletionSource<string>(TaskCreationOptions.RunContinuationsAsynchronously);
        reader.MotionReceived += frame => arrived.TrySetResult(frame.AvatarName);
        reader.Start();
        Assert.Equal("Demo", await arrived.Task.Soon());
        program.Kill();
        Assert.Empty(await error);
        Assert.DoesNotContain("fail:", await rest, StringComparison.Ordinal);
    }

    [Fact]
    public async Task The_web_server_names_a_source_that_is_no_address()
    {
        using var program = new ToolProcess("WebServer", "--source", "no address", "--web", "0", "--tls", "0");
        Task<string> output = program.Output.ReadToEndAsync(TestContext.Current.CancellationToken);
        string error = await program.ReadErrorAsync();
        await output;

        Assert.Equal(2, await program.WaitForExitAsync());
        Assert.Contains("'no address' is not an address", error, StringComparison.Ordinal);
    }

    private static async Task<int> FindPortAsync(ToolProcess program, string address)
    {
        while (await program.Output.ReadLineAsync(TestContext.Current.CancellationToken).AsTask().Soon() is { } line)
        {
            int start = line.IndexOf(address, StringComparison.Ordinal);
            if (start >= 0)
                return int.Parse(line.AsSpan(start + address.Length), CultureInfo.InvariantCulture);
        }

        throw new InvalidOperationException($"The sample does not listen on {address}.");
    }
}
