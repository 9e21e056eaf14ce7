#nullable enable

using System.Threading;

namespace NeuronMocap.Unity
{
    // What calculation frames said about the feet in the last while, because poses are shown with a delay. The receive thread writes, the main thread
    // reads. An entry is one 64-bit number, time and both feet, so that none is ever half of one and half of another; an entry that is overwritten
    // while others are read is only a newer one.
    internal sealed class ContactHistory
    {
        private const int Left = 1;
        private const int Right = 2;
        private const int FlagBits = 2;

        private readonly long[] _entries = new long[256];
        private int _next;

        // timestamp: ticks of Stopwatch, of which two bits fewer are enough for centuries.
        public void Add(long timestamp, FootContacts contacts)
        {
            long flags = (contacts.Left ? Left : 0) | (contacts.Right ? Right : 0);
            Interlocked.Exchange(ref _entries[_next], (timestamp << FlagBits) | flags);
            _next = (_next + 1) % _entries.Length;
        }

        // The newest that is not after a moment and not before another; null when there is none.
        public FootContacts? Find(long earliest, long latest)
        {
            long found = 0;
            for (int i = 0; i < _entries.Length; i++)
            {
                long entry = Interlocked.Read(ref _entries[i]);
                long timestamp = entry >> FlagBits;
                if (entry > found && timestamp >= earliest && timestamp <= latest)
                    found = entry;
            }

            return found == 0 ? (FootContacts?)null : new FootContacts((found & Left) != 0, (found & Right) != 0);
        }
    }
}
