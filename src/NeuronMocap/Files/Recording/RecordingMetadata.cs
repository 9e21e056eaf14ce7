using System.Diagnostics.CodeAnalysis;
using System.Globalization;
using System.Runtime.InteropServices;
using System.Text;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Recording;

/// <summary>
/// Describes a recording as a whole with text values by key. The library writes and understands the keys of this type; a program may add its own.
/// Immutable.
/// </summary>
public sealed class RecordingMetadata
{
    /// <summary>The program that recorded, with its version.</summary>
    public const string ProgramKey = "program";

    /// <summary>The server as written in the reader's options, such as "192.168.1.20:7001" or "UDP port 7012".</summary>
    public const string ServerKey = "server";

    /// <summary>The name of the reader.</summary>
    public const string ReaderKey = "reader";

    /// <summary>The transport of the bytes: "Tcp" or "Udp" (<see cref="TransportKind"/>).</summary>
    public const string TransportKey = "transport";

    /// <summary>The stream format of the server, as <see cref="StreamFormat"/> names it.</summary>
    public const string StreamFormatKey = "stream-format";

    /// <summary>The rotation order, as <see cref="RotationOrder"/> names it.</summary>
    public const string RotationOrderKey = "rotation-order";

    /// <summary>The names of the spine bones, as <see cref="Skeleton.SkeletonVariant"/> names them.</summary>
    public const string SkeletonVariantKey = "skeleton-variant";

    /// <summary>
    /// The body of avatar 0: the HIERARCHY of a BVH file with its OFFSETs, which a stream without displacement does not contain.
    /// </summary>
    public const string BvhHierarchyKey = "bvh-hierarchy";

    /// <summary>The reader's limit of floats in a packet. With another limit, a hostile stream gives other frames.</summary>
    public const string MaxValuesKey = "max-values";

    /// <summary>
    /// The sizes of the body of avatar 0, in metres: twelve numbers separated by blanks, in the order of <see cref="BoneDimensions"/>.
    /// </summary>
    public const string BoneDimensionsKey = "bone-dimensions";

    /// <summary>Maximum number of values.</summary>
    public const int MaxCount = 256;

    /// <summary>Maximum length of a key in bytes of UTF-8.</summary>
    public const int MaxKeyBytes = 255;

    /// <summary>Maximum length of a value in bytes of UTF-8.</summary>
    public const int MaxValueBytes = 32 * 1024;

    /// <summary>Maximum length of all keys and values together, in bytes.</summary>
    public const int MaxTotalBytes = 256 * 1024;

    private readonly SortedDictionary<string, string> _values;
    private int _bytes;

    /// <summary>Creates empty metadata.</summary>
    public RecordingMetadata()
        : this(new SortedDictionary<string, string>(StringComparer.Ordinal), 0)
    {
    }

    private RecordingMetadata(SortedDictionary<string, string> values, int bytes)
    {
        _values = values;
        _bytes = bytes;
    }

    /// <summary>Metadata without values.</summary>
    public static RecordingMetadata Empty { get; } = new();

    /// <summary>All values, in the order of their keys.</summary>
    public IReadOnlyDictionary<string, string> Values => _values;

    /// <summary>Gets the value of a key; null if the key does not exist.</summary>
    /// <param name="key">The key.</param>
    public string? this[string key] => _values.TryGetValue(key, out string? value) ? value : null;

    /// <summary>The rotation order; null when unknown.</summary>
    public RotationOrder? RotationOrder => Enum.TryParse(this[RotationOrderKey], out RotationOrder order) && Enum.IsDefined(typeof(RotationOrder), order)
        ? order
        : null;

    /// <summary>The names of the spine bones; null when unknown.</summary>
    public SkeletonVariant? SkeletonVariant =>
        Enum.TryParse(this[SkeletonVariantKey], out SkeletonVariant variant) && Enum.IsDefined(typeof(SkeletonVariant), variant) ? variant : null;

