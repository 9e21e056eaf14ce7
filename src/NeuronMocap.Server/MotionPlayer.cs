using NeuronMocap.Recording;
using NeuronMocap.Server.Broadcasting;

namespace NeuronMocap.Server;

/// <summary>Plays motion to a reader in the same process, without a network: for example a BVH file, with <see cref="BvhSource"/>.</summary>
public static class MotionPlayer
{
    /// <summary>Creates a player of the frames that a <see cref="Broadcaster"/> would send.</summary>
    /// <remarks>
    /// The player starts at the first frame and follows <see cref="PlaybackOptions.Clock"/>, if it is set. It can be paused and can seek. If the source
    /// never ends, <see cref="RecordingPlayer.Duration"/> is <see cref="TimeSpan.MaxValue"/>.
    /// </remarks>
    /// <param name="source">The motion of one avatar. It is called on the thread of the playback, at its own frame rate.</param>
    /// <param name="name">The name of the avatar, at most 32 bytes of UTF-8; the rest is cut off.</param>
    /// <param name="options">The options of the playback; null for the defaults. Options of a file have no effect.</param>
    /// <returns>A player for <see cref="NeuronReader(RecordingPlayer, NeuronReaderOptions?)"/>.</returns>
    /// <exception cref="ArgumentException">An option is out of range.</exception>
    public static RecordingPlayer Create(MotionSource source, string name, PlaybackOptions? options = null)
    {
        ArgumentNullException.ThrowIfNull(source);
        ArgumentNullException.ThrowIfNull(name);

        // With displacement, so that the stream carries the performer's sizes.
        BroadcasterOptions content = new BroadcasterOptions { Sources = [source], IncludeDisplacement = true }.CopyChecked();
        var plan = new FramePlan(content, [new AvatarName(name)], source.FrameRate, hasMotion: true, hasCalculation: false);
        return new RecordingPlayer(new MotionEvents(plan, name), PlaybackOptions.CopyChecked(options));
    }
}
