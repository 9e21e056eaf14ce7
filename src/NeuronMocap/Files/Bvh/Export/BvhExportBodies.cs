using System.Diagnostics;
using System.Numerics;
using NeuronMocap.Commands;
using NeuronMocap.Frames;
using NeuronMocap.Skeleton;
using NeuronMocap.Transport;

namespace NeuronMocap.Bvh;

// Finds the bodies for the hierarchies of an export. Runs on the export's thread, which may wait.
internal sealed class BvhExportBodies(BvhExportOptions options, ServerInquiry? inquiry, FrameFormat format)
{
    private static readonly TimeSpan PollPeriod = TimeSpan.FromMilliseconds(10);

    private bool _hasGivenUp;

    // Waits until the command channel has reported the format, because frames are decoded with the format known when they are taken from the queue.
    // Without the wait, the first part of a file could have a rotation order that was only assumed.
    public void WaitForFormat(ManualResetEventSlim stop)
    {
        var waited = Stopwatch.StartNew();
        while (inquiry is not null && !IsSettled(format.Discovered) && waited.Elapsed < options.HeaderTimeout && !stop.Wait(PollPeriod))
        {
        }
    }

    // If the stream has displacement, only the End Sites of the body are used.
    public (SkeletonBody? Body, BvhBodyOrigin Source) Find(MotionFrame frame)
    {
        (SkeletonBody? body, BvhBodyOrigin source) = options.Body is { } given
            ? (given, BvhBodyOrigin.Options)
            : Ask(frame.AvatarIndex, frame.Format.Variant);
        if (frame.Layout.HasDisplacement)
            return (body, BvhBodyOrigin.Stream);

        return body?.Variant == frame.Format.Variant ? (body, source) : (null, BvhBodyOrigin.Default);
    }

    private static bool IsSettled(DiscoveredFormat discovered) => discovered.Failure is not null || (discovered.Order is not null && discovered.Variant is not null);

    private (SkeletonBody? Body, BvhBodyOrigin Source) Ask(int avatar, SkeletonVariant variant)
    {
        if (inquiry is null || _hasGivenUp || avatar < 0)
            return default;

        using var timeoutSource = new CancellationTokenSource(options.HeaderTimeout);
        try
        {
            BodyAnswer answer = AskAsync(inquiry, avatar, timeoutSource.Token).GetAwaiter().GetResult();
            return answer.Skeleton is { } skeleton
                ? (CreateBody(skeleton), BvhBodyOrigin.Header)
                : (answer.GetBody(variant), BvhBodyOrigin.Dimensions);
        }
        catch (Exception exception) when (exception is NeuronCommandException or OperationCanceledException or ObjectDisposedException)
        {
            // A server that does not answer for one avatar is not asked again for the next, because the frames of that avatar wait.
            _hasGivenUp = true;
            return default;
        }
    }

    private static async Task<BodyAnswer> AskAsync(ServerInquiry inquiry, int avatar, CancellationToken cancellationToken)
    {
        Task<BodyAnswer> answer = inquiry.GetBodyAsync(avatar, isRetry: false);
        _ = answer.ContinueWith(static task => task.Exception, CancellationToken.None, TaskContinuationOptions.ExecuteSynchronously, TaskScheduler.Default); // observed
        await TaskWaiting.WaitAsync(answer, cancellationToken).ConfigureAwait(false);
        return await answer.ConfigureAwait(false);
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
