#nullable enable

namespace NeuronMocap.Unity
{
    /// <summary>Specifies what a <see cref="ClipRecorder"/> records.</summary>
    public enum ClipKind
    {
        /// <summary>
        /// Body position, muscles, and the goals of feet and hands, which play on every Humanoid, with and without Foot IK. Muscles have limits and
        /// cannot roll fingers, so poses may differ a little.
        /// </summary>
        Humanoid,

        /// <summary>The rotations of the transforms. They are exact, but need a character with the same transforms.</summary>
        Generic,
    }
}
