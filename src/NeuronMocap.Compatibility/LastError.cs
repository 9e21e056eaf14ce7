using System.Runtime.InteropServices;
using System.Text;

namespace NeuronMocap.Compatibility;

// The vendor's last error: one text for the whole process, which a success does not clear.
internal static class LastError
{
    private const int Capacity = 1024;

    private const string NoMemory = "Out of memory, or no thread can be started.";

    private static readonly object Lock = new();

    // Created in advance, because it could not be created when memory has run out.
    private static readonly byte[] NoMemoryImage = ImageOf(NoMemory);
    private static volatile string _text = string.Empty;

    static LastError()
    {
        Pointer = Marshal.AllocHGlobal(Capacity);
        Set("No error.");
    }

    public static IntPtr Pointer { get; }

    public static string Text => _text;

    // A concurrent reader may see parts of two texts, as in the vendor's library. The memory always ends with a zero.
    public static void Set(string text) => Set(text, ImageOf(text));

    public static void Set(string text, int systemError) => Set($"{text} System error code: {systemError}");

    // For unexpected exceptions inside a function, which then fails.
    public static void SetFault(string function, Exception exception)
    {
        if (exception is OutOfMemoryException)
            Set(NoMemory, NoMemoryImage);
        else
            Set($"{function} failed because of an error in the library: {exception.GetType()}: {exception.Message}");
    }

    private static void Set(string text, byte[] image)
    {
        lock (Lock)
        {
            _text = text;
            Marshal.Copy(image, 0, Pointer, Capacity);
        }
    }

    private static byte[] ImageOf(string text)
    {
        byte[] image = new byte[Capacity];
        Encoding.UTF8.GetEncoder().Convert(text, image.AsSpan(0, Capacity - 1), flush: true, out _, out _, out _);
        return image;
    }
}
