namespace NeuronMocap.Recording;

// Goes through a file block by block. It skips and reports damaged sections.
internal sealed class BlockSearch(BlockFile file, RecordingProblems problems)
{
    public const string DamagedBlock = "A block is damaged: its checksum is wrong.";

    // Limits the work for a file that consists of headers with wrong payloads. Otherwise each byte could be checked thousands of times.
    private const long MaxLookedInto = 16 * RecordingLayout.MaxPayload;

    private long _place = RecordingLayout.FileHeaderSize;
    private long _lookedInto;

    // Number of unreadable bytes before the last block found.
    public long DamagedBytes { get; private set; }

    public bool IsBehindDamage => DamagedBytes > 0;

    public void MoveTo(long place)
    {
        _place = place;
        DamagedBytes = 0;
    }

    // The payload has not been checked.
    public bool TryFind(out long offset, out BlockHeader header)
    {
        offset = file.Find(_place, out header);
        if (offset != _place && _place < file.Length)
            ReportDamage(_place, offset < 0 ? file.Length : offset);

        if (offset < 0)
            _place = file.Length;

        return offset >= 0;
    }

    // Continues after the block. If no block follows there, this block may be incomplete, and the next one may begin anywhere within it. The
    // payload then decides whether the block is damaged.
    public void Pass(long offset, in BlockHeader header)
    {
        DamagedBytes = 0;
        _place = offset + RecordingLayout.BlockHeaderSize + header.Length;
        if (_place != file.Length && !file.TryReadHeader(_place, out _) && !file.TryReadPayload(offset, header, out _))
            PassDamaged(offset, header);
    }

    public void PassDamaged(long offset, in BlockHeader header)
    {
        _place = offset + RecordingLayout.BlockHeaderSize + header.Length;
        if (_place != file.Length && !file.TryReadHeader(_place, out _) && _lookedInto < MaxLookedInto)
        {
            _lookedInto += header.Length;
            _place = offset + BlockHeader.Marker.Length;
        }

        if (header.Kind == BlockKind.Entries)
            ReportDamage(offset, _place);
        else
            problems.Add(offset, _place - offset, DamagedBlock);
    }

    public void PassWhole(long offset, in BlockHeader header)
    {
        DamagedBytes = 0;
        _place = offset + RecordingLayout.BlockHeaderSize + header.Length;
    }

    private void ReportDamage(long start, long end)
    {
        DamagedBytes += end - start;
        problems.Add(start, end - start, end == file.Length ? "The file ends in the middle of a block." : DamagedBlock);
    }
}
