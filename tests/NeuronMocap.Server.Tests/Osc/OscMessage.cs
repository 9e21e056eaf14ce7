using System.Buffers.Binary;
using System.Globalization;
using System.Text;

namespace NeuronMocap.Server.Tests.Osc;

/// <summary>A message of OSC 1.0, read by another decoder than the library's. It accepts nothing that the specification does not allow.</summary>
internal sealed record OscMessage(string Address, object[] Arguments)
{
    public string Types => string.Concat(Arguments.Select(static argument => argument is int ? 'i' : argument is float ? 'f' : 's'));

    public float Float(int index) => (float)Arguments[index];

    /// <summary>Reads a datagram that is a bundle of messages.</summary>
    public static OscMessage[] ReadBundle(byte[] datagram)
    {
        Assert.Equal("#bundle\0"u8.ToArray(), datagram[..8]);
        Assert.Equal(1ul, BinaryPrimitives.ReadUInt64BigEndian(datagram.AsSpan(8)));
        List<OscMessage> messages = [];
        int at = 16;
        while (at < datagram.Length)
        {
            int size = BinaryPrimitives.ReadInt32BigEndian(datagram.AsSpan(at));
            Assert.InRange(size, 4, datagram.Length - at - 4);
            Assert.Equal(0, size % 4);
            messages.Add(Read(datagram[(at + 4)..(at + 4 + size)]));
            at += 4 + size;
        }

        return [.. messages];
    }

    /// <summary>Reads a line of oscdump, such as: eeae7096.025bd944 /VMC/Ext/Root/Pos sf "root" 1.000000</summary>
    public static OscMessage ReadDump(string line)
    {
        string[] words = line.Split(' ');
        IEnumerable<object> arguments = words[3..].Zip(words[2], static (word, type) => type switch
        {
            'i' => (object)int.Parse(word, CultureInfo.InvariantCulture),
            'f' => float.Parse(word, CultureInfo.InvariantCulture),
            _ => word.Trim('"'),
        });
        return new OscMessage(words[1], [.. arguments]);
    }

    private static OscMessage Read(byte[] bytes)
    {
        int at = 0;
        string address = ReadText(bytes, ref at);
        Assert.StartsWith("/", address, StringComparison.Ordinal);
        string types = ReadText(bytes, ref at);
        Assert.StartsWith(",", types, StringComparison.Ordinal);
        List<object> arguments = [];
        foreach (char type in types[1..])
        {
            if (type == 's')
            {
                arguments.Add(ReadText(bytes, ref at));
                continue;
            }

            int word = BinaryPrimitives.ReadInt32BigEndian(bytes.AsSpan(at));
            arguments.Add(type == 'i' ? (object)word : type == 'f' ? BitConverter.Int32BitsToSingle(word) : throw new InvalidDataException($"{type}"));
            at += 4;
        }

        Assert.Equal(bytes.Length, at);
        return new OscMessage(address, [.. arguments]);
    }

    private static string ReadText(byte[] bytes, ref int at)
    {
        int end = Array.IndexOf(bytes, (byte)0, at);
        string text = Encoding.ASCII.GetString(bytes, at, end - at);
        int next = at + ((text.Length / 4) + 1) * 4;
        Assert.All(bytes[end..next], static padding => Assert.Equal(0, padding));
        at = next;
        return text;
    }
}
