using System.Collections.Concurrent;

namespace NeuronMocap.Tool.Terminal;

/// <summary>
/// The keys that were pressed. A thread of its own stays inside the system's read: outside of it the terminal would show what is typed.
/// It ends with the program.
/// </summary>
internal sealed class Keyboard
{
    private readonly ConcurrentQueue<ConsoleKeyInfo> _keys = new();

    private Keyboard()
    {
    }

    /// <summary>Set with every key.</summary>
    public AutoResetEvent Pressed { get; } = new(initialState: false);

    /// <summary>Starts to listen; without a keyboard there are no keys.</summary>
    public static Keyboard Open()
    {
        var keyboard = new Keyboard();
        if (!Console.IsInputRedirected)
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
