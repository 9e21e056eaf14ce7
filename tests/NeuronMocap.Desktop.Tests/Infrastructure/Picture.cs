using System.Globalization;
using System.Text;

namespace NeuronMocap.Desktop.Tests.Infrastructure;

/// <summary>The pixels of a window at one moment, three bytes each.</summary>
internal sealed class Picture
{
    private const int BytesPerPixel = 3;
    private readonly byte[] _pixels;

    private Picture(byte[] pixels) => _pixels = pixels;

    /// <summary>Reads a picture in the format PPM: three words and numbers, one white space, the pixels.</summary>
    public static Picture FromPpm(byte[] file)
    {
        int start = 0;
        string[] words = new string[4];
        for (int i = 0; i < words.Length; i++)
        {
            int end = Array.FindIndex(file, start, static letter => char.IsWhiteSpace((char)letter));
            words[i] = Encoding.ASCII.GetString(file, start, end - start);
            start = end + 1;
        }

        Assert.Equal("P6", words[0]);
        byte[] pixels = file[start..];
        Assert.Equal(BytesPerPixel * int.Parse(words[1], CultureInfo.InvariantCulture) * int.Parse(words[2], CultureInfo.InvariantCulture), pixels.Length);
        return new Picture(pixels);
    }

    public bool IsSameAs(Picture other) => _pixels.AsSpan().SequenceEqual(other._pixels);

    public int Count(byte red, byte green, byte blue)
    {
        int count = 0;
        for (int i = 0; i < _pixels.Length; i += BytesPerPixel)
            count += _pixels[i] == red && _pixels[i + 1] == green && _pixels[i + 2] == blue ? 1 : 0;

        return count;
    }
}
