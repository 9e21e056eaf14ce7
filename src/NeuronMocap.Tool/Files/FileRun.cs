using NeuronMocap.Tool.Convert;
using NeuronMocap.Tool.Info;
using NeuronMocap.Tool.Output;
using NeuronMocap.Tool.Plot;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Files;

/// <summary>One run of info, convert or plot.</summary>
internal sealed class FileRun(FileSettings settings, StandardStreams streams)
{
    // For work that looks whether it shall end; what does not, as a read from a disk that hangs, is left behind.
    private static readonly TimeSpan StopTimeout = TimeSpan.FromSeconds(2);

    public async Task<int> RunAsync(CancellationToken cancellationToken)
    {
        using OutputFile? output = settings.Output is { } path ? new OutputFile(path, settings.Overwrite) : null;
        try
        {
            Task work = Task.Run(() => Run(output, cancellationToken), CancellationToken.None);
            await Task.WhenAny(work, WaitForEndAsync(cancellationToken));
            if (!work.IsCompleted)
            {
                ProgressLine.Abandon(streams);
                return CommandLine.Interrupted;
            }

            await work;
            return CommandLine.Done;
        }
        catch (OperationCanceledException)
        {
            return CommandLine.Interrupted;
        }
        catch (Exception exception) when (exception is NeuronException or UnauthorizedAccessException or NotSupportedException)
        {
            return await FailAsync(FileFault.OfReading(exception, settings.Input));
        }
        catch (OutOfMemoryException)
        {
            return await FailAsync($"'{settings.Input}' is too large for the memory of this computer.");
        }
        catch (IOException exception)
        {
            // Whoever reads the output may leave when he has seen enough.
            return WatchOutput.IsBrokenPipe(exception) ? CommandLine.Done : await FailAsync(Describe(exception));
        }
    }

    // The input is read, and the page of info is all that goes to standard output; a file that is written has told its own fault.
    private string Describe(IOException exception) => settings.Task == FileTask.Info && FileFault.IsDiskFull(exception)
        ? FileFault.OfStandardOutput(exception)
        : FileFault.OfReading(exception, settings.Input);

    private static async Task WaitForEndAsync(CancellationToken cancellationToken)
    {
        await Task.Delay(Timeout.Infinite, cancellationToken).ConfigureAwait(ConfigureAwaitOptions.SuppressThrowing);
        await Task.Delay(StopTimeout, CancellationToken.None);
    }

    private void Run(OutputFile? output, CancellationToken cancellationToken)
    {
        switch (settings.Task)
        {
            case FileTask.Info:
                new InfoTool(settings, streams).Run(cancellationToken);
                break;
            case FileTask.Plot:
                new PlotTool(settings, streams).Run(output!, cancellationToken);
                break;
            default:
                new ConvertTool(settings, streams).Run(output!, cancellationToken);
                break;
        }
    }

    private async Task<int> FailAsync(string message)
    {
        await streams.ComplainAsync(message);
        return CommandLine.NothingReceived;
    }
}
