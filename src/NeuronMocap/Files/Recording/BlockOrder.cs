namespace NeuronMocap.Recording;

// The positions of the blocks in the order of their numbers, for a file with missing blocks or with blocks out of order.
internal sealed class BlockOrder
{
    // Each position has 32 bytes. The limit covers four gigabytes of a busy stream, or half a day of a quiet one.
    public const int MaxBlocks = 64 * 1024;

    private readonly List<BlockPosition> _places;

    private BlockOrder(List<BlockPosition> places) => _places = places;

    public int Count => _places.Count;

    public BlockPosition this[int index] => _places[index];

    // Returns null if the file has too many blocks. Reports missing, duplicate, displaced and damaged blocks.
    public static BlockOrder? TryRead(BlockFile file, RecordingProblems problems, int maxBlocks)
    {
        List<BlockPosition> places = [];
        var walk = new BlockSearch(file, problems);
        while (walk.TryFind(out long offset, out BlockHeader header))
        {
            if (places.Count == maxBlocks)
                return null;

            places.Add(new BlockPosition(offset, header.Sequence, header.Time, header.Kind == BlockKind.Checkpoint, walk.IsBehindDamage));
            walk.Pass(offset, header);
        }

        ReportDisplaced(places, problems);
        places.Sort(static (left, right) =>
            left.Sequence != right.Sequence ? left.Sequence.CompareTo(right.Sequence) : left.Offset.CompareTo(right.Offset));
        DropDoubled(places, problems);
        ReportMissing(places, problems);
        return new BlockOrder(places);
    }

    // Finds the first block with this number or a higher one.
    public int Find(uint sequence)
    {
        int index = _places.FindIndex(place => place.Sequence >= sequence);
        return index >= 0 ? index : _places.Count;
    }

    // Finds the last checkpoint before a time, or else the first block.
    public int FindTime(long time) => Math.Max(0, _places.FindLastIndex(place => place.IsCheckpoint && place.Time < time));

    // The blocks are in the order of the file.
    private static void ReportDisplaced(List<BlockPosition> places, RecordingProblems problems)
    {
        uint highest = 0;
        var seen = new HashSet<uint>();
        foreach (BlockPosition place in places)
        {
            if (seen.Add(place.Sequence) && place.Sequence < highest && !problems.IsFull)
                problems.Add(place.Offset, 0, $"Block {place.Sequence} follows block {highest}; it is read in its proper place.");

            highest = Math.Max(highest, place.Sequence);
        }
    }

    private static void DropDoubled(List<BlockPosition> places, RecordingProblems problems)
    {
        int kept = 0;
        for (int i = 0; i < places.Count; i++)
        {
            BlockPosition place = places[i];
            bool isDoubled = kept > 0 && places[kept - 1].Sequence == place.Sequence;
            if (isDoubled && !problems.IsFull)
                problems.Add(place.Offset, 0, $"Block {place.Sequence} exists twice; the second one is skipped.");
            if (!isDoubled)
                places[kept++] = place;
        }

        places.RemoveRange(kept, places.Count - kept);
    }

    // A gap after a damaged section is not reported again.
    private static void ReportMissing(List<BlockPosition> places, RecordingProblems problems)
    {
        uint expected = 0;
        foreach (BlockPosition place in places)
        {
            if (place.Sequence > expected && !place.IsBehindDamage && !problems.IsFull)
                problems.Add(place.Offset, 0, DescribeMissing(expected, place.Sequence - 1));

            expected = place.Sequence + 1;
        }
    }

    public static string DescribeMissing(uint first, uint last) =>
        first == last ? $"Block {first} is missing before this one." : $"Blocks {first} to {last} are missing before this one.";
}

internal readonly record struct BlockPosition(long Offset, uint Sequence, long Time, bool IsCheckpoint, bool IsBehindDamage);
