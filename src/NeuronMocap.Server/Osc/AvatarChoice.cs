using System.Diagnostics;

namespace NeuronMocap.Server.Osc;

/// <summary>Says which avatars of a stream go to a destination.</summary>
/// <param name="index">The number of the avatar; null for any.</param>
/// <param name="name">The name of the avatar; null for any.</param>
/// <param name="onlyOne">Whether only one avatar goes there: the first that arrives, until it is gone.</param>
internal sealed class AvatarChoice(int? index, string? name, bool onlyOne)
{
    /// <summary>A performer who has been silent for this long makes room for another.</summary>
    private static readonly long Absence = 2 * Stopwatch.Frequency;

    private (int Sender, int Index)? _one;
    private long _lastSeen;

    public bool Takes(MotionFrame frame) =>
        (index is null || index == frame.AvatarIndex)
        && (name is null || string.Equals(name, frame.AvatarName, StringComparison.Ordinal))
        && (!onlyOne || IsTheOne(frame.Sender, frame.AvatarIndex, frame.Timestamp));

    internal bool IsTheOne(int sender, int avatar, long timestamp)
    {
        if (_one is { } one && one != (sender, avatar) && timestamp - _lastSeen < Absence)
            return false;

        _one = (sender, avatar);
        _lastSeen = timestamp;
        return true;
    }
}
