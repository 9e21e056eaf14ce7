#nullable enable

namespace NeuronMocap.Unity
{
    /// <summary>What a <see cref="MocapSource"/> is doing. <see cref="MocapSource.StatusMessage"/> says it in words, with what can be changed.</summary>
    public enum SourceState
    {
        /// <summary>Not open: the component is disabled, or <see cref="MocapSource.Close"/> was called.</summary>
        Closed,

        /// <summary>A file is being read.</summary>
        Loading,

        /// <summary>Connecting, or taking the UDP port.</summary>
        Connecting,

        /// <summary>The connection stands; no frame has come yet.</summary>
        Connected,

        /// <summary>Frames arrive.</summary>
        Receiving,

        /// <summary>The connection stands, and no frames arrive.</summary>
        Silent,

        /// <summary>The connection failed or ended; it is tried again in a moment.</summary>
        Waiting,

        /// <summary>The file is over.</summary>
        Ended,

        /// <summary>It does not work, and is not tried again until something is changed.</summary>
        Failed,
    }
}
