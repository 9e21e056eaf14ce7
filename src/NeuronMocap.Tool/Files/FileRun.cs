using NeuronMocap.Tool.Convert;
using NeuronMocap.Tool.Info;
using NeuronMocap.Tool.Output;
using NeuronMocap.Tool.Plot;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Files;

/// <summary>One run of info, convert or plot.</summary>
internal sealed class FileRun(FileSettings settings, StandardStreams streams)
{
    // Time-out for work that checks for cancellation. Work that does not, such as a read from a disk that hangs, is abandoned.
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
            // The program that reads the output may close it at any time.
            return WatchOutput.IsBrokenPipe(exception) ? CommandLine.Done : await FailAsync(Describe(exception));
        }
    }

    // For info, only its page goes to standard output. A file that is written has already described its own fault.
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
