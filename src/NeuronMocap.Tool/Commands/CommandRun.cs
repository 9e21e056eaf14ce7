using System.Text;
using NeuronMocap.Commands;
using NeuronMocap.Skeleton;
using NeuronMocap.Tool.Arguments;
using NeuronMocap.Tool.Files;
using NeuronMocap.Tool.Output;
using NeuronMocap.Tool.Terminal;
using NeuronMocap.Tool.Watch;

namespace NeuronMocap.Tool.Commands;

/// <summary>--commands: asks a server's command channel, and prints what it says.</summary>
internal sealed class CommandRun(MonitorOptions options, CommandSettings settings, StandardStreams streams)
{
    public async Task<int> RunAsync(CancellationToken cancelled)
    {
        try
        {
            using DemoServer? demo = settings.Server is null ? DemoServer.Start(options.RotationOrder ?? RotationOrder.YXZ) : null;
            ServerAddress server = settings.Server ?? demo!.OpenCommands();
            await using var client = new NeuronCommandClient(server.Host, server.Port);
            byte[] output = Encoding.UTF8.GetBytes(await AskAsync(client, server, cancelled));
            await streams.Output.WriteAsync(output, CancellationToken.None);
            await streams.Output.FlushAsync(CancellationToken.None);
            return CommandLine.Done;
        }
        catch (NeuronException exception)
        {
            return await FailAsync(OptionNames.Translate(exception.Message));
        }
        catch (OperationCanceledException)
        {
            return CommandLine.Interrupted;
        }
        catch (IOException exception)
        {
            // Whoever reads the output may leave when he has seen enough.
            return MonitorOutput.IsBrokenPipe(exception)
                ? CommandLine.Done
                : await FailAsync(FileFault.OfStandardOutput(exception));
        }
    }

    private async Task<string> AskAsync(NeuronCommandClient client, ServerAddress server, CancellationToken cancelled)
    {
        bool isJson = options.Output == OutputKind.Json;
        if (settings.ZeroOut is { } target)
        {
            await (target.Avatar is { } avatar ? client.ZeroOutAsync(avatar, cancelled) : client.ZeroOutAllAsync(cancelled));
            return isJson ? CommandJson.ZeroOut(server, target) : CommandText.ZeroOut(server, target);
        }

        if (settings.WholeHeader)
        {
            string text = await client.GetBvhHeaderTextAsync(settings.Avatar, cancelled);
            return streams.IsTerminal ? CleanLines(text) : text;
        }

        RotationOrder order = await client.GetRotationOrderAsync(cancelled);
        BoneDimensions sizes = await client.GetBoneDimensionsAsync(settings.Avatar, cancelled);
        string header = await client.GetBvhHeaderTextAsync(settings.Avatar, cancelled);
        return isJson
            ? CommandJson.Report(server, settings.Avatar, order, sizes, header)
            : CommandText.Report(server, settings.Avatar, order, sizes, header);
    }

    // A file or a program gets the header as it is; a terminal obeys what is in it.
    private static string CleanLines(string text) =>
        string.Join('\n', text.Replace("\t", "    ", StringComparison.Ordinal).Split('\n').Select(static line => TerminalText.Clean(line.TrimEnd('\r'))));

    private async Task<int> FailAsync(string message)
    {
        await streams.Error.WriteLineAsync($"neuron-mocap: --commands: {TerminalText.Clean(message)}");
        return CommandLine.NothingReceived;
    }
}
