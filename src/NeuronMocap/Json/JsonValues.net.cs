using System.Buffers;
using System.Buffers.Text;
using System.Net;
using System.Text.Json;

namespace NeuronMocap.Json;

/// <summary>Writes values of --json for which the writer has no method. Numbers and timecodes allocate nothing.</summary>
internal static class JsonValues
{
    private static readonly JsonEncodedText NotANumber = JsonEncodedText.Encode("NaN");
    private static readonly JsonEncodedText PositiveInfinity = JsonEncodedText.Encode("Infinity");
    private static readonly JsonEncodedText NegativeInfinity = JsonEncodedText.Encode("-Infinity");

    public static void WriteTimecode(this Utf8JsonWriter json, Timecode? timecode)
    {
        Span<byte> text = stackalloc byte[32];
        if (timecode is { } time)
            json.WriteString("timecode"u8, text[..FormatTimecode(time, text)]);
        else
            json.WriteNull("timecode"u8);
    }

    public static void WriteNumber(this Utf8JsonWriter json, ReadOnlySpan<byte> name, double? number)
    {
        if (number is { } value)
            json.WriteNumber(name, value);
        else
            json.WriteNull(name);
    }

    public static void WriteEndPoint(this Utf8JsonWriter json, ReadOnlySpan<byte> name, EndPoint? endPoint)
    {
        if (endPoint is null)
            json.WriteNull(name);
        else
            json.WriteString(name, endPoint.ToString());
    }

    public static void WriteValues(this Utf8JsonWriter json, ReadOnlySpan<float> values)
    {
        json.WriteStartArray("values"u8);
        foreach (float value in values)
            json.WriteValue(value);

        json.WriteEndArray();
    }

    public static void WriteValue(this Utf8JsonWriter json, float value)
    {
        if (value == 0 && float.IsNegative(value))
            json.WriteRawValue("-0.0"u8, skipInputValidation: true); // many a reader takes -0 for the integer 0
        else if (float.IsFinite(value))
            json.WriteNumberValue(value);
        else
            json.WriteStringValue(float.IsNaN(value) ? NotANumber : value > 0 ? PositiveInfinity : NegativeInfinity);
    }

    // Does the same as Timecode.ToString, without allocating a string.
    private static int FormatTimecode(Timecode time, Span<byte> text)
    {
        int length = 0;
        foreach (int part in (ReadOnlySpan<int>)[time.Hours, time.Minutes, time.Seconds, time.Frames])
        {
            if (length > 0)
                text[length++] = (byte)':';

            Utf8Formatter.TryFormat(part, text[length..], out int written, new StandardFormat('D', 2));
            length += written;
        }

        return length;
    }
}
