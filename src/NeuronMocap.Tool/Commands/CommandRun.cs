using System.Text;
using NeuronMocap.Commands;
using NeuronMocap.Server;
using NeuronMocap.Tool.Arguments;
using NeuronMocap.Tool.Files;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Commands;

/// <summary>Sends commands to a server's command channel and prints the answers.</summary>
internal sealed class CommandRun(CommandSettings settings, StandardStreams streams)
{
    public async Task<int> RunAsync(CancellationToken cancellationToken)
    {
        try
        {
            using Broadcaster? demo = settings.Server is null ? Broadcaster.StartDemo() : null;
            using CommandServer? demoCommands = demo is null ? null : new CommandServer(demo, new CommandServerOptions { Port = 0 });
            demoCommands?.Start();
            ServerAddress server = settings.Server ?? ServerAddress.Of(demoCommands!.LocalEndPoint!);
            await using var client = new NeuronCommandClient(
                new NeuronCommandOptions { Host = server.Host, Port = server.Port, LocalAddress = settings.LocalAddress });
            if (settings.Question == CommandQuestion.ZeroOut)
                await ZeroOutAsync(client, server, cancellationToken);
            else
                Write(await AskAsync(client, server, cancellationToken));

            return ToolCommand.Done;
        }
        catch (NeuronException exception)
        {
            return await FailAsync(OptionNames.Translate(exception.Message));
        }
        catch (OperationCanceledException)
        {
            return ToolCommand.Interrupted;
        }
        catch (IOException exception)
        {
            // The program that reads the output may close it at any time.
            return StandardStreams.IsBrokenPipe(exception)
                ? ToolCommand.Done
                : await FailAsync(FileFault.OfStandardOutput(exception));
        }
    }

    private async Task ZeroOutAsync(NeuronCommandClient client, ServerAddress server, CancellationToken cancellationToken)
    {
        await (settings.Avatar is { } avatar ? client.ZeroOutAsync(avatar, cancellationToken) : client.ZeroOutAllAsync(cancellationToken));
        if (settings.Json)
            WriteText(CommandJson.ZeroOut(server, settings.Avatar));
        else
            new CommandPage(streams).ZeroOut(server, settings.Avatar);
    }

    private async Task<CommandResults> AskAsync(NeuronCommandClient client, ServerAddress server, CancellationToken cancellationToken)
    {
        var results = new CommandResults(server, settings.Avatar ?? 0);
        if (settings.Question is CommandQuestion.All or CommandQuestion.Order)
            results = results with { Order = await client.GetRotationOrderAsync(cancellationToken) };
        if (settings.Question is CommandQuestion.All or CommandQuestion.Bones)
            results = results with { Sizes = await client.GetBoneDimensionsAsync(results.Avatar, cancellationToken) };
        if (settings.Question is CommandQuestion.All or CommandQuestion.Header)
            results = results with { Header = await client.GetBvhHeaderTextAsync(results.Avatar, cancellationToken) };

        return results;
    }

    private void Write(CommandResults results)
    {
        if (settings.Json)
            WriteText(CommandJson.Report(results));
        else if (settings.Question == CommandQuestion.Header)
            WriteText(streams.IsTerminal ? CleanLines(results.Header!) : results.Header!);
        else if (settings.Question == CommandQuestion.Order)
            WriteText($"{results.Order}\n");
        else
            new CommandPage(streams).Report(results);
    }

    private void WriteText(string text)
    {
        streams.Output.Write(Encoding.UTF8.GetBytes(text));
        streams.Output.Flush();
    }

    // A file or a program gets the header unchanged. A terminal would execute its control characters.
    private static string CleanLines(string text) =>
        string.Join('\n', text.Replace("\t", "    ", StringComparison.Ordinal).Split('\n').Select(static line => TerminalText.Clean(line.TrimEnd('\r'))));

    private async Task<int> FailAsync(string message)
    {
        await streams.ComplainAsync(message);
        return ToolCommand.NothingReceived;
    }
}
