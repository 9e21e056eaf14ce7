using NeuronMocap.Skeleton;
using NeuronMocap.Tool.Files;
using NeuronMocap.Tool.Terminal;
using NeuronMocap.Tool.View.Performers;

namespace NeuronMocap.Tool.View.Takes;

/// <summary>Reads the file of a take once, from start to end, into its performers. Its thread is the only one that adds to the take.</summary>
/// <param name="take">The take.</param>
/// <param name="folder">The folder for temporary files.</param>
/// <param name="room">The room for these files; null for as much as the disk has.</param>
internal sealed class TakeReading(Take take, string folder, TakeRoom? room = null)
{
    private static readonly TimeSpan FlushInterval = TimeSpan.FromMilliseconds(200);

    private readonly List<PerformerWriter> _writers = [];
    private long _flushed = Environment.TickCount64;

    /// <summary>Reads the whole file. Faults become problems of the take.</summary>
    public void Run()
    {
        try
        {
            Read();
        }
        catch (OperationCanceledException)
        {
            return;
        }
        catch (ObjectDisposedException) when (take.Closed.IsCancellationRequested)
        {
            return;
        }
        catch (Exception exception)
        {
            take.AddProblem(FileFault.OfReading(exception, take.Name));
        }

        // Pages ask until a take is complete.
        try
        {
            Complete();
        }
        finally
        {
            take.Report(1);
        }
    }

    /// <summary>Adds a performer.</summary>
    public PerformerWriter Open(AvatarName name, PerformerKey source, SkeletonBody body)
    {
        var writer = new PerformerWriter(size => new RecordFile(folder, size, room), $"{take.Id}-{_writers.Count}", _writers.Count, name, source, body);
        take.Add(writer.Performer);
        _writers.Add(writer);
        return writer;
    }

    /// <summary>Reports progress, and now and then makes what was read visible.</summary>
    /// <exception cref="OperationCanceledException">The take was closed.</exception>
    public void Report(double progress)
    {
        take.Closed.ThrowIfCancellationRequested();
        if (Environment.TickCount64 - _flushed < FlushInterval.TotalMilliseconds)
            return;

        take.Report(progress);
        _writers.ForEach(static writer => writer.Flush());
        _flushed = Environment.TickCount64;
    }

    public void AddProblem(string sentence) => take.AddProblem(sentence);

    private void Read()
    {
        switch (take.Kind)
        {
            case FileKind.Bvh:
                BvhTakeFile.Read(take.Path, this);
                break;
            case FileKind.Calculation:
                CalculationTakeFile.Read(take.Path, this);
                break;
            default:
                new StreamTakeFile(take.Path, take.RotationOrder, this).Read(take.Kind == FileKind.Recording);
                break;
        }
    }

    private void Complete()
    {
        foreach (PerformerWriter writer in _writers)
        {
            Finish(writer);
            Describe(writer);
        }

        if (take.Problems.IsEmpty && take.Duration == TimeSpan.Zero && take.Performers.All(static performer => performer.Frames == 0))
            take.AddProblem("The file holds no frames.");
    }

    private void Finish(PerformerWriter writer)
    {
        try
        {
            writer.Finish();
        }
        catch (IOException exception)
        {
            if (!take.Problems.Contains(exception.Message, StringComparer.Ordinal))
                take.AddProblem(exception.Message);
        }
        catch (ObjectDisposedException)
        {
            // The take was closed.
        }
    }

    private void Describe(PerformerWriter writer)
    {
        string name = _writers.Count > 1 ? $" of {writer.Performer.Name}" : "";
        if (writer.LeftOut > 0)
            take.AddProblem($"{Quantity.Count(writer.LeftOut, "frame")}{name} left out: values that are not numbers.");
        if (writer.Late > 0)
            take.AddProblem($"{Quantity.Count(writer.Late, "frame")}{name} left out: received twice, or after a later frame.");
    }
}
