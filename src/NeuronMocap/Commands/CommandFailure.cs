namespace NeuronMocap.Commands;

/// <summary>Why a command got no right answer.</summary>
public enum CommandFailure
{
    /// <summary>No reason was given.</summary>
    None,

    /// <summary>There is no connection to send it on.</summary>
    NotConnected,

    /// <summary>No reply came in time.</summary>
    TimedOut,
}
