namespace NeuronMocap.Protocol;

/// <summary>
/// Writes the lines of the text stream, which Axis Neuron and Axis Studio send with the block type String (protocol.md section 8). Allocates nothing; the
/// caller owns the memory.
/// </summary>
/// <remarks>
/// A value is rounded to the given number of decimals, halves away from zero, and keeps its sign: -0.001 becomes -0.00. The text has no exponents. Numbers
/// from a billion on become 999999999 with their sign, and NaN becomes 0.
/// </remarks>
public static class TextEncoder
{
    /// <summary>Number of digits after the point in the only published example of a line.</summary>
    public const int DefaultDecimals = 2;

    /// <summary>Largest number of digits after the point that can be requested.</summary>
    public const int MaxDecimals = 6;

    private const double Largest = 999_999_999;

    // A space, a sign, nine digits and a point.
    private const int MaxValueSize = 12;

    // The number of an avatar, a space, the name, " ||" and CR LF.
    private const int MaxMotionFrame = 10 + 1 + ProtocolConstants.AvatarNameSize + 3 + 2;

    private static readonly double[] Scales = [1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6];

    private static ReadOnlySpan<byte> LineEnd => " ||\r\n"u8;

    /// <summary>Gets the largest size in bytes of a line of motion values.</summary>
    /// <param name="valueCount">Number of values, not negative.</param>
    /// <param name="decimals">Digits after the point, 0 to 6.</param>
    /// <returns>A size that is sufficient for <see cref="WriteMotion"/>, whatever the values and the name.</returns>
    public static int GetMaxMotionSize(int valueCount, int decimals = DefaultDecimals) =>
        checked(MaxMotionFrame + (valueCount * (MaxValueSize + decimals)));

    /// <summary>Gets the largest size in bytes of a line of calculation values.</summary>
    /// <param name="valueCount">Number of values, not negative.</param>
    /// <param name="decimals">Digits after the point, 0 to 6.</param>
    /// <returns>A size that is sufficient for <see cref="WriteCalculation"/>, whatever the values.</returns>
    public static int GetMaxCalculationSize(int valueCount, int decimals = DefaultDecimals) =>
        checked(1 + (valueCount * (MaxValueSize + decimals)));

    /// <summary>Writes a line of motion values: <c>index name value value … ||</c> and CR LF.</summary>
    /// <param name="destination">Room for the line; <see cref="GetMaxMotionSize"/> is always sufficient.</param>
    /// <param name="avatarIndex">Number of the avatar on the server, from 0.</param>
    /// <param name="avatarName">
    /// Name of the avatar. The text cannot contain spaces in it. Spaces and other separators (control characters, the vertical bar) become "_", and so
    /// does an empty name. Names that begin with a digit are sent unchanged; one known reader mistakes them for values.
    /// </param>
    /// <param name="values">The values in stream order, in cm and degrees.</param>
    /// <param name="decimals">Digits after the point, 0 to 6; with 0 there is no point.</param>
    /// <returns>Number of bytes written.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The destination is too short, or the number of decimals is out of range.</exception>
    public static int WriteMotion(
        Span<byte> destination, int avatarIndex, AvatarName avatarName, ReadOnlySpan<float> values, int decimals = DefaultDecimals)
    {
        var line = new Line(destination, decimals);
        line.WriteInteger((uint)avatarIndex);
        line.Write((byte)' ');
        line.WriteName(avatarName);
        line.WriteValues(values, separatesFirst: true);
        line.Write(LineEnd);
        return line.Length;
    }

    /// <summary>
    /// Writes a line of calculation values: columns with a space between them, and LF. The line contains neither avatar nor frame number.
    /// </summary>
    /// <param name="destination">Room for the line; <see cref="GetMaxCalculationSize"/> is always sufficient.</param>
    /// <param name="values">The values in stream order, in metres, metres per second and the units of the sensors. Known servers send 946 values.</param>
    /// <param name="decimals">Digits after the point, 0 to 6; with 0 there is no point.</param>
    /// <returns>Number of bytes written.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The destination is too short, or the number of decimals is out of range.</exception>
    public static int WriteCalculation(Span<byte> destination, ReadOnlySpan<float> values, int decimals = DefaultDecimals)
    {
        var line = new Line(destination, decimals);
        line.WriteValues(values, separatesFirst: false);
        line.Write((byte)'\n');
        return line.Length;
    }

    private ref struct Line
    {
        private readonly Span<byte> _destination;
        private readonly int _decimals;
        private readonly double _scale;

        public Line(Span<byte> destination, int decimals)
        {
            if (decimals is < 0 or > MaxDecimals)
                throw new ArgumentOutOfRangeException(nameof(decimals), decimals, "The number of decimals must be 0 to 6.");

            _destination = destination;
            _decimals = decimals;
            _scale = Scales[decimals];
            Length = 0;
        }

        public int Length { get; private set; }

        public void Write(byte character) => Reserve(1)[0] = character;

        public void Write(scoped ReadOnlySpan<byte> characters) => characters.CopyTo(Reserve(characters.Length));

        public void WriteName(AvatarName name)
        {
            Span<byte> bytes = stackalloc byte[ProtocolConstants.AvatarNameSize];
            name.CopyTo(bytes);
            int end = bytes.IndexOf((byte)0);
            bytes = end < 0 ? bytes : bytes[..end];
            foreach (ref byte character in bytes)
            {
                if (character is <= (byte)' ' or (byte)'|' or 0x7F)
                    character = (byte)'_';
            }

            if (bytes.IsEmpty)
                Write((byte)'_');
            Write(bytes);
        }

        public void WriteValues(ReadOnlySpan<float> values, bool separatesFirst)
        {
            for (int i = 0; i < values.Length; i++)
            {
                if (separatesFirst || i > 0)
                    Write((byte)' ');
                WriteValue(values[i]);
            }
        }

        public void WriteInteger(ulong number)
        {
            int digits = CountDigits(number);
            WriteDigits(Reserve(digits), number);
        }

        // A float has 24 significant bits and the scale at most 20. Their product is exact, and so is the rounding.
        private void WriteValue(float value)
        {
            double magnitude = float.IsNaN(value) ? 0 : Math.Min(Math.Abs((double)value), Largest);
            ulong scaled = (ulong)Math.Round(magnitude * _scale, MidpointRounding.AwayFromZero);
            if (float.IsNegative(value) && !float.IsNaN(value))
                Write((byte)'-');
            if (_decimals == 0)
            {
                WriteInteger(scaled);
                return;
            }

            ulong whole = scaled / (ulong)_scale;
            WriteInteger(whole);
            Write((byte)'.');
            WriteDigits(Reserve(_decimals), scaled - (whole * (ulong)_scale));
        }

        private static int CountDigits(ulong number)
        {
            int digits = 1;
            while ((number /= 10) > 0)
                digits++;

            return digits;
        }

        // Fills the target, with leading zeros.
        private static void WriteDigits(Span<byte> target, ulong number)
        {
            for (int i = target.Length - 1; i >= 0; i--)
            {
                ulong rest = number / 10;
                target[i] = (byte)('0' + (number - (rest * 10)));
                number = rest;
            }
        }

        // Throws if the destination is too short.
        private Span<byte> Reserve(int count)
        {
            Span<byte> room = _destination.Slice(Length, count);
            Length += count;
            return room;
        }
    }
}
