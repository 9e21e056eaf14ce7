namespace NeuronMocap.Bvh;

// The only parser of BVH text, used by BvhReader and BvhDocument. It reads the hierarchy, then row by row.
internal sealed class BvhParser(BvhReadOptions? options)
{
    private readonly BvhTextFormatBuilder _format = new();
    private BvhHierarchy? _hierarchy;
    private BvhMotionReader? _motion;

    public BvhRepairLog Repairs { get; } = new(options?.Strict ?? false);

    public BvhHierarchy Hierarchy => _hierarchy!;

    public BvhFrameTime FrameTime => _motion!.FrameTime;

    public double DeclaredFrameTime => _motion!.DeclaredFrameTime;

    public long? AnnouncedFrames => _motion!.AnnouncedFrames;

    public BvhTextFormat GetTextFormat(string? lineEnd) => _format.Build(lineEnd);

    /// <summary>Reads up to the first row.</summary>
    public void Begin(ref BvhText text)
    {
        _hierarchy = BvhHierarchyReader.Read(ref text, Repairs, _format);
        _motion = new BvhMotionReader(_hierarchy.ChannelCount, Repairs, _format);
        _motion.Begin(ref text);
    }

    public bool TryReadRow(ref BvhText text, Span<float> row) => _motion!.TryReadRow(ref text, row);
}
