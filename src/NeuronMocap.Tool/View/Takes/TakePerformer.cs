using System.Collections.Immutable;
using System.Runtime.InteropServices;
using NeuronMocap.Skeleton;
using NeuronMocap.Tool.View.Performers;

namespace NeuronMocap.Tool.View.Takes;

/// <summary>One performer of a take, ready for access by frame: poses and summaries are in temporary files. Thread-safe for reading.</summary>
internal sealed class TakePerformer : IDisposable
{
    /// <summary>Values in the summary of a block: lowest and highest of each quantity of each bone.</summary>
    public const int SummaryValues = BoneHierarchy.BoneCount * FrameMeter.Quantities * 2;

    private readonly ContactFinder _contacts;
    private double _rate = double.NaN;

    public TakePerformer(string key, int index, string name, PerformerKey source, SkeletonBody body, RecordFile poses, RecordFile summaries, TakeTimes times, ContactFinder contacts)
    {
        (Key, Index, Name, Source, Body) = (key, index, name, source, body);
        (Poses, Summaries, Times, _contacts) = (poses, summaries, times, contacts);
    }

    /// <summary>Identifies the performer among those of all takes.</summary>
    public string Key { get; }

    /// <summary>Number of the performer in the take, from 0.</summary>
    public int Index { get; }

    /// <summary>Name of the avatar, in its first frame.</summary>
    public string Name { get; }

    /// <summary>Numbers of the sender and the avatar in the file.</summary>
    public PerformerKey Source { get; }

    public SkeletonBody Body { get; }

    /// <summary>The compact poses of all frames, all of one size. Their times are relative to the start of the take.</summary>
    public RecordFile Poses { get; }

    /// <summary>The lowest and highest values in each block of frames.</summary>
    public RecordFile Summaries { get; }

    public TakeTimes Times { get; }

    /// <summary>Frames per second; null if the times do not give a rate.</summary>
    public double? Rate
    {
        get => Volatile.Read(ref _rate) is var rate && double.IsNaN(rate) ? null : rate;
        set => Volatile.Write(ref _rate, value ?? double.NaN);
    }

    /// <summary>Number of frames that can be read.</summary>
    public long Frames => Poses.Count;

    /// <summary>The times of the left and right foot on the ground, as far as they are known.</summary>
    public (ImmutableArray<TimeStretch> Left, ImmutableArray<TimeStretch> Right) GetContacts() => _contacts.GetContacts();

    /// <summary>Reads the summaries of blocks.</summary>
    /// <returns>The number of blocks read.</returns>
    public int ReadSummaries(long firstBlock, Span<float> values) => Summaries.Read(firstBlock, MemoryMarshal.AsBytes(values));

    public void Dispose()
    {
        Poses.Dispose();
        Summaries.Dispose();
    }
}
