using System.Diagnostics.CodeAnalysis;
using System.Globalization;
using System.Runtime.InteropServices;
using System.Text;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Recording;

/// <summary>
/// What is known about a recording as a whole: text values by keys. The keys of this type are what the library writes and understands;
/// a program may add its own. Immutable.
/// </summary>
public sealed class RecordingMetadata
{
    /// <summary>The program that recorded, with its version.</summary>
    public const string ProgramKey = "program";

    /// <summary>The server as the reader's options name it, such as "192.168.1.20:7001", or "UDP port 7012".</summary>
    public const string ServerKey = "server";

    /// <summary>The reader's name.</summary>
    public const string ReaderKey = "reader";

    /// <summary>How the bytes came: "Tcp" or "Udp" (<see cref="TransportKind"/>).</summary>
    public const string TransportKey = "transport";

    /// <summary>What the server sends, as <see cref="StreamFormat"/> names it.</summary>
    public const string StreamFormatKey = "stream-format";

    /// <summary>Order of the rotation values, as <see cref="RotationOrder"/> names it.</summary>
    public const string RotationOrderKey = "rotation-order";

    /// <summary>Names of the spine's bones, as <see cref="Skeleton.SkeletonVariant"/> names them.</summary>
    public const string SkeletonVariantKey = "skeleton-variant";

    /// <summary>
    /// The body of avatar 0: the HIERARCHY of a BVH file, with its OFFSETs, which a stream without displacement does not carry.
    /// </summary>
    public const string BvhHierarchyKey = "bvh-hierarchy";

    /// <summary>The reader's limit of floats in a packet: with another one, a hostile stream gives other frames.</summary>
    public const string MaxValuesKey = "max-values";

    /// <summary>Sizes of the body of avatar 0, in metres: twelve numbers with blanks between them, as <see cref="BoneDimensions"/> lists them.</summary>
    public const string BoneDimensionsKey = "bone-dimensions";

    /// <summary>Most names.</summary>
    public const int MaxCount = 256;

    /// <summary>Most bytes of a name in UTF-8.</summary>
    public const int MaxKeyBytes = 255;

    /// <summary>Most bytes of a value in UTF-8.</summary>
    public const int MaxValueBytes = 32 * 1024;

    /// <summary>Most bytes of all keys and values together.</summary>
    public const int MaxTotalBytes = 256 * 1024;

    private readonly SortedDictionary<string, string> _values;
    private int _bytes;

    /// <summary>Makes metadata without any value.</summary>
    public RecordingMetadata()
        : this(new SortedDictionary<string, string>(StringComparer.Ordinal), 0)
    {
    }

    private RecordingMetadata(SortedDictionary<string, string> values, int bytes)
    {
        _values = values;
        _bytes = bytes;
    }

    /// <summary>No value.</summary>
    public static RecordingMetadata Empty { get; } = new();

    /// <summary>All values, in the order of their keys.</summary>
    public IReadOnlyDictionary<string, string> Values => _values;

    /// <summary>The value of a name; null when there is none.</summary>
    /// <param name="key">The name.</param>
    public string? this[string key] => _values.TryGetValue(key, out string? value) ? value : null;

    /// <summary>Order of the rotation values; null when it is not known.</summary>
    public RotationOrder? RotationOrder => Enum.TryParse(this[RotationOrderKey], out RotationOrder order) && Enum.IsDefined(typeof(RotationOrder), order)
        ? order
        : null;

    /// <summary>Names of the spine's bones; null when they are not known.</summary>
    public SkeletonVariant? SkeletonVariant =>
        Enum.TryParse(this[SkeletonVariantKey], out SkeletonVariant variant) && Enum.IsDefined(typeof(SkeletonVariant), variant) ? variant : null;

    /// <summary>The reader's limit of floats in a packet; null when it is not known.</summary>
    public int? MaxValues => int.TryParse(this[MaxValuesKey], NumberStyles.None, CultureInfo.InvariantCulture, out int count) && count > 0 ? count : null;

    /// <summary>Sizes of the body of avatar 0; null when they are not known.</summary>
    public BoneDimensions? BoneDimensions => ParseDimensions(this[BoneDimensionsKey]);

    /// <summary>Makes metadata that have this value besides, or instead of one of the same name.</summary>
    /// <param name="key">The name, not empty.</param>
    /// <param name="value">The value.</param>
    /// <returns>The new metadata.</returns>
    /// <exception cref="ArgumentException">One of the limits is exceeded; the message says which.</exception>
    public RecordingMetadata With(string key, string value)
    {
        ArgumentNullException.ThrowIfNull(key);
        ArgumentNullException.ThrowIfNull(value);
        return TryWith(key, value, out RecordingMetadata? metadata, out string? fault) ? metadata : throw new ArgumentException(fault, nameof(value));
    }

    // Nine digits give the same float again.
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

    // Before anybody else sees it: a file may hold any number of values, and a copy for each would take as much memory.
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
        fault = keyBytes is 0 or > MaxKeyBytes ? $"A name of metadata has 1 to {MaxKeyBytes} bytes; this has {keyBytes}."
            : valueBytes > MaxValueBytes ? $"The value of '{key}' has {valueBytes} bytes; it may have {MaxValueBytes}."
            : isNew && _values.Count == MaxCount ? $"There are {MaxCount} values already."
            : bytes > MaxTotalBytes ? $"With '{key}' the metadata would have {bytes} bytes; they may have {MaxTotalBytes}."
            : null;
        return fault is null;
    }
}
