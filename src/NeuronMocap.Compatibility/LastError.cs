using System.Runtime.InteropServices;
using System.Text;

namespace NeuronMocap.Compatibility;

// The vendor's last error: one text for the process, which no success clears.
internal static class LastError
{
    private const int Capacity = 1024;

    private static readonly object Lock = new();
    private static volatile string _text = string.Empty;

    static LastError()
    {
        Pointer = Marshal.AllocHGlobal(Capacity);
        Set("No error.");
    }

    public static IntPtr Pointer { get; }

    public static string Text => _text;

    // Whoever reads the memory at this moment may see parts of two texts, as in the vendor's library; it always ends with a zero.
    public static void Set(string text)
    {
        byte[] image = new byte[Capacity];
        Encoding.UTF8.GetEncoder().Convert(text, image.AsSpan(0, Capacity - 1), flush: true, out _, out _, out _);
        lock (Lock)
        {
            _text = text;
            Marshal.Copy(image, 0, Pointer, Capacity);
        }
    }

    public static void Set(string text, int systemError) => Set($"{text} System error code: {systemError}");
}
