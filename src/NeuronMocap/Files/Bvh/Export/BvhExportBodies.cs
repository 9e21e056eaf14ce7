using System.Diagnostics;
using System.Numerics;
using NeuronMocap.Commands;
using NeuronMocap.Frames;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Bvh;

// Finds out what the hierarchies of an export's files are made of. The export's thread, which may wait.
internal sealed class BvhExportBodies(BvhExportOptions options, NeuronCommandOptions? commands, FrameFormat format) : IDisposable
{
    private static readonly TimeSpan PollPeriod = TimeSpan.FromMilliseconds(10);

    private NeuronCommandClient? _client = commands is null || options.Body is not null ? null : new NeuronCommandClient(commands);

    // Frames that are taken out of the queue are understood as the command channel says by then; a first part of a file in a rotation order that was only
    // assumed is of no use to anybody.
    public void WaitForFormat(ManualResetEventSlim stop)
    {
        var waited = Stopwatch.StartNew();
        while (commands is not null && !IsSettled(format.Findings) && waited.Elapsed < options.HeaderTimeout && !stop.Wait(PollPeriod))
        {
        }
    }

    // Of a stream with displacement only the End Sites of the body are of use.
    public (SkeletonBody? Body, BvhBodySource Source) Find(MotionFrame frame)
    {
        (SkeletonBody? body, BvhBodySource source) = options.Body is { } given
            ? (given, BvhBodySource.Options)
            : Ask(frame.AvatarIndex, frame.Format.Variant);
        if (frame.Layout.HasDisplacement)
            return (body, BvhBodySource.Stream);

        return body?.Variant == frame.Format.Variant ? (body, source) : (null, BvhBodySource.Default);
    }

    public void Dispose() => _client?.Dispose();

    private static bool IsSettled(FormatFindings findings) => findings.Failure is not null || (findings.Order is not null && findings.Variant is not null);

    private (SkeletonBody? Body, BvhBodySource Source) Ask(int avatar, SkeletonVariant variant)
    {
        if (_client is null || avatar < 0)
            return default;

        using var timeout = new CancellationTokenSource(options.HeaderTimeout);
        try
        {
            return AskAsync(_client, avatar, variant, timeout.Token).GetAwaiter().GetResult();
        }
        catch (Exception exception) when (exception is NeuronCommandException or OperationCanceledException)
        {
            // Whoever does not answer for one avatar is not asked for the next: its frames wait.
            _client.Dispose();
            _client = null;
            return default;
        }
    }

    private static async Task<(SkeletonBody? Body, BvhBodySource Source)> AskAsync(
        NeuronCommandClient client, int avatar, SkeletonVariant variant, CancellationToken timeout)
    {
        try
        {
            BvhDocument header = await client.GetBvhHeaderAsync(avatar, timeout).ConfigureAwait(false);
            if (BvhSkeletonMap.TryCreate(header, out BvhSkeletonMap? map, out _))
                return (CreateBody(map), BvhBodySource.Header);
        }
        catch (NeuronCommandException exception) when (exception.Reason is CommandFailure.Rejected or CommandFailure.InvalidReply)
        {
            // It answers, but not this.
        }

        BoneDimensions dimensions = await client.GetBoneDimensionsAsync(avatar, timeout).ConfigureAwait(false);
        return (SkeletonBody.FromDimensions(dimensions, variant), BvhBodySource.Dimensions);
    }

    private static SkeletonBody CreateBody(BvhSkeletonMap map)
    {
        Span<Vector3> offsets = stackalloc Vector3[BoneHierarchy.BoneCount];
        Span<Vector3> endSites = stackalloc Vector3[BoneHierarchy.BoneCount];
        foreach (Bone bone in BoneHierarchy.Bones)
        {
            DefaultOffsets.TryGetEndSite(bone, out Vector3 end);
            offsets[(int)bone] = map[bone].Offset;
            endSites[(int)bone] = map[bone].EndSite ?? end;
        }

        return new SkeletonBody(offsets, endSites, map.Format.Variant);
    }
}
