using System.Diagnostics;
using System.Net.WebSockets;
using NeuronMocap.Motion;
using NeuronMocap.Skeleton;
using NeuronMocap.Tool.View.Live;
using NeuronMocap.Tool.View.Performers;

namespace NeuronMocap.Tool.View.Characters;

/// <summary>The live poses of a character for the pages that show it. While no page listens, it takes no frames.</summary>
/// <param name="character">The character.</param>
/// <param name="live">The stream; null if a take is open instead.</param>
internal sealed class CharacterMotion(Character character, LiveSession? live)
{
    private readonly Lock _lock = new();
    private readonly BoneTransform[] _local = new BoneTransform[BoneHierarchy.BoneCount];
    private readonly BoneTransform[] _world = new BoneTransform[BoneHierarchy.BoneCount];
    private readonly byte[] _bytes = new byte[CharacterPose.MaxSize];
    private readonly FootContactEstimator _feet = new();
    private CharacterListener[] _listeners = [];
    private IDisposable? _subscription;
    private CharacterState? _state;
    private CharacterPoser? _poser;
    private FootContacts? _measured;
    private long _posed;
    private bool _hasEnded;

    public Character Character => character;

    /// <summary>When a page last used the character, in ticks of <see cref="Stopwatch"/>.</summary>
    public long LastUse { get; set; } = Stopwatch.GetTimestamp();

    /// <summary>Number of pages that listen.</summary>
    public int Listeners => Volatile.Read(ref _listeners).Length;

    /// <summary>Number of poses that were made. It does not grow while no page listens.</summary>
    public long Posed => Interlocked.Read(ref _posed);

    /// <summary>Adds a page.</summary>
    public void Add(CharacterListener listener)
    {
        lock (_lock)
        {
            _listeners = [.. _listeners, listener];
            _subscription ??= live?.Motion.Subscribe(Take);
            if (_hasEnded)
                listener.End(WebSocketCloseStatus.NormalClosure, "The character was removed.");
        }
    }

    /// <summary>Removes a page.</summary>
    public void Remove(CharacterListener listener)
    {
        lock (_lock)
        {
            _listeners = [.. _listeners.Where(each => each != listener)];
            if (_listeners.Length > 0)
                return;

            _subscription?.Dispose();
            _subscription = null;
        }
    }

    /// <summary>Disconnects all pages, and all that come later.</summary>
    public void End(WebSocketCloseStatus status, string reason)
    {
        lock (_lock)
        {
            _hasEnded = true;
            Array.ForEach(_listeners, listener => listener.End(status, reason));
        }
    }

    // Called for one frame at a time.
    private void Take(AvatarFrame frame)
    {
        CharacterState state = character.State;
        if (state.Performer is not { } performer || PerformerKey.Of(frame) != performer)
            return;

        if (frame is CalculationFrame { BoneCount: > 0 } calculation)
            _measured = calculation.FootContacts;
        if (frame is not MotionFrame { HasSkeleton: true } motion)
            return;

        SkeletonBody body = FindBody(performer, motion.Format.Variant);
        if (state != _state || _poser is null)
            Begin(state, body);

        motion.CopyLocalTransforms(_local, body);
        if (motion.Layout.HasReference)
            _local[0] = motion.GetReference().Apply(_local[0]);

        double seconds = motion.Timestamp / (double)Stopwatch.Frequency;
        ForwardKinematics.ToWorld(_local, _world, body.Variant);
        FootContacts contacts = _feet.Update(_world, body, seconds, _measured);
        _poser!.SetBody(body);
        if (!_poser.TryTake(_local, contacts, seconds))
            return;

        long microseconds = (DateTime.UtcNow - motion.Age - DateTime.UnixEpoch).Ticks / TimeSpan.TicksPerMicrosecond;
        int size = CharacterPose.Encode(state.Rig, _poser.Pose, character.Id, microseconds, _bytes);
        Interlocked.Increment(ref _posed);
        foreach (CharacterListener listener in Volatile.Read(ref _listeners))
            listener.Put(_bytes.AsSpan(0, size));
    }

    private void Begin(CharacterState state, SkeletonBody body)
    {
        if (state.Performer != _state?.Performer)
        {
            _feet.Reset();
            _measured = null;
        }

        _state = state;
        _poser = new CharacterPoser(state.Rig, body) { PlantsFeet = state.PlantsFeet };
    }

    private SkeletonBody FindBody(PerformerKey performer, SkeletonVariant variant) =>
        live!.Performers.Find(performer)?.Body is { } body && body.Variant == variant ? body : SkeletonBody.GetDefault(variant);
}
