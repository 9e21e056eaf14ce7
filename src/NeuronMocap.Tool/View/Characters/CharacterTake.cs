using System.Buffers.Binary;
using System.Collections.Immutable;
using Microsoft.AspNetCore.Http;
using NeuronMocap.Skeleton;
using NeuronMocap.Tool.View.Takes;
using NeuronMocap.Tool.View.Web;

namespace NeuronMocap.Tool.View.Characters;

/// <summary>Poses of a character for frames of a take. Used for one request.</summary>
internal sealed class CharacterTake(Character character, TakePerformer performer)
{
    /// <summary>The most frames of an answer.</summary>
    public const int MostFrames = 1024;

    // Planted feet depend on the frames before. A step is over by then.
    private const int FramesBefore = 240;
    private const int FramesPerRead = 64;
    private const long MicrosecondsPerSecond = 1_000_000;

    private readonly CharacterState _state = character.State;
    private readonly CharacterPoser _poser = new(character.State.Rig, performer.Body) { PlantsFeet = character.State.PlantsFeet };
    private readonly BoneTransform[] _local = new BoneTransform[BoneHierarchy.BoneCount];
    private readonly (ImmutableArray<TimeStretch> Left, ImmutableArray<TimeStretch> Right) _contacts = performer.GetContacts();

    /// <summary>Answers with the poses of frames: for each frame the size of its pose, and the pose.</summary>
    /// <param name="context">The request.</param>
    /// <param name="first">Number of the first frame.</param>
    /// <param name="count">Number of frames; fewer at the end of the take.</param>
    public async Task SendAsync(HttpContext context, long first, int count)
    {
        long end = Math.Min(performer.Frames, first + count);
        int size = CharacterPose.SizeOf(_state.Rig);
        byte[] answer = new byte[Math.Max(0, end - first) * (sizeof(uint) + size)];
        await Task.Run(() => Write(first, end, size, answer), context.RequestAborted);
        context.Response.ContentType = "application/octet-stream";
        context.Response.ContentLength = answer.Length;
        await context.Response.Body.WriteAsync(answer, context.RequestAborted);
    }

    private static bool Contains(ImmutableArray<TimeStretch> stretches, long microseconds)
    {
        int low = 0;
        int high = stretches.Length;
        while (low < high)
        {
            int middle = (low + high) / 2;
            if (stretches[middle].To < microseconds)
                low = middle + 1;
            else
                high = middle;
        }

        return low < stretches.Length && stretches[low].From <= microseconds;
    }

    private void Write(long first, long end, int size, Span<byte> answer)
    {
        byte[] poses = new byte[FramesPerRead * performer.Poses.RecordSize];
        for (long next = Math.Max(0, first - FramesBefore); next < end;)
        {
            int count = Read(next, poses.AsSpan(0, (int)Math.Min(end - next, FramesPerRead) * performer.Poses.RecordSize));
            for (int i = 0; i < count; i++, next++)
            {
                long time = Take(poses.AsSpan(i * performer.Poses.RecordSize, performer.Poses.RecordSize));
                if (next < first)
                    continue;

                Span<byte> entry = answer.Slice((int)(next - first) * (sizeof(uint) + size), sizeof(uint) + size);
                BinaryPrimitives.WriteUInt32LittleEndian(entry, (uint)size);
                CharacterPose.Encode(_state.Rig, _poser.Pose, character.Id, time, entry[sizeof(uint)..]);
            }
        }
    }

    private int Read(long first, Span<byte> poses)
    {
        try
        {
            return performer.Poses.Read(first, poses);
        }
        catch (ObjectDisposedException)
        {
            throw ApiException.NotFound("The take was closed.");
        }
    }

    // Returns the time of the frame in microseconds.
    private long Take(ReadOnlySpan<byte> pose)
    {
        long time = BinaryPrimitives.ReadInt64LittleEndian(pose[8..]);
        if (CompactPose.TryDecode(pose, out _, _local, performer.Body))
            _poser.TryTake(_local, new FootContacts(Contains(_contacts.Left, time), Contains(_contacts.Right, time)), time / (double)MicrosecondsPerSecond);

        return time;
    }
}
