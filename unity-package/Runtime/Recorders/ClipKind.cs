#nullable enable

namespace NeuronMocap.Unity
{
    /// <summary>What a <see cref="ClipRecorder"/> records.</summary>
    public enum ClipKind
    {
        /// <summary>Body position and muscles: plays on every humanoid. Muscles have limits and no roll of the fingers, so that poses may differ a little.</summary>
        Humanoid,

        /// <summary>The transforms' own rotations: exact, for characters with the same transforms.</summary>
        Generic,
    }
}
