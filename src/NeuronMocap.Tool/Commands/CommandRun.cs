using System.Text;
using NeuronMocap.Commands;
using NeuronMocap.Server;
using NeuronMocap.Tool.Arguments;
using NeuronMocap.Tool.Files;
using NeuronMocap.Tool.Output;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Commands;

/// <summary>Asks a server's command channel, and prints what it says.</summary>
internal sealed class CommandRun(CommandSettings settings, StandardStreams streams)
{
    public async Task<int> RunAsync(CancellationToken cancelled)
    {
        try
        {
            using Broadcaster? demo = settings.Server is null ? Broadcaster.StartDemo() : null;
            using CommandServer? demoCommands = demo is null ? null : new CommandServer(demo, new CommandServerOptions { Port = 0 });
            demoCommands?.Start();
            ServerAddress server = settings.Server ?? ServerAddress.Of(demoCommands!.LocalEndPoint!);
            await using var client = new NeuronCommandClient(server.Host, server.Port);
            if (settings.Question == CommandQuestion.ZeroOut)
                await ZeroOutAsync(client, server, cancelled);
            else
                Write(await AskAsync(client, server, cancelled));

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
            return WatchOutput.IsBrokenPipe(exception)
                ? CommandLine.Done
                : await FailAsync(FileFault.OfStandardOutput(exception));
        }
    }

    private async Task ZeroOutAsync(NeuronCommandClient client, ServerAddress server, CancellationToken cancelled)
    {
        await (settings.Avatar is { } avatar ? client.ZeroOutAsync(avatar, cancelled) : client.ZeroOutAllAsync(cancelled));
        if (settings.Json)
            WriteText(CommandJson.ZeroOut(server, settings.Avatar));
        else
            new CommandPage(streams).ZeroOut(server, settings.Avatar);
    }

    private async Task<CommandAnswers> AskAsync(NeuronCommandClient client, ServerAddress server, CancellationToken cancelled)
    {
        var answers = new CommandAnswers(server, settings.Avatar ?? 0);
        if (settings.Question is CommandQuestion.All or CommandQuestion.Order)
            answers = answers with { Order = await client.GetRotationOrderAsync(cancelled) };
        if (settings.Question is CommandQuestion.All or CommandQuestion.Bones)
            answers = answers with { Sizes = await client.GetBoneDimensionsAsync(answers.Avatar, cancelled) };
        if (settings.Question is CommandQuestion.All or CommandQuestion.Header)
            answers = answers with { Header = await client.GetBvhHeaderTextAsync(answers.Avatar, cancelled) };

        return answers;
    }

    private void Write(CommandAnswers answers)
    {
        if (settings.Json)
            WriteText(CommandJson.Report(answers));
        else if (settings.Question == CommandQuestion.Header)
            WriteText(streams.IsTerminal ? CleanLines(answers.Header!) : answers.Header!);
        else if (settings.Question == CommandQuestion.Order)
            WriteText($"{answers.Order}\n");
        else
            new CommandPage(streams).Report(answers);
    }

    private void WriteText(string text)
    {
        streams.Output.Write(Encoding.UTF8.GetBytes(text));
        streams.Output.Flush();
    }

    // A file or a program gets the header as it is; a terminal obeys what is in it.
    private static string CleanLines(string text) =>
        string.Join('\n', text.Replace("\t", "    ", StringComparison.Ordinal).Split('\n').Select(static line => TerminalText.Clean(line.TrimEnd('\r'))));

    private async Task<int> FailAsync(string message)
    {
        await streams.ComplainAsync(message);
        return CommandLine.NothingReceived;
    }
}
