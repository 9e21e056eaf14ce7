#nullable enable

using System.Threading;

namespace NeuronMocap.Unity
{
    // Recent foot contacts from calculation frames, kept because poses are shown with a delay. The receive thread writes, the main thread reads. An
    // entry is one 64-bit number with time and both feet, so reads are never torn. If an entry is overwritten during a read, the reader gets a newer
    // entry.
    internal sealed class ContactHistory
    {
        private const int Left = 1;
        private const int Right = 2;
        private const int FlagBits = 2;

        private readonly long[] _entries = new long[256];
        private int _next;

        // timestamp: Stopwatch ticks. Two bits less are still enough for centuries.
        public void Add(long timestamp, FootContacts contacts)
        {
            long flags = (contacts.Left ? Left : 0) | (contacts.Right ? Right : 0);
            Interlocked.Exchange(ref _entries[_next], (timestamp << FlagBits) | flags);
            _next = (_next + 1) % _entries.Length;
        }

        // The newest entry within the given times, or null.
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
