namespace NeuronMocap.Recording;

// What is known of a file before it is read: where its checkpoints are, how long it is and what its metadata are. From the last block, where the
// recording was closed and is complete; else by hopping from header to header.
internal sealed class RecordingMap
{
    private readonly BlockFile _file;

    public RecordingMap(BlockFile file)
    {
        _file = file;
        // The index is only where the end says when nothing is missing in between.
        if (!TryReadEnd(out long indexOffset) || !TryReadIndex(indexOffset))
        {
            Index = new RecordingIndex();
            LookThrough();
        }

        Metadata = ReadMetadata();
    }

    public RecordingIndex Index { get; private set; } = new();

    // Null when the file has no end.
    public RecordingTotals? Totals { get; private set; }

    // Closed, and its last block taken away.
    public bool LacksEnd { get; private set; }

    public long Duration { get; private set; }

    public RecordingMetadata Metadata { get; }

    // Where the last checkpoint is.
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

            // Displaced.
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

    // The last ones that were written at a checkpoint: what came to be known early in the recording is in them.
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
