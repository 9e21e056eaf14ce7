#nullable enable

namespace NeuronMocap.Unity
{
    /// <summary>Specifies what a <see cref="MotionRecorder"/> does.</summary>
    public enum RecorderState
    {
        /// <summary>Nothing.</summary>
        Idle,

        /// <summary>It waits for the source to open.</summary>
        Waiting,

        /// <summary>It writes what arrives.</summary>
        Recording,

        /// <summary>It completes its files on another thread.</summary>
        Finishing,
    }
}
