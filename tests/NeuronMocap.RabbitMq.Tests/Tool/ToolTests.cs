using System.Text;
using NeuronMocap.RabbitMq.Tests.Infrastructure;
using NeuronMocap.Tests.Network;
using NeuronMocap.Tests.RabbitMq;
using NeuronMocap.Tool;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.RabbitMq.Tests.Tool;

/// <summary>The program neuron-mocap with a broker.</summary>
public sealed class ToolTests(SharedBroker shared)
{
    [Fact]
    public async Task Relay_publishes_a_stage_that_watch_and_record_receive_and_nobody_shows_the_password()
    {
        Broker broker = await shared.GetAsync();
        string address = $"amqp://{Broker.Actor}:{Broker.ActorPassword}@127.0.0.1:{broker.Port}/?stage=tool";
        string folder = Directory.CreateTempSubdirectory().FullName;
        string recording = Path.Combine(folder, "take.nmrec");
        using var stopSource = CancellationTokenSource.CreateLinkedTokenSource(TestContext.Current.CancellationToken);
        Task<(int Code, string Output)> relaying = RunAsync(stopSource.Token, "relay", "demo", address + "&stream=tool");

        (int code, string output) = await RunAsync(TestContext.Current.CancellationToken, "watch", address, "--json", "--frames", "30", "--record", recording).Soon();
        await stopSource.CancelAsync();
        (int relayCode, string relayOutput) = await relaying.Soon();

        Assert.Equal((0, 0), (code, relayCode));
        Assert.Equal(30, output.Split('\n').Count(static line => line.StartsWith("{\"type\":\"frame\"", StringComparison.Ordinal)));
        Assert.Contains($"Publishing to amqp://127.0.0.1:{broker.Port}/?stage=tool&stream=tool\n", relayOutput, StringComparison.Ordinal);
        Assert.Contains(" packets, 0 dropped", relayOutput, StringComparison.Ordinal);
        Assert.DoesNotContain(Broker.ActorPassword, output + relayOutput + Encoding.Latin1.GetString(await File.ReadAllBytesAsync(recording, TestContext.Current.CancellationToken)));
        Directory.Delete(folder, recursive: true);
    }

    [Theory]
    [InlineData("relay", "demo", "ADDRESS")]
    [InlineData("watch", "ADDRESS", "--once")]
    public async Task A_wrong_password_is_one_line(params string[] words)
    {
        Broker broker = await shared.GetAsync();
        string address = $"amqp://{Broker.Actor}:wrong-word@127.0.0.1:{broker.Port}?stage=tool";

        (int code, string output) = await RunAsync(TestContext.Current.CancellationToken, [.. words.Select(word => word.Replace("ADDRESS", address))]).Soon();

        Assert.Equal(1, code);
        Assert.Contains($"The broker 127.0.0.1:{broker.Port} refuses the user '{Broker.Actor}' or the password.", output, StringComparison.Ordinal);
        Assert.DoesNotContain("wrong-word", output);
    }

    [Fact]
    public async Task A_closed_port_is_one_line()
    {
        int port = FreePort.Next();

        (int code, string output) = await RunAsync(TestContext.Current.CancellationToken, "relay", "demo", $"amqp://127.0.0.1:{port}").Soon();

        Assert.Equal(1, code);
        Assert.Equal(
            $"neuron-mocap: amqp://127.0.0.1:{port}/?stage=main: 127.0.0.1:{port} refused the connection: no broker listens there.", output.Trim());
    }

    private static async Task<(int Code, string Output)> RunAsync(CancellationToken cancellationToken, params string[] args)
    {
        using var output = new MemoryStream();
        using var error = new StringWriter();
        using var streams = new StandardStreams(output, error, IsTerminal: false);
        int code = await Task.Run(() => CommandLine.RunAsync(args, streams, cancellationToken), TestContext.Current.CancellationToken);
        return (code, Encoding.UTF8.GetString(output.ToArray()) + error);
    }
}
