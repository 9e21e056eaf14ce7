namespace NeuronMocap.Recording;

// Reads the whole blocks of a file in the order of their numbers. As long as the file has this order, no positions are kept. At the first block out
// of order, the positions of all blocks are looked up once.
internal sealed class BlockIterator(BlockFile file, RecordingProblems problems, int maxBlocks = BlockOrder.MaxBlocks)
{
    private readonly BlockSearch _search = new(file, problems);
    private BlockOrder? _order;
    private bool _isOrderTried;
    private int _next;

    // Null when the next number is unknown, after a jump.
    private uint? _sequence = 0;

    // Number of unreadable bytes before the last block, and whether anything is missing there.
    public long DamagedBytes { get; private set; }

    public bool IsBroken { get; private set; }

    public long Offset { get; private set; }

    public BlockHeader Header { get; private set; }

    // Moves to the last checkpoint before a time. The index supplies the expected offset.
    public void MoveTo(long time, long place)
    {
        bool isIndexRight = place == RecordingLayout.FileHeaderSize
            || (file.TryReadHeader(place, out BlockHeader header) && header.Kind == BlockKind.Checkpoint);
        if (!isIndexRight)
            LookUpOrder();

        (DamagedBytes, IsBroken) = (0, false);
        if (_order is not null)
        {
            _next = _order.FindTime(time);
            _sequence = _next < _order.Count ? _order[_next].Sequence : null;
            return;
        }

        _search.MoveTo(place);
        _sequence = place == RecordingLayout.FileHeaderSize ? 0 : null;
    }

    // Returns false at the end. Damage accumulates until ForgetBreak is called.
    public bool TryRead(out ArraySegment<byte> payload)
    {
        while (_order is null)
        {
            if (!_search.TryFind(out long offset, out BlockHeader header))
            {
                payload = default;
                return false;
            }

            bool isWhole = file.TryReadPayload(offset, header, out payload);
            bool isBehindDamage = _search.IsBehindDamage;
            Break(_search.DamagedBytes);
            if (!isWhole)
            {
                // A damaged block with the expected number still takes its place in the order.
                if (_sequence == header.Sequence)
                    _sequence++;

                _search.MoveTo(offset);
                _search.PassDamaged(offset, header);
                continue;
            }

            bool wasTried = _isOrderTried;
            bool isInOrder = IsInOrder(offset, header, isBehindDamage);
            _search.PassWhole(offset, header);

            // The lookup reads other blocks into the same memory.
            if (!isInOrder || (!wasTried && _isOrderTried && !file.TryReadPayload(offset, header, out payload)))
                continue;

            Take(offset, header);
            return true;
        }

        return TryReadInOrder(_order, out payload);
    }

    public void ForgetBreak() => (DamagedBytes, IsBroken) = (0, false);

    private bool TryReadInOrder(BlockOrder order, out ArraySegment<byte> payload)
    {
        while (_next < order.Count)
        {
            BlockPosition place = order[_next++];
            if (place.Sequence != _sequence)
                IsBroken = true;

            _sequence = place.Sequence + 1;
            if (!file.TryReadHeader(place.Offset, out BlockHeader header))
                continue;

            if (file.TryReadPayload(place.Offset, header, out payload))
            {
                Take(place.Offset, header);
                return true;
            }

            problems.Add(place.Offset, RecordingLayout.BlockHeaderSize + header.Length, BlockSearch.DamagedBlock);
            if (header.Kind == BlockKind.Entries)
                Break(RecordingLayout.BlockHeaderSize + header.Length);
        }

        payload = default;
        return false;
    }

    // Returns false if the block is not to be read now: it is skipped, or the order of all blocks has been looked up.
    private bool IsInOrder(long offset, in BlockHeader header, bool isBehindDamage)
    {
        if (_sequence is not { } sequence || header.Sequence == sequence || (isBehindDamage && header.Sequence > sequence))
            return true;

        LookUpOrder();
        if (_order is not null)
        {
            _next = _order.Find(sequence);
            return false;
        }

        if (header.Sequence < sequence)
        {
            if (!problems.IsFull)
                problems.Add(offset, 0, $"Block {header.Sequence} follows block {sequence - 1}; it is skipped.");
            return false;
        }

        problems.Add(offset, 0, BlockOrder.DescribeMissing(sequence, header.Sequence - 1));
        IsBroken = true;
        return true;
    }

    private void LookUpOrder()
    {
        if (!_isOrderTried)
            _order = BlockOrder.TryRead(file, problems, maxBlocks);

        _isOrderTried = true;
    }

    private void Take(long offset, in BlockHeader header)
    {
        (Offset, Header) = (offset, header);
        _sequence = header.Sequence + 1;
    }

    private void Break(long damagedBytes)
    {
        DamagedBytes += damagedBytes;
        IsBroken |= damagedBytes > 0;
    }
}
