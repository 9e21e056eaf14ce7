using System.Runtime.InteropServices;
using System.Text;
using NeuronMocap.Protocol;

namespace NeuronMocap;

/// <summary>The 32 bytes of an avatar's name in a header: UTF-8, padded with zeros, without a terminator if all 32 bytes are used.</summary>
/// <remarks>Comparing and copying a name allocates nothing; <see cref="ToString"/> allocates a string.</remarks>
[StructLayout(LayoutKind.Sequential)]
public readonly struct AvatarName : IEquatable<AvatarName>
{
    private readonly ulong _part0;
    private readonly ulong _part1;
    private readonly ulong _part2;
    private readonly ulong _part3;

    /// <summary>Makes a name from its bytes in a header.</summary>
    /// <param name="bytes">At most 32 bytes; fewer are padded with zeros.</param>
    /// <exception cref="ArgumentException">There are more than 32 bytes.</exception>
    public AvatarName(ReadOnlySpan<byte> bytes)
    {
        if (bytes.Length > ProtocolConstants.AvatarNameSize)
            throw new ArgumentException($"A name must have at most {ProtocolConstants.AvatarNameSize} bytes.", nameof(bytes));

        Span<byte> padded = stackalloc byte[ProtocolConstants.AvatarNameSize];
        padded.Clear();
        bytes.CopyTo(padded);
        this = MemoryMarshal.Read<AvatarName>(padded);
    }

    /// <summary>Makes a name from text. Text beyond 32 bytes of UTF-8 is cut off, between two characters.</summary>
    /// <param name="text">The name.</param>
    public AvatarName(string text)
    {
        ArgumentNullException.ThrowIfNull(text);
        Span<byte> padded = stackalloc byte[ProtocolConstants.AvatarNameSize];
        padded.Clear();
        Encoding.UTF8.GetEncoder().Convert(text, padded, flush: true, out _, out _, out _);
        this = MemoryMarshal.Read<AvatarName>(padded);
    }

    /// <summary>Copies the 32 bytes of the name.</summary>
    /// <param name="destination">At least 32 bytes.</param>
    public void CopyTo(Span<byte> destination)
    {
        Span<byte> bytes = stackalloc byte[ProtocolConstants.AvatarNameSize];
        MemoryMarshal.Write(bytes, in this);
        bytes.CopyTo(destination);
    }

    /// <summary>Gets the text up to the first zero byte. Bytes that are not UTF-8 become replacement characters.</summary>
    /// <returns>A new string in every call.</returns>
    public override string ToString()
    {
        Span<byte> bytes = stackalloc byte[ProtocolConstants.AvatarNameSize];
        CopyTo(bytes);
        int end = bytes.IndexOf((byte)0);
        return Encoding.UTF8.GetString(end < 0 ? bytes : bytes[..end]);
    }

    /// <inheritdoc/>
    public bool Equals(AvatarName other) =>
        _part0 == other._part0 && _part1 == other._part1 && _part2 == other._part2 && _part3 == other._part3;

    /// <inheritdoc/>
    public override bool Equals(object? obj) => obj is AvatarName other && Equals(other);

    /// <inheritdoc/>
    public override int GetHashCode() => HashCode.Combine(_part0, _part1, _part2, _part3);

    /// <summary>Determines whether both names have the same 32 bytes.</summary>
    /// <param name="left">A name.</param>
    /// <param name="right">Another name.</param>
    public static bool operator ==(AvatarName left, AvatarName right) => left.Equals(right);

    /// <summary>Determines whether the names differ in any of their 32 bytes.</summary>
    /// <param name="left">A name.</param>
    /// <param name="right">Another name.</param>
    public static bool operator !=(AvatarName left, AvatarName right) => !left.Equals(right);

    internal static AvatarName Read(ReadOnlySpan<byte> source) =>
        MemoryMarshal.Read<AvatarName>(source[..ProtocolConstants.AvatarNameSize]);
}
