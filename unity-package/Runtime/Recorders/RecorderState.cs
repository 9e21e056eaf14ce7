#nullable enable

namespace NeuronMocap.Unity
{
    /// <summary>What a <see cref="MotionRecorder"/> does.</summary>
    public enum RecorderState
    {
        /// <summary>Nothing.</summary>
        Idle,

        /// <summary>Waits for the source to open.</summary>
        Waiting,

        /// <summary>Writes what arrives.</summary>
        Recording,

        /// <summary>Completes its files, on another thread.</summary>
        Finishing,
    }
}
