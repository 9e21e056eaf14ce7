using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Files;

/// <summary>One run of info, convert or plot.</summary>
internal sealed class FileRun(FileSettings settings, StandardStreams streams)
{
    // Time-out for work that checks for cancellation. Work that does not, such as a read from a disk that hangs, is abandoned.
    private static readonly TimeSpan StopTimeout = TimeSpan.FromSeconds(2);

    /// <summary>Receives the sentence about a file that cannot be read or written, after it was shown; null for nobody.</summary>
    public Action<string>? Failed { get; init; }

    /// <summary>Runs the work on another thread, and reports its faults.</summary>
    /// <param name="work">The work. It receives the file to write; null if there is none.</param>
    /// <param name="cancellationToken">Cancelled by Ctrl+C and by anything else that ends the program.</param>
    /// <returns>The exit code.</returns>
    public async Task<int> RunAsync(Action<OutputFile?, CancellationToken> work, CancellationToken cancellationToken)
    {
        using OutputFile? output = settings.Output is { } path ? new OutputFile(path, settings.Overwrite) : null;
        try
        {
            Task task = Task.Run(() => work(output, cancellationToken), CancellationToken.None);
            await Task.WhenAny(task, WaitForEndAsync(cancellationToken));
            if (!task.IsCompleted)
            {
                ProgressLine.Abandon(streams);
                return ToolCommand.Interrupted;
            }

            await task;
            return ToolCommand.Done;
        }
        catch (OperationCanceledException)
        {
            return ToolCommand.Interrupted;
        }
        catch (NeuronException exception)
        {
            return await FailAsync(FileFault.WithName(FileFault.OfReading(exception, settings.Input), settings.Input));
        }
        catch (Exception exception) when (exception is UnauthorizedAccessException or NotSupportedException)
        {
            return await FailAsync(FileFault.OfReading(exception, settings.Input));
        }
        catch (OutOfMemoryException)
        {
            return await FailAsync($"'{settings.Input}' is too large for the memory of this computer.");
        }
        catch (IOException exception) when (StandardStreams.IsBrokenPipe(exception))
        {
            // The program that reads the output may close it at any time.
            return ToolCommand.Done;
        }
        catch (IOException exception) when (settings.Output is null && FileFault.IsDiskFull(exception))
        {
            // A run without a file writes to standard output.
            await streams.ComplainAsync(FileFault.OfStandardOutput(exception));
            return ToolCommand.NothingReceived;
        }
        catch (IOException exception)
        {
            // A file that is written has already described its own fault.
            return await FailAsync(FileFault.OfReading(exception, settings.Input));
        }
    }

    private static async Task WaitForEndAsync(CancellationToken cancellationToken)
    {
        await Task.Delay(Timeout.Infinite, cancellationToken).ConfigureAwait(ConfigureAwaitOptions.SuppressThrowing);
        await Task.Delay(StopTimeout, CancellationToken.None);
    }

    private async Task<int> FailAsync(string message)
    {
        await streams.ComplainAsync(message);
        Failed?.Invoke(message);
        return ToolCommand.NothingReceived;
    }
}
