namespace NeuronMocap.Commands;

/// <summary>The reason why a command has no answer.</summary>
public enum CommandFailure
{
    /// <summary>The reason is not known.</summary>
    Unknown,

    /// <summary>The host name has no address.</summary>
    HostNotFound,

    /// <summary>The computer refused the connection: nothing listens on the port.</summary>
    Refused,

    /// <summary>The connection failed for another reason: no answer, no route, or a firewall.</summary>
    NotConnected,

    /// <summary>The complete reply did not arrive within the timeout. The server may have executed the command.</summary>
    TimedOut,

    /// <summary>The server closed the connection before it answered. The server may have executed the command.</summary>
    Closed,

    /// <summary>The server sent data that is not a valid answer to the command.</summary>
    InvalidReply,

    /// <summary>The server answered that it did not execute the command, or that it has no data.</summary>
    Rejected,
}
