using System.Buffers.Binary;
using System.Runtime.CompilerServices;

namespace NeuronMocap;

/// <summary>
/// Version of the stream's data format. It has four bytes in the stream, lowest part first (manual section 2.1.2, protocol.md section 2.4).
/// </summary>
/// <remarks>Major and minor determine the layout of the header. Revision and build do not affect a reader.</remarks>
/// <param name="Major">Byte 5 of a header.</param>
/// <param name="Minor">Byte 4 of a header.</param>
/// <param name="Revision">Byte 3 of a header.</param>
/// <param name="Build">Byte 2 of a header.</param>
public readonly record struct DataVersion(byte Major, byte Minor, byte Revision, byte Build)
{
    /// <summary>1.1.0.0: Axis Neuron since b15.</summary>
    public static DataVersion New => new(1, 1, 0, 0);

    /// <summary>1.1.0.1: Axis Studio.</summary>
    public static DataVersion Studio => new(1, 1, 0, 1);

    /// <summary>1.0.0.2: servers up to b12, and Axis Studio with "Use old header format" on.</summary>
    public static DataVersion Old => new(1, 0, 0, 2);

    /// <summary>1.0.0.3: the version that the manual's example gives for calculation packets (section 2.1.4).</summary>
    public static DataVersion Calculation => new(1, 0, 0, 3);

    /// <summary>2.0.0.0: Axis Studio's calculation packets (protocol.md section 9).</summary>
    public static DataVersion StudioCalculation => new(2, 0, 0, 0);

    /// <summary>
    /// 0.0.0.0: the frame has no version, because it arrived as text (protocol.md section 8). A binary motion packet with this version is rejected.
    /// </summary>
    public static DataVersion None => default;

    /// <summary>Gets the layout of the motion header for this version.</summary>
    /// <param name="layout">The layout, if the version is known.</param>
    /// <returns>False for every version except 1.0 and 1.1; other headers are not documented.</returns>
    public bool TryGetLayout(out HeaderLayout layout)
    {
        layout = Layout;
        return Major == 1 && Minor <= 1;
    }

    /// <summary>Gets the version as text, for example "1.1.0.0".</summary>
    /// <returns>Four numbers, major first.</returns>
    public override string ToString() => $"{Major}.{Minor}.{Revision}.{Build}";

    // A frame without a version has no frame index either, like the Old layout.
    internal HeaderLayout Layout => this is { Major: <= 1, Minor: 0 } ? HeaderLayout.Old : HeaderLayout.New;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static bool IsOld(ReadOnlySpan<byte> source) => (BinaryPrimitives.ReadUInt16LittleEndian(source[2..]) & ~0x0100) == 0;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static bool IsKnown(ReadOnlySpan<byte> source) => source[3] == 1 && source[2] <= 1;

    internal static DataVersion Read(ReadOnlySpan<byte> source) => new(source[3], source[2], source[1], source[0]);

    internal void Write(Span<byte> destination)
    {
        destination[3] = Major;
        destination[2] = Minor;
        destination[1] = Revision;
        destination[0] = Build;
    }
}
