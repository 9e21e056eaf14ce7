namespace NeuronMocap.Commands;

/// <summary>Why a command has no answer.</summary>
public enum CommandFailure
{
    /// <summary>Not said.</summary>
    Unknown,

    /// <summary>The host name has no address.</summary>
    HostNotFound,

    /// <summary>The address answered that nothing listens on the port.</summary>
    Refused,

    /// <summary>There is no connection for another reason: no answer, no route, a firewall.</summary>
    NotConnected,

    /// <summary>The server did not answer, or not all of it, within the time of the option. The command may have been carried out.</summary>
    TimedOut,

    /// <summary>The server closed the connection before it had answered. The command may have been carried out.</summary>
    Closed,

    /// <summary>Something came that is no answer to the command.</summary>
    InvalidReply,

    /// <summary>The server answered that it did not do it, or that it has nothing to tell.</summary>
    Rejected,
}
