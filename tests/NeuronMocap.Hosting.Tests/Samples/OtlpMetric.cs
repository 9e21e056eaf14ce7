using System.Buffers.Binary;
using System.Text;

namespace NeuronMocap.Hosting.Tests.Samples;

/// <summary>One number of an export: a point of a sum or gauge, or the count of a histogram. It reads only what the tests use.</summary>
/// <param name="Name">The name of the instrument.</param>
/// <param name="Unit">The unit of the instrument.</param>
/// <param name="Tags">"key=value" for each tag with a text.</param>
/// <param name="Value">The point's value, or the histogram's count.</param>
internal sealed record OtlpMetric(string Name, string Unit, IReadOnlyList<string> Tags, double Value)
{
    private const int Varint = 0;
    private const int Fixed64 = 1;
    private const int Bytes = 2;

    // request.resource_metrics (1) . scope_metrics (2) . metrics (2)
    public static IEnumerable<OtlpMetric> ReadAll(ReadOnlyMemory<byte> request) =>
        Messages(request, 1).SelectMany(resource => Messages(resource, 2)).SelectMany(scope => Messages(scope, 2)).SelectMany(Read);

    // metric: name (1), unit (3), gauge (5), sum (7) or histogram (9), each with data_points (1).
    private static IEnumerable<OtlpMetric> Read(ReadOnlyMemory<byte> metric)
    {
        string name = Text(metric, 1);
        string unit = Text(metric, 3);
        foreach (ReadOnlyMemory<byte> point in Messages(metric, 5).Concat(Messages(metric, 7)).SelectMany(data => Messages(data, 1)))
            yield return new OtlpMetric(name, unit, ReadTags(point, 7), Number(point));

        foreach (ReadOnlyMemory<byte> point in Messages(metric, 9).SelectMany(data => Messages(data, 1)))
            yield return new OtlpMetric(name, unit, ReadTags(point, 9), Fields(point).First(field => field.Number == 4).Integer);
    }

    // as_double (4) or as_int (6).
    private static double Number(ReadOnlyMemory<byte> point)
    {
        (int number, long value, _) = Fields(point).First(field => field.Number is 4 or 6);
        return number == 4 ? BitConverter.Int64BitsToDouble(value) : value;
    }

    // key_value: key (1), value (2) . string_value (1).
    private static string[] ReadTags(ReadOnlyMemory<byte> point, int number) =>
        [.. Messages(point, number).Select(tag => $"{Text(tag, 1)}={Text(Messages(tag, 2).Single(), 1)}")];

    private static string Text(ReadOnlyMemory<byte> message, int number) =>
        Encoding.UTF8.GetString(Messages(message, number).FirstOrDefault().Span);

    private static IEnumerable<ReadOnlyMemory<byte>> Messages(ReadOnlyMemory<byte> message, int number) =>
        Fields(message).Where(field => field.Number == number).Select(field => field.Content);

    private static IEnumerable<(int Number, long Integer, ReadOnlyMemory<byte> Content)> Fields(ReadOnlyMemory<byte> message)
    {
        while (message.Length > 0)
        {
            long key = ReadVarint(ref message);
            int number = (int)(key >> 3);
            switch ((int)(key & 7))
            {
                case Varint:
                    yield return (number, ReadVarint(ref message), default);
                    break;
                case Fixed64:
                    yield return (number, BinaryPrimitives.ReadInt64LittleEndian(message.Span), default);
                    message = message[8..];
                    break;
                case Bytes:
                    int length = (int)ReadVarint(ref message);
                    yield return (number, 0, message[..length]);
                    message = message[length..];
                    break;
                default:
                    yield return (number, BinaryPrimitives.ReadInt32LittleEndian(message.Span), default);
                    message = message[4..];
                    break;
            }
        }
    }

    private static long ReadVarint(ref ReadOnlyMemory<byte> message)
    {
        long value = 0;
        for (int shift = 0; ; shift += 7)
        {
            byte part = message.Span[0];
            message = message[1..];
            value |= (long)(part & 0x7F) << shift;
            if (part < 0x80)
                return value;
        }
    }
}
