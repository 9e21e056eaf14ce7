#nullable enable

namespace NeuronMocap.Unity
{
    /// <summary>
    /// Specifies what a <see cref="MocapSource"/> is doing. <see cref="MocapSource.StatusMessage"/> says it in words, with the setting to change.
    /// </summary>
    public enum SourceState
    {
        /// <summary>Not open: the component is disabled, or <see cref="MocapSource.Close"/> was called.</summary>
        Closed,

        /// <summary>A file is being read.</summary>
        Loading,

        /// <summary>The source is connecting, or opening the UDP port.</summary>
        Connecting,

        /// <summary>The connection is open. No frame has arrived yet.</summary>
        Connected,

        /// <summary>Frames arrive.</summary>
        Receiving,

        /// <summary>The connection is open, but no frames arrive.</summary>
        Silent,

        /// <summary>The connection failed or ended. The source reconnects in a moment.</summary>
        Waiting,

        /// <summary>The file has ended.</summary>
        Ended,

        /// <summary>The source failed. It does not try again until a setting changes.</summary>
        Failed,
    }
}
