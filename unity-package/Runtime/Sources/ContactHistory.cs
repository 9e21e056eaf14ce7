#nullable enable

using System.Threading;

namespace NeuronMocap.Unity
{
    // Recent foot contacts from calculation frames, kept because poses are shown with a delay. They belong to motion frames, by number. Arrival times
    // would not do: after a stall many frames arrive at once, but they are shown one after another. The receive thread writes, the main thread reads. An
    // entry is one 64-bit number with frame and both feet, so reads are never torn.
    internal sealed class ContactHistory
    {
        private const int Left = 1;
        private const int Right = 2;
        private const int FlagBits = 2;

        private readonly long[] _entries = new long[256];
        private int _next;

        // frame: the number of the motion frame, from 1.
        public void Add(long frame, FootContacts contacts)
        {
            long flags = (contacts.Left ? Left : 0) | (contacts.Right ? Right : 0);
            int place = _next;
            Interlocked.Exchange(ref _entries[place], (frame << FlagBits) | flags);
            Volatile.Write(ref _next, (place + 1) % _entries.Length);
        }

        // The contacts of the last frame within a range, or null.
        public FootContacts? Find(long first, long last)
        {
            int next = Volatile.Read(ref _next);
            for (int i = 1; i <= _entries.Length; i++)
            {
                long entry = Interlocked.Read(ref _entries[(next + _entries.Length - i) % _entries.Length]);
                long frame = entry >> FlagBits;
                if (frame < first || frame == 0)
                    return null;
                if (frame <= last)
                    return new FootContacts((entry & Left) != 0, (entry & Right) != 0);
            }

            return null;
        }
    }
}
