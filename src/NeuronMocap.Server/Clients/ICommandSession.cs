using NeuronMocap.Server.Broadcasting;

namespace NeuronMocap.Server.Clients;

/// <summary>One client of a command channel. Disposing it ends its connection at once, on any thread.</summary>
internal interface ICommandSession : IDisposable
{
    // Measures how long the client has been idle. Thread-safe.
    IdleClock Idle { get; }

    // Whether the session is about to end and needs no place any more. Thread-safe.
    bool IsLeft { get; }

    // Starts to serve. Returns the thread of the session; null if it has none.
    Worker? Start();
}
