using System.Collections.Concurrent;

namespace NeuronMocap.Tool.Terminal;

/// <summary>
/// The keys that were pressed. A thread waits in the system's read all the time, because otherwise the terminal shows what is typed.
/// The thread ends with the program.
/// </summary>
internal sealed class Keyboard
{
    private readonly ConcurrentQueue<ConsoleKeyInfo> _keys = new();

    private Keyboard()
    {
    }

    /// <summary>Set with every key.</summary>
    public AutoResetEvent Pressed { get; } = new(initialState: false);

    /// <summary>Whether there are keys to read. There are none if standard input is redirected.</summary>
    public static bool IsAvailable => !Console.IsInputRedirected;

    /// <summary>Starts to listen.</summary>
    public static Keyboard Open()
    {
        var keyboard = new Keyboard();
        if (IsAvailable)
            new Thread(keyboard.Read) { IsBackground = true, Name = "Keyboard" }.Start();

        return keyboard;
    }

    public bool TryRead(out ConsoleKeyInfo key) => _keys.TryDequeue(out key);

    private void Read()
    {
        while (true)
        {
            _keys.Enqueue(Console.ReadKey(intercept: true));
            Pressed.Set();
        }
    }
}
