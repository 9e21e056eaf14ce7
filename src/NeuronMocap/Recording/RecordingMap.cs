namespace NeuronMocap.Recording;

// What is known of a file before it is read: where its checkpoints are, how long it is and what its metadata are. From the last block, where the
// recording was closed; else by hopping from header to header.
internal sealed class RecordingMap
{
    private readonly BlockFile _file;

    public RecordingMap(BlockFile file)
    {
        _file = file;
        if (TryReadEnd(out RecordingEnd end))
        {
            Totals = end.Totals;
            Duration = end.Duration;
        }
        else
        {
            Index = new RecordingIndex();
            LookThrough();
        }

        Metadata = ReadMetadata();
    }

    public RecordingIndex Index { get; private set; } = new();

    // Null when the file has no end.
    public RecordingTotals? Totals { get; }

    public long Duration { get; private set; }

    public RecordingMetadata Metadata { get; }

    // Where the last checkpoint is.
    private long LastCheckpoint { get; set; }

    private bool TryReadEnd(out RecordingEnd end)
    {
        end = default;
        long offset = _file.Length - RecordingLayout.BlockHeaderSize - RecordingEnd.Size;
        if (!_file.TryReadHeader(offset, out BlockHeader header) || header is not { Kind: BlockKind.End, Length: RecordingEnd.Size }
            || !_file.TryReadPayload(offset, header, out ArraySegment<byte> payload))
        {
            return false;
        }

        end = RecordingEnd.Read(payload);
        if (!_file.TryReadHeader(end.IndexOffset, out header) || header.Kind != BlockKind.Index
            || !_file.TryReadPayload(end.IndexOffset, header, out payload) || !Index.TryRead(payload, _file.Length))
        {
            return false;
        }

        LastCheckpoint = Index.LastOffset;
        return true;
    }

    private void LookThrough()
    {
        long offset = RecordingLayout.FileHeaderSize;
        (long Offset, BlockHeader Header) last = default;
        while ((offset = _file.Find(offset, out BlockHeader header)) >= 0)
        {
            if (header.Kind is BlockKind.Entries or BlockKind.Checkpoint)
                last = (offset, header);
            if (header.Kind == BlockKind.Checkpoint)
            {
                Index.Add(header.Time, offset);
                LastCheckpoint = offset;
            }

            offset += RecordingLayout.BlockHeaderSize + header.Length;
        }

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
        RecordingMetadata metadata = RecordingMetadata.Empty;
        if (!_file.TryReadHeader(LastCheckpoint, out BlockHeader header) || header.Kind != BlockKind.Checkpoint
            || !_file.TryReadPayload(LastCheckpoint, header, out ArraySegment<byte> payload))
        {
            return metadata;
        }

        var decoder = new EntryDecoder();
        decoder.Begin(payload, header.Time);
        while (decoder.TryTake(out RecordingEntry entry))
        {
            if (entry.Kind == RecordingEntryKind.Metadata && metadata.TryWith(entry.Key!, entry.Text!, out RecordingMetadata? further, out _))
                metadata = further;
        }

        return metadata;
    }
}
