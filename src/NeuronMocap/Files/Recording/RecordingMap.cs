namespace NeuronMocap.Recording;

// Determines the checkpoints, duration and metadata of a file before it is read. They come from the last block if the recording was closed and is
// complete. Otherwise, all block headers are visited.
internal sealed class RecordingMap
{
    private readonly BlockFile _file;

    public RecordingMap(BlockFile file)
    {
        _file = file;
        // The index is where the end block says only if nothing is missing in between.
        if (!TryReadEnd(out long indexOffset) || !TryReadIndex(indexOffset))
        {
            Index = new RecordingIndex();
            LookThrough();
        }

        Metadata = ReadMetadata();
    }

    public RecordingIndex Index { get; private set; } = new();

    // Null if the file does not have an end block.
    public RecordingTotals? Totals { get; private set; }

    // The file was closed, but its last block was removed.
    public bool LacksEnd { get; private set; }

    public long Duration { get; private set; }

    public RecordingMetadata Metadata { get; }

    // Position of the last checkpoint.
    private long LastCheckpoint { get; set; }

    private bool TryReadEnd(out long indexOffset)
    {
        long offset = _file.Length - RecordingLayout.BlockHeaderSize - RecordingEnd.Size;
        indexOffset = 0;
        return _file.TryReadHeader(offset, out BlockHeader header) && TryTakeEnd(offset, header, out indexOffset);
    }

    private bool TryTakeEnd(long offset, in BlockHeader header, out long indexOffset)
    {
        indexOffset = 0;
        if (header is not { Kind: BlockKind.End, Length: RecordingEnd.Size } || !_file.TryReadPayload(offset, header, out ArraySegment<byte> payload))
            return false;

        RecordingEnd end = RecordingEnd.Read(payload);
        (indexOffset, Totals, Duration) = (end.IndexOffset, end.Totals, end.Duration);
        return true;
    }

    private bool TryReadIndex(long offset)
    {
        if (!_file.TryReadHeader(offset, out BlockHeader header) || header.Kind != BlockKind.Index
            || !_file.TryReadPayload(offset, header, out ArraySegment<byte> payload) || !Index.TryRead(payload, _file.Length))
        {
            return false;
        }

        LastCheckpoint = Index.LastOffset;
        return true;
    }

    private void LookThrough()
    {
        long offset = RecordingLayout.FileHeaderSize;
        BlockKind lastKind = default;
        long end = 0;
        (long Offset, BlockHeader Header) last = default;
        while ((offset = _file.Find(offset, out BlockHeader header)) >= 0)
        {
            if (header.Kind is BlockKind.Entries or BlockKind.Checkpoint && header.Time >= last.Header.Time)
                last = (offset, header);
            if (header.Kind == BlockKind.Checkpoint)
            {
                Index.Add(header.Time, offset);
                LastCheckpoint = offset;
            }

            // A displaced end block.
            if (Totals is null && header.Kind == BlockKind.End)
                TryTakeEnd(offset, header, out _);

            lastKind = header.Kind;
            offset = end = offset + RecordingLayout.BlockHeaderSize + header.Length;
        }

        LacksEnd = Totals is null && lastKind == BlockKind.Index && end == _file.Length;
        if (Totals is null)
            Duration = last.Offset > 0 ? LastTime(last.Offset, last.Header) : 0;
    }

    private long LastTime(long offset, in BlockHeader header)
    {
        long time = header.Time;
        if (!_file.TryReadPayload(offset, header, out ArraySegment<byte> payload))
            return time;

        var decoder = new EntryDecoder();
        decoder.Begin(payload, time);
        while (decoder.TryTake(out RecordingEntry entry))
            time = entry.Time.Ticks;

        return time;
    }

    // Reads the metadata of the last checkpoint, which includes values that became known earlier in the recording.
    private RecordingMetadata ReadMetadata()
    {
        if (!_file.TryReadHeader(LastCheckpoint, out BlockHeader header) || header.Kind != BlockKind.Checkpoint
            || !_file.TryReadPayload(LastCheckpoint, header, out ArraySegment<byte> payload))
        {
            return RecordingMetadata.Empty;
        }

        var decoder = new EntryDecoder();
        decoder.Begin(payload, header.Time);
        var metadata = new RecordingMetadata();
        while (decoder.TryTake(out RecordingEntry entry))
        {
            if (entry.Kind == RecordingEntryKind.Metadata)
                metadata.TryAdd(entry.Key!, entry.Text!, out _);
        }

        return metadata;
    }
}
