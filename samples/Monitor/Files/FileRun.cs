using NeuronMocap.Monitor.Output;

namespace NeuronMocap.Monitor.Files;

/// <summary>--info, --convert and --plot: one run of a tool for files.</summary>
internal sealed class FileRun(FileSettings settings, StandardStreams streams)
{
    public async Task<int> RunAsync(CancellationToken cancelled)
    {
        try
        {
            await Task.Run(() => Run(cancelled), CancellationToken.None);
            return CommandLine.Done;
        }
        catch (OperationCanceledException)
        {
            return CommandLine.Interrupted;
        }
        catch (Exception exception) when (exception is NeuronException or UnauthorizedAccessException)
        {
            return await FailAsync(exception.Message);
        }
        catch (IOException exception)
        {
            // Whoever reads the output may leave when he has seen enough.
            return MonitorOutput.IsBrokenPipe(exception) ? CommandLine.Done : await FailAsync(exception.Message);
        }
    }

    private void Run(CancellationToken cancelled)
    {
        switch (settings.Task)
        {
            case FileTask.Info:
                new InfoTool(settings, streams).Run(cancelled);
                break;
            case FileTask.Plot:
                new PlotTool(settings, streams).Run(cancelled);
                break;
            default:
                new ConvertTool(settings, streams).Run(cancelled);
                break;
        }
    }

    private async Task<int> FailAsync(string message)
    {
        await streams.Error.WriteLineAsync($"neuron-monitor: {TerminalText.Clean(message)}");
        return CommandLine.NothingReceived;
    }
}
