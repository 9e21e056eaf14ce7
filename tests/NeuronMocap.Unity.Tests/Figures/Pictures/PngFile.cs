using System.Buffers.Binary;
using System.IO.Compression;
using System.Text;

namespace NeuronMocap.Unity.Tests.Figures.Pictures;

/// <summary>A minimal PNG for our own pictures: red, green and blue, a byte each, every row as differences to the previous pixel.</summary>
internal static class PngFile
{
    private const int Channels = 3;
    private const byte SubFilter = 1;

    private static readonly byte[] Signature = [0x89, (byte)'P', (byte)'N', (byte)'G', 13, 10, 26, 10];
    private static readonly uint[] CrcTable = [.. Enumerable.Range(0, 256).Select(static value => CrcOf((uint)value))];

    public static void Write(string path, int width, int height, ReadOnlySpan<byte> pixels)
    {
        using var compressed = new MemoryStream();
        using (var deflate = new ZLibStream(compressed, CompressionLevel.SmallestSize, leaveOpen: true))
        {
            int stride = width * Channels;
            var row = new byte[stride + 1];
            row[0] = SubFilter;
            for (int y = 0; y < height; y++)
            {
                ReadOnlySpan<byte> line = pixels.Slice(y * stride, stride);
                for (int i = 0; i < stride; i++)
                    row[i + 1] = (byte)(line[i] - (i < Channels ? 0 : line[i - Channels]));

                deflate.Write(row);
            }
        }

        var header = new byte[13];
        BinaryPrimitives.WriteInt32BigEndian(header, width);
        BinaryPrimitives.WriteInt32BigEndian(header.AsSpan(4), height);
        header[8] = 8; // bits of a channel
        header[9] = 2; // red, green, blue

        using FileStream file = File.Create(path);
        file.Write(Signature);
        WriteChunk(file, "IHDR", header);
        WriteChunk(file, "IDAT", compressed.ToArray());
        WriteChunk(file, "IEND", []);
    }

    /// <summary>Reads a file written by <see cref="Write"/>.</summary>
    public static byte[] Read(string path, out int width, out int height)
    {
        ReadOnlySpan<byte> file = File.ReadAllBytes(path);
        Assert.Equal(Signature, file[..Signature.Length].ToArray());
        width = BinaryPrimitives.ReadInt32BigEndian(file[16..]);
        height = BinaryPrimitives.ReadInt32BigEndian(file[20..]);
        int size = BinaryPrimitives.ReadInt32BigEndian(file[33..]);

        using var inflate = new ZLibStream(new MemoryStream(file.Slice(41, size).ToArray()), CompressionMode.Decompress);
        int stride = width * Channels;
        var pixels = new byte[height * stride];
        for (int y = 0; y < height; y++)
        {
            Assert.Equal(SubFilter, inflate.ReadByte());
            Span<byte> line = pixels.AsSpan(y * stride, stride);
            inflate.ReadExactly(line);
            for (int i = Channels; i < stride; i++)
                line[i] += line[i - Channels];
        }

        return pixels;
    }

    private static void WriteChunk(Stream file, string type, byte[] content)
    {
        byte[] body = [.. Encoding.ASCII.GetBytes(type), .. content];
        Span<byte> number = stackalloc byte[4];
        BinaryPrimitives.WriteInt32BigEndian(number, content.Length);
        file.Write(number);
        file.Write(body);

        uint crc = uint.MaxValue;
        foreach (byte value in body)
            crc = CrcTable[(byte)(crc ^ value)] ^ (crc >> 8);

        BinaryPrimitives.WriteUInt32BigEndian(number, ~crc);
        file.Write(number);
    }

    private static uint CrcOf(uint value)
    {
        for (int bit = 0; bit < 8; bit++)
            value = (value & 1) != 0 ? 0xedb88320 ^ (value >> 1) : value >> 1;

        return value;
    }
}
