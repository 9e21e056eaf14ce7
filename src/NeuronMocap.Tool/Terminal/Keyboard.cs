using System.Collections.Concurrent;

namespace NeuronMocap.Tool.Terminal;

/// <summary>Collects pressed keys.</summary>
/// <remarks>
/// A thread always waits in the system's read function. Otherwise the terminal would show the typed keys. The thread ends with the program.
/// </remarks>
internal sealed class Keyboard
{
    private readonly ConcurrentQueue<ConsoleKeyInfo> _keys = new();

    private Keyboard()
    {
    }

    /// <summary>Set with every key.</summary>
    public AutoResetEvent Pressed { get; } = new(initialState: false);

    /// <summary>Whether keys can be read. They cannot if standard input is redirected.</summary>
    public static bool IsAvailable => !Console.IsInputRedirected;

    /// <summary>Starts to listen for keys.</summary>
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