    /// <summary>The reader's limit of floats in a packet; null when unknown.</summary>
    public int? MaxValues => int.TryParse(this[MaxValuesKey], NumberStyles.None, CultureInfo.InvariantCulture, out int count) && count > 0 ? count : null;

    /// <summary>The sizes of the body of avatar 0; null when unknown.</summary>
    public BoneDimensions? BoneDimensions => ParseDimensions(this[BoneDimensionsKey]);

    /// <summary>Creates metadata with an additional or replaced value.</summary>
    /// <param name="key">The key, not empty.</param>
    /// <param name="value">The value.</param>
    /// <returns>The new metadata.</returns>
    /// <exception cref="ArgumentException">A limit is exceeded; the message names it.</exception>
    public RecordingMetadata With(string key, string value)
    {
        ArgumentNullException.ThrowIfNull(key);
        ArgumentNullException.ThrowIfNull(value);
        return TryWith(key, value, out RecordingMetadata? metadata, out string? fault) ? metadata : throw new ArgumentException(fault, nameof(value));
    }

    // Nine digits are enough to restore the same float.
    internal static string ToText(BoneDimensions dimensions)
    {
        byte[] bytes = new byte[Skeleton.BoneDimensions.Size];
        dimensions.Write(bytes);
        return string.Join(" ", MemoryMarshal.Cast<byte, float>(bytes).ToArray().Select(size => ((double)size).ToString("G9", CultureInfo.InvariantCulture)));
    }

    private static BoneDimensions? ParseDimensions(string? text)
    {
        byte[] bytes = new byte[Skeleton.BoneDimensions.Size];
        Span<float> sizes = MemoryMarshal.Cast<byte, float>(bytes.AsSpan());
        string[] parts = text?.Split(' ') ?? [];
        if (parts.Length != sizes.Length)
            return null;

        for (int i = 0; i < parts.Length; i++)
        {
            if (!double.TryParse(parts[i], NumberStyles.Float, CultureInfo.InvariantCulture, out double size))
                return null;

            sizes[i] = (float)size;
        }

        return Skeleton.BoneDimensions.TryRead(bytes, out BoneDimensions dimensions) ? dimensions : null;
    }

    internal bool TryWith(string key, string value, [NotNullWhen(true)] out RecordingMetadata? metadata, [NotNullWhen(false)] out string? fault)
    {
        metadata = null;
        if (!Fits(key, value, out int bytes, out fault))
            return false;

        metadata = new RecordingMetadata(new SortedDictionary<string, string>(_values, StringComparer.Ordinal) { [key] = value }, bytes);
        return true;
    }

    // Changes this object, so it must not be shared yet. A file may hold any number of values, and a copy for each would need as much memory.
    internal bool TryAdd(string key, string value, [NotNullWhen(false)] out string? fault)
    {
        if (!Fits(key, value, out int bytes, out fault))
            return false;

        _values[key] = value;
        _bytes = bytes;
        return true;
    }

    private bool Fits(string key, string value, out int bytes, [NotNullWhen(false)] out string? fault)
    {
        int keyBytes = Encoding.UTF8.GetByteCount(key);
        int valueBytes = Encoding.UTF8.GetByteCount(value);
        bool isNew = !_values.TryGetValue(key, out string? old);
        bytes = _bytes + valueBytes + (isNew ? keyBytes : -Encoding.UTF8.GetByteCount(old!));
        fault = keyBytes is 0 or > MaxKeyBytes ? $"A metadata key must have 1 to {MaxKeyBytes} bytes, not {keyBytes}."
            : valueBytes > MaxValueBytes ? $"The value of '{key}' has {valueBytes} bytes; at most {MaxValueBytes} are allowed."
            : isNew && _values.Count == MaxCount ? $"There are already {MaxCount} values, which is the maximum."
            : bytes > MaxTotalBytes ? $"With '{key}', the metadata would have {bytes} bytes; at most {MaxTotalBytes} are allowed."
            : null;
        return fault is null;
    }
}
